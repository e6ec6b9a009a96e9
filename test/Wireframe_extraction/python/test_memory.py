"""Large arrays are not copied, and nothing is kept that nobody wants."""

import os
import pathlib
import subprocess
import sys

import numpy as np
import pytest
from conftest import make_cylinder

import wireframe_extraction as we

STATUS = pathlib.Path("/proc/self/status")
pytestmark = pytest.mark.skipif(not STATUS.exists(), reason="needs Linux")

# In a process of its own, where nothing was freed before that could be used again: prints how many bytes the memory
# grew at most, and how many the arrays have.
LARGE_CLOUD = """
import pathlib
import numpy as np
from conftest import make_cylinder
import wireframe_extraction as we
from test_memory import memory

points, distances = make_cylinder({number})
table = np.zeros((6, {number}), dtype="{dtype}").T
table[:, :3], table[:, 4] = points, distances
size = points.nbytes + distances.nbytes
del points, distances
we.extract(*make_cylinder(1000))
pathlib.Path("/proc/self/clear_refs").write_text("5")
before = memory("VmRSS")
we.extract(table[:, :3], table[:, 4], points_in_memory=100000)
print(memory("VmHWM") - before, size)
"""


def memory(name):
    """Return VmRSS, or VmHWM, which is the most since it was reset, in bytes."""
    line = next(line for line in STATUS.read_text().splitlines() if line.startswith(name))
    return 1024 * int(line.split()[1])


# f4 shows copies of both kinds, of what is converted and of what is not side by side
@pytest.mark.parametrize("dtype", ["f4", "f8"] if "WIREFRAME_EXTRACTION_LARGE_CLOUD" in os.environ else ["f4"])
def test_large_cloud(dtype):
    number = int(os.environ.get("WIREFRAME_EXTRACTION_LARGE_CLOUD", 2000000))
    done = subprocess.run([sys.executable, "-c", LARGE_CLOUD.format(number=number, dtype=dtype)], check=True,
                          cwd=pathlib.Path(__file__).parent, stdout=subprocess.PIPE, encoding="utf-8")
    growth, size = map(int, done.stdout.split())
    print(f"{number} points of {dtype}: {growth / 1e6:.0f} MB more, {size / 1e6:.0f} MB would be a copy")
    assert growth < 0.6 * size


def test_nothing_leaks(data, tmp_path):
    points, distances = make_cylinder(400)
    wireframe = we.extract(points, distances)
    wireframe.write(tmp_path / "wireframe.json")

    def use():
        one = we.read(tmp_path / "wireframe.json")
        one.curves[0](np.linspace(0, 1, 100)), one.curves[0].knots, one.vertices, one.distance(points[:5])
        one.sample(0.1)
        for arguments in ((points[:, :2],), (points, distances[1:]), (points * np.nan,)):
            with pytest.raises(ValueError):
                we.extract(*arguments)

    def extract():
        we.extract(points, distances, threads=1)

    calls = int(os.environ.get("WIREFRAME_EXTRACTION_CALLS", 300))
    for work, number in ((use, calls), (extract, calls // 10 if calls < 1000 else calls)):
        for _ in range(10):
            work()
        before = memory("VmRSS")
        for _ in range(number):
            work()
        growth = memory("VmRSS") - before
        print(f"{number} calls of {work.__name__}(): {growth / 1e6:.2f} MB more")
        assert growth < 1e6, work.__name__
