// Writers of formats that other programs read. With the name of a folder it only writes files into it, which
// test_wireframe_formats_read.py looks at with readers of others.

#include <CGAL/Wireframe_extraction/IO/write_wireframe.h>

#include "Comma_locale.h"
#include "check_words.h"
#include "minimal_traits.h"

#include <CGAL/Wireframe_extraction/IO/internal/file/byte_tools.h>

#include <CGAL/Simple_cartesian.h>

#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <random>
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
typedef Curve::Spline Spline;
typedef CGAL::Wireframe_curve_type Type;
typedef CGAL::Wireframe_extraction::Length_unit Length_unit;

const std::vector<std::string> extensions = {".dxf", ".obj", ".vtp", ".gltf", ".glb", ".svg", ".csv"};

// ---- wireframes that are known exactly ----

Vector normalized(const Vector& v) { return v / std::sqrt(v.squared_length()); }

class Closed_form_wireframe
{
public:
  Closed_form_wireframe(unsigned seed, const Vector& offset) : m_random(seed), m_offset(offset)
  {
    m_wireframe.sampling_distance = 0.5;
    for (const Vector& axis : axes())
      for (const Type type : {Type::CIRCLE, Type::ARC, Type::ELLIPSE, Type::ELLIPTIC_ARC})
        add_conic(type, axis);
    add_line();
    for (const std::size_t degree : {1, 2, 3, 5})
      for (const bool is_rational : {false, true})
        for (const bool is_closed : {false, true})
          add_spline(degree, is_rational, is_closed);
  }

  const Wireframe& operator()() const { return m_wireframe; }

private:
  double number(double from, double to) { return std::uniform_real_distribution<double>(from, to)(m_random); }
  Vector vector() { return Vector(number(-5, 5), number(-5, 5), number(-5, 5)); }
  Point point() { return CGAL::ORIGIN + m_offset + vector(); }

  // those of the coordinate system, on both sides of where the rule of DXF for the axes of a plane changes, and any
  std::vector<Vector> axes()
  {
    return {Vector(0, 0, 1),
            Vector(0, 0, -1),
            Vector(1, 0, 0),
            Vector(0, -1, 0),
            normalized(Vector(0.0155, 0, 1)),
            normalized(Vector(0.016, 0, -1)),
            normalized(Vector(0.01, -0.0158, 1)),
            normalized(vector()),
            normalized(vector()),
            normalized(vector())};
  }

  void measure(Curve& curve)
  {
    curve.rms = number(0, 0.1);
    curve.max = number(0.1, 0.2);
    curve.support = static_cast<std::size_t>(number(1, 1000));
    if (curve.support % 2 == 0)
      curve.doubts = {CGAL::Wireframe_doubt::SHORT, CGAL::Wireframe_doubt::NO_FOLD};
    if (curve.type == Type::BSPLINE)
      return;
    curve.uncertainty.position = number(0, 0.1);
    curve.uncertainty.direction = number(0, 0.1);
    if (curve.type != Type::LINE)
    {
      curve.uncertainty.major_radius = number(0, 0.1);
      curve.uncertainty.minor_radius = number(0, 0.1);
    }
  }

  std::size_t add_vertex(const Point& point)
  {
    m_wireframe.vertices.push_back(point);
    return m_wireframe.vertices.size() - 1;
  }

  void add(Curve curve)
  {
    measure(curve);
    m_wireframe.curves.push_back(curve);
  }

  void add_conic(Type type, const Vector& axis)
  {
    Curve curve;
    curve.type = type;
    const Vector x = normalized(CGAL::cross_product(axis, vector()));
    const bool is_round = (type == Type::CIRCLE || type == Type::ARC);
    const bool is_full = (type == Type::CIRCLE || type == Type::ELLIPSE);
    const double major = number(2, 3), begin = is_round ? 0. : number(-4, 4);
    curve.conic = CGAL::Wireframe_conic<Kernel>{point(),
                                                axis,
                                                x,
                                                major,
                                                is_round ? major : number(0.5, 2),
                                                is_full ? 0. : begin,
                                                is_full ? 2 * CGAL_PI : begin + number(0.1, 6.2)};
    curve.spline = curve.conic->to_spline(is_full);
    if (!is_full)
    {
      curve.source = add_vertex(curve.spline.control_points().front());
      curve.target = add_vertex(curve.spline.control_points().back());
    }
    add(curve);
  }

  void add_line()
  {
    Curve curve;
    curve.type = Type::LINE;
    curve.source = add_vertex(point());
    curve.target = add_vertex(point());
    curve.spline = Spline(1, {0, 0, 2, 2}, {m_wireframe.vertices[curve.source], m_wireframe.vertices[curve.target]});
    add(curve);
  }

  // a closed one of an even degree passes through a vertex; weights at the ends may differ from one
  void add_spline(std::size_t degree, bool is_rational, bool is_closed)
  {
    Curve curve;
    const std::size_t count = degree + 4;
    std::vector<Point> points;
    for (std::size_t i = 0; i < count; ++i)
      points.push_back(point());
    if (is_closed)
      points.back() = points.front();
    if (!is_closed || degree % 2 == 0)
    {
      curve.source = add_vertex(points.front());
      curve.target = is_closed ? curve.source : add_vertex(points.back());
    }
    std::vector<double> knots(degree + 1, -0.5), weights;
    for (std::size_t i = degree + 1; i < count; ++i)
      knots.push_back(knots.back() + number(0.1, 1));
    knots.insert(knots.end(), degree + 1, knots.back() + 0.5);
    for (std::size_t i = 0; i < count && is_rational; ++i)
      weights.push_back(degree == 3 && i == 0 ? 1. : number(0.5, 2));
    curve.spline = Spline(degree, knots, points, weights, is_closed);
    add(curve);
  }

