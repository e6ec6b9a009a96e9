// Wireframes as JSON: what is written is what is read.

#include <CGAL/Wireframe_extraction/IO/write_wireframe_json.h>

#include "Comma_locale.h"
#include "minimal_traits.h"
#include "scratch_files.h"
#include "theta_wireframe.h"

#include <CGAL/Wireframe_extraction/IO/internal/wireframe/curve_tools.h>
#include <CGAL/Wireframe_extraction/IO/read_wireframe_json.h>
#include <CGAL/Wireframe_extraction/IO/write_wireframe.h>
#include <CGAL/Wireframe_extraction/parameters.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>

#include <cassert>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace parameters = CGAL::Wireframe_extraction::parameters;

template <class Traits>
class Random_wireframe
{
public:
  typedef typename Traits::Point_3 Point_3;
  typedef typename Traits::FT FT;
  typedef CGAL::Wireframe<Traits> Wireframe;
  typedef CGAL::Wireframe_curve<Traits> Curve;

  explicit Random_wireframe(unsigned seed) : m_random(seed) {}

  Wireframe operator()()
  {
    Wireframe wireframe;
    wireframe.sampling_distance = number(0.01, 1);
    for (std::size_t i = 0; i < 5; ++i)
      wireframe.vertices.push_back(point());
    for (std::size_t i = 0; i < 20; ++i)
      wireframe.curves.push_back(curve(wireframe, i));
    return wireframe;
  }

private:
  FT number(double low, double high) { return FT(std::uniform_real_distribution<double>(low, high)(m_random)); }

  Point_3 point()
  {
    return Traits().construct_point_3_object()(number(-10, 10), number(-1e-5, 1e-5), number(-1e9, 1e9));
  }

  // a circle or an ellipse, or an arc of one, whose ends become vertices
  Curve conic(Wireframe& wireframe, CGAL::Wireframe_curve_type type)
  {
    typedef CGAL::Wireframe_curve_type Type;
    const double pi = CGAL_PI, tilt = CGAL::to_double(number(-pi, pi));
    Curve result;
    result.type = type;
    const Traits traits;
    result.conic.emplace();
    result.conic->center = point();
    result.conic->axis = traits.construct_vector_3_object()(FT(std::sin(tilt)), FT(0), FT(std::cos(tilt)));
    result.conic->major_direction = traits.construct_vector_3_object()(FT(std::cos(tilt)), FT(0), FT(-std::sin(tilt)));
    result.conic->major_radius = number(2, 3);
    result.conic->minor_radius = type == Type::CIRCLE || type == Type::ARC ? result.conic->major_radius : number(1, 2);
    const bool is_full = type == Type::CIRCLE || type == Type::ELLIPSE;
    result.conic->start_angle = is_full ? FT(0) : number(0, 3);
    result.conic->end_angle = is_full ? FT(2 * pi) : FT(result.conic->start_angle + number(0.1, 6));
    result.spline = result.conic->to_spline(is_full);
    result.uncertainty.position = number(0, 1);
    result.uncertainty.direction = number(0, 1);
    result.uncertainty.major_radius = number(0, 1);
    result.uncertainty.minor_radius = number(0, 1);
    if (!is_full)
    {
      result.source = wireframe.vertices.size();
      result.target = result.source + 1;
      wireframe.vertices.push_back(result.spline.control_points().front());
      wireframe.vertices.push_back(result.spline.control_points().back());
    }
    return result;
  }

