"""Files: clouds in all formats, wireframes in and out."""

import concurrent.futures
import errno
import os
import pickle
import sys
import xml.etree.ElementTree

import numpy as np
import pytest
import shapes

import wireframe_extraction as we

FORMATS = ["json", "dxf", "obj", "ply", "vtp", "gltf", "glb", "svg", "csv", "polylines.txt", "txt", "cgal", "html"]


@pytest.mark.parametrize("extension", FORMATS)
def test_formats(box_wireframe, extension, tmp_path):
    path = tmp_path / f"wireframe.{extension}"
    box_wireframe.write(path)
    assert path.stat().st_size > 500 and os.listdir(tmp_path) == [path.name]


@pytest.mark.parametrize("extension", ["step", "STP", "iges", "igs", "brep"])
def test_formats_of_cad_programs(box_wireframe, extension, tmp_path):
    pytest.importorskip("wireframe_extraction._cad")
    path = tmp_path / f"wireframe.{extension}"
    box_wireframe.write(path, unit="in")
    assert path.stat().st_size > 500
    if extension == "step":
        text = path.read_text()
        assert text.count("=CIRCLE(") + text.count("= CIRCLE(") == 2 and "INCH" in text


def test_threads_write_at_once(box_wireframe, tmp_path):
    pytest.importorskip("wireframe_extraction._cad")
    units = ["mm", "in"] * 3
    with concurrent.futures.ThreadPoolExecutor(len(units)) as pool:
        list(pool.map(lambda i: box_wireframe.write(tmp_path / f"{i}.step", unit=units[i]), range(len(units))))
    assert [("INCH" in (tmp_path / f"{i}.step").read_text()) for i in range(len(units))] == [u == "in" for u in units]


def test_options(box_wireframe, tmp_path):
    box_wireframe.write(tmp_path / "coarse.obj", step=10)
    box_wireframe.write(tmp_path / "fine.obj", step=0.001)
    assert (tmp_path / "fine.obj").stat().st_size > 10 * (tmp_path / "coarse.obj").stat().st_size
    box_wireframe.write(tmp_path / "splines.obj", obj_splines=True)
    box_wireframe.write(tmp_path / "splines.dxf", dxf_splines=True)
    assert "cstype" in (tmp_path / "splines.obj").read_text()
    box_wireframe.write(tmp_path / "feet.dxf", unit="ft")
    assert (tmp_path / "feet.dxf").read_text() != (box_wireframe.write(tmp_path / "mm.dxf"),
                                                   (tmp_path / "mm.dxf").read_text())[1]


def test_there_and_back(box_wireframe, tmp_path):
    box_wireframe.write(tmp_path / "one.json")
    read = we.read(tmp_path / "one.json")
    read.write(tmp_path / "two.json")
    assert (tmp_path / "one.json").read_bytes() == (tmp_path / "two.json").read_bytes()
    assert read.report is None and repr(read) == repr(box_wireframe)
    copy = pickle.loads(pickle.dumps(box_wireframe))
    copy.write(tmp_path / "three.json")
    assert (tmp_path / "one.json").read_bytes() == (tmp_path / "three.json").read_bytes()
    assert copy.report == box_wireframe.report


def test_names(box_wireframe, tmp_path):
    for name in ("with space.json", "ümlaut.json", os.fsencode(tmp_path) + b"/not \xff text.json"):
        path = tmp_path / name if isinstance(name, str) else name
        box_wireframe.write(path)
        assert len(we.read(path).curves) == 14
        assert len(we.read(os.fsdecode(path)).curves) == 14


def test_empty_wireframe(tmp_path):
    wireframe = we.Wireframe()
    assert wireframe.is_valid() and wireframe.vertices.shape == (0, 3) and wireframe.edges.shape == (0, 2)
    wireframe.write(tmp_path / "empty.json")
    assert we.read(tmp_path / "empty.json").curves == ()


@pytest.mark.parametrize("name, error, text", [
    ("a.foo", ValueError, "unknown extension '.foo' of a wireframe; known are .step"),
    ("a", ValueError, "unknown extension ''"),
    ("missing/a.json", OSError, "missing"),
    ("missing/a.html", OSError, "missing"),
])
def test_bad_names(box_wireframe, name, error, text, tmp_path):
    with pytest.raises(error) as raised:
        box_wireframe.write(tmp_path / name)
    assert text in str(raised.value)


@pytest.mark.parametrize("arguments, text", [({"unit": "mile"}, "um, mm"), ({"schema": "ap1"}, "ap242"),
                                             ({"step": -1}, "positive")])
def test_bad_options(box_wireframe, arguments, text, tmp_path):
    with pytest.raises(ValueError, match=text):
        box_wireframe.write(tmp_path / "a.obj", **arguments)
    assert not os.listdir(tmp_path)


