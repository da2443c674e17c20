#include "channels.hpp"

#include "codegen/image_writer.hpp"
#include "support/catch.hpp"

#include <sstream>
#include <utility>

#include <fmt/format.h>

namespace axisc::test {
namespace {

machine::AxisConfiguration axis(std::size_t index) {
  machine::AxisConfiguration axis;
  axis.name = std::string(1, static_cast<char>('X' + index));
  axis.number = static_cast<std::uint32_t>(index + 1);
  axis.velocity_limit = 500'000;
  axis.acceleration_limit = 10'000;
  return axis;
}

machine::Machine group_of(std::vector<machine::AxisConfiguration> axes, design::CycleTime cycle_time) {
  machine::Machine machine;
  machine.name = "test";
  machine.cycle_time = cycle_time;
  machine.groups.push_back({.name = "channel", .axes = {}, .filter_sets = {}});
  for (std::size_t i = 0; i < axes.size(); ++i) machine.groups[0].axes.push_back(i);
  machine.axes = std::move(axes);
  return machine;
}

struct Ignore final : motion::PathListener {
  explicit Ignore(machine::MachineGroup& where) : group(where) {}
  void motion(motion::ProgrammedBlock const&) override {}
  void command(motion::FilterChange const& change) override {
    current = machine::parameters_after(current, change.command);
    if (!current.empty()) group.filter_sets.push_back(current);
  }
  void end() override {}
  machine::MachineGroup& group;
  machine::FilterParameters current;
};

void interpret(motion::ProgramChannel const& channel, motion::PathListener& listener,
               std::string const& program) {
  CHECK(interpreted(channel, listener, program).first == std::vector<std::string>());
}

}  // namespace

machine::Machine channel_of(std::vector<design::KernelSpecification> const& kernels,
                            design::CycleTime cycle_time) {
  std::vector<machine::AxisConfiguration> axes;
  for (auto const& kernel : kernels) {
    axes.push_back(axis(axes.size()));
    axes.back().kernel = machine::ConfiguredKernel{
        .family = machine::KernelFamily::fir, .index = 0, .specification = kernel, .on_at_start = true};
  }
  return group_of(std::move(axes), cycle_time);
}

machine::Machine channel_of_pt1(double time_constant_us, std::size_t count) {
  std::vector<machine::AxisConfiguration> axes;
  for (std::size_t i = 0; i < count; ++i) {
    axes.push_back(axis(i));
    axes.back().filters.push_back(
        {.index = 0,
         .specification = {.type = design::FilterType::pt1, .time_constant = {time_constant_us}}});
  }
  return group_of(std::move(axes), {});
}

motion::GroupRuntime runtime_of(machine::Machine const& machine) {
  auto const image = codegen::write_image(machine, {});
  auto contents = image::read_image(image);
  REQUIRE(std::holds_alternative<image::ImageContents>(contents));
  auto runtime =
      motion::GroupRuntime::create(image, std::get<image::ImageContents>(contents), machine.groups[0].axes);
  REQUIRE(std::holds_alternative<motion::GroupRuntime>(runtime));
  return std::get<motion::GroupRuntime>(std::move(runtime));
}

std::vector<motion::ChainAnswer> answers_of(machine::Machine const& machine) {
  auto runtime = runtime_of(machine);
  auto answers = motion::chain_answers(runtime);
  REQUIRE(std::holds_alternative<std::vector<motion::ChainAnswer>>(answers));
  return std::get<std::vector<motion::ChainAnswer>>(std::move(answers));
}

machine::AxisDynamics step_axis(double velocity, double acceleration) {
  machine::AxisDynamics axis;
  for (auto* const motion : {&axis.feed, &axis.rapid}) {
    motion->velocity = velocity;
    for (auto* const stages : {&motion->step_up, &motion->step_down}) {
      stages->first = stages->second = acceleration;
    }
    motion->up.acceleration = motion->down.acceleration = acceleration;
  }
  axis.highest_acceleration = acceleration;
  return axis;
}

motion::PathDynamics path_of(machine::Machine const& machine) {
  motion::PathDynamics path;
  path.cycle_time = machine.cycle_time;
  path.channel = machine.groups.at(0).dynamics;
  for (auto const& axis : machine.axes) {
    path.axes.push_back(step_axis(axis.velocity_limit, axis.acceleration_limit));
    path.axes.back().acceleration_transition_weight = axis.transition_weight;
  }
  return path;
}

double per_cycle(double feed_mm_per_min, design::CycleTime cycle_time) {
  return feed_mm_per_min / 60 * cycle_time.seconds() * motion::units_per_mm;
}

motion::FilterCommandReader filter_command_reader(design::CycleTime cycle_time) {
  return [cycle_time](grammar::NcCommand const& command, std::string_view text) {
    validator::CommandLimits const limits{.cycle_time = cycle_time};
    auto const checked = validator::check_command(command, text, limits, validator::Variables::refused);
    motion::FilterCommandReading reading{.command = checked.command, .mistakes = {}};
    for (auto const& mistake : checked.mistakes) {
      reading.mistakes.push_back({.code = mistake.code, .span = mistake.span, .message = mistake.message});
    }
    return reading;
  };
}

Recorded simulated(machine::Machine machine, std::string const& program, bool constant_velocity) {
  motion::ProgramChannel channel;
  channel.cycle_time = machine.cycle_time;
  channel.read_filter_command = filter_command_reader(machine.cycle_time);
  for (auto const& axis : machine.axes) {
    channel.axes.push_back(axis.name);
    channel.rotary.push_back(false);
  }
  Ignore first(machine.groups[0]);
  interpret(channel, first, program);
  Recorded recorded;
  motion::Simulation simulation(runtime_of(machine), runtime_of(machine),
                                motion::PathLimits(path_of(machine)), constant_velocity, recorded);
  interpret(channel, simulation, program);
  CHECK_FALSE(simulation.failure().has_value());
  return recorded;
}

std::pair<std::vector<std::string>, std::optional<double>> interpreted(motion::ProgramChannel const& channel,
                                                                       motion::PathListener& listener,
                                                                       std::string const& program) {
  std::vector<std::string> problems;
  motion::ProgramInterpreter interpreter(channel, listener, [&](motion::ProgramProblem const& problem) {
    problems.push_back(fmt::format("{}:{} {} {}", problem.line, problem.span.begin + 1,
                                   code_text(problem.finding.code),
                                   problem.line_text.substr(problem.span.begin, problem.span.size())));
  });
  std::istringstream in(program);
  std::uint32_t offset = 0;
  for (std::string line; std::getline(in, line); offset += static_cast<std::uint32_t>(line.size() + 1)) {
    if (!interpreter.line(line, offset)) break;
  }
  interpreter.finish();
  return {std::move(problems), interpreter.rounding()};
}

}  // namespace axisc::test