  Curve curve(Wireframe& wireframe, std::size_t i)
  {
    const CGAL::Wireframe_curve_type type = static_cast<CGAL::Wireframe_curve_type>(i % 6);
    if (CGAL::is_conic(type))
      return conic(wireframe, type);
    const bool is_closed = (i % 4 == 1), has_vertex = !is_closed || i % 8 == 1;
    const std::size_t degree = 1 + i % 5, count = degree + 2 + i % 7;
    std::vector<Point_3> points;
    for (std::size_t j = 0; j < count; ++j)
      points.push_back(point());
    Curve result;
    if (has_vertex)
    {
      result.source = i % 5;
      result.target = is_closed ? result.source : (i + 1) % 5;
      points.front() = wireframe.vertices[result.source];
    }
    points.back() = has_vertex ? wireframe.vertices[result.target] : points.front();
    std::vector<FT> knots(degree + 1, FT(-1) / FT(3)), weights;
    for (std::size_t j = degree + 1; j < count; ++j)
      knots.push_back(knots.back() + number(0.1, 1));
    knots.insert(knots.end(), degree + 1, knots.back() + number(0.1, 1));
    for (std::size_t j = 0; j < count && i % 3 == 0; ++j)
      weights.push_back(number(0.5, 2));
    result.type = type;
    result.spline = typename Curve::Spline(degree, knots, points, weights, is_closed);
    result.rms = number(0, 1);
    result.max = number(0, 1e-300);
    result.support = i * 1000;
    const auto& doubts = CGAL::IO::internal::all_doubts();
    for (std::size_t k = 0; k < doubts.size(); ++k)
      if (i % (k + 2) == 0)
        result.doubts.insert(doubts[k]);
    return result;
  }

  std::mt19937 m_random;
};

// of points or vectors
template <class Traits, class Position>
std::vector<double> numbers_of(const std::vector<Position>& points)
{
  std::vector<double> numbers;
  const auto begin = Traits().construct_cartesian_const_iterator_3_object();
  for (const auto& point : points)
    for (auto iterator = begin(point); iterator != begin(point, 0); ++iterator)
      numbers.push_back(CGAL::to_double(*iterator));
  return numbers;
}

template <class Traits>
std::vector<double> conic_numbers(const CGAL::Wireframe_curve<Traits>& curve)
{
  const auto& c = *curve.conic;
  const auto& u = curve.uncertainty;
  std::vector<double> numbers = numbers_of<Traits>(std::vector<typename Traits::Point_3>{c.center});
  const std::vector<typename Traits::Vector_3> directions = {c.axis, c.major_direction};
  for (const double number : numbers_of<Traits>(directions))
    numbers.push_back(number);
  for (const auto& number : {c.major_radius, c.minor_radius, c.start_angle, c.end_angle, u.position, u.direction,
                             u.major_radius, u.minor_radius})
    numbers.push_back(CGAL::to_double(number));
  return numbers;
}

template <class Traits>
bool are_equal(const CGAL::Wireframe<Traits>& first, const CGAL::Wireframe<Traits>& second)
{
  bool is_equal = first.sampling_distance == second.sampling_distance
    && numbers_of<Traits>(first.vertices) == numbers_of<Traits>(second.vertices)
    && first.curves.size() == second.curves.size();
  for (std::size_t i = 0; i < first.curves.size() && is_equal; ++i)
  {
    const auto& a = first.curves[i];
    const auto& b = second.curves[i];
    is_equal = a.type == b.type && a.source == b.source && a.target == b.target && a.support == b.support
      && a.doubts == b.doubts && a.rms == b.rms && a.max == b.max && bool(a.conic) == bool(b.conic)
      && (!a.conic || conic_numbers(a) == conic_numbers(b)) && a.is_closed() == b.is_closed()
      && a.spline.degree() == b.spline.degree() && a.spline.knots() == b.spline.knots()
      && a.spline.weights() == b.spline.weights()
      && numbers_of<Traits>(a.spline.control_points()) == numbers_of<Traits>(b.spline.control_points());
  }
  return is_equal;
}

template <class Traits>
void test_json_round_trip(unsigned seed)
{
  const CGAL::Wireframe<Traits> wireframe = Random_wireframe<Traits>(seed)();
  CGAL::Wireframe<Traits> result;
  std::string error = "not cleared";
  std::stringstream stream;
  // whatever state the stream is in
  stream.precision(2);
  stream.setf(std::ios::fixed | std::ios::showpos | std::ios::hex);
  assert(CGAL::IO::write_wireframe_json(stream, wireframe, parameters::error_message(&error)));
  assert(error.empty());
  const std::string text = stream.str();
  assert(CGAL::IO::read_wireframe_json(stream, result, parameters::error_message(&error)));
  assert(error.empty() && are_equal(wireframe, result));

  const Test_file file(".json");
  assert(CGAL::IO::write_wireframe(file.name, wireframe));
  assert(file.content() == text);
  assert(CGAL::IO::read_wireframe_json(file.name, result));
  assert(are_equal(wireframe, result));
}

