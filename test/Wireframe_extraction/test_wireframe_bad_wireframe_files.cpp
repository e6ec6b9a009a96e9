// Files of wireframes that are refused, wireframes that are not written, and files that cannot be.

#include <CGAL/Wireframe_extraction/IO/read_wireframe_json.h>

#include "check_words.h"
#include "scratch_files.h"

#include <CGAL/Wireframe_extraction/IO/write_wireframe.h>
#include <CGAL/Wireframe_extraction/parameters.h>

#include <CGAL/Simple_cartesian.h>

#include <cassert>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <stdexcept>
#include <streambuf>
#include <string>

namespace fs = std::filesystem;
namespace parameters = CGAL::Wireframe_extraction::parameters;

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point;
typedef CGAL::Wireframe<Kernel> Wireframe;
typedef CGAL::Wireframe_curve<Kernel> Curve;

// a valid file, in which `from` is replaced by `to`
std::string json(const std::string& from = "", const std::string& to = "")
{
  std::string text = "{\"format\":\"wireframe\",\"version\":1,\"sampling_distance\":0.5,\"vertices\":[[0,0,0],[1,0,0]],"
                     "\"curves\":[{\"type\":\"line\",\"closed\":false,\"source\":0,\"target\":1,\"degree\":1,"
                     "\"knots\":[0,0,1,1],\"control_points\":[[0,0,0],[1,0,0]],\"rms\":0.1,\"max\":0.2,\"support\":10},"
                     "{\"type\":\"bspline\",\"closed\":false,\"source\":1,\"target\":0,\"degree\":2,"
                     "\"knots\":[0,0,0,0.5,1,1,1],\"control_points\":[[1,0,0],[1,1,0],[0,1,0],[0,0,0]],"
                     "\"weights\":[1,2,3,4],\"rms\":0.3,\"max\":0.4,"
                     "\"support\":30}]}";
  if (!from.empty())
  {
    const std::size_t position = text.find(from);
    assert(position != std::string::npos);
    text.replace(position, from.size(), to);
  }
  return text;
}

void refuse_json(const std::string& content, const Words& words)
{
  const Test_file file(".json", content);
  Wireframe wireframe;
  wireframe.vertices.push_back(Point(7, 7, 7));
  std::string error;
  assert(!CGAL::IO::read_wireframe_json(file.name, wireframe, parameters::error_message(&error)));
  assert(wireframe.vertices.size() == 1 && wireframe.curves.empty());
  check_words(error, words);
  check_words(error, {file.name});
  std::istringstream stream(content);
  assert(!CGAL::IO::read_wireframe_json(stream, wireframe));
}

void test_json_documents()
{
  std::istringstream valid(json());
  Wireframe wireframe;
  assert(CGAL::IO::read_wireframe_json(valid, wireframe) && wireframe.curves.size() == 2);

  refuse_json("", {"is empty"});
  refuse_json("{", {"JSON", "truncated", "line 1"});
  refuse_json(json().substr(0, 100), {"JSON", "truncated"});
  refuse_json(json() + "x", {"JSON"});
  refuse_json(std::string(1000000, '['), {"JSON"});
  refuse_json(std::string("\xff\xfe{\0", 4), {"JSON"});
  refuse_json("[]", {"no wireframe"});
  refuse_json("{}", {"no wireframe"});
  refuse_json(json("\"wireframe\"", "\"mesh\""), {"no wireframe"});
  refuse_json(json("\"version\":1", "\"version\":3"), {"version 3", "versions 1 and 2"});
  for (const char* const provenance :
       {"[]", "{\"program\":1}", "{\"inputs\":\"a\"}", "{\"options\":[]}", "{\"noise_level\":\"a\"}"})
    refuse_json(json("\"version\":1", "\"version\":2,\"provenance\":" + std::string(provenance)), {"it has to be"});
  for (const char* const provenance : {"{\"inputs\":[1]}", "{\"options\":{\"a\":1}}"})
    refuse_json(json("\"version\":1", "\"version\":2,\"provenance\":" + std::string(provenance)), {"no text"});
  refuse_json(json("\"version\":1", "\"version\":\"1\""), {"version"});
  refuse_json(json("\"version\":1,", ""), {"version"});
  refuse_json(json("\"sampling_distance\":0.5,", ""), {"sampling_distance", "missing"});
  refuse_json(json("0.5,", "null,"), {"sampling_distance", "null"});
  refuse_json(json("0.5,", "-0.5,"), {"sampling distance", "-0.5"});
  refuse_json(json("0.5,", "1e999,"), {"JSON"});
  refuse_json(json("\"vertices\":", "\"points\":"), {"vertices", "missing"});
  refuse_json(json("[[0,0,0],[1,0,0]],\"curves", "[[0,0,0],[1,0]],\"curves"), {"vertices", "index 1"});
  refuse_json(json("[[0,0,0],[1,0,0]],\"curves", "[[0,0,null],[1,0,0]],\"curves"), {"vertices", "index 0"});
  refuse_json(json("[[0,0,0],[1,0,0]],\"curves", "[3],\"curves"), {"vertices", "index 0"});
  refuse_json(json("\"curves\":", "\"edges\":"), {"curves", "missing"});
  refuse_json("{\"format\":\"wireframe\",\"version\":1,\"sampling_distance\":1,\"vertices\":[],"
              "\"curves\":{}}",
              {"curves", "array"});
  refuse_json("{\"format\":\"wireframe\",\"version\":1,\"sampling_distance\":1,\"vertices\":[],"
              "\"curves\":[1]}",
              {"curve 0", "object"});
}

