#include "analysis/motion/simulation.hpp"

#include "analysis/motion/planning/junction.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace axisc::motion {
namespace {

constexpr std::uint64_t cycles_per_call = 1024;
constexpr double rounding = 1e-9;

Point windows_of(PathLimits const& path) {
  Point windows{};
  auto const& axes = path.dynamics().axes;
  for (std::size_t i = 0; i < axes.size(); ++i) windows[i] = axes[i].exact_stop_window;
  return windows;
}

}  // namespace

Simulation::Simulation(GroupRuntime runtime, GroupRuntime probe, PathLimits path, bool constant_velocity,
                       SimulationListener& listener, SimulationLimits limits)
    : runtime_(std::move(runtime)),
      probe_(std::move(probe)),
      listener_(listener),
      meter_(runtime_.axis_count(), *this),
      interpolator_(*this),
      constant_velocity_(constant_velocity),
      exact_stop_windows_(windows_of(path)),
      trapez_time_(path),
      look_ahead_(std::move(path), constant_velocity, interpolator_),
      limits_(std::move(limits)) {
  learn_answers();
  static_cast<void>(runtime_.reset({}));
}

void Simulation::learn_answers() {
  auto answered = chain_answers(probe_);
  if (auto const* const missing = std::get_if<NoAnswer>(&answered)) {
    failure_ = SimulationFailure{
        .status = AXISRT_OK, .command = {}, .blocking_axis = missing->axis, .endless_line = {}};
    answers_.assign(runtime_.axis_count(), {});
    return;
  }
  answers_ = std::get<std::vector<ChainAnswer>>(std::move(answered));
}

void Simulation::begin_pass(std::string command, std::uint32_t line) {
  pass_ = {};
  pass_.command = std::move(command);
  pass_.line = line;
}

void Simulation::motion(ProgrammedBlock const& block) {
  if (failure_) return;
  open_pass();
  if (compares_slopes()) trapez_time_.add(block);
  look_ahead_.add(block);
}

void Simulation::open_pass() {
  if (pass_open_) return;
  pass_open_ = true;
  pass_begin_ = cycles_;
  if (tolerance_ > 0 && !constant_velocity_) pass_.tolerance = tolerance_;
  path_cycles_ = 0;
  trapez_time_.begin(last_.nominal, acceleration_factor_);
  meter_.begin(answers_, last_.nominal);
  look_ahead_.begin(last_.nominal, ToleranceMonitor(probe_, answers_, tolerance_, limits_.working),
                    acceleration_factor_);
}

/// Ends the pass. False if the simulation has failed.
bool Simulation::come_to_rest() {
  if (failure_) return false;
  finish_pass();
  if (failure_) return false;
  // The filters have settled: their states are those of a reset to this position.
  static_cast<void>(runtime_.reset(last_.nominal));
  static_cast<void>(probe_.reset({}));
  return true;
}

void Simulation::feedforward(bool is_on, std::uint32_t line) {
  bool const changes = is_on != feeds_forward_ && runtime_.feedforward_matters();
  if (!changes || !come_to_rest()) return;
  feeds_forward_ = is_on;
  for (GroupRuntime* const runtime : {&runtime_, &probe_}) runtime->feed_forward(is_on);
  static_cast<void>(runtime_.reset(last_.nominal));
  static_cast<void>(probe_.reset({}));
  learn_answers();
  begin_pass(is_on ? "G135" : "G137", line);
}

void Simulation::command(FilterChange const& change) {
  if (!come_to_rest()) return;
  auto const status = std::max(runtime_.command(change.command), probe_.command(change.command));
  if (status != AXISRT_OK) {
    failure_ =
        SimulationFailure{.status = status, .command = change.text, .blocking_axis = {}, .endless_line = {}};
    return;
  }
  learn_answers();
  if (!change.command.hsc) {
    if (change.command.filter_switch != machine::FilterSwitch::unchanged) {
      tolerance_ = 0;
      acceleration_factor_ = 1;
    }
    if (change.command.filter_switch != machine::FilterSwitch::off) {
      tolerance_ = change.tolerance.value_or(tolerance_);
      acceleration_factor_ = change.command.acceleration_factor.value_or(acceleration_factor_);
    }
  }
  begin_pass(change.text, change.line);
}

void Simulation::end() {
  if (failure_) return;
  finish_pass();
}

void Simulation::stop(double cycles, std::uint32_t line) {
  if (failure_) return;
  open_pass();
  rest(cycles, line);
}

bool Simulation::compares_slopes() const {
  return tolerance_ == 0 && !constant_velocity_;
}

/// The path stops until the filters have settled, and at least this long.
void Simulation::rest(double cycles, std::uint32_t line) {
  look_ahead_.stop();
  trapez_time_.stop();
  if (failure_) return;
  last_.velocity = 0;
  if (!settled_) {
    for (auto const& answer : answers_) cycles = std::max(cycles, answer.delay + answer.reach);
  }
  if (cycles > room()) return fail_for_length(line);
  for (double n = 0; n < cycles && !failure_; n += 1) step(last_);
  settled_ = true;
}