  std::mt19937 m_random;
  const Vector m_offset;
  Wireframe m_wireframe;
};

Wireframe near_wireframe() { return Closed_form_wireframe(1, Vector(0, 0, 0))(); }
Wireframe far_wireframe() { return Closed_form_wireframe(2, Vector(5e5, -4e6, 1200))(); }

// arcs, some of whose projections are as flat as rounding lets them be
Wireframe tilted_wireframe()
{
  Wireframe wireframe;
  for (const double tilt : {0., 1e-10, 1e-7, 1e-5, 1e-4, 1e-3, 0.008, 0.02, 0.3})
    for (const double sweep : {0.5, 3.1, 6.})
    {
      Curve curve;
      curve.type = Type::ARC;
      curve.conic = CGAL::Wireframe_conic<Kernel>{Point(10 * sweep, 1, 300 * tilt),
                                                  Vector(0, std::sin(tilt), std::cos(tilt)),
                                                  Vector(1, 0, 0),
                                                  10.,
                                                  10.,
                                                  0.3,
                                                  0.3 + sweep};
      curve.spline = curve.conic->to_spline(false);
      for (const Point& point : {curve.spline.control_points().front(), curve.spline.control_points().back()})
        wireframe.vertices.push_back(point);
      curve.source = wireframe.vertices.size() - 2;
      curve.target = wireframe.vertices.size() - 1;
      wireframe.curves.push_back(curve);
    }
  return wireframe;
}

// with its vertices only, so that there is something to write
Wireframe flat_wireframe()
{
  Wireframe wireframe;
  wireframe.vertices = {Point(1, 2, 3), Point(2, 2, 3)};
  return wireframe;
}

// the same, whose planes DXF may not level
Wireframe with_known_planes(Wireframe wireframe)
{
  for (Curve& curve : wireframe.curves)
    curve.uncertainty.direction = 0.;
  return wireframe;
}

void write_all(const std::string& folder)
{
  const std::map<std::string, Wireframe> wireframes = {{"near", near_wireframe()},
                                                       {"far", far_wireframe()},
                                                       {"flat", flat_wireframe()},
                                                       {"empty", Wireframe()}};
  const auto write = [&folder](const std::string& name, const Wireframe& wireframe, const auto& np) {
    const bool is_written = CGAL::IO::write_wireframe(folder + "/" + name, wireframe, np);
    assert(is_written);
  };
  for (const auto& named : wireframes)
  {
    write(named.first + ".json", named.second, parameters::sampling_step(0.1));
    for (const std::string& extension : extensions)
      write(named.first + extension, extension == ".dxf" ? with_known_planes(named.second) : named.second,
            parameters::sampling_step(0.1));
    write(named.first + "_splines.obj", named.second, parameters::obj_splines(true));
  }
  write("tilted.svg", tilted_wireframe(), parameters::dimensions(false));
  write("tilted.json", tilted_wireframe(), parameters::dimensions(false));
  write("dimensions.svg", near_wireframe(), parameters::dimensions(true));
  const std::vector<std::pair<std::string, Length_unit>> units = {
    {"um", Length_unit::MICROMETER}, {"mm", Length_unit::MILLIMETER}, {"cm", Length_unit::CENTIMETER},
    {"m", Length_unit::METER},       {"in", Length_unit::INCH},       {"ft", Length_unit::FOOT}};
  for (const auto& unit : units)
    for (const std::string& extension : extensions)
      write("unit_" + unit.first + extension, flat_wireframe(), parameters::unit(unit.second));
}

// ---- what was written ----

std::string read_file(const std::string& name)
{
  std::ifstream stream(name, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
}

std::vector<std::string> split(const std::string& text, char separator)
{
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);)
    parts.push_back(part);
  return parts;
}

std::size_t count_of(const std::string& text, const std::string& word)
{
  std::size_t count = 0;
  for (std::size_t i = text.find(word); i != std::string::npos; i = text.find(word, i + 1))
    ++count;
  return count;
}

double distance(const Point& p, const Point& q) { return std::sqrt(CGAL::squared_distance(p, q)); }

typedef std::vector<std::pair<int, std::string>> Dxf_pairs;

Dxf_pairs parse_dxf(const std::string& text)
{
  const std::vector<std::string> lines = split(text, '\n');
  assert(lines.size() % 2 == 0);
  Dxf_pairs pairs;
  for (std::size_t i = 0; i < lines.size(); i += 2)
    pairs.emplace_back(std::stoi(lines[i]), lines[i + 1]);
  return pairs;
}

