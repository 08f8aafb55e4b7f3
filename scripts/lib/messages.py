"""What scripts say: counted nouns, and the last words about wrong input."""

import sys


def fail(message):
    """Ends the script with exit code 2, as the program does where its input is wrong."""
    print(message, file=sys.stderr)
    sys.exit(2)


def format_count(number, noun):
    """`1 case`, `2 cases`."""
    return f"{number} {noun}" if number == 1 else f"{number} {noun}s"
