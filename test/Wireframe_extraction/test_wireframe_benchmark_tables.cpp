// Wireframe_benchmark: what is done with the figures of the cases, and with the command of the tool.

#include <Wireframe_benchmark/Tool_command.h>
#include <Wireframe_benchmark/compare_rows.h>
#include <Wireframe_benchmark/csv.h>
#include <Wireframe_benchmark/report.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace Wireframe_benchmark;
typedef std::vector<std::string> Words;

void check_near(double value, double expected) { assert(std::abs(value - expected) <= 1e-12); }

Benchmark_row row(const std::string& family, const std::string& name, const std::string& field, double chamfer,
                  double curve_f1)
{
  Benchmark_row result;
  result.family = family;
  result.name = name;
  result.field = field;
  result.values = {{"chamfer_distance_r", chamfer}, {"curve_f1", curve_f1}, {"seconds", 1.5}};
  return result;
}

Benchmark_row failed(Benchmark_row result)
{
  result.failure = "exit 1";
  result.values["chamfer_distance_r"] = 100;
  result.values["curve_f1"] = 0;
  return result;
}

Words words(const std::string& command) { return Tool_command(command).words("I n", "O", "0.5"); }

bool is_refused(const std::string& command)
{
  try
  {
    Tool_command{command};
  }
  catch (const std::invalid_argument&)
  {
    return true;
  }
  return false;
}

void test_command()
{
  assert(words("tool") == Words({"tool", "I n", "-o", "O"}));
  assert(words("tool --paper  -x") == Words({"tool", "--paper", "-x", "I n", "-o", "O"}));
  assert(words("tool -i={in} {out} --r {r}") == Words({"tool", "-i=I n", "O", "--r", "0.5"}));
  assert(words("sh -c 'a  \"b\"' {in}") == Words({"sh", "-c", "a  \"b\"", "I n"}));
  assert(words("\"my tool\" a\\ b '' \"\\\"\" {in}") == Words({"my tool", "a b", "", "\"", "I n"}));
  assert(words("tool {in}{in} {other}") == Words({"tool", "I nI n", "{other}"}));
  // what is filled in is not filled in again
  assert(Tool_command("t {in} {out}").words("{out}", "x", "") == Words({"t", "{out}", "x"}));
  assert(Tool_command("tool {r} {in}").uses_sampling_distance() && !Tool_command("tool").uses_sampling_distance());
  assert(is_refused("") && is_refused("  ") && is_refused("tool 'a") && is_refused("tool \"a"));
}

void test_statistics()
{
  check_near(quantile({3, 1, 2}, 0.5), 2);
  check_near(quantile({4, 1, 2, 3}, 0.5), 2.5);
  check_near(quantile({0, 10}, 0.9), 9);
  check_near(quantile({7}, 0.9), 7);
  check_near(mean({1, 2, 6}), 3);
  assert(std::isnan(quantile({}, 0.5)) && std::isnan(mean({})));
}

double figure(const Summary& summary, const std::string& heading)
{
  for (std::size_t i = 0; i < summary_columns().size(); ++i)
    if (summary_columns()[i].heading == heading)
      return summary.figures[i];
  assert(false);
  return 0;
}

void test_summary()
{
  std::vector<Benchmark_row> rows = {row("a", "x", "def", 1, 1), row("a", "y", "def", 3, 0.5),
                                     row("a", "x", "exact", 0.5, 1), failed(row("b", "x", "def", 0, 0))};
  const std::vector<Summary> groups = summarize_groups(rows);
  assert(groups.size() == 5); // a def, a exact, b def, and both fields over all
  assert(groups[0].family == "a" && groups[0].field == "def" && groups[0].number_of_cases == 2);
  check_near(figure(groups[0], "CD/r md"), 2);
  check_near(figure(groups[0], "CD/r q90"), 2.8);
  check_near(figure(groups[0], "curveF1"), 0.75);
  assert(groups[2].family == "b" && groups[2].number_of_failures == 1);
  // no figure drops failures
  assert(groups[3].family.empty() && groups[3].field == "def" && groups[3].number_of_cases == 3);
  check_near(figure(groups[3], "CD/r mean"), 104. / 3);
  check_near(figure(groups[3], "curveF1"), 0.5);
  // one family alone is all there is
  assert(summarize_groups({rows[0], rows[1]}).size() == 1);

  // types: not there at all, or with failures as 0
  assert(std::isnan(figure(groups[3], "typedR")));
  rows[0].values["typed_recall"] = 1;
  rows[1].values["typed_recall"] = 0.5;
  check_near(figure(summarize_groups(rows)[3], "typedR"), 0.5);
  check_near(figure(summarize_groups(rows)[0], "typedR"), 0.75);
}

void test_order()
{
  std::vector<Benchmark_row> rows = {row("a", "x", "def", 1, 1), row("a", "y", "def", 3, 1),
                                     failed(row("a", "z", "def", 0, 0)), row("a", "w", "def", 3, 1)};
  std::sort(rows.begin(), rows.end(), is_worse);
  assert(rows[0].name == "z" && rows[1].name == "w" && rows[2].name == "y" && rows[3].name == "x");
}

