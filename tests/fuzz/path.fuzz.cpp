// Any bytes as an NC program that is simulated: what is refused has its place in the line, and what is
// followed stays within the velocities of the axes, with figures that are numbers.
#include "analysis/motion/program/interpreter.hpp"
#include "analysis/motion/simulation.hpp"
#include "codegen/image_writer.hpp"
#include "grammar/line_splitter.hpp"
#include "validator/commands/command_check.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace {

using namespace axisc;

constexpr std::size_t axis_count = 3;
constexpr double fastest = 5000;  ///< units per cycle: 500 mm/s
constexpr std::size_t most_cycles = 1500;
constexpr std::size_t most_sets = 2;

void require(bool condition) {
  if (!condition) std::abort();
}

machine::Machine mill() {
  machine::Machine machine;
  machine.name = "mill";
  machine.groups.push_back({.name = "channel", .axes = {}, .filter_sets = {}});
  for (std::size_t i = 0; i < axis_count; ++i) {
    machine::AxisConfiguration axis;
    axis.name = std::string(1, static_cast<char>('X' + i));
    axis.number = static_cast<std::uint32_t>(i + 1);
    axis.kernel =
        machine::ConfiguredKernel{.family = machine::KernelFamily::fir,
                                  .index = 0,
                                  .specification = {.type = design::KernelType::moving_average, .order = 10},
                                  .on_at_start = true};
    machine.axes.push_back(std::move(axis));
    machine.groups[0].axes.push_back(i);
  }
  return machine;
}

motion::FilterCommandReading read_command(grammar::NcCommand const& command, std::string_view text) {
  auto const checked = validator::check_command(command, text, {}, validator::Variables::refused);
  motion::FilterCommandReading reading{.command = checked.command, .mistakes = {}};
  for (auto const& mistake : checked.mistakes) {
    reading.mistakes.push_back({.code = mistake.code, .span = mistake.span, .message = mistake.message});
  }
  return reading;
}

motion::ProgramChannel channel() {
  motion::ProgramChannel channel;
  channel.axes = {"X", "Y", "Z"};
  channel.rotary.assign(axis_count, false);
  channel.read_filter_command = read_command;
  channel.most_repeated_blocks = 1000;
  return channel;
}

void interpret(std::string_view bytes, motion::PathListener& listener, bool& refused) {
  motion::ProgramInterpreter interpreter(channel(), listener, [&](motion::ProgramProblem const& problem) {
    require(problem.line >= 1 && problem.span.begin <= problem.span.end);
    require(problem.span.end <= problem.line_text.size());
    require(!render(problem.finding.message, Language::german).empty());
    refused = refused || problem.finding.severity == Severity::error;
  });
  grammar::LineSplitter lines(bytes);
  for (std::string_view line; lines.next(line);) {
    if (!interpreter.line(line, static_cast<std::uint32_t>(line.data() - bytes.data()))) break;
  }
  interpreter.finish();
}

/// What the program asks of the image, before anything moves.
struct Survey final : motion::PathListener {
  void motion(motion::ProgrammedBlock const& block) override {
    for (double const end : block.end) require(std::isfinite(end));
    require(block.feed > 0 && block.line >= 1);
  }
  void command(motion::FilterChange const& change) override {
    current = machine::parameters_after(current, change.command);
    if (!current.empty() && std::find(sets.begin(), sets.end(), current) == sets.end())
      sets.push_back(current);
  }
  void stop(double cycles, std::uint32_t /*line*/) override { require(cycles >= 0); }
  void end() override {}
  machine::FilterParameters current;
  std::vector<machine::FilterParameters> sets;
};

struct Enough {};

struct Follower final : motion::SimulationListener {
  void cycle(motion::MeasuredPoint const& point, motion::BlockSummary const&) override {
    require(point.deviation >= 0 && std::isfinite(point.deviation));
    for (std::size_t i = 0; i < axis_count; ++i) {
      double const here = point.point.nominal[i];
      require(std::isfinite(here) && std::isfinite(point.filtered[i]));
      // Far away two neighbours among the numbers are a step of their own.
      double const rounding = 1e-3 + std::abs(here) * 1e-14;
      require(!moved || std::abs(here - before[i]) <= fastest * (1 + 1e-6) + rounding);
    }
    before = point.point.nominal;
    moved = true;
    if (++cycles == most_cycles) throw Enough{};
  }
  void block(motion::BlockSummary const& summary) override { require(std::isfinite(summary.cycles)); }
  void pass(motion::PassSummary const& summary) override { require(summary.blocks > 0); }
  motion::Point before{};
  bool moved = false;
  std::size_t cycles = 0;
};

motion::GroupRuntime runtime_of(machine::Machine const& machine, std::vector<std::byte> const& image) {
  auto contents = image::read_image(image);
  require(std::holds_alternative<image::ImageContents>(contents));
  auto runtime =
      motion::GroupRuntime::create(image, std::get<image::ImageContents>(contents), machine.groups[0].axes);
  require(std::holds_alternative<motion::GroupRuntime>(runtime));
  return std::get<motion::GroupRuntime>(std::move(runtime));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  std::string_view const bytes(reinterpret_cast<char const*>(data), size);
  bool refused = false;
  Survey survey;
  interpret(bytes, survey, refused);
  if (refused || survey.sets.size() > most_sets) return 0;
  auto machine = mill();
  machine.groups[0].filter_sets = survey.sets;
  auto const image = codegen::write_image(machine, {});
  machine::AxisDynamics axis;
  axis.feed.velocity = axis.rapid.velocity = fastest / (motion::units_per_um * machine.cycle_time.seconds());
  motion::PathDynamics dynamics;
  dynamics.axes.assign(3, axis);
  Follower follower;
  motion::Simulation simulation(runtime_of(machine, image), runtime_of(machine, image),
                                motion::PathLimits(dynamics), false, follower);
  try {
    interpret(bytes, simulation, refused);
  } catch (Enough const&) {
    return 0;
  }
  require(!refused);
  return 0;
}
