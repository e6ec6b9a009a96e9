"""What other libraries get, and what notebooks show."""

import csv
import json
import math
import sys
import types

import numpy as np
import pytest
import shapes

import wireframe_extraction as we


def test_networkx(box_wireframe, cylinder):
    networkx = pytest.importorskip("networkx")
    graph = box_wireframe.to_networkx()
    assert isinstance(graph, networkx.MultiGraph) and graph.number_of_nodes() == 8 and graph.number_of_edges() == 12
    assert graph.graph["closed_curves"] == [curve.index for curve in box_wireframe.curves if curve.closed]
    assert all(degree == 3 for _, degree in graph.degree())
    for source, target, key, values in graph.edges(keys=True, data=True):
        assert set(box_wireframe.edges[key]) == {source, target} and values["curve"].index == key
        assert values["length"] == values["curve"].length and values["type"] == "line"
    assert np.array_equal([graph.nodes[i]["pos"] for i in range(8)], box_wireframe.vertices)


def test_pandas(box_wireframe, tmp_path):
    pytest.importorskip("pandas")
    table = box_wireframe.to_pandas()
    box_wireframe.write(tmp_path / "table.csv")
    with open(tmp_path / "table.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    assert ["index", *table.columns] == list(rows[0])
    for row, (index, values) in zip(rows, table.iterrows()):
        assert int(row["index"]) == index
        for name, value in values.items():
            if row[name] == "" and name != "doubts":
                assert str(value) in ("nan", "<NA>"), name
            elif name in ("type", "doubts"):
                assert row[name] == value
            elif name in ("closed", "doubtful"):
                assert row[name] == str(value).lower()
            else:
                assert float(row[name]) == pytest.approx(float(value), rel=1e-12), name
    holes = table[table.type == "circle"]
    assert len(holes) == 2 and holes.major_radius.notna().all()
    assert table.doubtful.dtype == bool and table.doubtful.tolist() == box_wireframe.doubtful.tolist()
    assert list(we.Wireframe().to_pandas().columns) == list(table.columns)


def test_pyvista(box_wireframe, monkeypatch):
    class Poly_data:
        def __init__(self, points, lines):
            self.points, self.lines, self.cell_data = points, lines, {}
    monkeypatch.setitem(sys.modules, "pyvista", types.SimpleNamespace(PolyData=Poly_data))
    data = box_wireframe.to_pyvista(0.1)
    place, lines = 0, []
    while place < len(data.lines):
        count = data.lines[place]
        lines.append(data.points[data.lines[place + 1:place + 1 + count]])
        place += 1 + count
    assert len(lines) == 14
    for line, curve in zip(lines, box_wireframe.curves):
        assert np.array_equal(line, curve.sample(0.1))
    assert data.cell_data["type"].tolist() == box_wireframe.types.tolist()
    assert not data.cell_data["doubtful"].any()


def test_matplotlib(box_wireframe, box):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    axes = box_wireframe.plot(points=box.points)
    assert len(axes.lines) == 14
    assert box_wireframe.plot(axes) is axes and len(axes.lines) == 28
    we.Wireframe().plot()
    from matplotlib import pyplot
    with pytest.raises(TypeError, match="projection='3d'"):
        box_wireframe.plot(pyplot.figure().add_subplot())
    pyplot.close("all")


@pytest.mark.parametrize("name, call", [
    ("pandas", lambda w: w.to_pandas()), ("networkx", lambda w: w.to_networkx()), ("pyvista", lambda w: w.to_pyvista()),
    ("matplotlib", lambda w: w.plot())])
def test_missing_library(box_wireframe, monkeypatch, name, call):
    for module in (name, f"{name}.pyplot"):
        monkeypatch.setitem(sys.modules, module, None)
    with pytest.raises(ImportError, match=f"needs {name}.*pip install {name}"):
        call(box_wireframe)


def test_html(box_wireframe, box):
    frame = box_wireframe._repr_html_()
    assert "14" in frame or "srcdoc" in frame
    page = box_wireframe.to_html(title="a <b>")
    assert page.lower().startswith("<!doctype html>") and "<b>" not in page.split("</head>")[0]
    larger = box_wireframe.to_html(*box)
    if we._core.has_viewer():
        assert len(larger) > len(page) and "@WIREFRAME_DATA@" not in page
    assert "none" in we.Wireframe()._repr_html_()
    with pytest.raises(ValueError, match="distances goes with points"):
        box_wireframe.to_html(distances=box.distances)


def test_html_without_viewer(box_wireframe, monkeypatch):
    monkeypatch.setattr(we._core, "has_viewer", lambda: False)
    frame = box_wireframe._repr_html_()
    assert "<svg" in frame and "2 circle, 12 line" in frame


def test_sample(box_wireframe):
    points, curves = box_wireframe.sample(0.05)
    assert points.shape == (len(curves), 3) and set(curves) == set(range(14))
    for curve in box_wireframe.curves:
        assert np.array_equal(points[curves == curve.index], curve.sample(0.05))
    default, _ = box_wireframe.sample()
    assert len(default) > sum(curve.length for curve in box_wireframe.curves) / box_wireframe.sampling_distance


def test_distance(box_wireframe):
    queries = np.random.default_rng(6).uniform(-1, 1, (300, 3))
    expected = np.min([curve.closest(queries).distances for curve in box_wireframe.curves], axis=0)
    assert np.array_equal(box_wireframe.distance(queries), expected)
    assert box_wireframe.distance(queries[0]).shape == (1,) and box_wireframe.distance(np.empty((0, 3))).shape == (0,)


def test_networkx_in_files(box_wireframe, tmp_path):
    networkx = pytest.importorskip("networkx")
    graph = box_wireframe.to_networkx(plain=True)
    networkx.write_graphml(graph, tmp_path / "graph.graphml")
    read = networkx.read_graphml(tmp_path / "graph.graphml", node_type=int)
    assert networkx.is_isomorphic(read, graph) and len(read.graph["closed_curves"].split()) == 2
    assert [read.nodes[0][axis] for axis in "xyz"] == pytest.approx(box_wireframe.vertices[0].tolist())
    json.dumps(networkx.node_link_data(graph))


def test_plot_that_fails(box_wireframe):
    pyplot = pytest.importorskip("matplotlib.pyplot")
    before = pyplot.get_fignums()
    with pytest.raises(ValueError, match="n, 3"):
        box_wireframe.plot(points=np.zeros((5, 2)))
    assert pyplot.get_fignums() == before


def test_nothing_can_be_changed(box_wireframe):
    for thing, name in ((box_wireframe, "curves"), (box_wireframe, "vertices"), (box_wireframe.curves[0], "length"),
                        (box_wireframe.curves[0], "doubts")):
        with pytest.raises(AttributeError):
            setattr(thing, name, ())


def test_evaluate(box_wireframe, tmp_path):
    same = we.evaluate(box_wireframe, box_wireframe)
    assert same["failure"] is None and same["curve_f1"] == same["corner_recall"] == 1
    assert same["chamfer_distance"] < 1e-12
    path = shapes.write(tmp_path / "line.json", [(0, 0, 0), (1, 0, 0)], [shapes.line((0, 0, 0), (1, 0, 0))])
    other = we.evaluate(box_wireframe, we.read(path))
    assert other["curve_recall"] < 0.5 and math.isfinite(other["hausdorff_distance"])
    assert we.evaluate(box_wireframe, we.Wireframe())["failure"] == "there is no curve"
    np.testing.assert_equal(we.evaluate(path, box_wireframe), we.evaluate(we.read(path), box_wireframe))
    (tmp_path / "bad.json").write_text("{}")
    for truth, text in ((we.Wireframe(), "no curve"), (tmp_path / "bad.json", "bad.json")):
        with pytest.raises(ValueError, match=text):
            we.evaluate(truth, box_wireframe)
    with pytest.raises(FileNotFoundError):
        we.evaluate("missing.json", box_wireframe)
    with pytest.raises(TypeError, match="ndarray"):
        we.evaluate(box_wireframe, np.zeros(3))
