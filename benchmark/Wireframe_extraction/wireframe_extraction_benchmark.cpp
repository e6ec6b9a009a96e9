// Times and memory of the extraction and its stages, beside those of a floor. See performance_table.py, which runs this
// program and makes a table of ratios.

#include <Wireframe_performance/Memory_meter.h>
#include <Wireframe_performance/Pipeline.h>

#include <benchmark/benchmark.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <functional>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace {

using Wireframe_performance::Timed_cloud;
using Wireframe_performance::Memory_meter;
using Wireframe_performance::Pipeline;
using Sample_solids::Field_kind;

// Benchmarks of one cloud are run one after the other; only this cloud is in memory.
const Pipeline& pipeline_of(const Timed_cloud& c)
{
  static std::unique_ptr<Pipeline> pipeline;
  if (!pipeline || !(pipeline->of() == c))
  {
    pipeline.reset();
    pipeline = std::make_unique<Pipeline>(c, std::filesystem::temp_directory_path().string());
  }
  return *pipeline;
}

struct Stage
{
  const char* name;
  std::function<void(const Pipeline&)> run;
  bool has_threads;
};

template <class Result>
std::function<void(const Pipeline&)> stage_of(Result (Pipeline::*stage)() const)
{
  return [stage](const Pipeline& pipeline) {
    auto result = (pipeline.*stage)();
    benchmark::DoNotOptimize(result);
  };
}

std::vector<Stage> stages()
{
  return {{"floor", stage_of(&Pipeline::floor), false},
          {"read", stage_of(&Pipeline::read), false},
          {"sampling_distance", stage_of(&Pipeline::scale), true},
          {"skeleton", stage_of(&Pipeline::select), true},
          {"contraction", stage_of(&Pipeline::contract), true},
          {"refinement", stage_of(&Pipeline::refine), true},
          {"corners", stage_of(&Pipeline::corners), true},
          {"segmentation", stage_of(&Pipeline::segment), true},
          {"graph", stage_of(&Pipeline::graph), true},
          {"splines", stage_of(&Pipeline::fit), true},
          {"types", stage_of(&Pipeline::recognize), true},
          {"all", stage_of(&Pipeline::all), true}};
}

void measure(benchmark::State& state, const Timed_cloud& c, const Stage& stage, int threads)
{
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
#else
  (void)threads;
#endif
  const Pipeline& pipeline = pipeline_of(c);
  double peak = 0.;
  for (auto _ : state)
  {
    const Memory_meter meter;
    stage.run(pipeline);
    peak = (std::max)(peak, meter.peak());
  }
  state.counters["points"] = static_cast<double>(pipeline.size());
  state.counters["skeleton"] = static_cast<double>(pipeline.skeleton_size());
  state.counters["support"] = static_cast<double>(pipeline.support_size());
  state.counters["curves"] = static_cast<double>(pipeline.number_of_curves());
  state.counters["points_per_second"] =
    benchmark::Counter(static_cast<double>(pipeline.size()), benchmark::Counter::kIsIterationInvariantRate);
  if (Memory_meter::is_available())
    state.counters["peak_bytes"] = peak;
}

// The ratio of the skeleton to the cloud is low for the box and high for the gear.
std::vector<Timed_cloud> cases(std::size_t least, std::size_t most)
{
  std::vector<Timed_cloud> result;
  const auto add = [&](const char* shape, Field_kind field, std::size_t points) {
    if (least <= points && points <= most)
      result.push_back(Timed_cloud{shape, field, points});
  };
  for (const char* shape : {"box", "box_with_hole", "gear"})
    for (Field_kind field : {Field_kind::EXACT, Field_kind::DEF})
      for (std::size_t points = 10000; points <= 10000000; points *= 10)
        add(shape, field, points);
  for (Field_kind field : {Field_kind::EXACT, Field_kind::DEF})
    add("perforated_plate", field, 1000000);
  return result;
}

void add_benchmarks(std::size_t least, std::size_t most)
{
  for (const Timed_cloud& c : cases(least, most))
    for (const Stage& stage : stages())
      for (int threads = 1; threads <= (stage.has_threads ? 2 : 1); ++threads)
        benchmark::RegisterBenchmark(
          (c.name() + "/" + stage.name + "/" + std::to_string(threads)).c_str(),
          [c, stage, threads](benchmark::State& state) { measure(state, c, stage, threads); })
          ->MeasureProcessCPUTime()
          ->UseRealTime()
          ->Unit(benchmark::kMillisecond);
}

// takes an option `--name=NUMBER` out of the command line
std::size_t take_number(int& argc, char** argv, const std::string& name, std::size_t number)
{
  const std::string start = "--" + name + "=";
  for (int i = 1; i < argc; ++i)
    if (std::strncmp(argv[i], start.c_str(), start.size()) == 0)
    {
      char* end = nullptr;
      const double value = std::strtod(argv[i] + start.size(), &end);
      if (end == argv[i] + start.size() || *end != '\0' || !(value >= 1. && value <= 1e12))
      {
        std::cerr << "wireframe_extraction_benchmark: '" << argv[i] << "' is no number of points\n";
        std::exit(2);
      }
      number = static_cast<std::size_t>(value);
      std::copy(argv + i + 1, argv + argc, argv + i);
      --argc;
      --i;
    }
  return number;
}

} // namespace

int main(int argc, char** argv)
{
  const std::size_t least = take_number(argc, argv, "least_points", 1);
  const std::size_t most = take_number(argc, argv, "most_points", 1000000);
  add_benchmarks(least, most);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv))
    return 2;
  try
  {
    if (benchmark::RunSpecifiedBenchmarks() == 0)
      return 1;
  }
  catch (const std::exception& error)
  {
    std::cerr << "wireframe_extraction_benchmark: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
