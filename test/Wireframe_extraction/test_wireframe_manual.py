#!/usr/bin/env python3
"""Tests that the manual builds without a warning, and that it is complete and true: every public entity is documented,
every named parameter, and every default as it is in the code.

usage: test_wireframe_manual.py ROOT BUILD CMAKE DOXYGEN [options of unittest]

ROOT is the folder of the project, BUILD one in which CMake has configured it. DOXYGEN may be empty: then the test is
skipped, with exit code 77.
"""

import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

ROOT = BUILD = None
CMAKE = DOXYGEN = ""
HEADERS = pathlib.Path("Wireframe_extraction/include/CGAL")
PAGES = pathlib.Path("doc/Wireframe_extraction")
USER_MANUAL = PAGES / "Wireframe_extraction.txt"
OPTIONS = HEADERS / "Wireframe_extraction/internal/options/Extraction_options.h"
PARAMETER_LIST = HEADERS / "Wireframe_extraction/internal/options/parameters_interface.h"
DOXYFILE = PAGES / "Doxyfile.in"
# where the stages read their parameters, besides their own headers
STAGES = {"select_skeleton.h": ("skeleton/find_skeleton_impl.h",), "contract_skeleton.h": ("skeleton/contract_impl.h",),
          "refine_field.h": ("skeleton/refine_impl.h",), "detect_corners.h": ("network/find_corners_impl.h",),
          "segment_curves.h": ("network/separate_curves_impl.h",), "recognize_curve_types.h": ("types/recognize_pieces_impl.h",),
          "find_doubts.h": ("pipeline/add_doubts_impl.h",),
          "fit_curves.h": ("fit/fit_splines_impl.h", "fit/Spline_network_fit.h"),
          "build_topological_graph.h": ("network/build_graph_impl.h", "network/Subdivided_network.h",
                                        "network/Traced_network.h", "fit/Spline_network_fit.h")}
NOT_FOR_USERS = {("build_topological_graph.h", "number_of_rounds")}  # always 2 there
CGAL_PARAMETERS = {"point_map", "geom_traits", "callback", "random_seed", "visitor", "use_binary_mode", "verbose"}


def public_headers(root):
    return [path for path in sorted((root / HEADERS).rglob("*.h")) if "internal" not in path.parts]


# What doxygen knows --------------------------------------------------------------------------------

