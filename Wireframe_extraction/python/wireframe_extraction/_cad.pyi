"""The compiled part that writes the files of CAD programs, if it was built with OpenCASCADE."""

from ._core import Wireframe

def write(wireframe: Wireframe, path: bytes, extension: str, unit: str, schema: str) -> None: ...
