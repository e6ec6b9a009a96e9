// What write_wireframe() puts into STEP, IGES and BREP files, as the readers of OpenCASCADE find it.

#include <CGAL/Wireframe_extraction/IO/write_wireframe.h>

#include <CGAL/Simple_cartesian.h>

#include <BRepAdaptor_Curve.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <GeomAbs_CurveType.hxx>
#include <IGESControl_Reader.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <Message_PrinterOStream.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <STEPControl_Reader.hxx>
#include <Standard_Type.hxx>
#include <TColStd_HSequenceOfExtendedString.hxx>
#include <TDF_Label.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shape.hxx>
#include <UnitsMethods.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_LayerTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <gp_Circ.hxx>
#include <gp_Elips.hxx>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace fs = std::filesystem;
namespace parameters = CGAL::Wireframe_extraction::parameters;

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point;
typedef Kernel::Vector_3 Vector;
typedef CGAL::Wireframe<Kernel> Wireframe;
typedef Wireframe::Curve Curve;
typedef CGAL::Wireframe_curve_type Type;
typedef CGAL::Wireframe_extraction::Length_unit Unit;
typedef CGAL::Wireframe_extraction::Step_schema Schema;

const char* const extensions[] = {".step", ".iges", ".brep"};

// Says what is wrong before it ends the test.
void check(bool is_right, const std::string& what)
{
  if (!is_right)
    std::cerr << "wrong: " << what << std::endl;
  assert(is_right);
}

