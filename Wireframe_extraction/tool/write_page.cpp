#include "write_page.h"

#include "Kernel.h"
#include "shown_cloud.h"

#include <CGAL/Wireframe_extraction/IO/internal/file/byte_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/Sampled_wireframe.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/curve_tools.h>

#include <CGAL/number_utils.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

namespace tool {

#ifdef EXTRACT_WIREFRAME_WITH_VIEWER

// The page without its data, made of the files in viewer/ when the tool is built.
extern const unsigned char page_template[];
extern const std::size_t page_template_size;

bool has_viewer() { return true; }

#else

static const unsigned char page_template[] = {0};
static const std::size_t page_template_size = 0;

bool has_viewer() { return false; }

#endif

namespace {

typedef CGAL::IO::internal::Coordinates Coordinates;
typedef nlohmann::json Json;

// more points than this are thinned out: they would make the page large, and none of them is missed
const std::size_t most_stage_points = 150000;

// Where the cloud is. On the page, positions are relative to it, so that single precision is enough.
class Frame
{
public:
  void add(const Coordinates& point)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      m_low[i] = (std::min)(m_low[i], point[i]);
      m_high[i] = (std::max)(m_high[i], point[i]);
    }
  }

  Coordinates center() const
  {
    return {{0.5 * m_low[0] + 0.5 * m_high[0], 0.5 * m_low[1] + 0.5 * m_high[1], 0.5 * m_low[2] + 0.5 * m_high[2]}};
  }

  // the largest extent
  double size() const
  {
    double size = 0.;
    for (std::size_t i = 0; i < 3; ++i)
      size = (std::max)(size, m_high[i] - m_low[i]);
    return size;
  }

  // from -0.5 to 0.5
  Coordinates place_of(const Coordinates& point) const
  {
    const Coordinates c = center();
    const double s = size();
    return {{(point[0] - c[0]) / s, (point[1] - c[1]) / s, (point[2] - c[2]) / s}};
  }

  std::array<double, 3> extent() const
  {
    const double s = size();
    return {{(m_high[0] - m_low[0]) / s, (m_high[1] - m_low[1]) / s, (m_high[2] - m_low[2]) / s}};
  }

private:
  static constexpr double largest = (std::numeric_limits<double>::max)();

  Coordinates m_low = {{largest, largest, largest}}, m_high = {{-largest, -largest, -largest}};
};

void append_place(const Frame& frame, const Coordinates& point, std::string& bytes)
{
  for (const double coordinate : frame.place_of(point))
    CGAL::IO::internal::append_little_endian(static_cast<float>(coordinate), bytes);
}

// a share from 0 to 1
void append_share(double share, std::string& bytes)
{
  const double number = std::lround(65535. * (std::min)((std::max)(share, 0.), 1.));
  CGAL::IO::internal::append_little_endian(static_cast<std::uint16_t>(number), bytes);
}

void append_colour(const Colour& colour, std::string& bytes)
{
  for (const unsigned char channel : {colour.red, colour.green, colour.blue})
    bytes += static_cast<char>(channel);
}

// Four numbers of 16 bits each: the position and the distance. That is exact to 1/65535 of the size of the cloud.
Json json_of_cloud(const Cloud& cloud, const std::vector<std::size_t>& indices, const Frame& frame)
{
  double largest_value = 0.;
  for (const std::size_t i : indices)
    largest_value = (std::max)(largest_value, cloud[i].second);
  std::string bytes;
  bytes.reserve(8 * indices.size());
  for (const std::size_t i : indices)
  {
    for (const double coordinate : frame.place_of(coordinates_of(cloud[i].first)))
      append_share(coordinate + 0.5, bytes);
    append_share(largest_value > 0. ? cloud[i].second / largest_value : 0., bytes);
  }
  return {{"largest_value", largest_value}, {"samples", CGAL::IO::internal::to_base64(bytes)}};
}