void test_dxf()
{
  const Wireframe wireframe = near_wireframe();
  std::ostringstream stream;
  assert(CGAL::IO::write_wireframe_dxf(stream, wireframe, parameters::unit(Length_unit::INCH)));
  const Dxf_pairs pairs = parse_dxf(stream.str());
  assert(pairs.back().second == "EOF");

  // entities in the order of the wireframe, handles that differ and are below the seed
  const std::map<Type, std::string> names = {{Type::BSPLINE, "SPLINE"},  {Type::LINE, "LINE"},
                                             {Type::CIRCLE, "CIRCLE"},   {Type::ARC, "ARC"},
                                             {Type::ELLIPSE, "ELLIPSE"}, {Type::ELLIPTIC_ARC, "ELLIPSE"}};
  std::vector<std::string> entities, expected(wireframe.vertices.size(), "POINT");
  for (const Curve& curve : wireframe.curves)
    expected.push_back(names.at(curve.type));
  std::set<long> handles;
  long seed = 0;
  bool is_in_entities = false;
  for (std::size_t i = 0; i < pairs.size(); ++i)
  {
    if (pairs[i] == std::make_pair(2, std::string("ENTITIES")))
      is_in_entities = true;
    else if (pairs[i].first == 0 && pairs[i].second == "ENDSEC")
      is_in_entities = false;
    else if (pairs[i].first == 0 && is_in_entities)
      entities.push_back(pairs[i].second);
    if (pairs[i].second == "$HANDSEED")
      seed = std::stol(pairs[i + 1].second, nullptr, 16);
    else if ((pairs[i].first == 5 && pairs[i - 1].second != "$HANDSEED") || pairs[i].first == 105)
      assert(handles.insert(std::stol(pairs[i].second, nullptr, 16)).second);
    if (pairs[i].second == "$INSUNITS")
      assert(pairs[i + 1].second == "1");
  }
  assert(entities == expected);
  assert(!handles.empty() && *handles.rbegin() < seed);
}

// the numbers of an entity, by their group codes
typedef std::map<int, std::vector<double>> Dxf_numbers;

Vector dxf_vector(const Dxf_numbers& numbers, int code)
{
  return Vector(numbers.at(code)[0], numbers.at(code + 10)[0], numbers.at(code + 20)[0]);
}

// A circle, an ellipse or an arc as the format defines it, at a share of its way.
Point dxf_conic_point(const std::string& name, const Dxf_numbers& numbers, double share)
{
  const Vector n = dxf_vector(numbers, 210);
  if (name == "ELLIPSE")
  {
    const double begin = numbers.at(41)[0], end = numbers.at(42)[0] + (numbers.at(42)[0] <= begin ? 2 * CGAL_PI : 0);
    const double angle = begin + share * (end - begin);
    const Vector major = dxf_vector(numbers, 11), minor = numbers.at(40)[0] * CGAL::cross_product(n, major);
    return CGAL::ORIGIN + dxf_vector(numbers, 10) + std::cos(angle) * major + std::sin(angle) * minor;
  }
  const bool is_near_z = std::abs(n.x()) < 1. / 64 && std::abs(n.y()) < 1. / 64;
  const Vector x = normalized(CGAL::cross_product(is_near_z ? Vector(0, 1, 0) : Vector(0, 0, 1), n));
  const Vector y = CGAL::cross_product(n, x), c = dxf_vector(numbers, 10);
  double begin = 0, end = 360;
  if (name == "ARC")
  {
    begin = numbers.at(50)[0];
    end = numbers.at(51)[0] + (numbers.at(51)[0] <= begin ? 360 : 0);
  }
  const double angle = (begin + share * (end - begin)) * CGAL_PI / 180, radius = numbers.at(40)[0];
  return CGAL::ORIGIN + (c.x() + radius * std::cos(angle)) * x + (c.y() + radius * std::sin(angle)) * y + c.z() * n;
}

// every entity is where its curve is
void test_dxf_geometry()
{
  const Wireframe wireframe = with_known_planes(near_wireframe());
  std::ostringstream stream;
  assert(CGAL::IO::write_wireframe_dxf(stream, wireframe));
  std::vector<std::pair<std::string, Dxf_numbers>> entities;
  for (const auto& pair : parse_dxf(stream.str().substr(stream.str().find("ENTITIES") + 9)))
  {
    if (pair.first == 0)
      entities.emplace_back(pair.second, Dxf_numbers());
    else if (!entities.empty() && ((pair.first >= 10 && pair.first < 80) || (pair.first >= 210 && pair.first < 240)))
      entities.back().second[pair.first].push_back(std::stod(pair.second));
  }
  for (std::size_t i = 0; i < wireframe.curves.size(); ++i)
  {
    const Curve& curve = wireframe.curves[i];
    const std::string& name = entities.at(wireframe.vertices.size() + i).first;
    const Dxf_numbers& numbers = entities[wireframe.vertices.size() + i].second;
    for (const double share : {0., 0.25, 0.7, 1.})
    {
      if (curve.type == Type::LINE)
        assert(CGAL::ORIGIN + dxf_vector(numbers, 10) == wireframe.vertices[curve.source]
               && CGAL::ORIGIN + dxf_vector(numbers, 11) == wireframe.vertices[curve.target]);
      else if (curve.type == Type::BSPLINE)
      {
        std::vector<Point> points;
        for (std::size_t j = 0; j < numbers.at(10).size(); ++j)
          points.emplace_back(numbers.at(10)[j], numbers.at(20)[j], numbers.at(30)[j]);
        assert(points == curve.spline.control_points() && numbers.at(40) == curve.spline.knots());
        assert((curve.spline.is_rational() ? numbers.at(41) : std::vector<double>()) == curve.spline.weights());
        assert(numbers.at(71)[0] == double(curve.spline.degree()) && (int(numbers.at(70)[0]) & 1) == 0);
      }
      else
      {
        const Point point = dxf_conic_point(name, numbers, share);
        const bool is_from_below = curve.conic->axis == Vector(0, 0, -1); // which is seen from above
        const double angle = curve.conic->start_angle
          + (is_from_below ? 1. - share : share) * (curve.conic->end_angle - curve.conic->start_angle);
        // a circle of the format has no start of its own
        if (curve.type == Type::CIRCLE)
          assert(curve.spline.closest_point(point).distance < 1e-9);
        else
          assert(distance(point, curve.conic->point(angle)) < 1e-9);
      }
    }
  }
}

