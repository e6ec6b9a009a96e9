// Makes clouds with exact ground truth from closed-form solids.

#include <Case_maker/number_check.h>
#include <Sample_solids/Sample_solids.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <new>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace Sample_solids;
using Case_maker::number_check;
namespace fs = std::filesystem;

const std::size_t most_points = 100000000;

/// A fault of the caller, told apart from faults of the machine by the exit code.
struct Usage_error : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

struct Arguments
{
  std::string shape, output, truth, field, sampling = "poisson", scope = "adjacent";
  std::vector<std::string> fields;
  double sampling_distance = 0.02, angle = 30, radius = 1, truncation = 50, position_noise = 0.25, scale = 1;
  std::size_t points = 0;
  std::uint64_t seed = 1;
  bool has_angle = false, has_radius = false, has_noise = false, is_list = false, is_forced = false, is_bare = false;

  bool is_one_file() const { return fs::path(output).extension() == ".ply"; }
};

std::string names_of_solids()
{
  std::string result;
  for (const auto& solid : solid_names())
    result += (result.empty() ? "" : ", ") + solid.first;
  return result;
}

void list_solids()
{
  for (const auto& solid : solid_names())
    std::cout << std::left << std::setw(20) << solid.first << solid.second << '\n';
}

void check(Arguments& a)
{
  if (a.shape.empty())
    throw Usage_error("name a solid; --list lists them");
  bool is_known = false;
  for (const auto& solid : solid_names())
    is_known = is_known || solid.first == a.shape;
  if (!is_known)
    throw Usage_error("there is no solid '" + a.shape + "'; there are " + names_of_solids());
  if (a.output.empty())
    throw Usage_error("say where to write: -o DIRECTORY or -o FILE.ply");
  if (a.has_angle && a.shape != "wedge")
    throw Usage_error("--angle is for the wedge only");
  if (a.has_radius && a.shape != "rounded_plate")
    throw Usage_error("--radius is for the rounded plate only");
  if (a.is_one_file() && !a.fields.empty())
    throw Usage_error("--fields is for an output directory; for one file give --field");
  if (!a.is_one_file() && (!a.field.empty() || !a.truth.empty()))
    throw Usage_error("--field and --truth are for one output file (-o FILE.ply), --fields for a directory");
  if (!a.truth.empty() && fs::path(a.truth).lexically_normal() == fs::path(a.output).lexically_normal())
    throw Usage_error("the cloud and its ground truth cannot be the same file");
  if (a.is_one_file())
    a.fields = {a.field.empty() ? "exact" : a.field};
  else if (a.fields.empty())
    a.fields = {"exact", "def", "noisy"};
  const bool is_noisy = std::find(a.fields.begin(), a.fields.end(), "noisy") != a.fields.end();
  if (a.has_noise && !is_noisy)
    throw Usage_error("--position-noise moves the points of the noisy field only, which is not asked for");
}

/// The solid and its sampling distance. Where lengths of the solid depend on that, it takes some rounds.
Solid solid_for(Arguments& a)
{
  Solid_options options;
  options.angle = a.angle;
  options.radius = a.radius;
  options.sampling_distance = a.sampling_distance;
  Solid solid = make_solid(a.shape, options);
  for (int i = 0; i < 30 && a.points > 0; ++i)
  {
    a.sampling_distance = sampling_distance_for(solid.area(), a.points);
    if (!depends_on_sampling_distance(a.shape))
      break;
    options.sampling_distance = a.sampling_distance;
    solid = make_solid(a.shape, options);
  }
  const double n = density * solid.area() / (a.sampling_distance * a.sampling_distance);
  if (!(n >= 50 && n <= static_cast<double>(most_points)))
  {
    std::ostringstream text;
    text << "a sampling distance of " << a.sampling_distance << " makes a cloud of about " << n
         << " points; 50 to 100000000 are possible";
    throw Usage_error(text.str());
  }
  return solid;
}

template <class Writer>
void write(const fs::path& path, bool is_forced, Writer writer)
{
  if (!is_forced && fs::exists(path))
    throw std::runtime_error("'" + path.string() + "' exists; --force overwrites it");
  std::ofstream out(path, std::ios::binary);
  if (!out)
    throw std::runtime_error("cannot write '" + path.string() + "'; is its folder there and writable?");
  if (!writer(out))
    throw std::runtime_error("writing '" + path.string() + "' failed; is the disk full?");
}

