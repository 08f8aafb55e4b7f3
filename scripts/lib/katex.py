"""Renders formulas by KaTeX, which `scripts/site/packages` installs."""

import json
import re
import subprocess
from pathlib import Path

ROOT = Path(__file__).parents[2]


def render_formulas(formulas):
    """HTML for each formula, or the reason why there is none: pairs, one of them None."""
    request = json.dumps([{"source": formula.source, "display": formula.display} for formula in formulas])
    command = ["node", str(ROOT / "scripts/site/formulas.cjs")]
    answer = subprocess.run(command, input=request, capture_output=True, text=True, check=True).stdout
    return [(safe(html["html"]), None) if "html" in html else (None, html["error"]) for html in json.loads(answer)]


def safe(html):
    """HTML that Markdown leaves unchanged: without the source of the formula, and with no sign that means something."""
    html = re.sub(r"<annotation.*?</annotation>", "", html, flags=re.DOTALL).replace("\n", " ")
    return re.sub(r">[^<]+<", lambda text: re.sub(r"[*_|`\[\]\\~$]", lambda sign: f"&#{ord(sign[0])};", text[0]), html)
