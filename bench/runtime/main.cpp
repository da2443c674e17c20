// Time per axis and cycle of the runtime at every instruction set, beside the plain loops and the libraries
// of the field, as ratios within one run: best of 15 repetitions that are interleaved at random.
//
//   bench_runtime [--axes N,N,...] [--case NAME] [options of Google Benchmark]
//   bench_runtime --case cycles     single cycles: their distribution, standstill, cold caches, recorder
//   bench_runtime --case load       checksum and verification of an image of about 1 MiB
#include "bench/runtime/cases.hpp"
#include "bench/runtime/cycles.hpp"
#include "bench/runtime/load.hpp"
#include "bench/runtime/peers.hpp"
#include "codegen/aligned_bytes.hpp"
#include "codegen/image_fields.hpp"
#include "codegen/record.hpp"

#include <algorithm>
#include <benchmark/benchmark.h>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <functional>
#include <map>
#include <memory>
#include <string>

namespace axisc::bench {
namespace {

constexpr std::size_t frames = 64;
constexpr double seconds_of_a_repetition = 0.004;
constexpr std::size_t cycles_of_an_iteration = 64;

/// Setpoints of a move near 1e9 units.
std::vector<double> make_inputs(std::size_t axes) {
  std::vector<double> inputs(frames * axes);
  for (std::size_t frame = 0; frame < frames; ++frame) {
    for (std::size_t axis = 0; axis < axes; ++axis) {
      double const phase = 2 * 3.14159265358979 * static_cast<double>(frame) / frames;
      inputs[frame * axes + axis] = 1e9 + 1e4 * std::sin(phase + static_cast<double>(axis)) + 0.125;
    }
  }
  return inputs;
}

using Step = std::function<void(double const* in, double* out)>;

void measure(benchmark::State& state, std::size_t axes, Step const& step) {
  std::vector<double> const inputs = make_inputs(axes);
  std::vector<double> outputs(axes);
  for (auto _ : state) {
    for (std::size_t cycle = 0; cycle < cycles_of_an_iteration; ++cycle) {
      step(inputs.data() + (cycle % frames) * axes, outputs.data());
      benchmark::DoNotOptimize(outputs.data());
      benchmark::ClobberMemory();
    }
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * cycles_of_an_iteration * axes));
}

/// The runtime as a controller's task calls it, without the checks of the program's own host around it.
struct Task {
  codegen::AlignedBytes image, memory;
  axisrt* runtime = nullptr;

  Task(std::span<std::byte const> bytes, std::uint32_t level) : image(bytes), memory(room(level)) {
    axisrt_config config = configuration(level);
    config.memory = memory.data();
    config.memory_size = memory.size();
    if (axisrt_create(&config, &runtime) != AXISRT_OK) return;
    for (std::uint32_t axis = 0; axis < axisrt_axis_count(runtime); ++axis) {
      axisrt_reset(runtime, axis, 1e9);
    }
  }