void test_csv()
{
  std::vector<Benchmark_row> rows = {row("a", "x,y", "def", 0.125, 1), failed(row("a", "z", "def", 0, 0))};
  rows[1].failure = "exit 1: a \"quoted\",\nbroken line";
  std::ofstream out("rows.csv");
  write_csv(out, rows);
  out.close();
  const std::vector<Benchmark_row> read = read_csv("rows.csv");
  assert(read.size() == 2);
  for (std::size_t i = 0; i < 2; ++i)
  {
    assert(read[i].key() == rows[i].key() && read[i].failure == rows[i].failure);
    for (const std::string& name : value_names())
      assert(read[i].value(name) == rows[i].value(name)
             || (std::isnan(read[i].value(name)) && std::isnan(rows[i].value(name))));
  }

  const auto error_of = [](const std::string& text) {
    std::ofstream("bad.csv") << text;
    try
    {
      read_csv("bad.csv");
    }
    catch (const std::runtime_error& error)
    {
      return std::string(error.what());
    }
    return std::string();
  };
  assert(error_of("").find("is not a table") != std::string::npos);
  assert(error_of("a,b\n1,2\n").find("is not a table") != std::string::npos);
  assert(error_of("family,case,field,failure,seconds\na,b,c,,1,2\n").find("row 1 has 6 fields instead of 5")
         != std::string::npos);
  assert(error_of("family,case,field,failure,seconds\na,b,c,,fast\n").find("'fast' in the column seconds")
         != std::string::npos);
  assert(error_of("family,case,field,failure,seconds\r\na,b,c,,1\r\n").empty());
  assert(error_of("family,case,field,failure\n").empty());
}

Case_change::Verdict verdict(const Benchmark_row& before, const Benchmark_row& after)
{
  return compare_rows({before}, {after}).changes.at(0).verdict;
}

void test_comparison()
{
  typedef Case_change::Verdict Verdict;
  const Benchmark_row a = row("a", "x", "def", 1, 0.8);
  assert(verdict(a, a) == Verdict::SAME);
  assert(verdict(a, row("a", "x", "def", 1.01, 0.8)) == Verdict::SAME); // within 2 %
  assert(verdict(a, row("a", "x", "def", 0.9, 0.8)) == Verdict::BETTER);
  assert(verdict(a, row("a", "x", "def", 1.1, 0.8)) == Verdict::WORSE);
  assert(verdict(a, row("a", "x", "def", 1, 0.9)) == Verdict::BETTER);
  assert(verdict(a, row("a", "x", "def", 0.9, 0.7)) == Verdict::MIXED);
  assert(verdict(a, failed(a)) == Verdict::WORSE && verdict(failed(a), a) == Verdict::BETTER);
  // a result is better than none, whatever it is
  assert(verdict(failed(a), row("a", "x", "def", 1000, 0)) == Verdict::BETTER);
  assert(verdict(failed(a), failed(a)) == Verdict::SAME);

  const Benchmark_row b = row("a", "y", "def", 1, 0.8), c = row("b", "x", "def", 1, 0.8);
  const Comparison comparison = compare_rows({a, b, row("gone", "x", "def", 1, 1)},
                                             {row("a", "x", "def", 1, 0.9), row("a", "y", "def", 1, 0.5), c});
  assert(comparison.changes.size() == 2 && comparison.only_before == 1 && comparison.only_after == 1);
  assert(comparison.changes[0].verdict == Verdict::WORSE && comparison.changes[0].after.name == "y");
  std::ostringstream text;
  write_comparison(text, comparison, false);
  assert(text.str().find("Of 2 cases in both runs: 1 better, 1 worse, 0 mixed, 0 the same; 1 only before, 1 only now.")
         == 0);
  assert(text.str().find("0.800 -> 0.500") != std::string::npos);
  assert(text.str().find("0.800 -> 0.700") != std::string::npos); // the mean

  std::ostringstream nothing;
  write_comparison(nothing, compare_rows({}, {}), false);
  assert(nothing.str().find("Of 0 cases") == 0);
}

void test_tables()
{
  Text_table table({"name", "x"}, 1);
  assert(table.is_empty());
  table.add({"a|b", "10"});
  table.add({"", fixed(std::nan(""), 3)});
  std::ostringstream text, markdown;
  table.write_text(text);
  table.write_markdown(markdown);
  assert(text.str() == "name   x\na|b   10\n       -\n");
  assert(markdown.str() == "| name |  x |\n|------|---:|\n| a\\|b | 10 |\n|      |  - |\n");

  std::ostringstream report;
  write_markdown(report, {failed(row("a", "x", "def", 0, 0))});
  assert(report.str().find("# Benchmark") == 0 && report.str().find("| exit 1") != std::string::npos);
}

} // namespace

int main()
{
  test_command();
  test_statistics();
  test_summary();
  test_order();
  test_csv();
  test_comparison();
  test_tables();
  std::cout << "done\n";
  return 0;
}
