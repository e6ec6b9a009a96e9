"""Writes the lists of parameters in the stubs, so that the compiled part has the only one.
 A comment `# EXTRACTION`, or the name of another table of _parameters.py, stands in a stub where its parameters belong.
Run it after a change of parameters, with the built module in PYTHONPATH; a test tells whether it has to be.
"""

import pathlib
import re
import sys

FOLDER = pathlib.Path(__file__).resolve().with_name("wireframe_extraction")
sys.path = [path for path in sys.path if pathlib.Path(path).resolve() != FOLDER.parent]   # not built there

from wireframe_extraction import _parameters  # noqa: E402

TYPES = {float: "Real", int: "Integer", bool: "Flag", tuple: "Sequence[str]", str: "str"}


def line(name, kind):
    """Return a parameter as a stub has it."""
    choices = _parameters._CHOICES.get(name)
    text = f"Literal[{', '.join(map(_quoted, choices))}]" if choices else TYPES[kind]
    return f"{name}: {text} | None = ...,\n"


def _quoted(text):
    return f'"{text}"'


def written(text):
    """Return the text of a stub with all lists as they are now."""
    def block(match):
        indent, table = match[1], match[2]
        return match[0][:match.start(3) - match.start(0)] + "".join(
            indent + line(name, kind) for name, kind in getattr(_parameters, table).items())
    return re.sub(r"(?m)^( +)# ([A-Z_]+)\n((?:\1\w+: .*,\n)*)", block, text)


if __name__ == "__main__":
    for path in FOLDER.glob("*.pyi"):
        old = path.read_text(encoding="utf-8")
        if written(old) != old:
            path.write_text(written(old), encoding="utf-8")