def read_symbols(root, folder):
    """Returns the compounds of all public headers and concepts, documented or not, as doxygen sees them."""
    settings = (BUILD / "doc/Wireframe_extraction/Doxyfile").read_text(encoding="utf-8")
    settings = settings.replace(str(ROOT / "Wireframe_extraction/include"), str(root / "Wireframe_extraction/include"))
    settings += f"""
OUTPUT_DIRECTORY = "{folder}"
GENERATE_TAGFILE =
GENERATE_HTML = NO
GENERATE_XML = YES
XML_PROGRAMLISTING = NO
EXTRACT_ALL = YES
HIDE_UNDOC_CLASSES = NO
HIDE_UNDOC_MEMBERS = NO
WARNINGS = NO
WARN_AS_ERROR = NO
"""
    subprocess.run([DOXYGEN, "-"], input=settings, encoding="utf-8", check=True, timeout=120,
                   stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    compounds = []
    for path in sorted((pathlib.Path(folder) / "xml").glob("*.xml")):
        compounds += ElementTree.parse(path).getroot().iter("compounddef")
    return compounds


def text(element, path):
    return "".join("".join(found.itertext()) for found in element.findall(path)).strip()


def is_documented(element):
    return bool(text(element, "briefdescription") or text(element, "detaileddescription"))


def members(compounds, *kinds):
    """Yields public members with the names of their compounds, each once."""
    seen = set()
    for compound in compounds:
        for member in compound.iter("memberdef"):
            if member.get("prot") == "public" and member.get("kind") in kinds and member.get("id") not in seen:
                seen.add(member.get("id"))
                yield compound.findtext("compoundname"), member


def undocumented(compounds):
    for compound in compounds:
        if compound.get("kind") in ("class", "struct") and compound.get("prot", "public") == "public" \
                and not is_documented(compound):
            yield f"{compound.get('kind')} {compound.findtext('compoundname')}"
    for owner, member in members(compounds, "function", "variable", "typedef", "enum"):
        if not is_documented(member):
            yield f"{member.get('kind')} {owner}::{member.findtext('name')}"
        for value in member.iter("enumvalue"):
            if not is_documented(value):
                yield f"value {member.findtext('name')}::{value.findtext('name')}"


def incomplete(compounds):
    """Yields what a free function takes or returns, but does not describe."""
    for owner, member in members(compounds, "function"):
        if not owner.startswith(("CGAL", "PkgWireframeExtraction")) or "(" not in text(member, "argsstring") \
                or "class" in member.get("id") or "struct" in member.get("id"):
            continue
        name = member.findtext("name")
        described = {item.text for item in member.iter("parametername")}
        for parameter in member.findall("param/declname"):
            if parameter.text not in described:
                yield f"{name}(): its parameter {parameter.text}"
        for parameter in member.findall("templateparamlist/param"):
            declared = parameter.findtext("declname") or parameter.findtext("type").split()[-1]
            if declared not in described and declared != "NamedParameters":
                yield f"{name}(): its template parameter {declared}"
        returns = (text(member, "briefdescription") + text(member, "detaileddescription")).startswith("returns") \
            or any(section.get("kind") == "return" for section in member.iter("simplesect"))
        if text(member, "type") not in ("void", "") and not returns:
            yield f"{name}(): what it returns"


# What the code says --------------------------------------------------------------------------------

def coded_defaults(root):
    source = (root / OPTIONS).read_text(encoding="utf-8")
    body = source[source.index("struct Extraction_options"):source.index("};")]
    return dict(re.findall(r"^  \w+ (\w+) = ([^;]+);", body, re.MULTILINE))


def known_parameters(root):
    return set(re.findall(r"CGAL_add_named_parameter\(\w+, \w+, (\w+)\)",
                          (root / PARAMETER_LIST).read_text(encoding="utf-8")))


def aliases_of_parameters():
    """The descriptions of named parameters that several functions share, by the names by which headers call them."""
    return dict(re.findall(r'"(wireframeParam\w+)=(.*)"', (ROOT / DOXYFILE).read_text(encoding="utf-8")))


def documented_defaults(root):
    """Yields header, parameter and default of each description of a named parameter."""
    aliases = aliases_of_parameters()
    for path in public_headers(root):
        source = re.sub(r"^\s*///", "", path.read_text(encoding="utf-8"), flags=re.MULTILINE)
        source = re.sub(r"\\(wireframeParam\w+)(\{[^}]*\})?", lambda match: aliases[match[1]], source)
        for name, body in re.findall(r"\\cgalParamNBegin\{(\w+)\}(.*?)\\cgalParamNEnd", source, re.DOTALL):
            default = re.search(r"\\cgalParamDefault\{(.*?)\}\s*(?:\\|$)", body, re.DOTALL)
            yield path.name, name, " ".join(default.group(1).split()) if default else ""


def literal_defaults(root):
    """Yields header, parameter and default where a public header itself chooses a value, in a way that can be read."""
    for path in public_headers(root):
        source = path.read_text(encoding="utf-8")
        for name, default in re.findall(r"\w*np\w*::(\w+)\)\s*,\s*(true|false|\w+::[A-Z]\w*)\)", source):
            yield path.name, name, default


def tabulated_defaults(root):
    """Yields parameter and default of each row of the manual's table of all parameters."""
    for line in (root / USER_MANUAL).read_text(encoding="utf-8").splitlines():
        row = re.match(r"\| `(\w+)` \| ([^|]+) \|", line)
        if row:
            yield row.group(1), row.group(2).strip()


def is_same_default(coded, documented):
    """Whether a text, such as "2, and more", starts with the default of the code. One below 0 stands for a text."""
    documented = documented.replace("`", "")
    try:
        number = float(coded)
    except ValueError:
        words = coded.split("::")[-1]
        return documented in (coded, words) or documented.replace(" ", "_").upper() == words
    first = re.match(r"[-\d.]+(?=$|[, ])", documented)
    return bool(documented) and (number < 0 or (first is not None and float(first.group()) == number))


def wrong_parameters(root):
    coded, known = coded_defaults(root), known_parameters(root)
    described = set()
    for header, name, default in documented_defaults(root):
        described.add(name)
        if name not in known | CGAL_PARAMETERS:
            yield f"{header}: there is no named parameter {name}"
        elif not default:
            yield f"{header}: {name} has no default"
        elif name in coded and not is_same_default(coded[name], default):
            yield f"{header}: the default of {name} is {coded[name]}, not {default}"
    for header, name, default in literal_defaults(root):
        for documented in {text for path, other, text in documented_defaults(root) if (path, other) == (header, name)}:
            if not is_same_default(default.split("::")[-1], documented.replace("`", "").split("::")[-1]):
                yield f"{header}: the default of {name} is {default}, not {documented}"
    for header, helpers in STAGES.items():
        folder = root / HEADERS / "Wireframe_extraction"
        read = "".join(path.read_text(encoding="utf-8")
                       for path in (folder / header, *(folder / "internal" / helper for helper in helpers)))
        of_header = {name for path, name, _ in documented_defaults(root) if path == header}
        read_names = set(re.findall(r"\b(?:m_)?options\.(\w+)", read)) & set(coded)
        for name in sorted(read_names - of_header):
            if (header, name) not in NOT_FOR_USERS:
                yield f"{header}: {name} is read, but not described"
    for name in sorted(known - described):
        yield f"the named parameter {name} is described nowhere"
    tabulated = dict(tabulated_defaults(root))
    for name in sorted(coded):
        if name not in tabulated:
            yield f"{USER_MANUAL.name}: {name} is not in the table of parameters"
        elif not is_same_default(coded[name], tabulated[name]):
            yield f"{USER_MANUAL.name}: the default of {name} is {coded[name]}, not {tabulated[name]}"


def unlisted(compounds, root):
    """Yields what is missing in the list of the package's page."""
    page = (root / PAGES / "PackageDescription.txt").read_text(encoding="utf-8")
    listed = set(re.findall(r"^- `([\w:]+)(?:\(\))?`$", page, re.MULTILINE))
    for compound in compounds:
        if compound.get("kind") == "group":
            for inner in compound.findall("innerclass"):
                if inner.text not in listed:
                    yield inner.text
    for owner, member in members([c for c in compounds if c.get("kind") == "group"], "function", "enum", "typedef"):
        if member.findtext("name") not in {entry.split("::")[-1] for entry in listed}:
            yield member.findtext("name")


# The tests -----------------------------------------------------------------------------------------

class Manual_test(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.mkdtemp(prefix="wireframe_manual_")
        cls.symbols = read_symbols(ROOT, cls.folder)

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.folder, ignore_errors=True)

    def copy_of_tree(self):
        root = pathlib.Path(tempfile.mkdtemp(dir=self.folder))
        shutil.copytree(ROOT / "Wireframe_extraction/include", root / "Wireframe_extraction/include")
        (root / PAGES).mkdir(parents=True)
        shutil.copy(ROOT / USER_MANUAL, root / PAGES)
        return root

    def replace(self, root, path, old, new):
        source = (root / path).read_text(encoding="utf-8")
        self.assertIn(old, source)
        (root / path).write_text(source.replace(old, new), encoding="utf-8")

    def test_builds_without_warning_and_its_links_lead_somewhere(self):
        done = subprocess.run([CMAKE, "--build", BUILD, "--target", "doc"], stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, encoding="utf-8", timeout=300)
        self.assertEqual(done.returncode, 0, done.stdout)
        page = (BUILD / "doc/html/index.html").read_text(encoding="utf-8")
        self.assertIn('id="secwe_introduction"', page)

    def test_dead_links_are_found(self):
        folder = pathlib.Path(tempfile.mkdtemp(dir=self.folder))
        (folder / "index.html").write_text('<a href="#here">a</a>\n<a href="b.html">b</a><img src="c.png"/>')
        done = subprocess.run([sys.executable, ROOT / PAGES / "check_links.py", folder], stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, encoding="utf-8", timeout=60)
        self.assertEqual(done.returncode, 1)
        for expected in ("index.html:1: there is no anchor #here", "index.html:2: there is no file b.html",
                         "index.html:2: there is no file c.png"):
            self.assertIn(expected, done.stderr)

    def test_every_public_entity_is_documented(self):
        self.assertEqual(list(undocumented(self.symbols)), [])
        names = {member.findtext("name") for _, member in members(self.symbols, "function")}
        self.assertLessEqual({"extract_wireframe", "fit_curves", "write_wireframe", "tangent"}, names)

    def test_functions_are_described_as_a_whole(self):
        self.assertEqual(list(incomplete(self.symbols)), [])

    def test_what_is_not_documented_is_found(self):
        root = self.copy_of_tree()
        header = HEADERS / "Wireframe_extraction/policies.h"
        self.replace(root, header, "#endif", "namespace CGAL { int bare(int x); struct Bare { int y; }; }\n#endif")
        self.replace(root, header, "METER,      ///< 1000 mm", "METER,")
        found = set(undocumented(read_symbols(root, tempfile.mkdtemp(dir=self.folder))))
        self.assertEqual(found, {"function CGAL::bare", "struct CGAL::Bare", "variable CGAL::Bare::y",
                                 "value Length_unit::METER"})

    def test_what_is_described_in_part_is_found(self):
        root = self.copy_of_tree()
        header = HEADERS / "Wireframe_extraction/segment_curves.h"
        self.replace(root, header, "\\param corners the corners; their", "Their")
        self.replace(root, header, "\\return for every", "For every")
        found = set(incomplete(read_symbols(root, tempfile.mkdtemp(dir=self.folder))))
        self.assertEqual(found, {"segment_curves(): its parameter corners", "segment_curves(): what it returns"})

    def test_named_parameters_and_their_defaults_are_those_of_the_code(self):
        self.assertEqual(list(wrong_parameters(ROOT)), [])
        self.assertEqual(coded_defaults(ROOT)["skeleton_distance"], "1.5")
        self.assertGreater(len(list(documented_defaults(ROOT))), 40)
        self.assertLessEqual({"skip_invalid", "unit", "step_schema", "use_binary_mode", "patch_fusion"},
                             {name for _, name, _ in literal_defaults(ROOT)})

    def test_another_default_is_found(self):
        root = self.copy_of_tree()
        self.replace(root, OPTIONS, "corner_radius = 4.", "corner_radius = 4.5")
        self.replace(root, OPTIONS, "use_tangents = true", "use_tangents = false")
        self.replace(root, OPTIONS, "End_detection::GRAPH_DISTANCE", "End_detection::MAIN_AXIS")
        self.replace(root, HEADERS / "Wireframe_extraction/segment_curves.h", "cgalParamNBegin{connection_angle}",
                     "cgalParamNBegin{smooth_angle}")
        self.replace(root, HEADERS / "Wireframe_extraction/IO/write_wireframe_step.h",
                     "Schema::AP214);", "Schema::AP242);")
        self.replace(root, PARAMETER_LIST, "(skip_invalid_t, skip_invalid, skip_invalid)",
                     "(spectator_t, spectator, spectator)")
        self.replace(root, USER_MANUAL, "| `move_corners` |", "| `moves_corners` |")
        found = "\n".join(wrong_parameters(root))
        for expected in ("detect_corners.h: the default of corner_radius is 4.5, not 4",
                         "segment_curves.h: the default of use_tangents is false, not `true`",
                         "the default of end_detection is End_detection::MAIN_AXIS",
                         "extract_wireframe.h: there is no named parameter skip_invalid",
                         "segment_curves.h: connection_angle is read, but not described",
                         "segment_curves.h: the default of smooth_angle is 20., not 30",
                         "write_wireframe_step.h: the default of step_schema is Schema::AP242, not `Step_schema::AP214",
                         "the named parameter spectator is described nowhere",
                         "Wireframe_extraction.txt: the default of corner_radius is 4.5, not 4",
                         "Wireframe_extraction.txt: move_corners is not in the table of parameters"):
            self.assertIn(expected, found)

    def test_the_page_of_the_package_lists_everything(self):
        self.assertEqual(list(unlisted(self.symbols, ROOT)), [])

    def test_no_line_starts_with_an_asterisk(self):
        # doxygen takes it for the frame of a comment, and leaves it out
        for path in sorted((ROOT / PAGES).rglob("*.txt")):
            source = path.read_text(encoding="utf-8")
            self.assertEqual(re.findall(r"^ *\*[^/\n].*", source, re.MULTILINE), [], path.name)

    def test_every_example_is_in_the_manual(self):
        manual = "".join(path.read_text(encoding="utf-8") for path in sorted((ROOT / PAGES).glob("*.txt")))
        for path in sorted((ROOT / "examples/Wireframe_extraction").glob("*_example.cpp")):
            name = f"Wireframe_extraction/{path.name}"
            self.assertIn(f"\\cgalExample{{{name}}}", manual)
            self.assertIn(f"\\example {name}\n", manual)


if __name__ == "__main__":
    if len(sys.argv) < 5:
        sys.exit(__doc__)
    ROOT, BUILD = (pathlib.Path(name).resolve() for name in sys.argv[1:3])
    CMAKE, DOXYGEN = sys.argv[3:5]
    if not DOXYGEN:
        print("skipped: the manual needs doxygen 1.9.4 (Debian: doxygen)")
        sys.exit(77)
    unittest.main(argv=sys.argv[:1] + sys.argv[5:])
