"""Validates TOML texts by a JSON schema, and compares what it says with what is expected.

    python tests/python/check_schema.py SCHEMA.json CASES.json

CASES.json is a list of objects with name, text and valid. Infinities are the null that editors make of them on the way
to JSON; valid files are tried with the numbers, too.
"""

import json
import math
import sys
from pathlib import Path

import fastjsonschema
import tomllib


def without_infinities(value):
    """Null in place of numbers that JSON has not."""
    if isinstance(value, dict):
        return {key: without_infinities(item) for key, item in value.items()}
    if isinstance(value, list):
        return [without_infinities(item) for item in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value


def problem(validate, document):
    """What is wrong with a document; None if it is valid."""
    try:
        validate(document)
    except fastjsonschema.JsonSchemaValueException as error:
        return str(error)
    return None


def main():
    """Validates the cases and says how many are as expected."""
    schema, cases = (json.loads(Path(name).read_text()) for name in sys.argv[1:])
    validate = fastjsonschema.compile(schema, use_default=False)
    wrong = 0
    for case in cases:
        document = tomllib.loads(case["text"])
        for form in [without_infinities(document)] + [document] * case["valid"]:
            found = problem(validate, form)
            if (found is None) != case["valid"]:
                wrong += 1
                print(f"{case['name']}: {found or 'it is valid'}\n{case['text']}\n", file=sys.stderr)
                break
    if wrong:
        sys.exit(f"{wrong} of {len(cases)} files are not as expected")
    print(f"{len(cases)} files as expected")


main()