std::vector<fs::path> paths_of_clouds(const Arguments& a)
{
  std::vector<fs::path> result;
  for (const std::string& field : a.fields)
    result.push_back(a.is_one_file() ? fs::path(a.output) : fs::path(a.output) / (field + ".ply"));
  return result;
}

fs::path path_of_truth(const Arguments& a)
{
  return a.is_one_file() ? fs::path(a.truth) : fs::path(a.output) / "truth.json";
}

/// finds out before the work is done whether it can be written.
void check_outputs(const Arguments& a)
{
  if (!a.is_one_file())
    fs::create_directories(a.output);
  std::vector<fs::path> paths = paths_of_clouds(a);
  if (!path_of_truth(a).empty())
    paths.push_back(path_of_truth(a));
  for (const fs::path& path : paths)
  {
    if (!a.is_forced && fs::exists(path))
      throw std::runtime_error("'" + path.string() + "' exists; --force overwrites it");
    if (path.has_parent_path() && !fs::is_directory(path.parent_path()))
      throw std::runtime_error("cannot write '" + path.string() + "': its folder does not exist");
  }
}

void print_counts(const Arguments& a, const Ground_truth& truth, std::size_t points)
{
  std::cout << a.shape << ": " << points << " points, sampling distance " << truth.sampling_distance << ", "
            << truth.curves.size() << " curves (" << truth.segments.size() << " segments), " << truth.corners.size()
            << " corners\n";
}

/// writes a cloud of uniformly random points with an exact field, which is never in memory as a whole.
std::size_t write_piece_by_piece(const Arguments& a, const Solid& solid, const Sampling_options& options,
                                 const Ground_truth& truth)
{
  const std::size_t points = number_of_points(solid.area(), options.sampling_distance);
  print_counts(a, truth, points);
  const fs::path path = paths_of_clouds(a).front();
  write(path, a.is_forced, [&](std::ostream& out) {
    write_ply_header(out, truth.sampling_distance, points);
    return sample_uniformly(solid, options,
                            [&](Cloud& piece) {
                              scale(piece, a.scale);
                              return write_ply_points(out, piece);
                            })
      && out.flush();
  });
  std::cout << "exact: RMSE 0 r, 0 % off by more than r: " << path.string() << '\n';
  return points;
}

/// writes all clouds that are asked for, and returns how many points they have.
std::size_t write_clouds(const Arguments& a, const Solid& solid, const Sampling_options& options,
                         const Ground_truth& truth)
{
  if (!a.is_bare && options.sampling == Sampling::UNIFORM && a.fields == std::vector<std::string>{"exact"})
    return write_piece_by_piece(a, solid, options, truth);
  const Cloud exact = sample_exactly(solid, options);
  print_counts(a, truth, exact.points.size());
  const std::vector<fs::path> paths = paths_of_clouds(a);
  for (std::size_t i = 0; i < paths.size(); ++i)
  {
    Cloud cloud = exact;
    const Field_kind kind = field_kind_of(a.fields[i]);
    disturb(cloud, kind, kind == Field_kind::NOISY ? a.position_noise : 0., a.seed);
    const Field_statistics statistics = field_statistics(cloud);
    scale(cloud, a.scale);
    if (a.is_bare)
      cloud.distances.clear();
    write(paths[i], a.is_forced, [&cloud](std::ostream& out) { return write_ply(out, cloud); });
    std::cout << std::setprecision(3) << a.fields[i] << ": RMSE " << statistics.root_mean_square << " r, "
              << 100. * statistics.share_off << " % off by more than r: " << paths[i].string() << '\n';
  }
  return exact.points.size();
}

void run(Arguments a)
{
  check(a);
  const Solid solid = solid_for(a);
  check_outputs(a);

  Sampling_options options;
  options.sampling_distance = a.sampling_distance;
  options.sampling = a.sampling == "poisson" ? Sampling::POISSON : Sampling::UNIFORM;
  options.scope = a.scope == "all" ? Field_scope::ALL : Field_scope::ADJACENT;
  options.truncation = a.truncation;
  options.seed = a.seed;
  Ground_truth truth = ground_truth(solid, a.sampling_distance);
  scale(truth, a.scale);
  const std::size_t points = write_clouds(a, solid, options, truth);
  if (!path_of_truth(a).empty())
    write(path_of_truth(a), a.is_forced, [&](std::ostream& out) { return write_truth(out, truth, a.shape, points); });
}

