#include "axisc/answers/simulation/program_answer.hpp"

#include "analysis/motion/point.hpp"
#include "axisc/answers/execution/path_dynamics.hpp"
#include "axisc/answers/labels.hpp"

#include <array>
#include <iterator>
#include <string_view>

namespace axisc::says {

constexpr Sentence program_title{"{blocks} blocks, {cycles} cycles of {cycle_time}, {time}",
                                 "{blocks} Sätze, {cycles} Zyklen zu {cycle_time}, {time}"};
constexpr Sentence program_of_one_block{"1 block, {cycles} cycles of {cycle_time}, {time}",
                                        "1 Satz, {cycles} Zyklen zu {cycle_time}, {time}"};
constexpr Sentence passes{"passes: from one command for filters to the next",
                          "Durchgänge: von einem Filterbefehl zum nächsten"};
constexpr Sentence block{"block", "Satz"};
constexpr Sentence pass{"pass", "Durchgang"};
constexpr Sentence axis_error{"axis error", "Achsfehler"};
constexpr Sentence lag{"lag", "Nachlauf"};
constexpr Sentence filters{"filters", "Filter"};
constexpr Sentence limited_by{"limited by", "begrenzt durch"};
constexpr Sentence by_feed{"feed", "Vorschub"};
constexpr Sentence by_axis{"axis", "Achse"};
constexpr Sentence by_curve{"curve", "Kurve"};
constexpr Sentence by_curve_jerk{"curve jerk", "Kurvenruck"};
constexpr Sentence by_corner{"corner", "Ecke"};
constexpr Sentence by_tangent_jerk{"tangent jerk", "Übergangsruck"};
constexpr Sentence by_braking{"braking", "Bremsen"};
constexpr Sentence by_look_ahead{"look-ahead", "Vorausschau"};
constexpr Sentence by_tolerance{"tolerance", "Toleranz"};
constexpr Sentence by_stop{"stop", "Halt"};
constexpr Sentence start{"as at start-up", "wie beim Hochlauf"};
constexpr Sentence from_channel_list{
    "slope {slope} at the beginning, look-ahead of {blocks} blocks, as the channel list says",
    "Slope {slope} am Anfang, Vorausschau über {blocks} Sätze, nach der Kanalliste"};
constexpr Sentence from_defaults{
    "slope {slope} at the beginning, look-ahead of {blocks} blocks: defaults of the control, as no channel "
    "list is named",
    "Slope {slope} am Anfang, Vorausschau über {blocks} Sätze: Standardwerte der Steuerung, weil keine "
    "Kanalliste genannt ist"};
constexpr Sentence rounded{
    "corners are followed as they are; the control rounds them, by {bound} at most",
    "Ecken werden verfolgt, wie sie sind; die Steuerung verschleift sie, um höchstens {bound}"};
constexpr Sentence exceeds{"{command}: AX_DEV is not kept", "{command}: AX_DEV wird nicht eingehalten"};

}  // namespace axisc::says

