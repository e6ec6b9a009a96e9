"""Types and documentation: everything has them, and they are right."""

import ast
import importlib.util
import inspect
import pathlib
import re
import subprocess
import sys

import pytest

import wireframe_extraction as we

USER = '''
import numpy as np
import wireframe_extraction as we
cloud = we.read_cloud("cloud.ply", field="auto")
w = we.extract(cloud.points, cloud.distances, corner_radius=4, progress=print, graph_method="traced")
reveal_type(w)
reveal_type(w.curves[0](0.5))
reveal_type(w.curves[0].radius)
reveal_type(w.report)
reveal_type(we.evaluate("truth.json", w))
reveal_type(we.Extractor(np.zeros((9, 3))).corners[0].center)
we.extract("cloud.ply", corner_radus=4)
we.extract("cloud.ply", graph_method="trace")
w.write(3)
we.Extractor(cloud.points, corner_radus=4)
we.extract_many([b"a.ply", cloud], errors="return", corner_radius=np.float32(4), threads=np.int8(1))
we.extract_many(["a.ply"], corner_radus=4)
w.write(b"a.step", unit="parsec")
w.curves = ()
w.curves[0].length = 3.0
w._core.sampling_distance = 3.0
'''


@pytest.fixture(scope="module")
def package(root):
    return root / "Wireframe_extraction/python/wireframe_extraction"


def mypy(package, folder, *arguments):
    pytest.importorskip("mypy")
    command = [sys.executable, "-m", "mypy", "--cache-dir", str(folder / "cache"),
               "--config-file", str(package.parents[2] / "pyproject.toml"), *arguments]
    done = subprocess.run(command, cwd=folder, env={"MYPYPATH": str(package.parent)}, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, encoding="utf-8", check=False)
    return done.stdout


def test_mypy(package, tmp_path):
    (tmp_path / "user.py").write_text(USER)
    text = mypy(package, tmp_path, "-p", "wireframe_extraction")
    assert "Success" in text, text
    text = mypy(package, tmp_path, "user.py")
    revealed = re.findall(r'Revealed type is "(.*)"', text)
    assert [re.sub(r"(\w+\.)+", "", name) for name in revealed[:1]] == ["Wireframe"], text
    assert "floating" in revealed[1] and revealed[2] == "Union[builtins.float, None]" and "Report" in revealed[3], text
    errors = re.findall(r"user\.py:(\d+): error: .*\[(.*)\]", text)
    assert errors == [("12", "call-arg"), ("13", "arg-type"), ("14", "arg-type"), ("15", "call-arg"),
                      ("17", "call-overload"), ("18", "arg-type"), ("19", "misc"), ("20", "misc"), ("21", "misc")], text


def names_in_stub(path):
    """Return the names of functions and classes, and of what is in the classes."""
    for node in ast.parse(path.read_text()).body:
        if isinstance(node, ast.FunctionDef):
            yield node.name
        elif isinstance(node, ast.ClassDef):
            yield node.name
            for member in node.body:
                if isinstance(member, ast.FunctionDef):
                    yield f"{node.name}.{member.name}"
                elif isinstance(member, ast.AnnAssign):
                    yield f"{node.name}.{member.target.id}"


def names_in_module(module):
    for name, value in vars(module).items():
        if name.startswith("_"):
            continue
        yield name
        if inspect.isclass(value):
            yield from (f"{name}.{member}" for member in vars(value) if not member.startswith("_"))


def test_compiled_part(package):
    written = {name for name in names_in_stub(package / "_core.pyi") if "__" not in name}
    assert written == set(names_in_module(we._core))


def test_parameters(package):
    spec = importlib.util.spec_from_file_location("write_stubs", package.with_name("write_stubs.py"))
    write_stubs = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(write_stubs)
    for path in package.glob("*.pyi"):
        text = path.read_text()
        assert write_stubs.written(text) == text, f"run {spec.origin}"


def nodes_in_stub(path):
    for node in ast.parse(path.read_text()).body:
        yield from (node.body if isinstance(node, ast.ClassDef) else [node])


@pytest.mark.parametrize("stub, name, function", [
    ("_extraction", "extract", we.extract), ("_extraction", "estimate_distances", we.estimate_distances),
    ("_clouds", "read_cloud", we.read_cloud), ("_batch", "extract_many", we.extract_many),
    ("_stages", "__init__", we.Extractor.__init__)])
def test_signatures(package, stub, name, function):
    nodes = [node for node in nodes_in_stub(package / f"{stub}.pyi") if getattr(node, "name", "") == name]
    assert nodes
    for node in nodes:
        written = [argument.arg for argument in node.args.args + node.args.kwonlyargs]
        assert written == list(inspect.signature(function).parameters)   # also what notebooks show


def public_things():
    for name in we.__all__:
        value = getattr(we, name)
        if isinstance(value, str):
            continue
        yield name, value
        if inspect.isclass(value):
            for member, function in vars(value).items():
                is_own = callable(function) or isinstance(function, property) or hasattr(function, "func")
                if is_own and (not member.startswith("_") or member == "__call__") and not isinstance(function, type):
                    yield f"{name}.{member}", function


@pytest.mark.parametrize("name, thing", list(public_things()))
def test_documentation(name, thing):
    text = inspect.getdoc(thing)
    assert text and len(text) > 20, name
    if inspect.isfunction(thing):
        code = thing.__code__   # not the signature, which has what **parameters takes
        for parameter in code.co_varnames[:code.co_argcount + code.co_kwonlyargcount]:
            assert parameter == "self" or re.search(rf"(^|[ *,]){parameter}\b.*", text, re.M), f"{name}: {parameter}"
        is_none = thing.__annotations__.get("return") == "None"
        assert is_none or "Returns\n-------" in text, name


def test_defaults():
    defaults = we.default_parameters()
    assert all(f"`{name}`" in we.default_parameters.__doc__ for name in defaults)
    assert defaults["corner_radius"] == 4 and defaults["sampling_distance"] is None
    assert set(we.paper_parameters()) < set(defaults)


def test_typed(package):
    assert (package / "py.typed").exists()
    assert pathlib.Path(we.__file__).with_name("py.typed").exists()