std::string read_file(const std::string& name)
{
  std::ifstream stream(name, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
}

// ---- wireframes ----

class Builder
{
public:
  explicit Builder(double scale, const Vector& shift = Vector(0, 0, 0)) : m_scale(scale), m_shift(shift) {}

  Wireframe wireframe;

  Point point(double x, double y, double z) const { return CGAL::ORIGIN + m_scale * (Vector(x, y, z) + m_shift); }

  std::size_t vertex(double x, double y, double z)
  {
    wireframe.vertices.push_back(point(x, y, z));
    return wireframe.vertices.size() - 1;
  }

  Curve& line(std::size_t source, std::size_t target)
  {
    Curve curve;
    curve.type = Type::LINE;
    curve.spline = Curve::Spline(1, {0, 0, 1, 1}, {wireframe.vertices[source], wireframe.vertices[target]});
    return add(curve, source, target);
  }

  Curve& spline(std::size_t degree, std::vector<double> knots, std::vector<Point> points, std::size_t source,
                std::size_t target, bool is_closed = false, std::vector<double> weights = {})
  {
    Curve curve;
    curve.spline = Curve::Spline(degree, std::move(knots), std::move(points), std::move(weights), is_closed);
    return add(curve, source, target);
  }

  // a whole one if `end` is the start, else from `start` to `end` in radians; the vertices are made where none is given
  Curve& conic(Type type, const Point& center, Vector axis, Vector direction, double major, double minor,
               double start = 0., double end = 2. * CGAL_PI, bool has_vertices = true,
               std::size_t source = Curve::no_vertex)
  {
    Curve curve;
    curve.type = type;
    curve.conic.emplace();
    curve.conic->center = center;
    axis = axis / std::sqrt(axis.squared_length());
    direction = direction - (direction * axis) * axis;
    curve.conic->axis = axis;
    curve.conic->major_direction = direction / std::sqrt(direction.squared_length());
    curve.conic->major_radius = m_scale * major;
    curve.conic->minor_radius = m_scale * minor;
    curve.conic->start_angle = start;
    curve.conic->end_angle = end;
    const bool is_full = type == Type::CIRCLE || type == Type::ELLIPSE;
    curve.spline = curve.conic->to_spline(is_full);
    std::size_t target = source;
    if (has_vertices)
    {
      if (source == Curve::no_vertex)
      {
        wireframe.vertices.push_back(curve.spline.control_points().front());
        source = wireframe.vertices.size() - 1;
      }
      target = source;
      if (!is_full)
      {
        wireframe.vertices.push_back(curve.spline.control_points().back());
        target = wireframe.vertices.size() - 1;
      }
    }
    return add(curve, source, target);
  }

private:
  Curve& add(Curve curve, std::size_t source, std::size_t target)
  {
    curve.source = source;
    curve.target = target;
    wireframe.curves.push_back(curve);
    return wireframe.curves.back();
  }

  double m_scale;
  Vector m_shift;
};

const Vector skew(1, 2, 3), across(2, -1, 0.25);

// A loop of four curves, two of them against the direction of the loop; a branching with three curves; a circle, an
// ellipse and a spline that are closed and alone; a circle with a line at its vertex; and a spline that ends where it
// starts, with a corner there.
Wireframe make_sample(double scale = 1.)
{
  Builder b(scale, Vector(3, -2, 1));
  // the loop
  b.conic(Type::ARC, b.point(0, 0, 0), Vector(0, 0, 1), Vector(1, 0, 0), 2, 2, 0, 0.5 * CGAL_PI); // from 0 to 1
  const std::size_t v2 = b.vertex(-3, 2, 0.5), v3 = b.vertex(-3, -1, 0.5);
  b.line(v2, 1);
  b.line(v2, v3);
  const Point start = b.wireframe.vertices[0], end = b.wireframe.vertices[v3];
  b.spline(2, {0, 0, 0, 1, 2, 2, 2}, {start, b.point(2, -1, 1), b.point(-1, -3, 2), end}, 0, v3, false, {1, 0.5, 2, 1});
  // the branching
  b.conic(Type::ELLIPTIC_ARC, b.point(10, 0, 0), skew, across, 3, 1.25, 0.4, 4.4);
  const std::size_t center = b.wireframe.curves.back().source;
  const std::size_t v6 = b.vertex(9, 9, 9), v7 = b.vertex(12, -4, 1. / 3.);
  b.line(center, v6);
  const Point p = b.wireframe.vertices[center];
  b.spline(3, {0, 0, 0, 0, 0.3, 1, 1, 1, 1},
           {p, b.point(11, 1, 1), b.point(13, 1, 4), b.point(13, -3, 2), b.wireframe.vertices[v7]}, center, v7);
  // what is alone
  b.conic(Type::CIRCLE, b.point(0, 10, 0), skew, across, 1.5, 1.5, 0, 2 * CGAL_PI, false);
  b.conic(Type::ELLIPSE, b.point(0, 15, 0), -skew, across, 2, 0.75, 1, 1 + 2 * CGAL_PI, false);
  const std::size_t v8 = b.vertex(0, 20, 0);
  b.spline(2, {0, 0, 0, 1, 2, 3, 3, 3},
           {b.point(0, 20, 0), b.point(2, 20, 0), b.point(2, 24, 1), b.point(-2, 20, 0), b.point(0, 20, 0)}, v8, v8,
           true);
  // a circle with a tail
  b.conic(Type::CIRCLE, b.point(0, 0, 10), across, skew, 2.5, 2.5);
  const std::size_t v10 = b.vertex(0, 0, 20);
  b.line(b.wireframe.curves.back().source, v10);
  // a drop
  const std::size_t v11 = b.vertex(20, 20, 20);
  b.spline(3, {0, 0, 0, 0, 7, 7, 7, 7},
           {b.point(20, 20, 20), b.point(24, 20, 20), b.point(20, 25, 21), b.point(20, 20, 20)}, v11, v11);
  return b.wireframe;
}

double size_of(const Wireframe& wireframe)
{
  double low[3] = {HUGE_VAL, HUGE_VAL, HUGE_VAL}, high[3] = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
  for (const Curve& curve : wireframe.curves)
    for (const Point& point : curve.spline.control_points())
      for (int k = 0; k < 3; ++k)
      {
        low[k] = (std::min)(low[k], point[k]);
        high[k] = (std::max)(high[k], point[k]);
      }
  return std::sqrt(CGAL::squared_distance(Point(low[0], low[1], low[2]), Point(high[0], high[1], high[2])));
}

// ---- files as OpenCASCADE reads them ----

TopoDS_Shape read_shape(const std::string& name)
{
  const std::string extension = fs::path(name).extension().string();
  TopoDS_Shape shape;
  if (extension == ".brep")
  {
    const bool is_read = BRepTools::Read(shape, name.c_str(), BRep_Builder());
    check(is_read, name);
  }
  else if (extension == ".step" || extension == ".stp")
  {
    STEPControl_Reader reader;
    check(reader.ReadFile(name.c_str()) == IFSelect_RetDone, name);
    reader.TransferRoots();
    shape = reader.OneShape();
  }
  else
  {
    IGESControl_Reader reader;
    check(reader.ReadFile(name.c_str()) == IFSelect_RetDone, name);
    reader.TransferRoots();
    shape = reader.OneShape();
  }
  check(!shape.IsNull(), name + " holds a shape");
  return shape;
}

GeomAbs_CurveType expected_kind(Type type)
{
  switch (type)
  {
  case Type::LINE: return GeomAbs_Line;
  case Type::CIRCLE:
  case Type::ARC: return GeomAbs_Circle;
  case Type::ELLIPSE:
  case Type::ELLIPTIC_ARC: return GeomAbs_Ellipse;
  default: return GeomAbs_BSplineCurve;
  }
}

double length_of(const TopoDS_Shape& edge)
{
  return GCPnts_AbscissaPoint::Length(BRepAdaptor_Curve(TopoDS::Edge(edge)), 1e-13);
}

// the largest distance of points of an edge, of which one unit is `scale` of the curve, from the curve
double deviation(const BRepAdaptor_Curve& edge, const Curve& curve, double scale)
{
  double largest = 0.;
  for (int i = 0; i <= 16; ++i)
  {
    const gp_Pnt p = edge.Value(edge.FirstParameter() + i / 16. * (edge.LastParameter() - edge.FirstParameter()));
    const Point query(p.X() / scale, p.Y() / scale, p.Z() / scale);
    largest = (std::max)(largest, curve.spline.closest_point(query).distance);
  }
  return largest;
}

void check_parameters(const BRepAdaptor_Curve& edge, const Curve& curve, double scale, double tolerance,
                      const std::string& what)
{
  const double major = scale * curve.conic->major_radius, minor = scale * curve.conic->minor_radius;
  if (edge.GetType() == GeomAbs_Circle)
    check(std::abs(edge.Circle().Radius() - major) <= scale * tolerance, what + ": radius");
  if (edge.GetType() == GeomAbs_Ellipse)
    check(std::abs(edge.Ellipse().MajorRadius() - major) <= scale * tolerance
            && std::abs(edge.Ellipse().MinorRadius() - minor) <= scale * tolerance,
          what + ": radii");
  // a reader may make a closed B-spline periodic, with fewer control points
  if (edge.GetType() == GeomAbs_BSplineCurve)
    check(edge.Degree() == int(curve.spline.degree()) && edge.IsRational() == curve.spline.is_rational()
            && (edge.IsPeriodic() || edge.NbPoles() == int(curve.spline.control_points().size())),
          what + ": B-spline");
}

// Every curve is there once, as what it is, and nothing else is. One unit of the wireframe is `scale` millimetres.
void check_edges(const TopoDS_Shape& shape, const Wireframe& wireframe, double scale, const std::string& what)
{
  const double tolerance = 1e-9 * size_of(wireframe);
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(shape, TopAbs_EDGE, edges);
  check(edges.Extent() == int(wireframe.curves.size()), what + ": number of edges");
  std::vector<bool> is_used(wireframe.curves.size(), false);
  for (std::size_t i = 0; i < wireframe.curves.size(); ++i)
  {
    const Curve& curve = wireframe.curves[i];
    const std::string name = what + ", curve " + std::to_string(i);
    bool is_found = false;
    for (int k = 1; k <= edges.Extent() && !is_found; ++k)
    {
      const BRepAdaptor_Curve edge(TopoDS::Edge(edges(k)));
      if (is_used[std::size_t(k) - 1] || edge.GetType() != expected_kind(curve.type)
          || std::abs(length_of(edges(k)) - scale * curve.spline.length()) > scale * tolerance
          || deviation(edge, curve, scale) > tolerance)
        continue;
      is_found = is_used[std::size_t(k) - 1] = true;
      check_parameters(edge, curve, scale, tolerance, name);
    }
    check(is_found, name + " is not there");
  }
}

int number_of_vertices(const TopoDS_Shape& shape)
{
  TopTools_IndexedMapOfShape vertices;
  TopExp::MapShapes(shape, TopAbs_VERTEX, vertices);
  return vertices.Extent();
}

// ends of edges, of which those that are closer than the tolerance are one
int number_of_ends(const TopoDS_Shape& shape, double tolerance)
{
  TopTools_IndexedMapOfShape vertices;
  TopExp::MapShapes(shape, TopAbs_VERTEX, vertices);
  std::vector<gp_Pnt> ends;
  for (int i = 1; i <= vertices.Extent(); ++i)
  {
    const gp_Pnt p = BRep_Tool::Pnt(TopoDS::Vertex(vertices(i)));
    if (std::none_of(ends.begin(), ends.end(), [&](const gp_Pnt& q) { return p.Distance(q) <= tolerance; }))
      ends.push_back(p);
  }
  return int(ends.size());
}

// the numbers of edges of the closed wires, in order
std::vector<int> closed_wires(const TopoDS_Shape& shape)
{
  TopTools_IndexedMapOfShape wires;
  TopExp::MapShapes(shape, TopAbs_WIRE, wires);
  std::vector<int> result;
  for (int i = 1; i <= wires.Extent(); ++i)
  {
    check(BRep_Tool::IsClosed(wires(i)), "a wire is closed");
    TopTools_IndexedMapOfShape edges, vertices;
    TopExp::MapShapes(wires(i), TopAbs_EDGE, edges);
    TopExp::MapShapes(wires(i), TopAbs_VERTEX, vertices);
    check(edges.Extent() == vertices.Extent(), "the edges of a closed wire share their vertices");
    result.push_back(edges.Extent());
  }
  std::sort(result.begin(), result.end());
  return result;
}

std::string write(const std::string& name, const Wireframe& wireframe, Unit unit = Unit::MILLIMETER,
                  Schema schema = Schema::AP214)
{
  std::string error = "not cleared";
  const bool is_written =
    CGAL::IO::write_wireframe(name, wireframe, parameters::error_message(&error).unit(unit).step_schema(schema));
  check(is_written && error.empty(), name + ": " + error);
  return name;
}

// ---- tests ----

void test_sample(double scale)
{
  const Wireframe wireframe = make_sample(scale);
  const double tolerance = 1e-9 * size_of(wireframe);
  for (const std::string extension : extensions)
  {
    const std::string what = extension + " at scale " + std::to_string(scale);
    const TopoDS_Shape shape = read_shape(write("sample" + extension, wireframe));
    check_edges(shape, wireframe, 1., what);
    const int isolated = 2; // the closed curves without vertex start somewhere too
    check(number_of_ends(shape, tolerance) == int(wireframe.vertices.size()) + isolated, what + ": ends");
    const std::vector<int> wires = closed_wires(shape);
    if (extension == ".brep")
    {
      check(number_of_vertices(shape) == int(wireframe.vertices.size()) + isolated, what + ": shared vertices");
      check(wires == std::vector<int>({1, 1, 1, 1, 4}), what + ": closed wires");
    }
    else
      check(!wires.empty() && wires.back() == 4, what + ": the loop is a closed wire");
  }
}

void test_units()
{
  Builder b(1.);
  b.vertex(0, 0, 0);
  b.vertex(3, 4, 0);
  b.line(0, 1);
  b.conic(Type::ELLIPTIC_ARC, b.point(1, 2, 3), skew, across, 2, 1, 0.5, 2);
  b.conic(Type::CIRCLE, b.point(1, 2, 3), skew, across, 2, 2);
  b.conic(Type::ELLIPSE, b.point(1, 2, 3), skew, across, 3, 2);
  const std::pair<Unit, double> millimeters[] = {{Unit::MICROMETER, 1e-3}, {Unit::MILLIMETER, 1.},
                                                 {Unit::CENTIMETER, 10.},  {Unit::METER, 1000.},
                                                 {Unit::INCH, 25.4},       {Unit::FOOT, 304.8}};
  for (const std::string extension : extensions)
    for (const auto& unit : millimeters)
      for (const Schema schema : {Schema::AP214, Schema::AP242})
        check_edges(read_shape(write("unit" + extension, b.wireframe, unit.first, schema)), b.wireframe,
                    extension == ".brep" ? 1. : unit.second,
                    extension + " in units of " + std::to_string(unit.second) + " mm");
}

void test_schemas()
{
  const Wireframe wireframe = make_sample();
  check(read_file(write("ap214.stp", wireframe)).find("AUTOMOTIVE_DESIGN") != std::string::npos, "AP214");
  const std::string file = read_file(write("ap242.stp", wireframe, Unit::MILLIMETER, Schema::AP242));
  check(file.find("AP242_MANAGED_MODEL_BASED_3D_ENGINEERING") != std::string::npos, "AP242");
  check(file.find("'curve_0_arc'") != std::string::npos && file.find("COMPOSITE_CURVE") != std::string::npos,
        "names and the loop in STEP");
  check_edges(read_shape("ap242.stp"), wireframe, 1., "AP242");
}

std::size_t count(const std::string& text, const std::string& word)
{
  std::size_t result = 0;
  for (std::size_t i = text.find(word); i != std::string::npos; i = text.find(word, i + 1))
    ++result;
  return result;
}

// the colours, as in HTML, and the layers of the shapes of a STEP file that have any, as XCAF finds them
class Presented_shapes
{
public:
  explicit Presented_shapes(const std::string& name) : m_document(new TDocStd_Document("XmlXCAF"))
  {
    STEPCAFControl_Reader reader;
    check(reader.ReadFile(name.c_str()) == IFSelect_RetDone && reader.Transfer(m_document), name);
    const TopoDS_Shape shape = reader.Reader().OneShape();
    for (const TopAbs_ShapeEnum kind : {TopAbs_EDGE, TopAbs_WIRE})
      TopExp::MapShapes(shape, kind, m_shapes);
  }

  // how often a colour and its layers are there, of edges and wires
  std::map<std::string, int> counts() const
  {
    const Handle(XCAFDoc_ShapeTool) shapes = XCAFDoc_DocumentTool::ShapeTool(m_document->Main());
    const Handle(XCAFDoc_ColorTool) colors = XCAFDoc_DocumentTool::ColorTool(m_document->Main());
    const Handle(XCAFDoc_LayerTool) layers = XCAFDoc_DocumentTool::LayerTool(m_document->Main());
    std::map<std::string, int> result;
    for (int i = 1; i <= m_shapes.Extent(); ++i)
    {
      Quantity_Color color;
      TDF_Label label;
      if (!colors->GetColor(m_shapes(i), XCAFDoc_ColorCurv, color) || !shapes->Search(m_shapes(i), label))
        continue;
      std::string text = Quantity_Color::ColorToHex(color).ToCString();
      Handle(TColStd_HSequenceOfExtendedString) names = new TColStd_HSequenceOfExtendedString;
      layers->GetLayers(label, names);
      for (const TCollection_ExtendedString& layer : *names)
        text += std::string(" ") + TCollection_AsciiString(layer).ToCString();
      ++result[text];
    }
    return result;
  }

private:
  Handle(TDocStd_Document) m_document;
  TopTools_IndexedMapOfShape m_shapes;
};

// Each kind has a colour and a layer, doubtful curves have a layer of their own, and loops are shown as a whole.
void test_presentation()
{
  Wireframe wireframe = make_sample();
  wireframe.curves[5].doubts.insert(CGAL::Wireframe_doubt::SHORT); // a line
  const std::map<std::string, int> expected = {
    {"#404040 DOUBTFUL", 1}, {"#404040 LINES", 1},   {"#D62728 CIRCLES", 2}, {"#17A2A2 ELLIPTIC_ARCS", 1},
    {"#1F77B4 ELLIPSES", 1}, {"#943CBD SPLINES", 3}, {"#943CBD LOOPS", 1}};
  for (const Schema schema : {Schema::AP214, Schema::AP242})
  {
    const std::map<std::string, int> found =
      Presented_shapes(write("presentation.step", wireframe, Unit::INCH, schema)).counts();
    for (const auto& row : found)
      check(expected.count(row.first) > 0 && expected.at(row.first) == row.second,
            row.first + ": " + std::to_string(row.second));
    check(found.size() == expected.size(), "all colours and layers are there");
  }
  wireframe.curves[1].doubts.insert(CGAL::Wireframe_doubt::SHORT); // in the loop
  const std::map<std::string, int> found =
    Presented_shapes(write("presentation.step", wireframe, Unit::INCH, Schema::AP214)).counts();
  check(found.count("#943CBD LOOPS") == 0 && found.count("#943CBD DOUBTFUL") == 1, "a doubtful loop");
}

// The header tells where the wireframe comes from, as far as that is told.
void test_provenance()
{
  Wireframe wireframe = make_sample();
  wireframe.sampling_distance = 0.25;
  CGAL::Wireframe_provenance provenance;
  provenance.program = "a program 1.2";
  provenance.inputs = {"it's a \\ part.ply"};
  provenance.noise_level = 0.125;
  std::ostringstream told, untold;
  check(CGAL::IO::write_wireframe_step(told, wireframe, parameters::provenance(provenance).unit(Unit::INCH))
          && CGAL::IO::write_wireframe_step(untold, make_sample()),
        "written");
  for (const char* const part :
       {"'a program 1.2'", "input: it''s a \\\\ part.ply", "'sampling distance: 0.25 in'", "'noise level: 0.125 in'"})
    check(told.str().find(part) != std::string::npos, part);
  check(untold.str().find("FILE_DESCRIPTION(('wireframe'),") != std::string::npos, "nothing is told");
  std::ofstream("provenance.step") << told.str();
  check_edges(read_shape("provenance.step"), wireframe, 25.4, "with a header that tells");
}

// Readers forgive a loop that is passed the wrong way round; the format does not.
void test_loop_in_step()
{
  const std::string file = read_file(write("loop.step", make_sample()));
  check(count(file, "COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.T.,") == 2
          && count(file, "COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.F.,") == 2,
        "directions in the loop");
}

// The same wireframe gives the same bytes, in a file or a stream, and however many were written before.
void test_determinism()
{
  const Wireframe wireframe = make_sample();
  for (const std::string extension : extensions)
  {
    const std::string first = read_file(write("first" + extension, wireframe));
    write("other" + extension, make_sample(2.), Unit::INCH, Schema::AP242);
    check(first == read_file(write("second" + extension, wireframe)), extension + " is the same again");
    check(extension == ".brep" || count(first, extension == ".step" ? "2000-01-01T00:00:00" : "20000101.000000") > 0,
          extension + " has always the same date");
    std::ostringstream stream;
    const bool is_written = extension == ".step" ? CGAL::IO::write_wireframe_step(stream, wireframe)
      : extension == ".iges"                     ? CGAL::IO::write_wireframe_iges(stream, wireframe)
                                                 : CGAL::IO::write_wireframe_brep(stream, wireframe);
    check(is_written && stream.str() == first, extension + " is the same in a stream");
  }
}

// Ends may be off their vertices by a millionth; a vertex is a ball that holds them, in BREP at least.
void test_gap()
{
  Builder b(1.);
  b.vertex(0, 0, 0);
  b.vertex(3, 4, 0);
  b.line(0, 1);
  b.spline(2, {0, 0, 0, 1, 1, 1}, {b.point(3, 4, 0), b.point(5, 5, 5), b.point(0, 0, 0)}, 1, 0);
  b.wireframe.vertices[1] = Point(3, 4, 2e-6);
  const TopoDS_Shape shape = read_shape(write("gap.brep", b.wireframe));
  check(closed_wires(shape) == std::vector<int>({2}), "the wire is closed in spite of the gap");
  TopTools_IndexedMapOfShape vertices;
  TopExp::MapShapes(shape, TopAbs_VERTEX, vertices);
  double largest = 0.;
  for (int i = 1; i <= vertices.Extent(); ++i)
    largest = (std::max)(largest, BRep_Tool::Tolerance(TopoDS::Vertex(vertices(i))));
  check(largest >= 2e-6 && largest < 3e-6, "the tolerance covers the gap");
}

void check_refused(const Wireframe& wireframe, const std::string& reason)
{
  for (const std::string extension : extensions)
  {
    const std::string name = "refused" + extension;
    std::ofstream(name) << "old";
    std::string error;
    check(!CGAL::IO::write_wireframe(name, wireframe, parameters::error_message(&error)), reason + " is refused");
    check(error.find(name) == 0 && error.find(reason) != std::string::npos, "\"" + error + "\" tells of " + reason);
    check(read_file(name) == "old", "the old file is as before");
    fs::remove(name);
    std::ostringstream stream;
    check(!CGAL::IO::write_wireframe_brep(stream, wireframe) && stream.str().empty(), "nothing is in the stream");
  }
  for (const auto& entry : fs::directory_iterator("."))
    check(entry.path().string().find("partial") == std::string::npos, "nothing is left behind");
}

void test_refused()
{
  check_refused(Wireframe(), "no curve");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Wireframe wireframe = make_sample();
  wireframe.vertices[2] = Point(nan, 0, 0);
  check_refused(wireframe, "not finite");
  wireframe = make_sample();
  wireframe.curves[0].conic->major_radius = nan;
  check_refused(wireframe, "curve 0: ");
  wireframe = make_sample();
  wireframe.curves[1].target = 99;
  check_refused(wireframe, "vertex 99");

  Builder high(1.);
  const std::size_t degree = 26;
  std::vector<double> knots(degree + 1, 0.);
  knots.insert(knots.end(), degree + 1, 1.);
  std::vector<Point> points;
  for (std::size_t i = 0; i <= degree; ++i)
    points.push_back(Point(double(i), i == 0 || i == degree ? 0. : 1., 0.));
  high.vertex(0, 0, 0);
  high.vertex(double(degree), 0, 0);
  high.spline(degree, knots, points, 0, 1);
  check_refused(high.wireframe, "degree is 26");

  Builder crooked(1.);
  crooked.vertex(0, 0, 0);
  crooked.vertex(2, 0, 0);
  crooked.spline(2, {0, 0, 0, 1, 1, 1}, {Point(0, 0, 0), Point(1, 1, 0), Point(2, 0, 0)}, 0, 1).type = Type::LINE;
  check_refused(crooked.wireframe, "not on one");

  Builder dense(1.);
  dense.vertex(0, 0, 0);
  dense.vertex(3, 0, 0);
  dense.spline(1, {0, 0, 0.5, std::nextafter(0.5, 1.), 1, 1},
               {Point(0, 0, 0), Point(1, 1, 0), Point(2, 1, 0), Point(3, 0, 0)}, 0, 1);
  check_refused(dense.wireframe, "knots");

  Builder flat(1.);
  flat.vertex(1, 1, 1);
  flat.vertex(1, 1, 1);
  flat.line(0, 1);
  check_refused(flat.wireframe, "length is zero");
}

// Whatever OpenCASCADE throws is told, and nothing is written.
void test_exception()
{
  std::ostringstream stream;
  std::string error;
  const bool is_written = CGAL::IO::internal::write_with_opencascade(
    stream,
    [](CGAL::IO::internal::Opencascade_session& session, std::ostream& text, std::string&) {
      text << "half";
      session.set("no.such.setting", "1");
      return true;
    },
    error);
  check(!is_written && stream.str().empty() && error.find("no.such.setting") != std::string::npos,
        "exception: " + error);
}

void test_unwritable()
{
  const Wireframe wireframe = make_sample();
  for (const std::string extension : extensions)
  {
    std::string error;
    const std::string name = "no_such_folder/part" + extension;
    check(!CGAL::IO::write_wireframe(name, wireframe, parameters::error_message(&error))
            && error.find(name + ": cannot be written") == 0,
          error);
    std::ostringstream broken;
    broken.setstate(std::ios::badbit);
    error.clear();
    check(!CGAL::IO::write_wireframe_step(broken, wireframe, parameters::error_message(&error)) && !error.empty(),
          "a stream that takes nothing");
  }
}

// OpenCASCADE says nothing, and what an application has set in it is as before.
void test_surroundings()
{
  const Handle(Message_Messenger) messenger = Message::DefaultMessenger();
  const std::string unit = Interface_Static::CVal("write.step.unit");
  const std::string schema = Interface_Static::CVal("write.step.schema");
  const double factor = UnitsMethods::GetCasCadeLengthUnit();
  std::ostringstream out;
  std::streambuf* const old_out = std::cout.rdbuf(out.rdbuf());
  std::streambuf* const old_err = std::cerr.rdbuf(out.rdbuf());
  messenger->AddPrinter(new Message_PrinterOStream(Message_Trace));
  const int number_of_printers = messenger->Printers().Length();
  for (const std::string extension : extensions)
    write("quiet" + extension, make_sample(), Unit::FOOT, Schema::AP242);
  const bool has_printers = number_of_printers > 0 && messenger->Printers().Length() == number_of_printers;
  messenger->RemovePrinters(STANDARD_TYPE(Message_Printer));
  std::cout.rdbuf(old_out);
  std::cerr.rdbuf(old_err);
  check(out.str().empty(), "OpenCASCADE said: " + out.str());
  check(has_printers, "the printers of the messenger are there again");
  check(unit == Interface_Static::CVal("write.step.unit") && schema == Interface_Static::CVal("write.step.schema")
          && factor == UnitsMethods::GetCasCadeLengthUnit(),
        "the settings are as before");
}

// With arguments, it only writes the sample into files of these names, for other programs to read.
int main(int argc, char** argv)
{
  for (int i = 1; i < argc; ++i)
    write(argv[i], make_sample());
  if (argc > 1)
    return 0;
  test_determinism(); // first, when OpenCASCADE has not written anything yet
  test_surroundings();
  for (const double scale : {1., 1e-3, 1e6})
    test_sample(scale);
  test_units();
  test_schemas();
  test_presentation();
  test_provenance();
  test_loop_in_step();
  test_gap();
  test_refused();
  test_exception();
  test_unwritable();
  return 0;
}
