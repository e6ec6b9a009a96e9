"""From arrays to a wireframe, and what it has."""

import pathlib
import sys

import wireframe_extraction

DATA = pathlib.Path(__file__).resolve().parent.parent / "data"
path = sys.argv[1] if len(sys.argv) > 1 else DATA / "box_with_hole.ply"

points, distances = wireframe_extraction.read_cloud(path)   # or arrays of your own; distances may be None
wireframe = wireframe_extraction.extract(points, distances)

print(wireframe)
for curve in wireframe.curves:
    print(curve)
    if curve.type == "circle":
        print("  center", curve.center, "axis", curve.axis, "+-", curve.uncertainty["position"])

curve = wireframe.curves[0]
begin, end = curve.range
print("its middle", curve(0.5 * (begin + end)), "and tangent", curve.tangent(0.5 * (begin + end)))
print("largest distance of a vertex to the curves", wireframe.distance(wireframe.vertices).max())
wireframe.write("wireframe.json")
