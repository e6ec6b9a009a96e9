#!/usr/bin/python3
"""Draws the curves of a STEP, IGES or BREP file as FreeCAD shows them, coloured by type, as a PNG.

Needs FreeCAD and a display (Debian: freecad xvfb), thus on a machine without one: xvfb-run draw_step.py PART.step OUT.png
"""

import argparse
import os
import sys

COLOURS = {"Line": (0.10, 0.35, 0.75), "Circle": (0.80, 0.25, 0.10), "Ellipse": (0.15, 0.55, 0.25),
           "BSplineCurve": (0.50, 0.30, 0.60)}


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("part", help="the file with the curves")
    parser.add_argument("output", help="the PNG to write")
    parser.add_argument("--freecad", default="/usr/lib/freecad-python3/lib", help="the folder of FreeCAD's modules")
    arguments = parser.parse_args()
    sys.path.append(arguments.freecad)
    try:
        import FreeCAD
        import FreeCADGui
        import Part
    except ImportError as error:
        sys.exit(f"draw_step.py: {error}; it needs FreeCAD (Debian: freecad)")
    FreeCADGui.showMainWindow()
    document = FreeCAD.newDocument("wireframe")
    shape = Part.Shape()
    shape.read(arguments.part)
    for edge in shape.Edges:
        feature = document.addObject("Part::Feature", "edge")
        feature.Shape = edge
        feature.ViewObject.LineWidth = 4
        feature.ViewObject.PointSize = 7
        feature.ViewObject.LineColor = COLOURS.get(type(edge.Curve).__name__, (0, 0, 0))
    document.recompute()
    view = FreeCADGui.activeDocument().activeView()
    view.setCameraType("Orthographic")
    view.viewIsometric()
    view.fitAll()
    FreeCADGui.updateGui()
    view.saveImage(arguments.output, 900, 520, "White")
    sys.stdout.flush()
    os._exit(0)  # without a user there is nobody to close the window


if __name__ == "__main__":
    main()