@pytest.mark.parametrize("text, message", [
    ("", "empty"), ("{", "no valid JSON"), ("{}", "is no wireframe"),
    ('{"format":"wireframe","version":3}', "version 3"),
    ('{"format":"wireframe","version":1,"sampling_distance":1,"vertices":[],"curves":[{"type":"x"}]}', "curve 0"),
])
def test_bad_wireframes(text, message, tmp_path):
    (tmp_path / "bad.json").write_text(text)
    with pytest.raises(ValueError, match=message):
        we.read(tmp_path / "bad.json")
    with pytest.raises(FileNotFoundError):
        we.read(tmp_path / "missing.json")
    with pytest.raises(IsADirectoryError):
        we.read(tmp_path)


def test_read_cloud(cylinder, data, tmp_path):
    points, distances = cylinder
    np.savez(tmp_path / "cloud.npz", points=points, distances=distances)
    np.savetxt(tmp_path / "cloud.xyz", points, fmt="%.17g")
    np.save(tmp_path / "distances.npy", distances)
    cloud = we.read_cloud(tmp_path / "cloud.npz")
    assert np.array_equal(cloud.points, points) and np.array_equal(cloud.distances, distances)
    np.save(tmp_path / "columns.npy", np.column_stack([distances - 1e-9, points[:, ::-1]]))
    turned = we.read_cloud(tmp_path / "columns.npy", coordinate_properties=("4", "3", "2"), distance_property="1",
                           clamp_negative=True)
    assert np.array_equal(turned.points, points) and turned.distances.min() >= 0
    with pytest.raises(ValueError, match="three different names"):
        we.read_cloud(tmp_path / "columns.npy", coordinate_properties="xyz")
    with pytest.raises(ValueError, match="coordinate_properties"):
        we.read_cloud(tmp_path / "columns.npy", coordinate_properties=("x", "y", "z"))
    (tmp_path / "columns.npy").rename(tmp_path / "columns.dat")
    assert len(we.read_cloud(tmp_path / "columns.dat", input_format="npy", field="estimated").points) == len(points)
    bare = we.read_cloud(tmp_path / "cloud.xyz")
    assert np.array_equal(bare.points, points) and bare.distances is None
    joined = we.read_cloud(tmp_path / "cloud.xyz", tmp_path / "distances.npy")
    assert np.array_equal(joined.distances, distances)
    assert we.read_cloud(tmp_path / "cloud.npz", field="estimated").distances is None
    with pytest.raises(ValueError, match="distance"):
        we.read_cloud(tmp_path / "cloud.xyz", field="given")
    assert len(we.read_cloud(data / "rounded_plate.stl", sampling_distance=0.05).points) > 1000


def test_read_patches(cylinder, tmp_path):
    h5py = pytest.importorskip("h5py")
    points, distances = cylinder
    with h5py.File(tmp_path / "patches.hdf5", "w") as file:
        file["points"] = np.stack([points[:4000], points[1000:]])
        file["distances"] = np.stack([distances[:4000], distances[1000:]])
    try:
        cloud = we.read_cloud(tmp_path / "patches.hdf5", patches=True)
    except ValueError as error:
        pytest.skip(str(error))   # the module was built without HDF5
    assert len(cloud.points) == len(points)
    assert len(we.extract(tmp_path / "patches.hdf5", patches=True).curves) == 2


@pytest.mark.parametrize("arguments, parameters, error, text", [
    ((["a", "b"],), {}, ValueError, "patches=True"),
    (([],), {}, ValueError, "no file"),
    (("a.ply", np.zeros(3)), {}, TypeError, "name of a file"),
    (("a.ply",), {"fild": "auto"}, TypeError, "did you mean 'field'?"),
    (("a.ply",), {"field": "none"}, ValueError, "'auto', 'given', 'estimated'"),
    (("a.ply",), {}, FileNotFoundError, "a.ply"),
    ((3,), {}, TypeError, "int"),
])
def test_bad_clouds(arguments, parameters, error, text):
    with pytest.raises(error) as raised:
        we.read_cloud(*arguments, **parameters)
    assert text in str(raised.value)


def test_message_of_a_file_names_it(tmp_path):
    np.savetxt(tmp_path / "flat.xyz", np.zeros((9, 3)))
    with pytest.raises(ValueError, match=r"flat\.xyz: all points coincide"):
        we.extract(tmp_path / "flat.xyz")


def test_invalid_wireframe_is_not_written(tmp_path):
    path = shapes.write(tmp_path / "line.json", [(0, 0, 0), (1, 0, 0)], [shapes.line((0, 0, 0), (1, 0, 0))])
    assert we.read(path).is_valid()


def test_drawing_is_xml(box_wireframe, tmp_path):
    box_wireframe.write(tmp_path / "drawing.svg")
    assert xml.etree.ElementTree.parse(tmp_path / "drawing.svg").getroot().tag.endswith("svg")


NAME = b"x\xff" if sys.platform == "linux" else b"x"   # elsewhere, names are always Unicode


