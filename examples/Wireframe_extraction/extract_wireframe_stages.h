// Writes the result of each stage as a coloured PLY file, for MeshLab and CloudCompare.

#ifndef EXTRACT_WIREFRAME_STAGES_H
#define EXTRACT_WIREFRAME_STAGES_H

#include <CGAL/Wireframe_extraction/IO/internal/Sampled_wireframe.h>
#include <CGAL/Wireframe_extraction/IO/internal/write_beside_and_rename.h>
#include <CGAL/Wireframe_extraction/IO/write_wireframe_ply.h>

#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/range/iterator_range.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <ostream>
#include <string>
#include <system_error>
#include <vector>

namespace tool {

struct Colour
{
  unsigned char red, green, blue;
};

const Colour grey = { 150, 150, 150 };
const Colour corner_colour = { 230, 30, 30 };

// from blue over green and yellow to red, for 0 to 1
inline Colour colour_of_value(double value)
{
  static const Colour stops[] = {{40, 60, 200}, {30, 170, 200}, {60, 190, 80}, {240, 210, 40}, {220, 40, 30}};
  const double position = 4. * (std::min)((std::max)(value, 0.), 1.);
  const int first = (std::min)(static_cast<int>(position), 3);
  const double t = position - first;
  const auto mix = [t](unsigned char a, unsigned char b)
  {
    return static_cast<unsigned char>(std::lround((1. - t) * a + t * b));
  };
  const Colour& a = stops[first];
  const Colour& b = stops[first + 1];
  return { mix(a.red, b.red), mix(a.green, b.green), mix(a.blue, b.blue) };
}

// neighbouring indices get colours far apart
inline Colour colour_of_index(std::size_t index)
{
  const double hue = 6. * std::fmod(static_cast<double>(index) * 0.6180339887498949, 1.);
  const double strength = (index / 3) % 2 == 0 ? 230. : 160.;
  const auto channel = [hue, strength](double peak)
  {
    const double away = (std::min)(std::abs(hue - peak), 6. - std::abs(hue - peak));
    return static_cast<unsigned char>(std::lround(strength * (std::min)((std::max)(2. - away, 0.1), 1.)));
  };
  return { channel(0.), channel(2.), channel(4.) };
}

// points, each with a colour and a value, and edges between them
class Coloured_ply
{
public:
  // CloudCompare shows the properties scalar_... of a file under the rest of their names
  explicit Coloured_ply(const std::string& value_name) : m_value_name(value_name) {}

  template <class Point>
  std::size_t add_point(const Point& point, const Colour& colour, double value)
  {
    return add_point(std::array<double, 3>{ CGAL::to_double(point.x()), CGAL::to_double(point.y()),
                                            CGAL::to_double(point.z()) }, colour, value);
  }

  std::size_t add_point(const std::array<double, 3>& point, const Colour& colour, double value)
  {
    for(const double coordinate : point)
      CGAL::IO::internal::append_little_endian(coordinate, m_vertices);
    append_colour(colour, m_vertices);
    CGAL::IO::internal::append_little_endian(value, m_vertices);
    return m_number_of_vertices++;
  }

  void add_edge(std::size_t first, std::size_t second, const Colour& colour)
  {
    for(const std::size_t index : { first, second })
      CGAL::IO::internal::append_little_endian(static_cast<std::uint32_t>(index), m_edges);
    append_colour(colour, m_edges);
    ++m_number_of_edges;
  }

  // returns what went wrong, nothing if all went well
  std::string write(const std::string& filename) const
  {
    std::string error;
    CGAL::IO::internal::write_beside_and_rename(filename, [this](std::ostream& stream, std::string&)
    {
      write_header(stream);
      stream << m_vertices << m_edges;
      return true;
    }, error);
    return error;
  }

private:
  static void append_colour(const Colour& colour, std::string& bytes)
  {
    for(const unsigned char channel : { colour.red, colour.green, colour.blue })
      bytes += static_cast<char>(channel);
  }

  void write_header(std::ostream& stream) const
  {
    const std::string colours = "property uchar red\nproperty uchar green\nproperty uchar blue\n";
    stream << "ply\nformat binary_little_endian 1.0\nelement vertex " << std::to_string(m_number_of_vertices)
           << "\nproperty double x\nproperty double y\nproperty double z\n" << colours
           << "property double scalar_" << m_value_name << '\n';
    if(m_number_of_edges > 0)
      stream << "element edge " << std::to_string(m_number_of_edges)
             << "\nproperty int vertex1\nproperty int vertex2\n" << colours;
    stream << "end_header\n";
  }

