#!/usr/bin/env python3
"""Tests how the source is laid out: that includes point downwards, that none is missing of what is compiled before,
that include guards equal paths, that C++ looks as .clang-format says, that no line is too long, that members have
the names of members, and that the tables of Wireframe_extraction/README.md tell where things are.

usage: test_wireframe_layout.py ROOT [options of unittest]
"""

import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

# Groups of headers from the bottom to the top. A header includes others of its own group and of lower rows; groups in
# one row do not know each other.
LAYERS = (
    ("internal/base",),
    ("internal/options", "internal/spline", "IO/internal/file"),
    ("internal/cloud", "internal/mesh", "IO/internal/cloud", "IO/internal/wireframe"),
    ("internal/estimate", "internal/skeleton", "IO/internal/mesh"),
    ("internal/fit", "IO"),
    ("internal/network", "internal/types"),
    ("internal/pipeline",),
    ("the stages",),       # public headers of functions
    ("the one call",),     # what stands in CGAL/ itself
)
RANKS = {group: rank for rank, row in enumerate(LAYERS) for group in row}
# Public headers of classes, and these, hold values. They belong to the highest group that they include, so that every
# group above may use them.
VALUES = "values"
NAMES_OF_VALUES = ("parameters.h", "policies.h")

FOLDERS = ("Wireframe_extraction", "test", "examples", "benchmark")   # of C++
# these are included several times, with other macros each time
WITHOUT_GUARD = ("CGAL/Wireframe_extraction/internal/options/parameters_interface.h",
                 "CGAL/Wireframe_extraction/internal/options/shared_parameters_interface.h")
CLANG_FORMAT_VERSION = 14
MOST_COLUMNS = 120   # as in .clang-format

# What the headers of the standard library give that a header of ours has to include by itself: headers_self_contained,
# which compiles each alone, has these precompiled.
STANDARD = {
    "algorithm": "all_of any_of binary_search clamp copy copy_if count_if equal fill find find_if for_each lower_bound "
                 "max max_element min min_element minmax minmax_element none_of nth_element partition remove remove_if "
                 "reverse rotate set_difference set_intersection sort stable_sort transform unique upper_bound",
    "array": "array", "atomic": "atomic", "bitset": "bitset", "chrono": "chrono",
    "cmath": "abs acos asin atan atan2 cbrt ceil cos exp floor fmod hypot isfinite isinf isnan log log2 pow round sin "
             "sqrt tan",
    "cstddef": "nullptr_t ptrdiff_t size_t",
    "cstdint": "int32_t int64_t int8_t uint16_t uint32_t uint64_t uint8_t",
    "cstdlib": "getenv strtod strtol", "cstring": "memcpy memset strerror strlen", "deque": "deque",
    "exception": "current_exception exception exception_ptr rethrow_exception", "filesystem": "filesystem",
    "fstream": "fstream ifstream ofstream", "functional": "function greater hash less ref",
    "iomanip": "setfill setprecision setw", "iostream": "cerr cin cout",
    "iterator": "advance back_inserter distance iterator_traits make_move_iterator next prev",
    "limits": "numeric_limits", "map": "map multimap", "memory": "make_shared make_unique shared_ptr unique_ptr weak_ptr",
    "mutex": "lock_guard mutex", "new": "bad_alloc", "numeric": "accumulate inner_product iota partial_sum",
    "optional": "nullopt optional", "queue": "priority_queue queue", "random": "mt19937 mt19937_64",
    "set": "multiset set", "sstream": "istringstream ostringstream stringstream",
    "stdexcept": "invalid_argument logic_error out_of_range runtime_error", "string": "stod stoi string to_string",
    "string_view": "string_view", "thread": "thread", "tuple": "forward_as_tuple tie tuple",
    "type_traits": "conditional_t decay_t enable_if enable_if_t false_type is_convertible is_same is_same_v "
                   "true_type",
    "unordered_map": "unordered_map", "unordered_set": "unordered_set",
    "utility": "declval exchange forward index_sequence make_pair move pair swap",
    "variant": "get_if monostate variant visit", "vector": "vector",
}
HEADER_OF = {name: header for header, names in STANDARD.items() for name in names.split()}
# The same for other libraries, of which a header of ours in between may include it.
OTHERS = (
    (r"\bEigen::", r"Eigen/|ceres/"),
    (r"\bboost::(adjacency_list|graph_traits|add_edge|vertices|edges|out_edges)\b", r"boost/graph/"),
    (r"\bsmall_vector\b", r"boost/container/small_vector\.hpp"),
    (r"\bSimple_cartesian\b", r"CGAL/Simple_cartesian\.h"),
    (r"\b(get_parameter|choose_parameter|Named_function_parameters)\b", r"CGAL/Named_function_parameters\.h"),
)


