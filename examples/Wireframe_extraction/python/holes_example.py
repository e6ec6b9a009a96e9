"""A table of the holes of a part: their places, axes and diameters, with uncertainties."""

import pathlib
import sys

import wireframe_extraction

DATA = pathlib.Path(__file__).resolve().parent.parent / "data"
path = sys.argv[1] if len(sys.argv) > 1 else DATA / "box_with_hole.ply"

table = wireframe_extraction.extract(path).to_pandas()
holes = table[table["type"] == "circle"]
holes = holes.assign(diameter=2 * holes["major_radius"], plus_minus=2 * holes["major_radius_uncertainty"])
print(holes[["center_x", "center_y", "center_z", "diameter", "plus_minus"]].to_string())