// Planes that are level within their uncertainty have the extrusion (0, 0, 1), whichever side they are seen from.
void test_dxf_extrusion()
{
  const double angle = 3e-4;
  for (const Type type : {Type::ARC, Type::CIRCLE, Type::ELLIPSE, Type::ELLIPTIC_ARC})
    for (const double side : {1., -1.})
      for (const double uncertainty : {0., 1e-4, 1e-3})
      {
        Wireframe wireframe;
        Curve curve;
        curve.type = type;
        const double minor = type == Type::ARC || type == Type::CIRCLE ? 2. : 1.;
        const bool is_closed = type == Type::CIRCLE || type == Type::ELLIPSE;
        curve.conic = CGAL::Wireframe_conic<Kernel>{Point(100, 3, -7),
                                                    Vector(std::sin(angle), 0, side * std::cos(angle)),
                                                    Vector(std::cos(angle), 0, -side * std::sin(angle)),
                                                    2.,
                                                    minor,
                                                    is_closed ? 0. : 0.4,
                                                    is_closed ? 2. * CGAL_PI : 2.1};
        curve.spline = curve.conic->to_spline(is_closed);
        curve.uncertainty.direction = uncertainty;
        if (!is_closed)
        {
          wireframe.vertices = {curve.spline.control_points().front(), curve.spline.control_points().back()};
          curve.source = 0;
          curve.target = 1;
        }
        wireframe.curves.push_back(curve);
        for (const bool has_splines : {false, true})
        {
          std::ostringstream stream;
          assert(CGAL::IO::write_wireframe_dxf(stream, wireframe, parameters::dxf_splines(has_splines)));
          const bool is_level = uncertainty > angle;
          if (has_splines && !is_level)
          {
            assert(count_of(stream.str(), "\n0\nSPLINE\n") == 1);
            continue;
          }
          std::string name;
          Dxf_numbers numbers;
          for (const auto& pair : parse_dxf(stream.str().substr(stream.str().find("ENTITIES") + 9)))
            if (pair.first == 0 && pair.second != "POINT" && name.empty())
              name = pair.second;
            else if (!name.empty() && (pair.first >= 10 && pair.first < 240))
              numbers[pair.first].push_back(pair.first < 80 || pair.first >= 210 ? std::stod(pair.second) : 0.);
            else if (pair.first == 0 && !name.empty())
              break;
          const Vector n = dxf_vector(numbers, 210);
          assert(is_level == (n == Vector(0, 0, 1)));
          assert(is_level || distance(CGAL::ORIGIN + n, CGAL::ORIGIN + curve.conic->axis) < 1e-12);
          for (const double share : {0., 0.3, 1.})
          {
            const double at = curve.conic->start_angle
              + (side < 0. && is_level ? 1. - share : share) * (curve.conic->end_angle - curve.conic->start_angle);
            const Point point = dxf_conic_point(name, numbers, share);
            const double tolerance = is_level ? 2.1 * angle : 1e-9;
            if (is_closed)
              assert(curve.spline.closest_point(point).distance < tolerance);
            else
              assert(distance(point, curve.conic->point(at)) < tolerance);
          }
        }
      }
}

// pieces that keep to a tolerance
void test_chord_tolerance()
{
  const Wireframe wireframe = near_wireframe();
  for (const double tolerance : {1e-1, 1e-3})
    for (const double step : {0., 0.05})
    {
      std::ostringstream stream;
      if (step > 0.)
        assert(CGAL::IO::write_wireframe_polylines(stream, wireframe,
                                                   parameters::chord_tolerance(tolerance).sampling_step(step)));
      else
        assert(CGAL::IO::write_wireframe_polylines(stream, wireframe, parameters::chord_tolerance(tolerance)));
      std::istringstream lines(stream.str());
      std::size_t number_of_points = 0;
      for (const Curve& curve : wireframe.curves)
      {
        std::size_t count = 0;
        lines >> count;
        number_of_points += count;
        std::vector<Point> points(count);
        for (Point& point : points)
          lines >> point;
        assert(lines && count >= (curve.is_closed() && curve.spline.degree() > 1 ? 4u : 2u));
        assert(curve.type != Type::LINE || step > 0. || count == 2);
        for (std::size_t i = 0; i + 1 < count; ++i)
        {
          assert(step == 0. || distance(points[i], points[i + 1]) < step * (1. + 1e-9));
          // the middle of a chord is farthest from the curve, about; some of them will do
          assert(i % 7 != 0
                 || curve.spline.closest_point(CGAL::midpoint(points[i], points[i + 1])).distance < 1.1 * tolerance);
        }
      }
      assert(tolerance < 1e-2 || step > 0. || number_of_points < 40 * wireframe.curves.size());
    }
  std::ostringstream stream;
  std::string error;
  for (const double bad : {0., -1., HUGE_VAL, std::nan("")})
  {
    assert(
      !CGAL::IO::write_wireframe_polylines(stream, wireframe, parameters::chord_tolerance(bad).error_message(&error)));
    check_words(error, {"chord_tolerance", "positive"});
  }
  // what asks for too many pieces is refused before they are made
  const std::clock_t start = std::clock();
  for (const double bad : {1e-17, 1e-300})
  {
    assert(
      !CGAL::IO::write_wireframe_polylines(stream, wireframe, parameters::chord_tolerance(bad).error_message(&error)));
    check_words(error, {"give a larger chord_tolerance"});
  }
  assert(std::clock() - start < 5 * CLOCKS_PER_SEC);
}