def includes_of(path):
    """Pairs of a line number and a header of this library, as it is included."""
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        match = re.match(r'\s*#\s*include\s*[<"](CGAL/[^>"]+)[>"]', line)
        if match:
            yield number, match[1]


def group_of(header):
    """The group of a header, given as CGAL/..."""
    parts = header.split("/")[1:]
    if parts[0] != "Wireframe_extraction":
        return "the one call"
    if len(parts) > 2:
        return "/".join(parts[1:-1])
    return VALUES if parts[1][0].isupper() or parts[1] in NAMES_OF_VALUES else "the stages"


class Library:
    """The headers of the library, and what they include of each other."""

    def __init__(self, root):
        self.folder = root / "Wireframe_extraction/include"
        self.sources = sorted((root / "Wireframe_extraction/src").glob("*.cpp"))
        paths = sorted(self.folder.rglob("*.h"))
        self.headers = {path.relative_to(self.folder).as_posix(): list(includes_of(path)) for path in paths}
        self.includes_of_others = {
            path.relative_to(self.folder).as_posix():
                set(re.findall(r"#\s*include <([^>]+)>", path.read_text(encoding="utf-8"))) for path in paths}
        for header, includes in self.headers.items():
            self.headers[header] = [(number, name) for number, name in includes if name in self.headers]

    def place(self, header, number):
        return f"Wireframe_extraction/include/{header}:{number}"

    def level_of(self, header, visited=()):
        """The group of a header; of values, the highest of those that they need."""
        group = group_of(header)
        if group != VALUES:
            return group
        levels = [self.level_of(name, (*visited, header)) for _, name in self.headers[header] if name not in visited]
        return max((level for level in levels if level != VALUES), key=RANKS.get, default=VALUES)

    def unknown_groups(self):
        for header in self.headers:
            group = group_of(header)
            if group != VALUES and group not in RANKS:
                yield f"{self.place(header, 1)}: there is no group {group}; move the header, or put it into LAYERS here"

    def rising_includes(self):
        for header, includes in self.headers.items():
            own = group_of(header)
            for number, name in includes:
                other = self.level_of(name)
                if problem := self.problem_between(own, other):
                    yield (f"{self.place(header, number)}: {own} includes <{name}> of {other}, {problem}; move what is "
                           f"needed down, or have it handed over by who calls")

    @staticmethod
    def problem_between(own, other):
        if other in (VALUES, own):
            return ""
        if own == VALUES:
            return "and a class needs no function for its users" if RANKS[other] >= RANKS["the stages"] else ""
        if own.startswith("internal/") and other.startswith("IO"):
            return "but the method knows no files"
        if RANKS[own] < RANKS[other]:
            return "which is above it"
        return "which is beside it" if RANKS[own] == RANKS[other] else ""

    def stray_implementations(self):
        """Implementations that others include than their own header and what is compiled once."""
        for header, includes in self.headers.items():
            for number, name in includes:
                if name.endswith("_impl.h") and name != header[:-len(".h")] + "_impl.h":
                    yield (f"{self.place(header, number)}: includes <{name}>, which only its own header may; include "
                           f"<{name.replace('_impl.h', '.h')}>")

    def circles(self):
        """Headers that include each other, but for an implementation that includes its own header."""
        done, path = set(), []

        def visit(header):
            if header in path:
                yield " > ".join([*path[path.index(header):], header])
                return
            if header in done:
                return
            path.append(header)
            for _, name in self.headers[header]:
                if name != header[:-len(".h")] + "_impl.h":
                    yield from visit(name)
            path.pop()
            done.add(header)

        for header in self.headers:
            for circle in visit(header):
                yield f"{self.place(circle.split(' > ')[0], 1)}: a circle, {circle}; take out what both need"

    def uncompiled_implementations(self):
        compiled = {name for source in self.sources for _, name in includes_of(source)}
        for header in self.headers:
            if header.endswith("_impl.h") and header not in compiled:
                yield f"{self.place(header, 1)}: no file in Wireframe_extraction/src/ includes it; one has to"

    def wrong_guards(self):
        for header in self.headers:
            if header in WITHOUT_GUARD:
                continue
            guard = re.sub(r"\W", "_", header).upper()
            text = (self.folder / header).read_text(encoding="utf-8")
            if f"#ifndef {guard}\n#define {guard}\n" not in text or not text.endswith(f"#endif // {guard}\n"):
                yield f"{self.place(header, 1)}: its include guard has to be {guard}, also behind its #endif"

    def own_header(self, header):
        """Of an implementation, the header that includes it."""
        return header.replace("_impl.h", ".h") if header.endswith("_impl.h") else header

    def reached(self, header, visited):
        """All that a header includes, itself and through others of ours."""
        if header not in visited:
            visited.add(header)
            yield from self.includes_of_others[header]
            for _, name in self.headers[header]:
                yield from self.reached(name, visited)

    def missing_includes(self):
        for header in self.headers:
            text = re.sub(r"//[^\n]*", "", (self.folder / header).read_text(encoding="utf-8"))
            given = self.includes_of_others[header] | self.includes_of_others.get(self.own_header(header), set())
            missing = {HEADER_OF[name]: "std::" + name for name in re.findall(r"\bstd::(\w+)", text)
                       if name in HEADER_OF}
            for name in sorted(set(missing) - given):
                yield f"{self.place(header, 1)}: lacks #include <{name}>, for {missing[name]}"
            for pattern, provider in OTHERS:
                used = re.search(pattern, text)
                if used and not any(re.match(provider, name) for name in self.reached(self.own_header(header), set())):
                    yield f"{self.place(header, 1)}: lacks an include of {provider}, for {used[0]}"

    def problems(self):
        problems = list(self.unknown_groups())
        if problems:
            return problems
        for check in (self.rising_includes, self.circles, self.stray_implementations, self.uncompiled_implementations,
                      self.wrong_guards, self.missing_includes):
            problems += check()
        return problems


