#include "axisc/answers/execution/execution.hpp"

#include "axisc/environment/failure.hpp"
#include "axisc/environment/sentences.hpp"
#include "axisc/files/csv.hpp"
#include "diagnostics/format_number.hpp"
#include "presentation/text_table.hpp"

#include <algorithm>
#include <utility>

namespace axisc {

namespace {

constexpr std::size_t piece = std::size_t{1} << 16U;

/// The rows of a run, in pieces.
class TableWriter {
 public:
  TableWriter(RunTable table, std::function<void(std::string_view)> const& write)
      : is_text_(table.is_text), write_(write) {}

  void header(std::vector<std::string> const& names) {
    for (auto const& name : names) {
      widths_.push_back(std::max(narrowest, presentation::display_width(csv_name(name))));
    }
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (is_text_) {
        add_cell(i, csv_name(names[i]));
      } else {
        if (i != 0) text_ += ',';
        append_csv_name(text_, names[i]);
      }
    }
    text_ += '\n';
  }

  void row(std::vector<double> const& values) {
    if (is_text_) {
      for (std::size_t i = 0; i < values.size(); ++i) {
        add_cell(i, format_rounded(values[i], digits).written());
      }
      text_ += '\n';
    } else {
      append_csv_row(text_, values);
    }
    if (text_.size() >= piece) flush();
  }

  void flush() {
    write_(text_);
    text_.clear();
  }

 private:
  static constexpr std::size_t narrowest = 10;
  static constexpr int digits = 4;

  void add_cell(std::size_t column, std::string const& cell) {
    text_ += column + 1 == widths_.size() ? cell : presentation::padded(cell, widths_[column]) + "  ";
  }

  bool is_text_;
  std::function<void(std::string_view)> const& write_;
  std::vector<std::size_t> widths_;
  std::string text_;
};

void require(axisrt_status status) {
  if (status == AXISRT_OK) return;
  throw Failure(
      {says::runtime, {{"status", axisrt_status_name(status)}, {"reason", axisrt_status_text(status)}}});
}

}  // namespace

Execution::Execution(std::string path, image::RuntimeHost host, image::ImageContents const& image,
                     Stimulus& stimulus, std::vector<TimedCommand> commands)
    : path_(std::move(path)),
      host_(std::move(host)),
      image_(image),
      stimulus_(stimulus),
      commands_(std::move(commands)),
      has_v_direct_(host_.axis_count(), false) {
  for (auto const& channel : stimulus.channels()) {
    if (channel.input == Input::v_direct) has_v_direct_[channel.axis] = true;
    feeds_velocities_ = feeds_velocities_ || port_of(channel.input) == Port::velocity;
  }
}

void Execution::record(std::uint32_t cycles) {
  require(host_.record(cycles));
}

void Execution::reset(double position, Port fed) {
  auto const start = [&](Port port) { return fed == port ? position : 0.0; };
  for (std::uint32_t axis = 0; axis < host_.axis_count(); ++axis) {
    require(host_.reset(axis, start(Port::setpoint)));
    require(host_.reset_interface(axis, start(Port::interface)));
    double const velocity = start(Port::velocity);
    require(host_.reset_velocity(axis, velocity, velocity, velocity));
  }
  for (auto const input :
       {Input::setpoint, Input::interface, Input::v_set, Input::v_motor, Input::v_direct}) {
    in(input).assign(host_.axis_count(), start(port_of(input)));
  }
  setpoints_ = in(Input::setpoint);
  interface_ = in(Input::interface);
  v_add_.assign(host_.axis_count(), 0);
  increments_.assign(host_.axis_count(), 0);
  status_.assign(host_.axis_count(), AXISRT_OK);
}

std::vector<Execution::Output> Execution::outputs() const {
  std::vector<Output> outputs;
  for (auto const& channel : stimulus_.channels()) {
    Port const port = port_of(channel.input);
    if (port == Port::velocity) continue;
    outputs.push_back({.name = channel_name(image_, channel),
                       .values = port == Port::setpoint ? &setpoints_ : &interface_,
                       .axis = channel.axis});
  }
  if (!feeds_velocities_) return outputs;
  for (std::size_t axis = 0; axis < image_.axes.size(); ++axis) {
    auto const& control = image_.axes[axis].control;
    if (!control) continue;
    std::string const label = axis_label(image_, axis);
    outputs.push_back({.name = label + ".v_add", .values = &v_add_, .axis = axis});
    if (control->scaling.controller == machine::PositionController::unknown) continue;
    outputs.push_back({.name = label + ".increments", .values = &increments_, .axis = axis});
  }
  return outputs;
}

Noticed Execution::go(RunTable table, std::function<void(std::string_view)> const& write) {
  auto const columns = outputs();
  TableWriter writer(table, write);
  std::vector<std::string> names;
  if (table.has_time) names.emplace_back("time_s");
  for (auto const& column : columns) names.push_back(column.name);
  writer.header(names);
  std::vector<double> row_in(stimulus_.channels().size());
  std::vector<double> row_out(names.size());
  double const cycle_time = image_.cycle_time.seconds();
  Noticed noticed;
  std::uint64_t cycle = 0;
  for (; stimulus_.next(row_in); ++cycle) {
    execute_commands(cycle);
    feed(row_in);
    step(cycle, noticed);
    if (table.has_time) row_out.front() = static_cast<double>(cycle) * cycle_time;
    std::transform(columns.begin(), columns.end(),
                   row_out.end() - static_cast<std::ptrdiff_t>(columns.size()),
                   [](Output const& column) { return (*column.values)[column.axis]; });
    writer.row(row_out);
  }
  writer.flush();
  refuse_late(commands_, cycle);
  return noticed;
}

void Execution::execute_commands(std::uint64_t cycle) {
  for (; next_command_ < commands_.size() && commands_[next_command_].cycle <= cycle; ++next_command_) {
    execute(commands_[next_command_], host_, image_, path_);
  }
}

void Execution::feed(std::vector<double> const& row) {
  auto const& channels = stimulus_.channels();
  for (std::size_t i = 0; i < channels.size(); ++i) in(channels[i].input)[channels[i].axis] = row[i];
  for (std::size_t axis = 0; axis < has_v_direct_.size(); ++axis) {
    if (!has_v_direct_[axis]) in(Input::v_direct)[axis] = in(Input::v_motor)[axis];
  }
}

void Execution::notice(axisrt_status worst, std::uint64_t cycle, Noticed& noticed) const {
  if (worst == AXISRT_OK) return;
  if (worst != AXISRT_BAD_INPUT && worst != AXISRT_IMPLAUSIBLE) require(worst);
  for (auto const status : status_) {
    if (status == AXISRT_BAD_INPUT) noticed.refused.add(cycle);
    if (status == AXISRT_IMPLAUSIBLE) noticed.jumps.add(cycle);
  }
}

void Execution::step(std::uint64_t cycle, Noticed& noticed) {
  notice(host_.step(in(Input::setpoint), setpoints_, status_), cycle, noticed);
  notice(host_.step_interface(in(Input::interface), interface_, status_), cycle, noticed);
  notice(host_.step_velocity(
             {.set = in(Input::v_set), .motor = in(Input::v_motor), .direct = in(Input::v_direct)}, v_add_,
             increments_, status_),
         cycle, noticed);
}

}  // namespace axisc