std::string check_seed(const std::string& text)
{
  const bool is_whole = !text.empty() && text.size() <= 19 && text.find_first_not_of("0123456789") == std::string::npos;
  return is_whole ? "" : "'" + text + "' is not a whole number between 0 and 9999999999999999999";
}

void add_options(CLI::App& app, Arguments& a)
{
  app.set_version_flag("--version", std::string("make_cloud ") + WIREFRAME_EXTRACTION_VERSION_STRING);
  app.add_option("shape", a.shape, "the solid: " + names_of_solids());
  app.add_flag("--list", a.is_list, "list the solids");
  app.add_option("-o,--output", a.output,
                 "a directory for truth.json and one cloud per field, or a file FILE.ply for one cloud");
  app.add_option("--truth", a.truth, "with one output file: where to write the ground truth");
  app.add_option("--field", a.field, "with one output file: its field; default exact")
    ->check(CLI::IsMember({"exact", "def", "noisy"}));
  app.add_option("--fields", a.fields, "with a directory: the fields, separated by commas; default all three")
    ->delimiter(',')
    ->check(CLI::IsMember({"exact", "def", "noisy"}));
  CLI::Option* r = app.add_option("--r", a.sampling_distance, "sampling distance, before scaling")
                     ->capture_default_str()
                     ->check(number_check());
  app.add_option("--points", a.points, "number of points; the sampling distance follows from it")
    ->excludes(r)
    ->check(CLI::Range(std::size_t(50), most_points));
  app
    .add_option("--sampling", a.sampling,
                "Poisson-disk or uniformly random points; uniform ones "
                "with an exact field only are written piece by piece, however many they are")
    ->capture_default_str()
    ->check(CLI::IsMember({"poisson", "uniform"}));
  app
    .add_option("--field-scope", a.scope,
                "which sharp curves count: those of the point's own face and the "
                "faces adjacent to it, or all")
    ->capture_default_str()
    ->check(CLI::IsMember({"adjacent", "all"}));
  app.add_option("--truncate", a.truncation, "upper bound of the field, in sampling distances")
    ->capture_default_str()
    ->check(number_check());
  app
    .add_option("--position-noise", a.position_noise,
                "by how much the noisy field's points are moved: the standard deviation per coordinate, in "
                "sampling distances")
    ->capture_default_str()
    ->check(number_check(true));
  app.add_option("--angle", a.angle, "of the wedge, in degrees")->capture_default_str()->check(CLI::Range(5., 170.));
  app.add_option("--radius", a.radius, "of the rounded plate's corners, in sampling distances")
    ->capture_default_str()
    ->check(CLI::Range(0.1, 10.));
  app.add_option("--scale", a.scale, "multiplies all lengths, the sampling distance too")
    ->capture_default_str()
    ->check(number_check());
  app.add_option("--seed", a.seed, "of the random numbers, a whole number")
    ->capture_default_str()
    ->check(CLI::Validator(check_seed, ""));
  app.add_flag(
    "--without-distances", a.is_bare,
    "leave the distances out, as a scanner does; what a field says of the points, such as their noise, stays");
  app.add_flag("--force", a.is_forced, "overwrite existing files");
}

} // namespace

int main(int argc, char** argv)
{
  CLI::App app("Makes clouds with exact ground truth from closed-form solids.", "make_cloud");
  Arguments arguments;
  add_options(app, arguments);
  try
  {
    app.parse(argc, argv);
    arguments.has_angle = app.count("--angle") > 0;
    arguments.has_radius = app.count("--radius") > 0;
    arguments.has_noise = app.count("--position-noise") > 0;
    if (arguments.is_list)
      list_solids();
    else
      run(arguments);
    return 0;
  }
  catch (const CLI::ParseError& error)
  {
    if (error.get_exit_code() == 0)
      return app.exit(error);
    std::cerr << "make_cloud: " << error.what() << '\n';
    return 2;
  }
  catch (const Usage_error& error)
  {
    std::cerr << "make_cloud: " << error.what() << '\n';
    return 2;
  }
  catch (const std::bad_alloc&)
  {
    std::cerr << "make_cloud: not enough memory; ask for fewer points\n";
    return 1;
  }
  catch (const std::exception& error)
  {
    std::cerr << "make_cloud: " << error.what() << '\n';
    return 1;
  }
}