class Map:
    """The tables of Wireframe_extraction/README.md, which tell what does the work of each stage and format."""

    NO_FORMATS = {"cloud/Chunked_cloud_reader.h"}   # what several readers are made of

    def __init__(self, library, root):
        self.library = library
        self.root = root
        self.sections = dict(re.findall(r"(?ms)^## (\w+)$(.*?)(?=^## |\Z)",
                                        (root / "Wireframe_extraction/README.md").read_text(encoding="utf-8")))

    def rows(self, section, heading):
        """The rows of the table whose first column has this heading: for each, the words in backticks of each cell."""
        table = re.search(rf"(?m)^\| {heading} \|.*\n\|[-|]+\n((?:\|.*\n)+)", self.sections[section])[1]
        return [[re.findall(r"`([^`]+)`", cell) for cell in line.strip("|").split("|")] for line in table.splitlines()]

    def reached(self, header):
        """All headers of this library that one includes, also through others."""
        found, new = set(), [header]
        while new:
            name = new.pop()
            if name not in found:
                found.add(name)
                new += [other for _, other in self.library.headers[name]]
        return found

    def untrue_stages(self):
        told = set()
        for _, public, workers in self.rows("Stages", "Stage"):
            header = f"CGAL/Wireframe_extraction/{public[0]}".replace("Wireframe_extraction/../", "")
            told.add(header)
            if header not in self.library.headers:
                yield f"there is no {header}"
                continue
            known = self.reached(header)
            yield from (f"{header} does not include internal/{worker}" for worker in workers
                        if f"CGAL/Wireframe_extraction/internal/{worker}" not in known)
        for header in self.library.headers:
            if group_of(header) == "the stages" and header not in told:
                yield f"the table of stages lacks {header}"

    def untrue_folders(self):
        told = [row[0][0].rstrip("/") for row in self.rows("Stages", "Folder")]
        there = {group[len("internal/"):] for group in RANKS if group.startswith("internal/")}
        if set(told) != there or len(told) != len(there):
            yield f"the table of folders has {told}, and there are {sorted(there)}"
        ranks = [RANKS.get("internal/" + folder, 0) for folder in told]
        if ranks != sorted(ranks):
            yield "the table of folders is not in the order in which they include each other"

    def untrue_formats(self):
        folder = pathlib.PurePosixPath("Wireframe_extraction/include/CGAL/Wireframe_extraction/IO")
        told = [{}, {}, {}, {}]   # of the columns: the extensions, and the files that go with each
        for extensions, *columns in self.rows("Formats", "Extensions"):
            for known, files in zip(told, columns):
                if files:
                    known.update(dict.fromkeys(extensions, files))
                for name in files:
                    if not (self.root / folder / "internal" / name).exists():
                        yield f"there is no {name} in {folder}/internal"
        columns = ("reads clouds", "reads meshes", "reads wireframes", "writes")
        for known, there, what in zip(told, self.formats(), columns):
            if set(known) != there:
                yield f"what {what} is told of {sorted(known)}, and there are {sorted(there)}"
        files = {name for column in told for names in column.values() for name in names}
        for path in sorted((self.root / folder / "internal").rglob("*.h")):
            name = f"{path.parent.name}/{path.name}"
            is_of_format = re.search(r"/(read_json|write_\w+)_impl\.h$|_reader\.h$", name)
            if is_of_format and name not in files | self.NO_FORMATS:
                yield f"the table of formats lacks {name}"

    def formats(self):
        """The extensions that the code has, in the order of the columns."""
        package = self.root / "Wireframe_extraction"
        internal = package / "include/CGAL/Wireframe_extraction/IO/internal"

        def found(path, pattern):
            return re.findall(pattern, path.read_text(encoding="utf-8"))

        written = found(internal / "file/file_tools.h", r"is_cad_extension[^{]*\{[^{]*\{([^}]*)\}")
        written += found(package / "tool/write_in_format.h", r"for \(const char\* const known :\s*\{([^}]*)\}")
        return (set(found(internal / "cloud/cloud_formats_impl.h", r'\{"(\.\w+)", Cloud_format::')),
                set(found(internal / "mesh/mesh_formats_impl.h", r'extension == "(\.\w+)" *\? Mesh_format::')),
                {".json"}, set(re.findall(r'"(\.\w+)"', "".join(written))))

    def twins(self):
        """Headers that are called alike, so that it has to be said which is meant, and calls of no public function."""
        names = {}
        for header in self.library.headers:
            name = header.split("/")[-1]
            if name.lower() in names:
                yield f"{header} is called as {names[name.lower()]}; call it another name"
            names[name.lower()] = header
        for name, header in names.items():
            if name.startswith("call_") and name[len("call_"):] not in names:
                yield f"{header}: there is no public header {name[len('call_'):]}"

    def problems(self):
        return [*self.untrue_stages(), *self.untrue_folders(), *self.untrue_formats(), *self.twins()]