// an ellipse that is too flat for the format is a spline, and an arc of a whole turn is a circle
void test_dxf_limits()
{
  Wireframe wireframe;
  Curve curve;
  curve.type = Type::ELLIPSE;
  curve.conic =
    CGAL::Wireframe_conic<Kernel>{Point(1, 0, 0), Vector(0, 0, 1), Vector(1, 0, 0), 1, 1e-7, 0, 2 * CGAL_PI};
  curve.spline = curve.conic->to_spline(true);
  wireframe.curves.push_back(curve);
  curve.type = Type::ARC;
  curve.conic->minor_radius = 1;
  curve.spline = curve.conic->to_spline();
  wireframe.vertices = {curve.spline.control_points().front(), curve.spline.control_points().back()};
  curve.source = 0;
  curve.target = 1;
  wireframe.curves.push_back(curve);
  std::ostringstream stream;
  assert(CGAL::IO::write_wireframe_dxf(stream, wireframe));
  const std::string text = stream.str();
  assert(count_of(text, "\n0\nELLIPSE\n") == 0 && count_of(text, "\n0\nSPLINE\n") == 1);
  assert(count_of(text, "\n0\nARC\n") == 0 && count_of(text, "\n0\nCIRCLE\n") == 1);
}

// ---- OBJ with free-form curves ----

struct Obj_curve
{
  std::string name;
  std::vector<std::size_t> indices;
  std::vector<double> knots, range;
  std::size_t degree = 1;
  bool is_rational = false, is_segment = false;
};

struct Obj_content
{
  std::vector<Point> points;
  std::vector<double> weights;
  std::vector<Obj_curve> curves;
};

Obj_content parse_obj(std::istream& stream)
{
  Obj_content content;
  for (std::string line; std::getline(stream, line);)
  {
    std::istringstream words(line);
    std::string kind, word;
    words >> kind;
    if (kind == "v")
    {
      double x, y, z, w = 1.;
      const bool is_point = static_cast<bool>(words >> x >> y >> z);
      assert(is_point);
      words >> w;
      content.points.emplace_back(x, y, z);
      content.weights.push_back(words ? w : 1.);
    }
    else if (kind == "g")
    {
      content.curves.emplace_back();
      words >> content.curves.back().name;
    }
    else if (kind == "cstype")
    {
      words >> word;
      content.curves.back().is_rational = (word == "rat");
      assert(word == "bspline" || static_cast<bool>(words >> word));
      assert(word == "bspline");
    }
    else if (kind == "deg")
      words >> content.curves.back().degree;
    else if (kind == "curv" || kind == "l")
    {
      Obj_curve& curve = content.curves.back();
      curve.is_segment = (kind == "l");
      curve.range.resize(curve.is_segment ? 0 : 2);
      for (double& end : curve.range)
        words >> end;
      for (std::size_t index; words >> index;)
        curve.indices.push_back(index - 1);
      // a reader goes from line to line
      for (const std::size_t index : curve.indices)
        assert(index < content.points.size());
    }
    else if (kind == "parm")
    {
      words >> word;
      assert(word == "u");
      for (double knot; words >> knot;)
        content.curves.back().knots.push_back(knot);
    }
    else
      assert(kind == "#" || kind == "end");
  }
  return content;
}

void test_obj_splines()
{
  const Wireframe wireframe = near_wireframe();
  std::stringstream stream;
  assert(CGAL::IO::write_wireframe_obj(stream, wireframe, parameters::obj_splines(true)));
  assert(count_of(stream.str(), "\nend\n") == wireframe.curves.size() - 1);
  const Obj_content content = parse_obj(stream);
  assert(content.curves.size() == wireframe.curves.size());
  for (std::size_t i = 0; i < wireframe.vertices.size(); ++i)
    assert(content.points[i] == wireframe.vertices[i] && content.weights[i] == 1.);
  for (std::size_t i = 0; i < content.curves.size(); ++i)
  {
    const Obj_curve& written = content.curves[i];
    const Curve& curve = wireframe.curves[i];
    assert(written.name.find("curve_" + std::to_string(i) + "_") == 0);
    assert(written.is_segment == (curve.type == Type::LINE));
    std::vector<Point> points;
    std::vector<double> weights;
    for (const std::size_t index : written.indices)
    {
      points.push_back(content.points[index]);
      weights.push_back(content.weights[index]);
      assert(written.is_rational || content.weights[index] == 1.);
    }
    if (written.is_segment)
    {
      assert(written.indices == (std::vector<std::size_t>{curve.source, curve.target}));
      continue;
    }
    assert(written.is_rational == curve.spline.is_rational());
    const Spline spline(written.degree, written.knots, points, weights);
    assert(written.range[0] == spline.parameter_range().first && written.range[1] == spline.parameter_range().second);
    for (int j = 0; j <= 50; ++j)
    {
      const double u = written.range[0] + (written.range[1] - written.range[0]) * j / 50;
      assert(curve.spline.closest_point(spline.point(u)).distance < 1e-9);
    }
    const double length = curve.spline.length();
    assert(std::abs(spline.length() - length) < 1e-6 * length);
    if (CGAL::is_conic(curve.type) && !curve.is_closed())
      assert(written.indices.front() == curve.source && written.indices.back() == curve.target);
    if (CGAL::is_conic(curve.type) && curve.is_closed())
      assert(written.indices.front() == written.indices.back());
  }
}

// ---- the other formats ----