// All points that edges need come first and stay; of the others an even share.
class Thinned_geometry
{
public:
  explicit Thinned_geometry(const Coloured_geometry& geometry)
  {
    const std::size_t count = geometry.points().size();
    std::vector<char> has_edge(count, 0);
    for (const auto& edge : geometry.edges())
      has_edge[edge[0]] = has_edge[edge[1]] = 1;
    const std::size_t number_of_free = static_cast<std::size_t>(std::count(has_edge.begin(), has_edge.end(), 0));
    const std::size_t step = number_of_free / most_stage_points + 1;
    m_new_index.resize(count);
    std::size_t position = 0;
    for (std::size_t i = 0; i < count; ++i)
      if (has_edge[i] || position++ % step == 0)
      {
        m_new_index[i] = static_cast<std::uint32_t>(m_indices.size());
        m_indices.push_back(i);
      }
  }

  const std::vector<std::size_t>& indices() const { return m_indices; }
  std::uint32_t new_index(std::size_t index) const { return m_new_index[index]; }

private:
  std::vector<std::size_t> m_indices;
  std::vector<std::uint32_t> m_new_index;
};

std::string title_of(const std::string& stage)
{
  return stage == "skeleton" ? "Skeleton"
    : stage == "feet"        ? "Contracted skeleton"
    : stage == "corners"     ? "Corners"
    : stage == "clusters"    ? "Clusters"
    : stage == "graph"       ? "Graph"
                             : "Fitted curves";
}

Json json_of_stage(const Recorded_stage& stage, const Frame& frame)
{
  using CGAL::IO::internal::append_little_endian;
  using CGAL::IO::internal::to_base64;
  const Coloured_geometry& geometry = stage.geometry;
  const Thinned_geometry thinned(geometry);
  std::string positions, colours, edges, edge_colours;
  for (const std::size_t i : thinned.indices())
  {
    append_place(frame, geometry.points()[i], positions);
    append_colour(geometry.colours()[i], colours);
  }
  for (std::size_t i = 0; i < geometry.edges().size(); ++i)
  {
    for (const std::uint32_t index : geometry.edges()[i])
      append_little_endian(thinned.new_index(index), edges);
    append_colour(geometry.edge_colours()[i], edge_colours);
  }
  // not the name of a layer that is there anyway
  return {{"name", "stage-" + stage.name},          {"title", title_of(stage.name)}, {"count", stage.count},
          {"positions", to_base64(positions)},      {"colours", to_base64(colours)}, {"edges", to_base64(edges)},
          {"edge_colours", to_base64(edge_colours)}};
}

Json index_or_null(std::size_t vertex)
{
  return vertex == CGAL::Wireframe_curve<Kernel>::no_vertex ? Json() : Json(vertex);
}

Json json_of_curve(std::size_t index, const CGAL::Wireframe_curve<Kernel>& curve, std::size_t first, std::size_t count)
{
  Json json = {{"index", index},
               {"type", CGAL::to_string(curve.type)},
               {"closed", curve.is_closed()},
               {"source", index_or_null(curve.source)},
               {"target", index_or_null(curve.target)},
               {"length", CGAL::to_double(curve.length())},
               {"rms", curve.rms},
               {"max", curve.max},
               {"support", curve.support},
               {"doubts", Json::array()},
               {"first", first},
               {"count", count}};
  for (const CGAL::Wireframe_doubt doubt : curve.doubts)
    json["doubts"].push_back(to_string(doubt));
  if (curve.conic)
    json["radii"] = {curve.conic->major_radius, curve.conic->minor_radius};
  return json;
}

void add_curves(const CGAL::Wireframe<Kernel>& wireframe, const CGAL::IO::internal::Sampled_wireframe& sampled,
                const Frame& frame, Json& json)
{
  std::string vertices, points;
  for (std::size_t i = 0; i < wireframe.vertices.size(); ++i)
    append_place(frame, sampled.points[i], vertices);
  json["curves"] = Json::array();
  std::size_t first = 0;
  for (std::size_t i = 0; i < wireframe.curves.size(); ++i)
  {
    for (const std::size_t index : sampled.polylines[i])
      append_place(frame, sampled.points[index], points);
    json["curves"].push_back(json_of_curve(i, wireframe.curves[i], first, sampled.polylines[i].size()));
    first += sampled.polylines[i].size();
  }
  json["vertices"] = CGAL::IO::internal::to_base64(vertices);
  json["curve_points"] = CGAL::IO::internal::to_base64(points);
}