def find_clang_format():
    """A clang-format of the version that the layout is of, or nothing; others lay some lines out differently."""
    for name in (f"clang-format-{CLANG_FORMAT_VERSION}", "clang-format"):
        program = shutil.which(name)
        if program:
            text = subprocess.run([program, "--version"], stdout=subprocess.PIPE, check=True, encoding="utf-8").stdout
            if f"version {CLANG_FORMAT_VERSION}." in text:
                return program
    return None


def badly_formatted(program, root, paths):
    done = subprocess.run([program, "--dry-run", "--Werror", f"--style=file:{root / '.clang-format'}", *map(str, paths)],
                          stderr=subprocess.PIPE, encoding="utf-8", check=False)
    return sorted({match[1] + ":" + match[2] for match in re.finditer(r"(?m)^(/[^:\n]+):(\d+):\d+: ", done.stderr)})


def long_lines(path):
    """The numbers of lines with too many columns: clang-format leaves comments as they are."""
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        if len(line) > MOST_COLUMNS:
            yield number


# what clang-format makes of data members without their values: a type, and names
DATA_MEMBER = re.compile(r"(?!(?:typedef|using|static|friend|enum|struct|class|template|return|explicit|CGAL_\w+)\b)"
                         r"(?:mutable |const )*[\w:]+(?:<.*>)?(?:::\w+)?(?: const)?[ *&]+(?:const )?(\w+(?:, \w+)*);")