void test_json_details()
{
  CGAL::Wireframe<Kernel> wireframe, result = Random_wireframe<Kernel>(1)();
  std::stringstream stream;
  assert(CGAL::IO::write_wireframe_json(stream, wireframe));
  assert(CGAL::IO::read_wireframe_json(stream, result));
  assert(result.is_empty() && result.vertices.empty() && result.sampling_distance == 0);

  // the sign of zero, the smallest and the largest numbers
  wireframe.vertices = {Point(-0., 5e-324, 1.7976931348623157e308), Point(1e22, 123456789012345678., 1. / 3)};
  std::stringstream extreme;
  assert(CGAL::IO::write_wireframe_json(extreme, wireframe));
  assert(CGAL::IO::read_wireframe_json(extreme, result));
  assert(result.vertices == wireframe.vertices && std::signbit(result.vertices[0].x()));

  // unknown keys, keys that may be missing, a closed curve without vertex
  std::stringstream foreign(
    "{\"format\":\"wireframe\",\"version\":1,\"sampling_distance\":0.5,\"by\":[{}],"
    "\"vertices\":[],\"curves\":[{\"type\":\"bspline\",\"closed\":true,\"degree\":1,\"radius\":null,"
    "\"knots\":[0,0,1,2,3,3],\"control_points\":[[0,0,0],[1,0,0],[0,1,0],[0,0,0]],\"source\":null}]}");
  assert(CGAL::IO::read_wireframe_json(foreign, result));
  assert(result.curves.size() == 1 && result.curves[0].is_closed() && result.curves[0].support == 0);
  assert(result.curves[0].source == CGAL::Wireframe_curve<Kernel>::no_vertex);
  std::stringstream again;
  assert(CGAL::IO::write_wireframe_json(again, result));
  assert(again.str().find("\"source\":null,\"target\":null") != std::string::npos);
  assert(again.str().find("weights") == std::string::npos);
}

// what is told of where a wireframe comes from is read back; nothing is told of what is not known
void test_provenance()
{
  namespace parameters = CGAL::Wireframe_extraction::parameters;
  CGAL::Wireframe_provenance provenance, found;
  provenance.program = "a \"program\" \\ 1.0";
  provenance.inputs = {"a\nb.ply", "\xc3\xa4.ply"};
  provenance.options = {{"--minimum-fold", "30"}, {"--regularize", "true"}};
  provenance.noise_level = 0.125;
  provenance.warnings = {"odd"};
  provenance.regularities = {"equal radii: curves 0, 1"};
  provenance.unit = "in";
  std::stringstream stream;
  assert(CGAL::IO::write_wireframe_json(stream, theta_wireframe(), parameters::provenance(provenance)));
  CGAL::Wireframe<Kernel> wireframe;
  assert(CGAL::IO::read_wireframe_json(stream, wireframe, parameters::provenance(&found)));
  assert(found.program == provenance.program && found.inputs == provenance.inputs && found.unit == "in");
  assert(found.options == provenance.options && found.noise_level == 0.125 && found.warnings == provenance.warnings);
  assert(found.regularities == provenance.regularities && wireframe.curves.size() == theta_wireframe().curves.size());

  std::stringstream untold;
  assert(CGAL::IO::write_wireframe_json(untold, theta_wireframe()));
  assert(untold.str().find("provenance") == std::string::npos);
  assert(CGAL::IO::read_wireframe_json(untold, wireframe, parameters::provenance(&found)));
  assert(found.program.empty() && found.inputs.empty() && found.noise_level == 0.);

  // files of version 1 have no such thing, and are read
  std::string old = untold.str();
  old.replace(old.find("\"version\":2"), 11, "\"version\":1");
  std::istringstream first(old);
  assert(CGAL::IO::read_wireframe_json(first, wireframe) && wireframe.curves.size() == theta_wireframe().curves.size());
}