/// The path stops, and the filters settle.
void Simulation::finish_pass() {
  if (!pass_open_) return;
  rest(0, last_line_);
  meter_.finish();
  close_blocks_before(~std::uint64_t{0});
  pass_open_ = false;
  pass_.cycles = static_cast<double>(cycles_ - pass_begin_);
  if (auto const other = trapez_time_.cycles()) pass_.trapez_cycles = pass_.cycles + *other - path_cycles_;
  if (pass_.blocks > 0 && !failure_) listener_.pass(pass_);
}

void Simulation::step(ContourPoint const& point) {
  auto const status = runtime_.step(point.nominal, filtered_);
  if (status != AXISRT_OK && !failure_) {
    failure_ = SimulationFailure{.status = status, .command = {}, .blocking_axis = {}, .endless_line = {}};
  }
  ++cycles_;
  meter_.cycle(point, filtered_);
  if (limits_.working && cycles_ % cycles_per_call == 0) limits_.working();
}

double Simulation::room() const {
  return failure_ ? 0 : static_cast<double>(limits_.most_cycles - std::min(limits_.most_cycles, cycles_));
}

void Simulation::no_room(PathBlock const& block) {
  fail_for_length(block.line);
}

void Simulation::fail_for_length(std::uint32_t line) {
  if (failure_) return;
  failure_ = SimulationFailure{.status = AXISRT_OK, .command = {}, .blocking_axis = {}, .endless_line = line};
}

void Simulation::open_block(PathBlock const& block) {
  if (!open_blocks_.empty() && open_blocks_.back().index >= block.index) return;
  BlockSummary summary;
  summary.index = block.index;
  summary.line = block.line;
  summary.label = block.label;
  open_blocks_.push_back(std::move(summary));
  ++pass_.blocks;
  ++blocks_;
}

BlockSummary* Simulation::find_block(std::uint64_t index) {
  if (open_blocks_.empty() || index < open_blocks_.front().index) return nullptr;
  auto const at = index - open_blocks_.front().index;
  return at < open_blocks_.size() ? &open_blocks_[at] : nullptr;
}

void Simulation::close_blocks_before(std::uint64_t index) {
  while (!open_blocks_.empty() && open_blocks_.front().index < index) {
    listener_.block(open_blocks_.front());
    open_blocks_.pop_front();
  }
}

void Simulation::sample(Point const& setpoint, double velocity, PathBlock const& block) {
  if (failure_) return;
  open_block(block);
  settled_ = false;
  last_.nominal = setpoint;
  last_.velocity = velocity;
  last_.block = block.index;
  last_line_ = block.line;
  step(last_);
}

void Simulation::phase(PathBlock const& block, Phase const& phase) {
  path_cycles_ += phase.duration;
  if (!constant_velocity_) pass_.peaks.take(block, phase);
}

/// The axes are there when the filters have come so close. Drives follow their setpoints.
void Simulation::exact_stop(PathBlock const& block) {
  last_.velocity = 0;
  auto const is_there = [this] {
    for (std::size_t i = 0; i < runtime_.axis_count(); ++i) {
      if (std::abs(filtered_[i] - last_.nominal[i]) > exact_stop_windows_[i]) return false;
    }
    return true;
  };
  double most = 0;
  for (auto const& answer : answers_) most = std::max(most, answer.delay + answer.reach);
  for (double n = 0; n < most && !failure_ && !is_there(); n += 1) {
    if (room() < 1) return fail_for_length(block.line);
    step(last_);
  }
}

void Simulation::corner(PathBlock const& block, PathBlock const* next, double block_cycles,
                        BlockMotion const& motion) {
  if (failure_) return;
  open_block(block);
  if (auto* const summary = find_block(block.index)) {
    summary->cycles = block_cycles;
    summary->motion = motion;
    summary->slope = block.mode->slope;
    bool const is_forced = next != nullptr && block.mode->least_corner_velocity > 0;
    double const share = is_forced ? motion.velocity_out / step_limit(block, *next).velocity : 0;
    if (share > 1 + rounding) summary->corner_step_share = share;
  }
  ContourPoint point;
  point.nominal = block.end;
  point.block = block.index;
  point.next_block = block.index;
  if (next != nullptr) {
    open_block(*next);
    point.next_block = next->index;
  }
  meter_.corner(point);
}

void Simulation::take(PathSummary& summary, MeasuredPoint const& point) const {
  for (std::size_t i = 0; i < runtime_.axis_count(); ++i) {
    summary.axis_error[i] = std::max(summary.axis_error[i], point.axis_error[i]);
  }
  summary.deviation = std::max(summary.deviation, point.deviation);
  if (point.lag) summary.lag = std::max(summary.lag, std::abs(*point.lag));
}

void Simulation::measured(MeasuredPoint const& point) {
  close_blocks_before(point.point.block);
  take(pass_, point);
  auto* const block = find_block(point.point.block);
  if (!point.point.is_corner) listener_.cycle(point, block != nullptr ? *block : BlockSummary{});
  if (block == nullptr) return;
  take(*block, point);
  if (!point.point.is_corner) return;
  auto* const next = find_block(point.point.next_block);
  if (next != block && next != nullptr) take(*next, point);
}

}  // namespace axisc::motion
