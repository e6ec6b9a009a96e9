"""Stage by stage: what is in between, and an own result in the middle."""

import pathlib
import sys

import numpy

import wireframe_extraction

DATA = pathlib.Path(__file__).resolve().parent.parent / "data"
path = sys.argv[1] if len(sys.argv) > 1 else DATA / "box_with_hole.ply"

# of the graph of the published method, every cluster is a curve; by default, curves are traced through the field
cloud = wireframe_extraction.read_cloud(path)
extractor = wireframe_extraction.Extractor(*cloud, graph_method="subdivided")
print("sampling distance", extractor.sampling_distance)
print("skeleton", len(extractor.skeleton.points), "points, noise of the field", extractor.feet.noise)
print("corners", [numpy.round(corner.center, 3).tolist() for corner in extractor.corners])
print("clusters", [len(cluster) for cluster in extractor.clusters])
print("graph", len(extractor.graph.vertices), "vertices,", len(extractor.graph.edges), "edges")
print("splines", extractor.curves)
print("typed", extractor.wireframe)

# only what the largest cluster has: the stages after it run again
extractor.clusters = [max(extractor.clusters, key=len)]
print("of one cluster", extractor.wireframe)
