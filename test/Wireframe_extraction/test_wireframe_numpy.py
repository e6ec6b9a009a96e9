#!/usr/bin/env python3
"""Tests that the tool extract_wireframe reads clouds as NumPy and, if it is there, h5py write them.

usage: test_wireframe_numpy.py EXTRACT_WIREFRAME MAKE_CLOUD [options of unittest]
"""

import json
import os
import unittest

import numpy

try:
    import h5py
except ImportError:
    h5py = None

from program_test import BAD_INPUT, USAGE_ERROR, Program_test, main, read_cloud, without_provenance

WITH_HDF5 = os.environ.get("EXTRACT_WIREFRAME_WITH_HDF5") == "1"   # whether the tool is built with these
WITH_ZLIB = os.environ.get("EXTRACT_WIREFRAME_WITH_ZLIB") == "1"


class Numpy_test(Program_test):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.make_cloud("box.ply", "box", "--points", 5000)
        cls.cloud = numpy.array(read_cloud(cls.shared / "box.ply"))
        cls.points, cls.distances = cls.cloud[:, :3], cls.cloud[:, 3]
        # the order in which points come out of a fusion by positions
        cls.order = numpy.lexsort(cls.points.T[::-1])
        cls.expected = cls.wireframe_of("box.ply")
        numpy.save(cls.shared / "sorted.npy", cls.cloud[cls.order])
        cls.expected_sorted = cls.wireframe_of("sorted.npy")

    @classmethod
    def wireframe_of(cls, name):
        done = cls.execute(cls.shared, name, "-o", "out.json")
        assert done.returncode == 0, done.stderr
        return json.loads(without_provenance((cls.shared / "out.json").read_text()))

    def check(self, *arguments, expected=None):
        """The tool finds the wireframe of the box, also if it reads the file several times; returns what it said."""
        for memory in ((), ("--points-in-memory", 900)):
            done = self.execute(self.folder, *arguments, *memory, "-o", "out.json")
            self.assertEqual((done.returncode, done.stderr), (0, ""), done.args)
            self.assertEqual(json.loads(without_provenance((self.folder / "out.json").read_text())), expected or self.expected)
        return done.stdout

    def refuse(self, exit_code, words, *arguments):
        done = self.execute(self.folder, *arguments, "-o", "none.json")
        self.assertEqual(done.returncode, exit_code, (done.args, done.stderr))
        self.assertRegex(done.stderr, r"\Aextract_wireframe: error: [^\n]+\n\Z")
        for word in words:
            self.assertIn(word, done.stderr)
        self.assertFalse((self.folder / "none.json").exists())

    def test_npy(self):
        for number, array in enumerate((self.cloud, self.cloud.astype(">f8"), self.cloud.astype("<f4"),
                                        numpy.asfortranarray(self.cloud.astype(">f4")))):
            numpy.save(self.folder / f"{number}.npy", array)
            self.check(f"{number}.npy")
        numpy.save(self.folder / "points.npy", self.points)
        numpy.save(self.folder / "distances.npy", self.distances)
        self.check("points.npy", "--distances", "distances.npy")
        self.refuse(BAD_INPUT, ["points.npy", "no distances"], "points.npy", "--field", "given")
        numpy.save(self.folder / "objects.npy", numpy.array([[1, "a", None]], dtype=object))
        self.refuse(BAD_INPUT, ["objects.npy", "Python objects"], "objects.npy")

    def structured(self, text="U3"):
        """The cloud as an array of structures, with what is no number among them."""
        array = numpy.zeros(len(self.cloud), [("label", text), ("distance", "f4"), ("x", ">f8"), ("y", "f4"), ("z", "f8"),
                                              ("normal", "f4", (3,)), ("is_seen", "?")])
        for name, values in zip(("x", "y", "z", "distance"), self.cloud.T):
            array[name] = values
        return array

    def test_structures(self):
        numpy.save(self.folder / "fields.npy", self.structured())
        self.check("fields.npy")
        numpy.savez(self.folder / "fields.npz", cloud=self.structured())
        self.assertIn("\"cloud\" is taken for the points", self.check("fields.npz"))
        self.refuse(BAD_INPUT, ["\"own\"", "normal:2"], "fields.npy", "--coordinates", "x,y,own")

    def test_half_precision(self):
        numpy.save(self.folder / "half.npy", self.cloud.astype("f2"))
        numpy.save(self.folder / "same.npy", self.cloud.astype("f2").astype("f8"))
        results = []
        for name in ("half.npy", "same.npy"):
            self.run_tool(name, "-o", "out.json")
            results.append(without_provenance((self.folder / "out.json").read_text()))
        self.assertEqual(*results)

    def test_columns(self):
        columns = numpy.column_stack([self.distances, self.points[:, ::-1]])
        numpy.save(self.folder / "columns.npy", columns)
        self.check("columns.npy", "--coordinates", "4,3,2", "--distance-property", "1")
        numpy.savez(self.folder / "four.npz", self.cloud)
        self.check("four.npz")
        text = "\n".join(" ".join(map(repr, row)) for row in columns.tolist())
        (self.folder / "columns.txt").write_text(text)
        self.check("columns.txt", "--coordinates", "4,3,2")
        self.check("columns.txt", "--coordinates", "4,3,2", "--distance-property", "1")
        (self.folder / "named.csv").write_text("u,v,w,t\n" + text.replace(" ", ","))
        self.check("named.csv", "--coordinates", "t,w,v", "--distance-property", "u")
        for bad in ("1,2", "1,2,2", "x", "", "1,,2", "1,2,3,4"):
            self.refuse(USAGE_ERROR, ["--coordinates"], "columns.txt", "--coordinates", bad)
        self.refuse(BAD_INPUT, ["\"5\"", "--coordinates"], "columns.txt", "--coordinates", "1,2,5")
        self.refuse(BAD_INPUT, ["\"2\"", "--distance-property"], "columns.txt", "--coordinates", "4,3,2",
                    "--distance-property", "2")
        self.refuse(BAD_INPUT, ["\"q\"", "u, v, w, t"], "named.csv", "--coordinates", "u,v,q")

    def test_npz(self):
        numpy.savez(self.folder / "a.npz", points=self.points, distances=self.distances, has_sharp=True)
        self.check("a.npz")
        numpy.savez(self.folder / "b.npz", xyz=self.points.reshape(10, -1, 3), d=self.distances.reshape(10, -1))
        self.check("b.npz", "--points-dataset", "xyz", "--distances-dataset", "d")
        self.refuse(BAD_INPUT, ["b.npz", "xyz, d", "--points-dataset"], "b.npz")
        self.refuse(BAD_INPUT, ["b.npz", "sharpness", "--distances-dataset"], "b.npz", "--points-dataset", "xyz",
                    "--field", "given")
        numpy.savez_compressed(self.folder / "c.npz", points=self.points, distances=self.distances)
        if WITH_ZLIB:
            self.check("c.npz")
        else:
            self.refuse(BAD_INPUT, ["c.npz", "zlib1g-dev"], "c.npz")

    def test_without_distances(self):
        numpy.save(self.folder / "raw.npy", self.points)
        numpy.savez(self.folder / "raw.npz", points=self.points)
        numpy.savez(self.folder / "patches.npz", points=self.points.reshape(10, -1, 3), other=self.distances)
        results = []
        for name in ("raw.npy", "raw.npz", "patches.npz"):
            self.assertIn("estimated from the points", self.run_tool(name, "-o", "raw.json"))
            results.append(without_provenance((self.folder / "raw.json").read_text()))
        self.assertEqual(results, results[:1] * 3)
        self.refuse(BAD_INPUT, ["patches.npz", "points, other", "--field"], "patches.npz", "--field", "given")

    def test_other_formats(self):
        rows = self.cloud.astype("<f8").tobytes()
        header = ("VERSION 0.7\nFIELDS x y z sharpness\nSIZE 8 8 8 8\nTYPE F F F F\nCOUNT 1 1 1 1\nWIDTH 5000\nHEIGHT 1\n"
                  "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 5000\nDATA binary\n")
        (self.folder / "cloud.pcd").write_bytes(header.encode() + rows)
        self.check("cloud.pcd")
        self.check("cloud.pcd", "--distance-property", "sharpness")
        self.refuse(BAD_INPUT, ["cloud.pcd", "\"own\"", "x, y, z, sharpness"], "cloud.pcd", "--distance-property", "own")
        (self.folder / "cut.pcd").write_bytes(header.encode() + rows[:-1])
        self.refuse(BAD_INPUT, ["cut.pcd", "5000 points", "truncated"], "cut.pcd")
        lines = "".join(" ".join(map(repr, row)) + "\n" for row in self.points.tolist())
        (self.folder / "mesh.off").write_text("OFF\n5000 1 0\n" + lines + "3 0 1 2\n")
        numpy.savez(self.folder / "d.npz", prediction=self.distances)
        self.check("mesh.off", "--distances", "d.npz", "--distances-dataset", "prediction")
        self.refuse(BAD_INPUT, ["mesh.off", "no distances"], "mesh.off", "--mesh", "scan", "--field", "given")
        self.refuse(BAD_INPUT, ["d.npz", "prediction", "--distances-dataset"], "mesh.off", "--distances", "d.npz")

    def patches(self, count=6):
        """Parts that overlap, as indices; and the distances of each, which are far near its borders."""
        generator = numpy.random.default_rng(5)
        parts = []
        for i in range(count):
            center = self.points[generator.integers(len(self.points))]
            parts.append(numpy.argsort(numpy.linalg.norm(self.points - center, axis=1))[:1500])
        parts.append(numpy.arange(len(self.points)))   # so that no point is missing
        values = [self.distances[part].copy() for part in parts]
        for value in values[:-1]:
            value[1200:] = 1
        return parts, values

    def test_patches(self):
        names, own_names = [], []
        for i, (part, value) in enumerate(zip(*self.patches())):
            numpy.savez(self.folder / f"{i}.npz", points=self.points[part], distances=value, indices=part)
            numpy.savez(self.folder / f"own_{i}.npz", points=self.points[part], distances=value, own=part)
            names.append(f"{i}.npz")
            own_names.append(f"own_{i}.npz")
        said = self.check("--patches", *names)
        self.assertIn("14000 points, which were fused to 5000", said)
        self.check(*reversed(names), "--patches", "--fuse", "minimum")
        self.check("--patches", *own_names, "--indices-dataset", "own")
        self.check("--patches", *own_names, expected=self.expected_sorted)
        self.check(*reversed(names), "--patches", "--use-indices", "false", expected=self.expected_sorted)
        self.refuse(BAD_INPUT, ["own_0.npz", "\"none\"", "points, distances, own", "--indices-dataset"],
                    "--patches", *own_names, "--indices-dataset", "none")
        numpy.savez(self.folder / "local.npz", points=self.points[::-1], distances=self.distances,
                    indices=numpy.arange(len(self.points)))
        self.refuse(BAD_INPUT, ["0.npz", "whole cloud", "--indices-dataset", "--use-indices"],
                    "--patches", names[0], "local.npz")
        self.refuse(USAGE_ERROR, ["1.npz", "--patches"], "0.npz", "1.npz")
        self.refuse(USAGE_ERROR, ["--patches", "--distances"], "0.npz", "--patches", "--distances", "1.npz")
        self.refuse(USAGE_ERROR, ["mean", "minimum|median"], "0.npz", "--patches", "--fuse", "mean")
        self.refuse(USAGE_ERROR, ["1.txt", "same file"], "--patches", "0.npz", "./1.txt", "-o", "1.txt")

    def test_median(self):
        """One patch that is wrong is outvoted; the minimum believes it."""
        for i in range(3):
            value = self.distances.copy()
            if i == 1:
                value[:2500] = 0
            numpy.savez(self.folder / f"{i}.npz", points=self.points, distances=value, indices=numpy.arange(5000))
        self.check("--patches", "0.npz", "1.npz", "2.npz", "--fuse", "median")
        done = self.execute(self.folder, "--patches", "0.npz", "1.npz", "2.npz", "-o", "minimum.json")
        if done.returncode == 0:
            self.assertNotEqual(json.loads(without_provenance((self.folder / "minimum.json").read_text())), self.expected)

    @unittest.skipUnless(h5py and WITH_HDF5, "there is no h5py, or the tool is built without HDF5")
    def test_hdf5(self):
        for number, options in enumerate(({}, {"compression": "gzip"}, {"compression": "gzip", "shuffle": True},
                                             {"compression": "lzf"}, {"compression": "lzf", "shuffle": True})):
            with h5py.File(self.folder / f"{number}.h5", "w") as file:
                file.create_dataset("points", data=self.points.reshape(10, -1, 3), **options)
                file.create_dataset("distances", data=self.distances.reshape(10, -1), **options)
                file["item_id"] = "box"
            self.check(f"{number}.h5")
        for name, array in (("fields.h5", self.structured("S3")), ("four.h5", self.cloud)):
            with h5py.File(self.folder / name, "w") as file:
                file.create_dataset("cloud", data=array, compression="gzip", chunks=(500, *array.shape[1:]))
            self.assertIn("\"cloud\" is taken for the points", self.check(name))
        parts, values = self.patches()
        with h5py.File(self.folder / "rows.hdf5", "w") as file:
            for name, kind, rows in (("points", "f8", [self.points[part].ravel() for part in parts]),
                                     ("distances", "f8", values), ("indexes_in_whole", "i4", parts)):
                dataset = file.create_dataset(name, len(rows), dtype=h5py.vlen_dtype(kind))
                for i, row in enumerate(rows):
                    dataset[i] = row
        self.check("--patches", "rows.hdf5")
        self.refuse(BAD_INPUT, ["rows.hdf5", "indexes_in_whole (7)", "--points-dataset"], "rows.hdf5",
                    "--points-dataset", "vertices")

    @unittest.skipIf(WITH_HDF5, "the tool is built with HDF5")
    def test_without_hdf5(self):
        (self.folder / "cloud.h5").write_bytes(b"anything")
        self.refuse(BAD_INPUT, ["cloud.h5", "libhdf5-dev"], "cloud.h5")


if __name__ == "__main__":
    main("tool", "cloud_maker")