def without_values(declaration):
    """A declaration without comment, initial values and bounds of arrays."""
    text = declaration.split(" //")[0]
    while re.search(r"[{[]", text):
        shorter = re.sub(r"( = )?(\{[^{}\[\]]*\}|\[[^{}\[\]]*\])", "", text)
        if shorter == text:
            return ""
        text = shorter
    return re.sub(r" = [^,;]+", "", text)


def badly_named_members(path):
    """Yields line number and name of data members of classes that are not public and do not start with m_. Those of
    structs are public."""
    lines = path.read_text(encoding="utf-8").splitlines()
    for begin, line in enumerate(lines[:-1]):
        head = re.match(r"( *)class \w[^;]*$", line)
        if not head or lines[begin + 1] != head[1] + "{":
            continue
        is_public = False
        for number, text in enumerate(lines[begin + 2:], begin + 3):
            if text == head[1] + "};":
                break
            section = re.match(re.escape(head[1]) + r"(public|private|protected):", text)
            is_public = section[1] == "public" if section else is_public
            indented = re.match(re.escape(head[1]) + r"  (\S.*)", text)
            member = indented and DATA_MEMBER.match(without_values(indented[1]))
            if member and not is_public:
                yield from ((number, name) for name in member[1].split(", ") if not name.startswith("m_"))


class Layout_test(unittest.TestCase):
    root = None   # set by main()
    maxDiff = None

    def sources(self):
        paths = [path for folder in FOLDERS for end in ("h", "cpp") for path in (self.root / folder).rglob("*." + end)]
        self.assertGreater(len(paths), 100)
        return paths

    def test_columns(self):
        self.assertEqual([], [f"{path}:{number}" for path in self.sources() for number in long_lines(path)],
                         f"more than {MOST_COLUMNS} columns")

    def test_names_of_members(self):
        self.assertEqual([], [f"{path}:{number}: {name}" for path in self.sources()
                              for number, name in badly_named_members(path)], "data members of classes start with m_")

    def test_library(self):
        self.assertEqual([], Library(self.root).problems())

    def test_map(self):
        self.assertEqual([], Map(Library(self.root), self.root).problems())

    def test_clang_format(self):
        program = find_clang_format()
        if not program:
            self.skipTest(f"there is no clang-format {CLANG_FORMAT_VERSION} (Debian 12: clang-format)")
        self.assertEqual([], badly_formatted(program, self.root, self.sources()), "lay them out with: clang-format -i FILE")


