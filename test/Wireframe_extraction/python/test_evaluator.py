"""The scores of evaluate() against those of the program."""

import json
import math
import subprocess

from conftest import program

import wireframe_extraction as we


def test_scores(tmp_path, evaluator):
    make_cloud = program("make_cloud")
    truth = tmp_path / "truth.json"
    subprocess.run([make_cloud, "box_with_hole", "-o", tmp_path / "cloud.ply", "--truth", truth], check=True,
                   stdout=subprocess.DEVNULL)
    wireframe = we.extract(tmp_path / "cloud.ply")
    wireframe.write(tmp_path / "wireframe.json")
    done = subprocess.run([evaluator, truth, tmp_path / "wireframe.json", "--json"], check=True,
                          stdout=subprocess.PIPE)
    expected = json.loads(done.stdout)
    scores = we.evaluate(truth, wireframe)
    assert list(scores) == list(expected)
    for name, value in expected.items():
        assert scores[name] == value or (value is None and (scores[name] is None or math.isnan(scores[name]))), name