void test_csv()
{
  const Wireframe wireframe = near_wireframe();
  std::ostringstream stream;
  assert(CGAL::IO::write_wireframe_csv(stream, wireframe));
  const std::string text = stream.str();
  assert(count_of(text, "\r\n") == wireframe.curves.size() + 1 && count_of(text, "\n") == count_of(text, "\r\n"));
  const std::vector<std::string> lines = split(text, '\n');
  const std::vector<std::string> names = split(lines[0], ',');
  for (std::size_t i = 0; i < wireframe.curves.size(); ++i)
  {
    const Curve& curve = wireframe.curves[i];
    const std::vector<std::string> values = split(lines[i + 1], ',');
    assert(values.size() == names.size());
    std::map<std::string, std::string> row;
    for (std::size_t j = 0; j < names.size(); ++j)
      row[names[j]] = values[j];
    assert(row["index"] == std::to_string(i));
    assert(row["closed"] == (curve.is_closed() ? "true" : "false"));
    assert(row["doubtful"] == (curve.is_doubtful() ? "true" : "false"));
    assert(row["doubts\r"] == (curve.is_doubtful() ? "short no_fold\r" : "\r")); // it ends the line
    assert(row["source"].empty() == (curve.source == Curve::no_vertex));
    assert(std::stod(row["length"]) == curve.spline.length() && std::stod(row["max"]) == curve.max);
    assert(row["center_y"].empty() == (curve.type == Type::BSPLINE));
    assert(row["minor_radius"].empty() == !CGAL::is_conic(curve.type));
    if (CGAL::is_conic(curve.type))
      assert(std::stod(row["center_y"]) == curve.conic->center.y() && std::stod(row["axis_z"]) == curve.conic->axis.z()
             && std::stod(row["minor_radius"]) == curve.conic->minor_radius
             && std::stod(row["end_angle"]) == curve.conic->end_angle
             && std::stod(row["minor_radius_uncertainty"]) == curve.uncertainty.minor_radius);
  }
}

// what stands between the tags of an array
std::vector<double> vtp_numbers(const std::string& text, const std::string& name)
{
  const std::size_t place = text.find("Name=\"" + name + "\"");
  assert(place != std::string::npos);
  const std::size_t begin = text.find('>', place) + 1;
  std::istringstream words(text.substr(begin, text.find('<', begin) - begin));
  std::vector<double> numbers;
  for (std::string word; words >> word;)
    numbers.push_back(std::stod(word));
  return numbers;
}

void test_vtp()
{
  const Wireframe wireframe = near_wireframe();
  std::ostringstream stream;
  assert(CGAL::IO::write_wireframe_vtp(stream, wireframe));
  const std::string text = stream.str(), lines = text.substr(text.find("<Lines>"));
  const std::vector<double> coordinates = vtp_numbers(text, "Points"), indices = vtp_numbers(lines, "connectivity");
  const std::vector<double> offsets = vtp_numbers(lines, "offsets"), radii = vtp_numbers(text, "radius");
  assert(offsets.size() == wireframe.curves.size() && offsets.back() == double(indices.size()));
  assert(radii.size() == wireframe.vertices.size() + wireframe.curves.size());
  std::size_t begin = 0;
  for (std::size_t i = 0; i < offsets.size(); begin = std::size_t(offsets[i++]))
  {
    const Curve& curve = wireframe.curves[i];
    assert(radii[wireframe.vertices.size() + i] == (CGAL::is_conic(curve.type) ? curve.conic->major_radius : 0.));
    assert(!curve.is_closed() || indices[begin] == indices[std::size_t(offsets[i]) - 1]);
    for (std::size_t j = begin; j < std::size_t(offsets[i]); ++j)
    {
      const std::size_t k = 3 * std::size_t(indices[j]);
      const Point point(coordinates.at(k), coordinates.at(k + 1), coordinates.at(k + 2));
      assert(curve.spline.closest_point(point).distance < 1e-9);
    }
  }
}

std::string from_base64(const std::string& text)
{
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text)
  {
    if (c == '=')
      break;
    bits = (bits << 6) | static_cast<std::uint32_t>(digits.find(c));
    count += 6;
    if (count >= 8)
      bytes += static_cast<char>((bits >> (count -= 8)) & 255u);
  }
  return bytes;
}

std::size_t load_size(const std::string& bytes, std::size_t position)
{
  std::size_t value = 0;
  for (std::size_t i = 0; i < 4; ++i)
    value |= std::size_t(static_cast<unsigned char>(bytes.at(position + i))) << (8 * i);
  return value;
}

// both forms hold the same bytes, which are points of the curves
void test_gltf()
{
  const Wireframe wireframe = near_wireframe();
  std::ostringstream text_stream, binary_stream;
  assert(CGAL::IO::write_wireframe_gltf(text_stream, wireframe));
  assert(CGAL::IO::write_wireframe_gltf(binary_stream, wireframe, parameters::use_binary_mode(true)));
  const std::string text = text_stream.str(), binary = binary_stream.str(), start = "base64,";
  const std::size_t begin = text.find(start) + start.size();
  const std::string bytes = from_base64(text.substr(begin, text.find('"', begin) - begin));
  assert(binary.substr(0, 4) == "glTF" && load_size(binary, 4) == 2 && load_size(binary, 8) == binary.size());
  const std::size_t json_size = load_size(binary, 12), place = 20 + json_size;
  assert(json_size % 4 == 0 && binary.substr(16, 4) == "JSON");
  assert(load_size(binary, place) == bytes.size() && binary.substr(place + 4, 4) == std::string("BIN\0", 4));
  assert(binary.substr(place + 8) == bytes);
  assert(text.find("\"uri\"") != std::string::npos && binary.find("\"uri\"") == std::string::npos);

  for (std::size_t size = 0; size < 7; ++size)
  {
    const std::string part = bytes.substr(0, size);
    assert(from_base64(CGAL::IO::internal::to_base64(part)) == part);
    assert(CGAL::IO::internal::to_base64(part).size() == (size + 2) / 3 * 4);
  }
}