namespace axisc {

namespace {

using motion::units_per_um;
using namespace presentation;

Quantity micrometres(double units, int decimals) {
  return fixed(units / units_per_um, Unit::micrometre, decimals);
}

Table table_with(std::string const& key, SentenceRef label, SimulatedPath const& path) {
  Table table{
      .key = key + "s", .columns = {head_column(key, label), head_column("line", labels::line)}, .rows = {}};
  auto& columns = table.columns;
  columns.push_back(column("time_s", labels::time, Unit::second));
  columns.push_back(column("max_axis_error_um", says::axis_error, Unit::micrometre));
  for (auto const& axis : path.axes) columns.push_back(data_column("axis_error_um", axis));
  columns.push_back(column("max_contour_deviation_um", labels::deviation, Unit::micrometre));
  columns.push_back(column("max_lag_um", says::lag, Unit::micrometre));
  return table;
}

/// By LimitedBy.
constexpr std::array<std::string_view, 10> limit_symbols = {
    "feed",         "axis",    "curve",      "curve-jerk", "corner",
    "tangent-jerk", "braking", "look-ahead", "tolerance",  "stop"};
constexpr std::array<SentenceRef, 10> limit_sentences = {
    says::by_feed,         says::by_axis,    says::by_curve,      says::by_curve_jerk, says::by_corner,
    says::by_tangent_jerk, says::by_braking, says::by_look_ahead, says::by_tolerance,  says::by_stop};

Symbol cause_of(motion::LimitedBy limit) {
  auto const index = static_cast<std::size_t>(limit);
  return {limit_symbols.at(index), limit_sentences.at(index)};
}

/// The command that a pass begins with, and whether it exceeds its tolerance.
Words filters_of(motion::PassSummary const& pass) {
  Words const command =
      pass.command.empty() ? Words(says::start) : Words(says::as_given, {{"text", pass.command}});
  return pass.keeps_tolerance() ? command : Words(says::exceeds, {{"command", command}});
}

/// Passes the simulation's events on.
class Recorder final : public motion::SimulationListener {
 public:
  Recorder(ProgramSummary& summary, std::vector<CycleWriter*> const& rows) : summary_(summary), rows_(rows) {}

  void cycle(motion::MeasuredPoint const& point, motion::BlockSummary const& block) override {
    for (auto* const writer : rows_) writer->cycle(point, block);
  }
  void block(motion::BlockSummary const& found) override { summary_.block(found); }
  void pass(motion::PassSummary const& found) override {
    summary_.pass(found);
    if (!found.keeps_tolerance()) exceeded.push_back(found);
  }

  std::vector<motion::PassSummary> exceeded;

