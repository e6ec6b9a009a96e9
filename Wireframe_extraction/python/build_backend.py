"""The build backend of the Python package: that of setuptools, with the setup script beside this file."""

import pathlib

from setuptools.build_meta import _BuildMetaBackend


class _Backend(_BuildMetaBackend):
    def run_setup(self, setup_script="setup.py"):
        super().run_setup(str(pathlib.Path(__file__).with_name(setup_script)))


_BACKEND = _Backend()
build_wheel = _BACKEND.build_wheel
build_sdist = _BACKEND.build_sdist
get_requires_for_build_wheel = _BACKEND.get_requires_for_build_wheel
get_requires_for_build_sdist = _BACKEND.get_requires_for_build_sdist
prepare_metadata_for_build_wheel = _BACKEND.prepare_metadata_for_build_wheel
if hasattr(_BACKEND, "build_editable"):   # since setuptools 64
    build_editable = _BACKEND.build_editable
    get_requires_for_build_editable = _BACKEND.get_requires_for_build_editable
    prepare_metadata_for_build_editable = _BACKEND.prepare_metadata_for_build_editable