 private:
  [[nodiscard]] axisrt_config configuration(std::uint32_t level) const {
    axisrt_config config{};
    config.size = sizeof(axisrt_config);
    config.level = level;
    config.image = image.data();
    config.image_size = image.size();
    config.cycle_time_ns = codegen::ConstRecord<codegen::records::header>(image.bytes())
                               .get(codegen::fields::header::cycle_time_ns);
    return config;
  }
  [[nodiscard]] std::size_t room(std::uint32_t level) const {
    axisrt_config const config = configuration(level);
    std::size_t size = 0;
    std::size_t alignment = 0;
    return axisrt_memory_size(&config, &size, &alignment) == AXISRT_OK ? size : 0;
  }
};

struct Level {
  char const* name;
  std::uint32_t number;
};
constexpr Level levels[] = {{"v4", AXISRT_LEVEL_X86_64_V4},
                            {"v3", AXISRT_LEVEL_X86_64_V3},
                            {"v2", AXISRT_LEVEL_X86_64_V2},
                            {"neon", AXISRT_LEVEL_NEON},
                            {"portable", AXISRT_LEVEL_PORTABLE}};

void add(std::string const& name, std::size_t axes, Step step) {
  benchmark::RegisterBenchmark(
      name.c_str(), [axes, step = std::move(step)](benchmark::State& state) { measure(state, axes, step); })
      ->Repetitions(15)
      ->ReportAggregatesOnly(false)
      ->MinTime(seconds_of_a_repetition);
}

void add_case(std::string const& name, std::size_t axes) {
  std::string const end = "/" + name + "/" + std::to_string(axes);
  auto const contender = std::make_shared<Contender>(make_case(name, axes));
  add("plain" + end, axes,
      [contender](double const* in, double* out) { step_plain(contender->plain, in, out); });
  for (Level const& level : levels) {
    auto const task = std::make_shared<Task>(contender->image, level.number);
    if (task->runtime == nullptr) continue;
    add(level.name + end, axes,
        [task](double const* in, double* out) { axisrt_step(task->runtime, in, out, nullptr); });
  }
  for (Peer& peer : make_peers(name, contender->plain)) add(peer.name + end, axes, std::move(peer.step));
}

/// Collects the best repetition of each benchmark, in ns per axis and cycle.
class BestOf : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(Context const&) override { return true; }
  void ReportRuns(std::vector<Run> const& runs) override {
    for (Run const& run : runs) {
      if (run.run_type != Run::RT_Iteration || run.error_occurred) continue;
      std::string const name = run.run_name.function_name;
      double const rate = run.counters.at("items_per_second").value;
      auto const [place, is_new] = best_.try_emplace(name, 1e9 / rate);
      if (is_new) order_.push_back(name);
      place->second = std::min(place->second, 1e9 / rate);
    }
  }
  void print() {
    std::sort(order_.begin(), order_.end(), [](std::string const& a, std::string const& b) {
      return std::pair(a.substr(a.find('/')), a) < std::pair(b.substr(b.find('/')), b);
    });
    std::printf("%-10s %-6s %5s  %12s  %s\n", "who", "case", "axes", "ns per axis", "plain loop / this");
    for (std::string const& name : order_) {
      std::size_t const first = name.find('/');
      std::size_t const second = name.find('/', first + 1);
      auto const found = best_.find("plain" + name.substr(first));
      double const plain = found == best_.end() ? 0 : found->second;
      double const own = best_.at(name);
      std::printf("%-10s %-6s %5s  %12.3f  %.2f\n", name.substr(0, first).c_str(),
                  name.substr(first + 1, second - first - 1).c_str(), name.substr(second + 1).c_str(), own,
                  plain / own);
    }
  }

 private:
  std::map<std::string, double> best_;
  std::vector<std::string> order_;
};

}  // namespace
}  // namespace axisc::bench

int main(int argc, char** argv) {
  using namespace axisc::bench;
  std::vector<std::size_t> counts = {1, 8, 32, 64, 256};
  std::string only;
  std::vector<char*> rest = {argv[0]};
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--axes") == 0 && i + 1 < argc) {
      counts.clear();
      for (char const* next = argv[++i]; *next != '\0';) {
        char* end = nullptr;
        counts.push_back(std::strtoul(next, &end, 10));
        if (end == next) return 2;
        next = *end == ',' ? end + 1 : end;
      }
    } else if (std::strcmp(argv[i], "--case") == 0 && i + 1 < argc) {
      only = argv[++i];
    } else {
      rest.push_back(argv[i]);
    }
  }
  char interleave[] = "--benchmark_enable_random_interleaving=true";
  rest.push_back(interleave);
  for (Case const& one : cases()) {
    if (!only.empty() && only != one.name) continue;
    for (std::size_t const axes : counts) add_case(one.name, axes);
  }
  int count = static_cast<int>(rest.size());
  benchmark::Initialize(&count, rest.data());
  if (only == "cycles") {
    for (char const* const name : {"a", "d", "f"}) {
      Contender contender = make_case(name, 64);
      std::printf("\ncase %s", name);
      report_cycles(contender, 64);
    }
    return 0;
  }
  if (only == "load") {
    report_load(make_case("a", 1200).image);
    return 0;
  }
  BestOf reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  reporter.print();
  return 0;
}