// the floats are points of the curves, around the middle
void test_gltf_points()
{
  const Wireframe wireframe = far_wireframe();
  std::ostringstream stream, obj_stream;
  assert(CGAL::IO::write_wireframe_gltf(stream, wireframe, parameters::unit(Length_unit::METER).use_binary_mode(true)));
  const std::string binary = stream.str(), start = "\"translation\":[";
  std::istringstream place(binary.substr(binary.find(start) + start.size(), 200));
  double x, y, z;
  char comma;
  place >> x >> comma >> y >> comma >> z;
  assert(place);
  std::size_t position = 28 + load_size(binary, 12);
  const auto next = [&binary, &position]() {
    const std::uint32_t bits = static_cast<std::uint32_t>(load_size(binary, position));
    position += 4;
    float value;
    std::memcpy(&value, &bits, 4);
    return double(value);
  };
  const auto next_point = [&]() {
    const double dx = next(), dy = next(), dz = next();
    return Point(x + dx, y + dy, z + dz);
  };
  for (const Point& vertex : wireframe.vertices)
    assert(distance(next_point(), vertex) < 5e-6);
  for (const Curve& curve : wireframe.curves)
  {
    const double step = 0.25 * wireframe.sampling_distance;
    const std::size_t count = std::size_t(std::ceil(curve.spline.length() / step - 1e-9));
    for (std::size_t i = 0; i <= count; ++i)
      assert(curve.spline.closest_point(next_point()).distance < 5e-6);
  }
  assert(position == binary.size());
}

void test_svg()
{
  const Wireframe wireframe = near_wireframe();
  std::ostringstream stream;
  assert(CGAL::IO::write_wireframe_svg(stream, wireframe, parameters::unit(Length_unit::FOOT)));
  const std::string text = stream.str();
  for (const char* const id : {"\"front\"", "\"top\"", "\"right\"", "\"isometric\""})
    assert(count_of(text, std::string("<g id=") + id) == 1);
  assert(count_of(text, "<title>curve ") == 4 * wireframe.curves.size() && count_of(text, "<polyline ") == 0);
  assert(count_of(text, "<circle class=\"vertex\"") == 4 * wireframe.vertices.size());
  assert(count_of(text, " ft,") == 1 && count_of(text, "nan") == 0 && count_of(text, "dimension") == 0);
}

// ---- all of them ----

void test_dispatch()
{
  const Wireframe wireframe = near_wireframe();
  typedef std::function<bool(std::ostream&)> Write;
  const std::map<std::string, Write> writers = {
    {".dxf", [&](std::ostream& out) { return CGAL::IO::write_wireframe_dxf(out, wireframe); }},
    {".obj", [&](std::ostream& out) { return CGAL::IO::write_wireframe_obj(out, wireframe); }},
    {".vtp", [&](std::ostream& out) { return CGAL::IO::write_wireframe_vtp(out, wireframe); }},
    {".gltf", [&](std::ostream& out) { return CGAL::IO::write_wireframe_gltf(out, wireframe); }},
    {".glb",
     [&](std::ostream& out) {
       return CGAL::IO::write_wireframe_gltf(out, wireframe, parameters::use_binary_mode(true));
     }},
    {".svg", [&](std::ostream& out) { return CGAL::IO::write_wireframe_svg(out, wireframe); }},
    {".csv", [&](std::ostream& out) { return CGAL::IO::write_wireframe_csv(out, wireframe); }}};
  for (const auto& writer : writers)
  {
    std::ostringstream expected;
    // whatever state the stream is in
    expected.precision(2);
    expected.setf(std::ios::fixed | std::ios::showpos | std::ios::hex);
    assert(writer.second(expected) && !expected.str().empty());
    std::string upper = "formats_scratch" + writer.first;
    for (char& c : upper)
      c = (c >= 'a' && c <= 'z') ? char(c - 'a' + 'A') : c;
    for (const std::string& name : {"formats_scratch" + writer.first, upper})
    {
      assert(CGAL::IO::write_wireframe(name, wireframe));
      assert(read_file(name) == expected.str());
      fs::remove(name);
    }
  }
  std::string error;
  assert(!CGAL::IO::write_wireframe("formats_scratch.xyz", wireframe, parameters::error_message(&error)));
  for (const std::string& extension : extensions)
    assert(error.find(extension) != std::string::npos);
}

