"""Messages of the library in the words of Python."""

from __future__ import annotations

import re

# the library speaks of its C++ parameters, and the readers of meshes of options of the tool
_REPLACEMENTS = (
    (r"skip_invalid\(true\)", "skip_invalid=True"),
    (r"--(mesh|field) (cad|scan|given|estimated)", r'\1="\2"'),
    (r"--(\w+(?:-\w+)*)", lambda match: match[1].replace("-", "_")),
)


def in_python(text: str) -> str:
    """Return a message with the names that parameters have here."""
    for pattern, replacement in _REPLACEMENTS:
        text = re.sub(pattern, replacement, text)   # type: ignore[call-overload]
    return text