  std::string m_value_name, m_vertices, m_edges;
  std::size_t m_number_of_vertices = 0, m_number_of_edges = 0;
};

// The folder for the stages, made if missing. What was made and stays empty is removed at the end.
class Stage_folder
{
public:
  static const std::vector<std::string>& file_names()
  {
    static const std::vector<std::string> names = { "1_skeleton.ply", "2_feet.ply", "3_corners.ply",
                                                    "4_clusters.ply", "5_graph.ply", "6_curves.ply" };
    return names;
  }

  Stage_folder() {}
  Stage_folder(const Stage_folder&) = delete;
  Stage_folder& operator=(const Stage_folder&) = delete;

  ~Stage_folder()
  {
    std::error_code ignored; // a folder that is not empty is not removed
    for(auto folder = m_made.rbegin(); folder != m_made.rend(); ++folder)
      std::filesystem::remove(*folder, ignored);
  }

  // returns what went wrong, nothing if all went well
  std::string make(const std::string& name)
  {
    namespace fs = std::filesystem;
    if(name.empty())
      return "the name of the folder for the stages is empty";
    m_path = fs::path(name);
    std::error_code code;
    std::vector<fs::path> missing;
    for(fs::path p = fs::absolute(m_path, code).lexically_normal(); !fs::exists(p, code); p = p.parent_path())
      if(p.has_filename())
        missing.push_back(p);
    for(auto folder = missing.rbegin(); folder != missing.rend(); ++folder)
    {
      if(!fs::create_directory(*folder, code))
        return name + ": the folder for the stages cannot be made: " + code.message();
      m_made.push_back(*folder);
    }
    if(!fs::is_directory(m_path, code))
      return name + ": is not a folder, so the stages cannot be written there";
    return std::string();
  }

  bool is_given() const { return !m_path.empty(); }
  std::string path_of(const std::string& file_name) const { return (m_path / file_name).string(); }

  // an old result must not be taken for one of this run
  void remove_old_files() const
  {
    std::error_code ignored;
    for(const std::string& name : file_names())
      if(std::filesystem::is_regular_file(m_path / name, ignored))
        std::filesystem::remove(m_path / name, ignored);
  }

private:
  std::filesystem::path m_path;
  std::vector<std::filesystem::path> m_made;
};

// Writes stage after stage; remembers the first thing that went wrong, and the files that were written.
class Stage_writer
{
public:
  explicit Stage_writer(const Stage_folder& folder) : m_folder(folder) {}

  const std::string& error() const { return m_error; }
  const std::vector<std::string>& written_files() const { return m_written_files; }

  template <class Skeleton>
  void write_skeleton(const Skeleton& skeleton)
  {
    if(!is_on())
      return;
    double largest = 0.;
    for(std::size_t i = 0; i < skeleton.size(); ++i)
      largest = (std::max)(largest, CGAL::to_double(skeleton.distance(i)));
    Coloured_ply ply("distance");
    for(std::size_t i = 0; i < skeleton.size(); ++i)
    {
      const double distance = CGAL::to_double(skeleton.distance(i));
      ply.add_point(skeleton.point(i), colour_of_value(largest > 0. ? distance / largest : 0.), distance);
    }
    write(ply, 0);
  }

  template <class Skeleton>
  void write_feet(const Skeleton& skeleton)
  {
    if(!is_on() || !skeleton.is_contracted())
      return;
    Coloured_ply ply("residual");
    for(std::size_t i = 0; i < skeleton.size(); ++i)
    {
      const double residual = CGAL::to_double(skeleton.residual(i));
      ply.add_point(skeleton.foot(i),
                    colour_of_value(residual / CGAL::to_double(skeleton.sampling_distance())), residual);
    }
    write(ply, 1);
  }

  template <class Skeleton, class Corners>
  void write_corners(const Skeleton& skeleton, const Corners& corners)
  {
    if(!is_on())
      return;
    std::vector<std::size_t> corner_of_point(skeleton.size(), corners.size());
    for(std::size_t i = 0; i < corners.size(); ++i)
      for(const std::size_t member : corners[i].members)
        if(member < skeleton.size())
          corner_of_point[member] = i;
    Coloured_ply ply("corner");
    add_by_index(skeleton, corner_of_point, corners.size(), ply);
    for(std::size_t i = 0; i < corners.size(); ++i)
      add_ball(corners[i], static_cast<double>(i), ply);
    write(ply, 2);
  }