Json json_of_colours()
{
  Json json;
  for (const CGAL::Wireframe_curve_type type : CGAL::IO::internal::all_curve_types())
    json[CGAL::to_string(type)] = CGAL::IO::internal::hexadecimal(CGAL::IO::internal::colour_of(type));
  return json;
}

Json json_of_field_colours()
{
  Json json = Json::array();
  for (const CGAL::IO::internal::Colour& colour : field_colours())
    json.push_back(CGAL::IO::internal::hexadecimal(colour));
  return json;
}

Json json_of_texts(const Page_texts& texts)
{
  Json json = {{"format", "wireframe page"},
               {"version", 1},
               {"title", texts.title},
               {"unit", texts.unit},
               {"program", texts.program},
               {"warnings", texts.warnings},
               {"type_colours", json_of_colours()},
               {"field_colours", json_of_field_colours()}};
  for (const char* const name : {"summary", "seconds", "parameters"})
    json[name] = Json::array();
  for (const auto& row : texts.summary)
    json["summary"].push_back(Json::array({row.first, row.second}));
  for (const auto& stage : texts.seconds)
    json["seconds"].push_back(Json::array({stage.first, stage.second}));
  for (const Parameter& parameter : texts.parameters)
    json["parameters"].push_back({{"group", parameter.group},
                                  {"name", parameter.name},
                                  {"value", parameter.value},
                                  {"is_given", parameter.is_given}});
  return json;
}

// No name of a file may end the element of the page in which the data are.
void write_escaped(std::ostream& stream, const std::string& text)
{
  std::size_t begin = 0;
  for (std::size_t i = text.find('<'); i != std::string::npos; i = text.find('<', begin))
  {
    stream.write(text.data() + begin, static_cast<std::streamsize>(i - begin));
    stream << "\\u003c";
    begin = i + 1;
  }
  stream.write(text.data() + begin, static_cast<std::streamsize>(text.size() - begin));
}

} // namespace

bool write_page(std::ostream& stream, const Page_texts& texts, const Cloud& cloud,
                const std::vector<Recorded_stage>& stages, const CGAL::Wireframe<Kernel>& wireframe, std::string& error)
{
  const std::string page(reinterpret_cast<const char*>(page_template), page_template_size);
  const std::string mark = "@WIREFRAME_DATA@";
  const std::size_t place = page.find(mark);
  CGAL::IO::internal::Sampled_wireframe sampled;
  if (place == std::string::npos)
    error = "the tool was built without its viewer";
  else
    sampled.sample(wireframe, 0., Kernel(), error);
  if (!error.empty())
    return false;

  Frame frame;
  std::vector<std::size_t> indices = indices_of_valid(cloud);
  for (const std::size_t i : indices)
    frame.add(coordinates_of(cloud[i].first));
  if (indices.empty()) // the curves say where everything is
    for (const Coordinates& point : sampled.points)
      frame.add(point);
  if (!std::isfinite(frame.size()) || !(frame.size() > 0.))
  {
    error = "the cloud is too large or too small to be drawn; scale it";
    return false;
  }
  shuffle(indices);
  Json json = json_of_texts(texts);
  json["number_of_points"] = indices.size();
  json["sampling_distance"] = CGAL::to_double(wireframe.sampling_distance);
  json["center"] = frame.center();
  json["size"] = frame.size();
  json["extent"] = frame.extent();
  json["cloud"] = json_of_cloud(cloud, indices, frame);
  json["layers"] = Json::array();
  for (const Recorded_stage& stage : stages)
    json["layers"].push_back(json_of_stage(stage, frame));
  add_curves(wireframe, sampled, frame, json);

  stream.write(page.data(), static_cast<std::streamsize>(place));
  // names of files need not be valid text
  write_escaped(stream, json.dump(-1, ' ', true, Json::error_handler_t::replace));
  stream << page.substr(place + mark.size());
  return true;
}

} // namespace tool