void test_json_curves()
{
  refuse_json(json("\"bspline\"", "\"helix\""), {"curve 1", "helix", "elliptic_arc"});
  refuse_json(json("\"type\":\"bspline\",", ""), {"curve 1", "type", "missing"});
  refuse_json(json("\"closed\":false", "\"closed\":0"), {"curve 0", "closed"});
  refuse_json(json("\"source\":1", "\"source\":2"), {"curve 1", "vertex 2", "2 vertices"});
  refuse_json(json("\"source\":1", "\"source\":-1"), {"curve 1", "source", "-1"});
  refuse_json(json("\"source\":1", "\"source\":1.5"), {"curve 1", "source", "1.5"});
  refuse_json(json("\"source\":1", "\"source\":18446744073709551615"), {"curve 1", "source"});
  refuse_json(json("\"source\":1", "\"source\":null"), {"curve 1", "open"});
  refuse_json(json("\"target\":0,", ""), {"curve 1", "open"});
  refuse_json(json("\"closed\":false", "\"closed\":true"), {"curve 0", "closed", "differ"});
  refuse_json(json("\"degree\":2", "\"degree\":0"), {"curve 1", "degree"});
  refuse_json(json("\"degree\":2", "\"degree\":3"), {"curve 1", "knots", "8", "7"});
  refuse_json(json("\"degree\":2", "\"degree\":4"), {"curve 1", "degree 4"});
  refuse_json(json("\"degree\":2", "\"degree\":18446744073709551615"), {"curve 1", "18446744073709551615"});
  refuse_json(json("\"degree\":2", "\"degree\":\"2\""), {"curve 1", "degree"});
  refuse_json(json("\"degree\":2,", ""), {"curve 1", "degree", "missing"});
  refuse_json(json("[0,0,0,0.5,1,1,1]", "[0,0,0,1,1,1]"), {"curve 1", "knots", "7", "6"});
  refuse_json(json("[0,0,0,0.5,1,1,1]", "[0,0,0,2,1,1,1]"), {"curve 1", "Knot 4"});
  refuse_json(json("[0,0,0,0.5,1,1,1]", "[0,0,0,null,1,1,1]"), {"curve 1", "knots", "index 3", "null"});
  refuse_json(json("[0,0,0,0.5,1,1,1]", "[0,0,0,0,0,0,0]"), {"curve 1", "knots"});
  refuse_json(json("[0,0,0,0.5,1,1,1]", "[0,0.1,0.2,0.5,1,1,1]"), {"curve 1", "clamped", "3 times"});
  refuse_json(json("[0,0,0,0.5,1,1,1]", "7"), {"curve 1", "knots", "array"});
  refuse_json(json("[1,1,0],", ""), {"curve 1", "knots"});
  refuse_json(json("[1,1,0],", "[1,1,0,0],"), {"curve 1", "control_points", "index 1"});
  refuse_json(json("[1,1,0],", "[1,1,\"0\"],"), {"curve 1", "control_points", "index 1"});
  refuse_json(json("[1,1,0],[0,1,0],[0,0,0]", "[1,1,0],[0,1,0],[0,0,1]"), {"curve 1", "end at its target"});
  refuse_json(json("[[1,0,0],[1,1,0]", "[[2,0,0],[1,1,0]"), {"curve 1", "start at its source"});
  refuse_json(json("\"closed\":false,\"source\":1,\"target\":0", "\"closed\":true"),
              {"curve 1", "closed", "where it starts"});
  refuse_json(json("[1,2,3,4]", "[1,2,3]"), {"curve 1", "weights", "3", "4"});
  refuse_json(json("[1,2,3,4]", "[1,2,3,0]"), {"curve 1", "Weight 3"});
  refuse_json(json("[1,2,3,4]", "[]"), {"curve 1", "weights", "empty"});
  refuse_json(json("\"rms\":0.3", "\"rms\":null"), {"curve 1", "rms", "null"});
  refuse_json(json("\"max\":0.4", "\"max\":-0.4"), {"curve 1", "residual"});
  refuse_json(json("\"support\":30", "\"support\":-1"), {"curve 1", "support", "-1"});
  refuse_json(json("\"support\":30", "\"doubts\":\"short\""), {"curve 1", "doubts", "array"});
  refuse_json(json("\"support\":30", "\"doubts\":[\"short\",\"long\"]"), {"curve 1", "doubts", "long"});
  refuse_json(json("\"support\":30", "\"doubts\":[1]"), {"curve 1", "doubts", "1"});

  Wireframe wireframe;
  std::string error;
  assert(!CGAL::IO::read_wireframe_json("io_bad_none.json", wireframe, parameters::error_message(&error)));
  check_words(error, {"io_bad_none.json", "cannot be opened"});
  assert(!CGAL::IO::read_wireframe_json(".", wireframe, parameters::error_message(&error)));
  check_words(error, {"is a directory"});
}

