// Compares a wireframe with the true one. See evaluate_wireframe --help.

#include <Wireframe_evaluation/evaluate_wireframe.h>
#include <Wireframe_evaluation/one_line.h>
#include <Wireframe_evaluation/read_truth.h>
#include <Wireframe_evaluation/write_scores.h>

#include <CLI/CLI.hpp>

#include <exception>
#include <iostream>
#include <string>

namespace {

enum Exit_code
{
  SUCCESS = 0,
  INTERNAL_ERROR = 1,
  USAGE_ERROR = 2,
  BAD_TRUTH = 3,
  FAILED_CASE = 4
};

int fail(Exit_code code, const std::string& text)
{
  std::cerr << "evaluate_wireframe: error: " << Wireframe_evaluation::one_line(text) << '\n';
  return code;
}

int run(const std::string& truth_path, const std::string& prediction_path, bool is_json)
{
  using namespace Wireframe_evaluation;
  True_wireframe truth;
  try
  {
    truth = read_truth(truth_path);
  }
  catch (const Format_error& error)
  {
    return fail(BAD_TRUTH, truth_path + ": " + error.what());
  }
  const Wireframe_scores scores = evaluate_wireframe(truth, prediction_path);
  if (is_json)
    write_scores_as_json(std::cout, scores);
  else
    write_scores_as_text(std::cout, scores);
  if (!std::cout.flush())
    return fail(INTERNAL_ERROR, "the scores cannot be written");
  return scores.failure.empty() ? SUCCESS : fail(FAILED_CASE, prediction_path + ": " + scores.failure);
}

} // namespace

int main(int argc, char** argv)
{
  CLI::App app("Compares a wireframe with the true one, and prints scores.", "evaluate_wireframe");
  std::string truth, prediction;
  bool is_json = false;
  app.add_option("TRUTH", truth, "the true wireframe, a truth.json as make_cloud writes it")->required();
  app.add_option("PREDICTION", prediction, "the wireframe to be evaluated, in wireframe JSON")->required();
  app.add_flag("--json", is_json, "print the scores as JSON");
  app.footer("Lengths are in the unit of the cloud; r is the sampling distance of the truth.\n"
             "Exit code: 0; 2 wrong usage; 3 the truth cannot be read; 4 there is no usable prediction, and the\n"
             "scores are those of a failed case.");
  try
  {
    app.parse(argc, argv);
    return run(truth, prediction, is_json);
  }
  catch (const CLI::ParseError& error)
  {
    if (error.get_exit_code() == 0)
      return app.exit(error);
    return fail(USAGE_ERROR, std::string(error.what()) + " (evaluate_wireframe --help tells more)");
  }
  catch (const std::exception& error)
  {
    return fail(INTERNAL_ERROR, std::string("unexpected: ") + error.what());
  }
}