  template <class Skeleton, class Clusters>
  void write_clusters(const Skeleton& skeleton, const Clusters& clusters)
  {
    if(!is_on())
      return;
    std::vector<std::size_t> cluster_of_point(skeleton.size(), clusters.size());
    for(std::size_t i = 0; i < clusters.size(); ++i)
      for(const std::size_t member : clusters[i])
        if(member < skeleton.size())
          cluster_of_point[member] = i;
    Coloured_ply ply("cluster");
    add_by_index(skeleton, cluster_of_point, clusters.size(), ply);
    write(ply, 3);
  }

  template <class Graph>
  void write_graph(const Graph& graph)
  {
    if(!is_on())
      return;
    Coloured_ply ply("corner");
    for(const auto v : boost::make_iterator_range(vertices(graph)))
      ply.add_point(get(CGAL::vertex_point, graph, v), graph[v].is_corner ? corner_colour : grey,
                    graph[v].is_corner ? 1. : 0.);
    for(const auto e : boost::make_iterator_range(edges(graph)))
      ply.add_edge(source(e, graph), target(e, graph), colour_of_index(graph[e].curve_id));
    write(ply, 4);
  }

  template <class Wireframe>
  void write_curves(const Wireframe& wireframe)
  {
    if(!is_on() || wireframe.is_empty())
      return;
    CGAL::IO::internal::Sampled_wireframe sampled;
    std::string error;
    if(!sampled.sample(wireframe, 0., typename Wireframe::Geom_traits(), error))
    {
      m_error = m_folder.path_of(Stage_folder::file_names()[5]) + ": " + error;
      return;
    }
    Coloured_ply ply("curve");
    // every curve has points of its own, so that each point has the colour of its curve
    for(std::size_t i = 0; i < sampled.polylines.size(); ++i)
    {
      const Colour colour = colour_of_index(i);
      std::size_t last = 0;
      for(std::size_t j = 0; j < sampled.polylines[i].size(); ++j)
      {
        const auto& p = sampled.points[sampled.polylines[i][j]];
        const std::size_t index = ply.add_point(std::array<double, 3>{ p[0], p[1], p[2] }, colour,
                                                static_cast<double>(i));
        if(j > 0)
          ply.add_edge(last, index, colour);
        last = index;
      }
    }
    write(ply, 5);
  }

private:
  bool is_on() const { return m_folder.is_given() && m_error.empty(); }

  // what belongs to nothing is grey, with the value -1
  template <class Skeleton>
  static void add_by_index(const Skeleton& skeleton, const std::vector<std::size_t>& index_of_point,
                           std::size_t number_of_indices, Coloured_ply& ply)
  {
    for(std::size_t i = 0; i < skeleton.size(); ++i)
    {
      const std::size_t index = index_of_point[i];
      const bool is_free = (index == number_of_indices);
      ply.add_point(skeleton.is_contracted() ? skeleton.foot(i) : skeleton.point(i),
                    is_free ? grey : colour_of_index(index), is_free ? -1. : static_cast<double>(index));
    }
  }

  // a single point is hard to see: three circles show the ball of the corner
  template <class Corner>
  static void add_ball(const Corner& corner, double value, Coloured_ply& ply)
  {
    const std::array<double, 3> center = {CGAL::to_double(corner.center.x()),
                                          CGAL::to_double(corner.center.y()),
                                          CGAL::to_double(corner.center.z())};
    const double radius = CGAL::to_double(corner.radius);
    const std::size_t count = 24;
    ply.add_point(center, corner_colour, value);
    for(std::size_t axis = 0; axis < 3; ++axis)
    {
      std::size_t first = 0, last = 0;
      for(std::size_t i = 0; i < count; ++i)
      {
        const double angle = 2. * CGAL_PI * static_cast<double>(i) / static_cast<double>(count);
        std::array<double, 3> point = center;
        point[axis] += radius * std::cos(angle);
        point[(axis + 1) % 3] += radius * std::sin(angle);
        const std::size_t index = ply.add_point(point, corner_colour, value);
        if(i == 0)
          first = index;
        else
          ply.add_edge(last, index, corner_colour);
        last = index;
      }
      ply.add_edge(last, first, corner_colour);
    }
  }

  void write(const Coloured_ply& ply, std::size_t stage)
  {
    const std::string filename = m_folder.path_of(Stage_folder::file_names()[stage]);
    m_error = ply.write(filename);
    if(m_error.empty())
      m_written_files.push_back(filename);
  }

  const Stage_folder& m_folder;
  std::string m_error;
  std::vector<std::string> m_written_files;
};

} // namespace tool

#endif // EXTRACT_WIREFRAME_STAGES_H