std::set<std::string> files_of(const std::string& directory)
{
  std::set<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(directory))
    names.insert(entry.path().filename().string());
  return names;
}

// refused by every writer, before a byte is out, and a file that was there stays
void refuse_to_write(const Wireframe& wireframe, const Words& words)
{
  std::string error;
  fs::create_directory("io_bad_output");
  for (const char* const suffix : {".json", ".obj", ".ply", ".polylines.txt", ".cgal"})
  {
    const std::string name = std::string("io_bad_output/x") + suffix;
    assert(!CGAL::IO::write_wireframe(name, wireframe, parameters::error_message(&error)));
    check_words(error, words);
    check_words(error, {name});
    assert(files_of("io_bad_output").empty());
    std::ofstream(name) << "old";
    assert(!CGAL::IO::write_wireframe(name, wireframe));
    std::ifstream stream(name);
    assert(std::string(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()) == "old");
    assert(files_of("io_bad_output").size() == 1);
    fs::remove(name);
  }
  fs::remove_all("io_bad_output");
  std::ostringstream stream;
  assert(!CGAL::IO::write_wireframe_json(stream, wireframe));
  assert(!CGAL::IO::write_wireframe_obj(stream, wireframe));
  assert(!CGAL::IO::write_wireframe_ply(stream, wireframe));
  assert(!CGAL::IO::write_wireframe_polylines(stream, wireframe));
  assert(stream.str().empty());
}

Wireframe valid_wireframe()
{
  std::istringstream stream(json());
  Wireframe wireframe;
  assert(CGAL::IO::read_wireframe_json(stream, wireframe));
  return wireframe;
}

void test_bad_wireframes()
{
  const double nan = std::nan(""), infinity = HUGE_VAL;
  Wireframe wireframe = valid_wireframe();
  wireframe.sampling_distance = nan;
  refuse_to_write(wireframe, {"sampling distance", "nan"});
  wireframe = valid_wireframe();
  wireframe.vertices[1] = Point(1, infinity, 0);
  refuse_to_write(wireframe, {"vertex 1", "not finite"});
  wireframe = valid_wireframe();
  wireframe.curves[1].rms = nan;
  refuse_to_write(wireframe, {"curve 1", "residual"});
  wireframe = valid_wireframe();
  wireframe.curves[0].max = infinity;
  refuse_to_write(wireframe, {"curve 0", "residual"});
  wireframe = valid_wireframe();
  wireframe.curves[1].source = 5;
  refuse_to_write(wireframe, {"curve 1", "vertex 5", "2 vertices"});
  wireframe = valid_wireframe();
  wireframe.curves[1].source = Curve::no_vertex;
  refuse_to_write(wireframe, {"curve 1", "open"});
  wireframe = valid_wireframe();
  wireframe.vertices[1] = Point(2, 0, 0);
  refuse_to_write(wireframe, {"curve 0", "end at its target"});
  wireframe = valid_wireframe();
  wireframe.curves[1].spline = Curve::Spline();
  refuse_to_write(wireframe, {"curve 1", "degree"});
}

void test_bad_steps()
{
  const Wireframe wireframe = valid_wireframe();
  for (const double step : {0., -1., HUGE_VAL, std::nan(""), 1e-12})
  {
    std::string error;
    std::ostringstream stream;
    assert(!CGAL::IO::write_wireframe_obj(stream, wireframe, parameters::sampling_step(step).error_message(&error)));
    check_words(error, {"sampling_step"});
    assert(stream.str().empty());
  }
}

void refuse_target(const std::string& name, const Words& words)
{
  std::string error;
  assert(!CGAL::IO::write_wireframe(name, valid_wireframe(), parameters::error_message(&error)));
  check_words(error, words);
}