 private:
  ProgramSummary& summary_;
  std::vector<CycleWriter*> const& rows_;
};

}  // namespace

ProgramSummary::ProgramSummary(SimulatedPath const& path)
    : path_(path),
      blocks_(table_with("block", says::block, path)),
      passes_(table_with("pass", says::pass, path)) {
  for (auto& one : data_columns({"velocity_in_mm_s", "velocity_peak_mm_s", "velocity_out_mm_s", "slope"})) {
    blocks_.columns.push_back(std::move(one));
  }
  blocks_.columns.push_back(column("limited_by", says::limited_by));
  blocks_.columns.push_back(data_column("corner_step_share"));
  passes_.key = "passes";
  passes_.columns.push_back(data_column("time_with_trapez_instead_of_hsc_s"));
  for (char const* const key : {"max_acceleration_mm_s2", "max_jerk_mm_s3"}) {
    for (auto const& axis : path.axes) passes_.columns.push_back(data_column(key, axis));
  }
  for (auto& one : data_columns({"command", "blocks", "tolerance_um", "tolerance_kept"})) {
    passes_.columns.push_back(std::move(one));
  }
  passes_.columns.push_back({.key = {}, .label = says::filters, .audience = Audience::people});
}

void ProgramSummary::add(Table& table, Row row, motion::PathSummary const& summary, Row const& rest) {
  if (table.rows.size() == most_rows) {
    ++table.left_out;
    return;
  }
  constexpr int decimals = 4;
  row.emplace_back(fixed(summary.cycles * path_.cycle_time.seconds(), Unit::second, decimals));
  row.emplace_back(micrometres(summary.largest_axis_error(), decimals));
  for (std::size_t i = 0; i < path_.axes.size(); ++i) {
    row.emplace_back(micrometres(summary.axis_error[i], decimals));
  }
  row.emplace_back(micrometres(summary.deviation, decimals));
  row.emplace_back(micrometres(summary.lag, decimals - 1));
  row.insert(row.end(), rest.begin(), rest.end());
  table.rows.push_back(std::move(row));
}

void ProgramSummary::block(motion::BlockSummary const& summary) {
  double const per_second = 1 / (motion::units_per_mm * path_.cycle_time.seconds());
  auto const& motion = summary.motion;
  add(blocks_, {summary.label, summary.line}, summary,
      {motion.velocity_in * per_second, motion.velocity_peak * per_second, motion.velocity_out * per_second,
       slope_name(summary.slope), cause_of(motion.limited_by), summary.corner_step_share});
}

void ProgramSummary::pass(motion::PassSummary const& summary) {
  std::optional<double> tolerance;
  std::optional<bool> kept;
  if (summary.tolerance) {
    tolerance = *summary.tolerance / units_per_um;
    kept = summary.keeps_tolerance();
  }
  double const T = path_.cycle_time.seconds();
  Row rest{summary.trapez_cycles ? Value(*summary.trapez_cycles * T) : Value()};
  for (std::size_t i = 0; i < path_.axes.size(); ++i) {
    rest.emplace_back(summary.peaks.acceleration[i] / (motion::units_per_mm * T * T));
  }
  for (std::size_t i = 0; i < path_.axes.size(); ++i) {
    double const jerk = summary.peaks.jerk[i] / (motion::units_per_mm * T * T * T);
    rest.push_back(summary.peaks.jumps ? Value() : Value(jerk));
  }
  for (auto const& value : Row{summary.command.empty() ? Value() : summary.command, summary.blocks, tolerance,
                               kept, filters_of(summary)}) {
    rest.push_back(value);
  }
  add(passes_, {passes_.rows.size() + 1, summary.line == 0 ? Value() : summary.line}, summary, rest);
}

Document ProgramSummary::answer(FollowedProgram const& followed) && {
  auto const cycle_time = exact(path_.cycle_time.microseconds(), Unit::microsecond);
  auto const time = fixed(static_cast<double>(followed.cycles) * path_.cycle_time.seconds(), Unit::second, 3);
  auto const& dynamics = path_.dynamics;
  auto const slope = slope_name(dynamics.slope);
  Document answer{
      .title = Words(followed.blocks == 1 ? says::program_of_one_block : says::program_title,
                     {{"blocks", followed.blocks},
                      {"cycles", followed.cycles},
                      {"cycle_time", cycle_time},
                      {"time", time}}),
      .blocks = {Facts{{data("cycle_time_us", cycle_time), data("group", path_.group),
                        data("axes", Names(path_.axes)), data("block_count", followed.blocks),
                        data("pass_count", passes_.rows.size() + passes_.left_out),
                        data("cycles", followed.cycles), data("time_s", time), data("slope_at_start", slope),
                        data("look_ahead_blocks", dynamics.look_ahead_blocks),
                        data("channel_list", dynamics.is_from_list)}},
                 Paragraph{Words(dynamics.is_from_list ? says::from_channel_list : says::from_defaults,
                                 {{"slope", slope}, {"blocks", dynamics.look_ahead_blocks}})}}};
  if (followed.rounding) {
    auto const bound = exact(*followed.rounding, Unit::millimetre);
    answer.blocks.emplace_back(Facts{{data("corners_rounded_by_up_to_mm", bound)}});
    answer.blocks.emplace_back(Paragraph{Words(says::rounded, {{"bound", bound}})});
  }
  answer.blocks.emplace_back(std::move(blocks_));
  answer.blocks.emplace_back(Section{.key = {}, .title = says::passes, .blocks = {std::move(passes_)}});
  return answer;
}

SimulatedProgram simulate_answer(ProgramLines& program, ProgramRequest const& request,
                                 machine::Machine const& machine, std::size_t group,
                                 SimulatedPath const& path, std::vector<CycleWriter*> const& rows) {
  ProgramSummary summary(path);
  Recorder recorder(summary, rows);
  auto const followed = follow_program(program, request, machine, group, recorder);
  for (auto* const writer : rows) writer->finish();
  return {.answer = std::move(summary).answer(followed), .exceeded = std::move(recorder.exceeded)};
}

}  // namespace axisc