// the parameters of a conic must be sound, and lead to the ends of its spline
void test_bad_conics()
{
  const auto fails = [](const CGAL::Wireframe<Kernel>& wireframe, const std::string& word) {
    std::ostringstream stream;
    std::string error;
    const bool is_written =
      CGAL::IO::write_wireframe_json(stream, wireframe, CGAL::Wireframe_extraction::parameters::error_message(&error));
    return !is_written && stream.str().empty() && error.find("curve 2") != std::string::npos
      && error.find(word) != std::string::npos;
  };
  const CGAL::Wireframe<Kernel> good = theta_wireframe();
  assert(!fails(good, ""));
  CGAL::Wireframe<Kernel> bad = good;
  bad.curves[2].conic->axis = Kernel::Vector_3(0, 0, 2);
  assert(fails(bad, "axis"));
  bad = good;
  bad.curves[2].conic->minor_radius = -1;
  assert(fails(bad, "radii"));
  bad = good;
  bad.curves[2].conic->end_angle = -1;
  assert(fails(bad, "angle"));
  bad = good;
  bad.curves[2].conic->center = Point(0, 0, 1);
  assert(fails(bad, "ends"));
  bad = good;
  bad.curves[2].uncertainty.position = std::numeric_limits<double>::quiet_NaN();
  assert(fails(bad, "uncertainty"));

  // the reader names what is missing
  std::stringstream stream;
  assert(CGAL::IO::write_wireframe_json(stream, good));
  std::string text = stream.str(), error;
  text.replace(text.find("\"center\""), 8, "\"centre\"");
  std::istringstream input(text);
  assert(!CGAL::IO::read_wireframe_json(input, bad, CGAL::Wireframe_extraction::parameters::error_message(&error)));
  assert(error.find("curve 2: \"center\" is missing") != std::string::npos);
}

// a file that is there is replaced, keeps its permissions, and a link to it stays a link
void test_replacing()
{
  const CGAL::Wireframe<Kernel> wireframe = theta_wireframe();
  const Test_file file(".json", "old");
  const auto read_and_write = std::filesystem::perms::owner_read | std::filesystem::perms::owner_write;
  std::filesystem::permissions(file.name, read_and_write);
  assert(CGAL::IO::write_wireframe(file.name, wireframe));
  CGAL::Wireframe<Kernel> result;
  assert(CGAL::IO::read_wireframe_json(file.name, result) && are_equal(wireframe, result));
  assert(std::filesystem::status(file.name).permissions() == read_and_write);

  const Test_file link("_link.json");
  std::error_code code;
  std::filesystem::create_symlink(file.name, link.name, code);
  if (code)
    return;
  assert(CGAL::IO::write_wireframe(link.name, CGAL::Wireframe<Kernel>()));
  assert(std::filesystem::is_symlink(link.name));
  assert(CGAL::IO::read_wireframe_json(file.name, result) && result.is_empty());
}

// once more where decimals are written with a comma
void test_other_locale()
{
  std::ostringstream json;
  {
    const Comma_locale locale;
    test_json_round_trip<Kernel>(11);
    assert(CGAL::IO::write_wireframe_json(json, theta_wireframe()));
  }
  assert(json.str().find("\"sampling_distance\":0.4,") != std::string::npos);
}

int main()
{
  test_bad_conics();
  for (unsigned seed = 0; seed < 10; ++seed)
  {
    test_json_round_trip<Kernel>(seed);
    test_json_round_trip<CGAL::Exact_predicates_inexact_constructions_kernel>(seed);
    test_json_round_trip<Minimal_traits>(seed);
  }
  test_json_round_trip<CGAL::Simple_cartesian<float>>(3);
  test_json_details();
  test_replacing();
  test_provenance();
  test_other_locale();
  return 0;
}