void test_bad_targets()
{
  const std::set<std::string> before = files_of(".");
  refuse_target("", {"extension"});
  refuse_target("io_bad.xyz",
                {"io_bad.xyz", "unknown extension \".xyz\"", ".json", ".dxf", ".obj", ".ply", ".txt", ".cgal"});
  for (const std::string name : {"io_bad.step", "io_bad.stp", "io_bad.iges", "io_bad.igs", "io_bad.brep"})
    refuse_target(name, {name, "OpenCASCADE", "libocct-data-exchange-dev"}); // this test is built without
  refuse_target("io_bad_none/x.json", {"io_bad_none/x.json", "cannot be written", "directory"});
  assert(files_of(".") == before);
  fs::create_directory("io_bad_directory.obj");
  refuse_target("io_bad_directory.obj", {"is a directory"});
  assert(files_of("io_bad_directory.obj").empty());
  fs::remove("io_bad_directory.obj");
  {
    const Test_file file(".json", "old");
    refuse_target(file.name + "/x.ply", {file.name, "cannot be written"});
  }

  // protection counts for everyone but the superuser
  fs::create_directory("io_bad_protected");
  std::ofstream("io_bad_protected/old.json") << "old";
  fs::permissions("io_bad_protected/old.json", fs::perms::owner_read);
  fs::permissions("io_bad_protected", fs::perms::owner_read | fs::perms::owner_exec);
  if (!std::ofstream("io_bad_protected/probe"))
  {
    refuse_target("io_bad_protected/new.json", {"cannot be written", "directory"});
    refuse_target("io_bad_protected/old.json", {"cannot be overwritten"});
    assert(files_of("io_bad_protected").size() == 1);
  }
  fs::permissions("io_bad_protected", fs::perms::owner_all);
  fs::remove_all("io_bad_protected");
  assert(files_of(".") == before);
}

struct Full_buffer : std::streambuf
{
  int_type overflow(int_type) override { return traits_type::eof(); }
};

void test_full_disk()
{
  const Wireframe wireframe = valid_wireframe();
  std::string error;
  Full_buffer buffer;
  std::ostream stream(&buffer);
  assert(!CGAL::IO::write_wireframe_json(stream, wireframe, parameters::error_message(&error)));
  check_words(error, {"does not take the data"});
  if (fs::is_character_file("/dev/full"))
  {
    assert(!CGAL::IO::write_wireframe_json("/dev/full", wireframe, parameters::error_message(&error)));
    check_words(error, {"/dev/full", "cannot be written completely", "full"});
  }
  if (fs::is_character_file("/dev/null"))
  {
    assert(CGAL::IO::write_wireframe_obj("/dev/null", wireframe));
    assert(fs::is_character_file("/dev/null"));
  }
}

// what fails in the middle of writing leaves nothing, however it fails
void test_failing_writer()
{
  namespace internal = CGAL::IO::internal;
  const std::set<std::string> before = files_of(".");
  std::string error;
  assert(!internal::write_beside_and_rename(
    "io_bad.out",
    [](std::ostream& stream, std::string& reason) {
      stream << "half of it";
      reason = "the rest is missing";
      return false;
    },
    error));
  check_words(error, {"io_bad.out: the rest is missing"});
  assert(!internal::write_beside_and_rename(
    "io_bad.out",
    [](std::ostream& stream, std::string&) {
      stream.setstate(std::ios::badbit);
      return true;
    },
    error));
  check_words(error, {"io_bad.out: cannot be written completely"});
  bool is_caught = false;
  try
  {
    internal::write_beside_and_rename(
      "io_bad.out", [](std::ostream&, std::string&) -> bool { throw std::runtime_error("stop"); }, error);
  }
  catch (const std::runtime_error&)
  {
    is_caught = true;
  }
  assert(is_caught && files_of(".") == before);

  // somebody else's file is not touched
  const Test_file other(".out.partial0", "mine"), target(".out", "old");
  assert(internal::write_beside_and_rename(
    target.name,
    [](std::ostream& stream, std::string&) {
      stream << "new";
      return true;
    },
    error));
  std::ifstream other_stream(other.name), target_stream(target.name);
  std::string other_text, target_text;
  other_stream >> other_text;
  target_stream >> target_text;
  assert(error.empty() && other_text == "mine" && target_text == "new");
}

int main()
{
  const std::set<std::string> before = files_of(".");
  test_json_documents();
  test_json_curves();
  test_bad_wireframes();
  test_bad_steps();
  test_bad_targets();
  test_full_disk();
  test_failing_writer();
  assert(files_of(".") == before);
  return 0;
}
