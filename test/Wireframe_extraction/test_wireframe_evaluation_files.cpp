// Files of Wireframe_evaluation: what is read and written, and what is refused.

#include "evaluated_curves.h"

#include <Wireframe_evaluation/evaluate_wireframe.h>
#include <Wireframe_evaluation/read_truth.h>
#include <Wireframe_evaluation/write_scores.h>

#include <nlohmann/json.hpp>

#include <cassert>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>

namespace {

typedef nlohmann::json Json;

std::string write(const std::string& text)
{
  const std::string path = "evaluated.json";
  std::ofstream(path) << text;
  return path;
}

Json good_prediction()
{
  return Json::parse(R"({"format": "wireframe", "version": 1, "vertices": [[0, 0, 0], [10, 0, 0]],
    "curves": [{"type": "bspline", "closed": false, "source": 0, "target": 1, "degree": 1, "knots": [0, 0, 1, 1],
                "control_points": [[0, 0, 0], [10, 0, 0]]}]})");
}

Json good_truth()
{
  return Json::parse(R"({"r": 0.1, "points": 1000, "corners": [[0, 0, 0], [10, 0, 0]],
    "curves": [{"kind": "line", "closed": false, "points": [[0, 0, 0], [10, 0, 0]]}],
    "segments": [{"kind": "line", "closed": false, "points": [[0, 0, 0], [10, 0, 0]]}]})");
}

// the reason must say what is meant, in one line
void check_reason(const std::string& reason, const std::string& expected)
{
  if (reason.find(expected) == std::string::npos)
    std::cerr << "'" << reason << "' does not tell '" << expected << "'\n";
  assert(reason.find(expected) != std::string::npos && reason.find('\n') == std::string::npos);
}

void check_bad_prediction(const std::string& text, const std::string& expected)
{
  const True_wireframe truth = truth_of({segment(Point(0, 0, 0), Point(10, 0, 0))});
  const Wireframe_scores scores = evaluate_wireframe(truth, write(text));
  check_failed(scores, 10);
  check_reason(scores.failure, expected);
}

// a good prediction with something at a place of it changed
void check_bad_prediction(const std::string& pointer, const Json& value, const std::string& expected)
{
  Json document = good_prediction();
  document[Json::json_pointer(pointer)] = value;
  check_bad_prediction(document.dump(), expected);
}

void test_prediction_files()
{
  const True_wireframe truth = truth_of({segment(Point(0, 0, 0), Point(10, 0, 0))}, {Point(0, 0, 0), Point(10, 0, 0)});
  const Wireframe_scores good = evaluate_wireframe(truth, write(good_prediction().dump()));
  check_near(good.chamfer_distance, 0, 1e-12);
  assert(good.failure.empty() && good.corner_recall == 1 && good.curve_f1 == 1);
  const Wireframe_scores points =
    evaluate_wireframe(truth, write(R"({"curves": [{"points": [[0, 0, 0], [10, 0, 0]]}]})"));
  assert(points.failure.empty() && points.curve_f1 == 1);

  check_bad_prediction("", "is empty");
  check_bad_prediction("{\"curves\": [", "is not JSON");
  check_bad_prediction("{\"curves\": [NaN]}", "is not JSON");
  check_bad_prediction("[]", "is not a JSON object");
  check_bad_prediction("{}", "there is no \"curves\"");
  check_bad_prediction("{\"curves\": []}", "there is no curve");
  check_bad_prediction("/curves", 7, "\"curves\" is not a list");
  check_bad_prediction("/curves/0", 7, "curves[0]: is not an object");
  check_bad_prediction("/curves/0", Json::object(), "neither \"control_points\" nor \"points\"");
  check_bad_prediction("/curves/0/knots", {0, 0, 1}, "there are 3 knots; 2 control points of degree 1 need 4");
  check_bad_prediction("/curves/0/knots", {0, 0, -1, -1}, "knot 2 is smaller");
  check_bad_prediction("/curves/0/knots", {0, 0, 0, 0}, "range of parameters is empty");
  check_bad_prediction("/curves/0/knots/1", "x", "number 1 of \"knots\" is not a number");
  check_bad_prediction("/curves/0/degree", 0, "degree is 0");
  check_bad_prediction("/curves/0/degree", -1, "\"degree\" is not a whole number");
  check_bad_prediction("/curves/0/degree", 5, "2 control points are too few for degree 5");
  check_bad_prediction("/curves/0/degree", 1000, "more than the");
  check_bad_prediction("/curves/0/weights", {1}, "there are 1 weights for 2 control points");
  check_bad_prediction("/curves/0/weights", {1, -1}, "a weight is not positive");
  check_bad_prediction("/curves/0/control_points/1", {1, 2}, "point 1 of \"control_points\"");
  check_bad_prediction("/curves/0/control_points/1/2", nullptr, "point 1 of \"control_points\" is not a number");
  check_bad_prediction("/curves/0/closed", "yes", "\"closed\" is neither true nor false");
  check_bad_prediction("/curves/0/type", 3, "\"type\" is not a text");
  check_bad_prediction("/curves/0/target", 2, "\"target\" is not an index of one of the 2 vertices");
  check_bad_prediction("/curves/0/source", -1, "\"source\" is not an index");
  check_bad_prediction("/curves/0/source", 0.5, "\"source\" is not an index");
  check_bad_prediction("/vertices/0", "x", "point 0 of \"vertices\"");
  check_bad_prediction("{\"curves\": [{\"points\": [[0, 0, 0]]}]}", "curves[0]: has fewer than two points");
}