@pytest.mark.parametrize("call", [
    we.read, we.read_cloud, we.extract, lambda path: we.evaluate(path, we.Wireframe()),
    lambda path: we.extract(path, patches=True)])
def test_names_that_are_no_unicode(call, tmp_path):
    path = os.fsencode(tmp_path) + b"/" + NAME + b".json"
    with open(path, "w") as file:
        file.write("no number")
    with pytest.raises(ValueError, match="x.*json"):
        call(path)


def test_written_names_that_are_no_unicode(box_wireframe, tmp_path):
    for extension in (b".html", b".json", b".csv"):
        box_wireframe.write(os.fsencode(tmp_path) + b"/" + NAME + extension)
    assert len(os.listdir(tmp_path)) == 3
    for path in (os.fsencode(tmp_path) + b"/" + NAME, os.fsencode(tmp_path) + b"/" + NAME + b"/a.json"):
        with pytest.raises((ValueError, OSError)) as raised:
            box_wireframe.write(path)
        assert "x" in str(raised.value)


def test_names_like_options(tmp_path):
    path = tmp_path / "a--mesh cad--b-c.xyz"
    path.write_text("no number\n")
    for call in (we.extract, we.read_cloud):
        with pytest.raises(ValueError) as raised:
            call(path)
        assert str(path) in str(raised.value)


@pytest.mark.parametrize("name, number", [
    ("missing/a.json", errno.ENOENT), ("missing/a.step", errno.ENOENT), ("missing/a.html", errno.ENOENT),
    ("folder.json", errno.EISDIR), ("folder.html", errno.EISDIR), ("file/a.obj", errno.ENOTDIR)])
def test_errors_of_the_system(box_wireframe, name, number, tmp_path):
    (tmp_path / "folder.json").mkdir()
    (tmp_path / "folder.html").mkdir()
    (tmp_path / "file").touch()
    with pytest.raises(OSError) as raised:
        box_wireframe.write(tmp_path / name)
    assert raised.value.errno == number and os.fspath(raised.value.filename) == str(tmp_path / name)
    assert sorted(os.listdir(tmp_path)) == ["file", "folder.html", "folder.json"]


@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() == 0, reason="root may read everything")
def test_file_that_may_not_be_read(tmp_path):
    (tmp_path / "a.json").touch(mode=0)
    for call in (we.read, we.read_cloud, we.extract):
        with pytest.raises(PermissionError):
            call(tmp_path / "a.json")


def test_folder_in_place_of_a_file(tmp_path):
    for call in (we.read, we.read_cloud, we.extract, lambda path: we.evaluate(path, we.Wireframe())):
        with pytest.raises(IsADirectoryError):
            call(tmp_path)


@pytest.mark.parametrize("name, arguments, error, text", [
    ("a.obj", {"obj_splines": "no"}, TypeError, "obj_splines is 'no'"), ("a.json", {"step": 0.1}, ValueError, "step"),
    ("a.json", {"schema": "ap242"}, ValueError, ".step"), ("a.obj", {"dxf_splines": True}, ValueError, ".dxf"),
    ("a.dxf", {"dxf_splines": 1}, TypeError, "dxf_splines is 1"),
    ("a.svg", {"chord_tolerance": 0.1}, ValueError, "chord_tolerance"),
    ("a.ply", {"chord_tolerance": -1.0}, ValueError, "positive"),
    ("a.ply", {"chord_tolerance": 1e-300}, ValueError, "give a larger chord_tolerance"),
    ("a.ply", {"obj_splines": True}, ValueError, ".obj")])
def test_arguments_without_effect(box_wireframe, name, arguments, error, text, tmp_path):
    with pytest.raises(error, match=text):
        box_wireframe.write(tmp_path / name, **arguments)
    assert not os.listdir(tmp_path)


def test_empty_wireframe(tmp_path):
    with pytest.raises(ValueError, match="no curve"):
        we.Wireframe().write(tmp_path / "a.step")


def test_page_arguments(box_wireframe):
    with pytest.raises(ValueError, match="unit is 'parsec'"):
        box_wireframe.to_html(unit="parsec")
    with pytest.raises(TypeError, match="title is None"):
        box_wireframe.to_html(title=None)


def test_what_a_reader_tells(cylinder, tmp_path):
    np.savetxt(tmp_path / "cloud.xyz", np.column_stack(cylinder))
    cloud = we.read_cloud(tmp_path / "cloud.xyz")
    assert len(cloud) == 2 and cloud.note == we.extract(tmp_path / "cloud.xyz").report.note
    np.savetxt(tmp_path / "bad.xyz", np.column_stack([cylinder[0][:3] * [[np.nan], [1], [1]], cylinder[1][:3]]))
    bad = we.read_cloud(tmp_path / "bad.xyz", skip_invalid=True)
    assert bad.number_of_skipped_points == 1 and len(bad.points) == 2