void test_errors()
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<std::pair<std::string, Wireframe>> bad = {{"vertex 1", near_wireframe()},
                                                        {"curve 2", near_wireframe()},
                                                        {"curve 1", near_wireframe()},
                                                        {"curve 0", near_wireframe()}};
  bad[0].second.vertices[1] = Point(nan, 0, 0);
  bad[1].second.curves[2].conic->minor_radius = nan;
  bad[2].second.curves[1].target = 1000;
  bad[3].second.curves[0].spline = Spline();

  fs::create_directory("formats_folder");
  for (const std::string& extension : extensions)
  {
    const std::string name = "formats_folder/old" + extension;
    const auto fails = [&](const std::string& filename, const std::string& word, const auto& wireframe,
                           const auto& np) {
      std::ofstream("formats_folder/old" + extension, std::ios::binary) << "old";
      std::string error;
      const bool is_written = CGAL::IO::write_wireframe(filename, wireframe, np.error_message(&error));
      assert(!is_written && error.find(filename) == 0 && error.find(word) != std::string::npos);
      // the old file is as it was, and nothing is beside it
      assert(read_file("formats_folder/old" + extension) == "old");
      assert(std::distance(fs::directory_iterator("formats_folder"), fs::directory_iterator()) == 1);
    };
    const auto none = parameters::unit(Length_unit::METER);
    for (const auto& wireframe : bad)
    {
      fails(name, wireframe.first, wireframe.second, none);
      fails(name, wireframe.first, wireframe.second, none.obj_splines(true));
    }
    fails("formats_missing/new" + extension, "cannot be written", near_wireframe(), none);
    const bool is_sampled = (extension != ".dxf" && extension != ".csv" && extension != ".svg");
    if (is_sampled)
      fails(name, "sampling_step", near_wireframe(), none.sampling_step(-1.));
    if (is_sampled)
      fails(name, "give a larger sampling_step", near_wireframe(), none.sampling_step(1e-9));
    if (extension == ".gltf" || extension == ".glb" || extension == ".svg")
    {
      Wireframe large = flat_wireframe();
      large.vertices[0] = Point(-1.7e308, 0, 0);
      large.vertices[1] = Point(1.7e308, 0, 0);
      fails(name, "too large", large, none);
    }
    if (extension == ".dxf" || extension == ".csv")
    {
      Wireframe large = flat_wireframe();
      large.vertices = {Point(-1.7e308, -1.7e308, 0), Point(1.7e308, 1.7e308, 0)};
      large.curves.resize(1);
      large.curves[0].type = Type::LINE;
      large.curves[0].spline = Spline(1, {0, 0, 1, 1}, large.vertices);
      large.curves[0].source = 0;
      large.curves[0].target = 1;
      fails(name, "scale", large, none);
    }
    fs::remove(name);
    fs::create_directory(name);
    std::string error;
    assert(!CGAL::IO::write_wireframe(name, near_wireframe(), parameters::error_message(&error)));
    assert(error.find("directory") != std::string::npos);
    fs::remove(name);
  }
  fs::remove_all("formats_folder");
}

// a stream that takes nothing
void test_bad_streams()
{
  const Wireframe wireframe = near_wireframe();
  const auto fails = [](const auto& write) {
    std::ostringstream stream;
    stream.setstate(std::ios::badbit);
    std::string error;
    return !write(stream, error) && !error.empty();
  };
  assert(fails([&](std::ostream& out, std::string& error) {
    return CGAL::IO::write_wireframe_dxf(out, wireframe, parameters::error_message(&error));
  }));
  assert(fails([&](std::ostream& out, std::string& error) {
    return CGAL::IO::write_wireframe_vtp(out, wireframe, parameters::error_message(&error));
  }));
  assert(fails([&](std::ostream& out, std::string& error) {
    return CGAL::IO::write_wireframe_gltf(out, wireframe, parameters::error_message(&error));
  }));
  assert(fails([&](std::ostream& out, std::string& error) {
    return CGAL::IO::write_wireframe_svg(out, wireframe, parameters::error_message(&error));
  }));
  assert(fails([&](std::ostream& out, std::string& error) {
    return CGAL::IO::write_wireframe_csv(out, wireframe, parameters::error_message(&error));
  }));
  assert(fails([&](std::ostream& out, std::string& error) {
    return CGAL::IO::write_wireframe_obj(out, wireframe, parameters::obj_splines(true).error_message(&error));
  }));
}

// where decimals are written with a comma, and thousands with a point
void test_other_locale()
{
  const auto write_each = []() {
    std::string all;
    for (const std::string& extension : extensions)
      for (const bool has_obj_splines : {false, true})
      {
        const std::string name = "formats_locale" + extension;
        const bool is_written =
          CGAL::IO::write_wireframe(name, near_wireframe(), parameters::obj_splines(has_obj_splines));
        assert(is_written);
        all += read_file(name);
        fs::remove(name);
      }
    return all;
  };
  const std::string before = write_each();
  const Comma_locale locale;
  assert(write_each() == before);
}

// with a traits class that has nothing beyond the concept
void test_minimal_traits()
{
  CGAL::Wireframe<Minimal_traits> wireframe;
  CGAL::Wireframe_curve<Minimal_traits> curve;
  curve.type = Type::CIRCLE;
  curve.conic.emplace();
  curve.conic->center = Minimal_point(1, 2, 3);
  curve.conic->axis = Minimal_vector(0, 0, 1);
  curve.conic->major_direction = Minimal_vector(1, 0, 0);
  curve.conic->major_radius = curve.conic->minor_radius = 4;
  curve.conic->end_angle = 2 * CGAL_PI;
  curve.spline = curve.conic->to_spline(true);
  wireframe.curves.push_back(curve);
  std::vector<std::string> all = extensions;
  all.insert(all.end(), {".json", ".ply", ".txt"});
  for (const std::string& extension : all)
  {
    const std::string name = "formats_minimal" + extension;
    const bool is_written = CGAL::IO::write_wireframe(name, wireframe, parameters::geom_traits(Minimal_traits()));
    assert(is_written && !read_file(name).empty());
    fs::remove(name);
  }
}

int main(int argc, char** argv)
{
  if (argc > 1)
  {
    write_all(argv[1]);
    return 0;
  }
  test_dxf();
  test_dxf_geometry();
  test_dxf_extrusion();
  test_chord_tolerance();
  test_dxf_limits();
  test_obj_splines();
  test_csv();
  test_vtp();
  test_gltf();
  test_gltf_points();
  test_svg();
  test_dispatch();
  test_errors();
  test_bad_streams();
  test_other_locale();
  test_minimal_traits();
  return 0;
}