void check_bad_truth(const std::string& path, const std::string& expected)
{
  std::string reason;
  try
  {
    read_truth(path);
  }
  catch (const Format_error& error)
  {
    reason = error.what();
  }
  check_reason(reason, expected);
}

void check_bad_truth(const std::string& pointer, const Json& value, const std::string& expected)
{
  Json document = good_truth();
  document[Json::json_pointer(pointer)] = value;
  check_bad_truth(write(document.dump()), expected);
}

void check_incomplete_truth(const char* key, const std::string& expected)
{
  Json document = good_truth();
  document.erase(key);
  check_bad_truth(write(document.dump()), expected);
}

void test_truth_files()
{
  const True_wireframe truth = read_truth(write(good_truth().dump()));
  assert(truth.sampling_distance == 0.1 && truth.curves.size() == 1 && truth.segments.size() == 1);
  assert(truth.corners.size() == 2 && truth.number_of_points == 1000 && truth.segments[0].kind == Curve_kind::LINE);
  Json without_segments = good_truth();
  without_segments.erase("segments");
  without_segments.erase("points");
  assert(read_truth(write(without_segments.dump())).segments.empty());

  check_bad_truth("no such file", "cannot be opened");
  check_bad_truth(".", "cannot be");
  check_bad_truth(write("{"), "is not JSON");
  check_bad_truth("/r", 0, "\"r\" is not positive");
  check_bad_truth("/r", "1", "\"r\" is not a number");
  check_bad_truth("/curves", Json::array(), "there is no curve");
  check_bad_truth("/curves/0/points", {{0, 0, 0}}, "curves[0]: has fewer than two points");
  check_bad_truth("/segments/0/points/1", {0, 0}, "segments[0]: point 1 of \"points\"");
  check_incomplete_truth("r", "there is no \"r\"");
  check_incomplete_truth("curves", "there is no \"curves\"");
  check_incomplete_truth("corners", "there is no \"corners\"");
}

// Every score is written, under its own name.
void test_writers()
{
  const Wireframe_scores good = scores_of({circle(2)}, {circle(2)});
  std::ostringstream text, json;
  write_scores_as_text(text, good);
  write_scores_as_json(json, good);
  const Json document = Json::parse(json.str());
  for (const Score_column& column : score_columns())
  {
    assert(text.str().find(column.name) != std::string::npos);
    assert(document.contains(column.name));
  }
  assert(document.size() == score_columns().size() + 3);
  assert(document["failure"].is_null() && document["curve_f1"] == 1 && document["typed_recall"].is_null());
  assert(document["true_curves"].is_number_integer());

  std::ostringstream failed;
  write_scores_as_json(failed, failed_scores(truth_of({circle(2)}), "a \"reason\" \xff"));
  assert(Json::parse(failed.str())["failure"].get<std::string>().find("a \"reason\"") == 0);
}

} // namespace

int main()
{
  test_prediction_files();
  test_truth_files();
  test_writers();
  return 0;
}