class Planted_test(unittest.TestCase):
    """What is not to be, put into a copy, is found."""

    def setUp(self):
        self.root = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        for folder in ("include", "src", "tool"):
            shutil.copytree(Layout_test.root / "Wireframe_extraction" / folder,
                            self.root / "Wireframe_extraction" / folder)
        shutil.copy(Layout_test.root / "Wireframe_extraction/README.md", self.root / "Wireframe_extraction")
        self.package = self.root / "Wireframe_extraction/include/CGAL/Wireframe_extraction"

    def enterContext(self, context):   # which unittest has since Python 3.11
        self.addCleanup(context.__exit__, None, None, None)
        return context.__enter__()

    def plant(self, header, *includes):
        """Adds includes in the third line of a header, and makes it if it is not there."""
        path = self.package / header
        guard = re.sub(r"\W", "_", f"CGAL/Wireframe_extraction/{header}").upper()
        path.parent.mkdir(parents=True, exist_ok=True)
        text = path.read_text() if path.exists() else f"#ifndef {guard}\n#define {guard}\n#endif // {guard}\n"
        lines = text.splitlines(keepends=True)
        lines[2:2] = [f"#include <CGAL/{name}>\n" for name in includes]
        path.write_text("".join(lines))

    def check_found(self, place, *words):
        problems = Library(self.root).problems()
        self.assertTrue(any(place in problem and all(word in problem for word in words) for problem in problems),
                        (place, words, problems))

    def test_nothing_planted(self):
        self.assertEqual([], Library(self.root).problems())

    def test_rising(self):
        for low, high in (("base", "options"), ("options", "cloud"), ("spline", "skeleton"), ("cloud", "skeleton"),
                          ("skeleton", "fit"), ("fit", "network"), ("fit", "types"), ("network", "pipeline")):
            with self.subTest(low=low):
                self.plant(f"internal/{high}/planted.h")
                self.plant(f"internal/{low}/Planted.h", f"Wireframe_extraction/internal/{high}/planted.h")
                self.check_found(f"internal/{low}/Planted.h:3", f"internal/{high}/planted.h", "above", "move")

    def test_beside(self):
        for one, other in (("internal/options", "internal/spline"), ("internal/types", "internal/network"),
                           ("IO/internal/cloud", "IO/internal/wireframe")):
            with self.subTest(one=one):
                self.plant(f"{other}/planted.h")
                self.plant(f"{one}/Planted.h", f"Wireframe_extraction/{other}/planted.h")
                self.check_found(f"{one}/Planted.h:3", "beside")

    def test_stage_from_below(self):
        self.plant("internal/pipeline/Planted.h", "Wireframe_extraction/fit_curves.h")
        self.plant("Planted.h", "Wireframe_extraction/fit_curves.h")
        self.plant("fit_curves.h", "extract_wireframe.h")
        self.check_found("pipeline/Planted.h:3", "the stages", "above")
        self.check_found("extraction/Planted.h:3", "the stages", "class")
        self.check_found("fit_curves.h:3", "the one call", "above")

    def test_value_hides_an_arrow(self):
        self.plant("Planted.h", "Wireframe_extraction/Hidden.h")
        self.plant("Hidden.h", "Wireframe_extraction/internal/fit/planted.h")
        self.plant("internal/fit/planted.h")
        self.plant("internal/skeleton/planted.h", "Wireframe_extraction/Planted.h")
        self.plant("internal/types/planted.h", "Wireframe_extraction/Planted.h")   # is above
        self.check_found("internal/skeleton/planted.h:3", "of internal/fit")
        self.assertEqual(1, len(Library(self.root).problems()))

    def test_files_in_the_method(self):
        self.plant("IO/internal/file/planted.h")
        self.plant("internal/network/Planted.h", "Wireframe_extraction/IO/internal/file/planted.h")
        self.check_found("internal/network/Planted.h:3", "files")

    def test_circle(self):
        self.plant("internal/fit/One.h", "Wireframe_extraction/internal/fit/Two.h")
        self.plant("internal/fit/Two.h", "Wireframe_extraction/internal/fit/Three.h")
        self.plant("internal/fit/Three.h", "Wireframe_extraction/internal/fit/One.h")
        self.check_found("internal/fit/One.h:1", "circle", "Two.h", "Three.h")

    def test_implementations(self):
        self.plant("internal/fit/planted_impl.h", "Wireframe_extraction/internal/fit/planted.h")
        self.plant("internal/fit/planted.h", "Wireframe_extraction/internal/fit/planted_impl.h")
        self.plant("internal/fit/Other.h", "Wireframe_extraction/internal/fit/planted_impl.h")
        self.check_found("internal/fit/Other.h:3", "only its own header", "fit/planted.h>")
        self.check_found("internal/fit/planted_impl.h:1", "src/")
        self.assertEqual(2, len(Library(self.root).problems()))

    def test_folder_and_guard(self):
        self.plant("internal/fit/Planted.h")
        path = self.package / "internal/fit/Planted.h"
        path.rename(path.with_name("Renamed.h"))
        self.check_found("internal/fit/Renamed.h:1", "CGAL_WIREFRAME_EXTRACTION_INTERNAL_FIT_RENAMED_H")
        self.plant("internal/misc/Planted.h")
        self.check_found("internal/misc/Planted.h:1", "no group internal/misc")

    def test_columns_and_names(self):
        path = self.root / "planted.h"
        path.write_text("// " + "x" * 117 + "\n// " + "x" * 118 + "\nclass A\n{\n  int m_a[2], b = 0, m_c{1};\n  double* c;\n"
                        "  static constexpr int d = 1;\n  std::vector<std::pair<int, int>> e;\n  int f() const;\n\n"
                        "public:\n  int g;\n\nprivate:\n  const std::string& h;\n};\nstruct B\n{\n  int i;\n};\n")
        self.assertEqual([2], list(long_lines(path)))
        self.assertEqual(["b", "c", "e", "h"], [name for _, name in badly_named_members(path)])

    def test_map(self):
        readme = self.root / "Wireframe_extraction/README.md"
        text = readme.read_text()
        changes = (("`fit/Spline_network_fit.h`", "`types/Curve_type_recognizer.h`", "fit_curves.h", "does not include"),
                   ("| `find_doubts.h` |", "| `find_doubt.h` |", "no", "find_doubt.h"),
                   ("| skeleton | `select_skeleton.h` | `skeleton/find_skeleton_impl.h` |\n", "",
                    "lacks", "select_skeleton.h"),
                   ("| `fit/` |", "| `fits/` |", "folders", "fits"), ("| `.stl` |", "| `.stp` |", "meshes", ".stl"),
                   ("`wireframe/write_svg_impl.h`", "", "lacks", "wireframe/write_svg_impl.h"),
                   ("`cloud/Npz_file.h`", "`cloud/Npz_reader.h`", "no", "Npz_reader.h"))
        for old, new, word, other in changes:
            with self.subTest(old):
                self.assertIn(old, text)
                readme.write_text(text.replace(old, new, 1))
                problems = Map(Library(self.root), self.root).problems()
                self.assertTrue(any(word in problem and other in problem for problem in problems), problems)
        readme.write_text(text)
        self.plant("internal/network/Fit_curves.h")
        self.plant("internal/network/call_nothing.h")
        problems = Map(Library(self.root), self.root).problems()
        self.assertTrue(any("network/Fit_curves.h" in p and "another name" in p for p in problems), problems)
        self.assertTrue(any("call_nothing.h" in p and "no public" in p for p in problems), problems)

    def test_missing_includes(self):
        for word, lacking in (("std::deque<int> planted();", "<deque>"), ("std::size_t planted();", "<cstddef>"),
                              ("Eigen::Vector3d planted();", "Eigen/"), ("// std::deque", None)):
            with self.subTest(word):
                self.plant("internal/base/Planted.h")
                path = self.package / "internal/base/Planted.h"
                path.write_text(path.read_text().replace("#endif", f"{word}\n#endif"))
                if lacking:
                    self.check_found("internal/base/Planted.h:1", "lacks", lacking)
                else:
                    self.assertEqual([], Library(self.root).problems())
                path.unlink()

    def test_layout(self):
        program = find_clang_format()
        if not program:
            self.skipTest("there is no clang-format")
        path = self.root / "planted.cpp"
        path.write_text("int main()\n{\n    f();\n    return 0;\n}\n")
        self.assertNotEqual([], badly_formatted(program, Layout_test.root, [path]))
        path.write_text("int main()\n{\n  f();\n  return 0;\n}\n")
        self.assertEqual([], badly_formatted(program, Layout_test.root, [path]))


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    Layout_test.root = pathlib.Path(sys.argv[1]).resolve()
    unittest.main(argv=sys.argv[:1] + sys.argv[2:])
