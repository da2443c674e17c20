#include "analysis/motion/axis_ramps.hpp"
#include "analysis/motion/point.hpp"
#include "analysis/tuning/suggestion/ramp_envelope.hpp"
#include "axisc/answers/execution/path_dynamics.hpp"
#include "axisc/answers/suggestion/suggest_answer.hpp"

#include <array>
#include <numbers>

namespace axisc::says {

constexpr Sentence excitation{"excitation: from rest to the feed and back to rest, {slope}",
                              "Anregung: aus dem Stillstand auf Vorschubgeschwindigkeit und zurück, {slope}"};
constexpr Sentence slope_of_option{"slope {slope}, as --slope says", "Slope {slope} nach --slope"};
constexpr Sentence envelope{
    "at {frequency} these ramps excite at most {share} of what STEP would with the same acceleration",
    "bei {frequency} regen diese Rampen höchstens {share} dessen an, was STEP mit gleicher Beschleunigung "
    "anregen würde"};
constexpr Sentence hsc_is_a_reading{
    "how HSC plans is not documented: this is a reading, each ramp with the longest of the four ramp times",
    "wie HSC plant, ist nicht dokumentiert: dies ist eine Lesart, jede Rampe mit der längsten der vier "
    "Rampenzeiten"};
constexpr Sentence sin2_is_a_reading{
    "the shape of SIN2 is not documented: these figures are those of a reading (\"sine\" of \"motion\")",
    "die Form von SIN2 ist nicht dokumentiert: diese Werte gelten für eine Lesart („sine“ in „motion“)"};
constexpr Sentence no_ramp_times{
    "ramp times have no effect with STEP; --slope TRAPEZ also compares ramp times with filters",
    "mit STEP wirken Rampenzeiten nicht; --slope TRAPEZ vergleicht auch Rampenzeiten mit Filtern"};

constexpr Sentence ramp_heading{
    "ramp times of axis {axis} (P-AXIS-00195 to 00198) instead of filters: no delay, no contour deviation",
    "Rampenzeiten der Achse {axis} (P-AXIS-00195 bis 00198) statt Filtern: keine Verzögerung, keine "
    "Bahnabweichung"};
constexpr Sentence ramp_time{"ramp time", "Rampenzeit"};
constexpr Sentence periods{"periods", "Perioden"};
constexpr Sentence periods_of{"{periods} of {frequency}", "{periods} von {frequency}"};
constexpr Sentence vibration{"vibration", "Schwingung"};
constexpr Sentence to_feed{"to the feed", "in den Vorschub"};
constexpr Sentence longer{"start and stop longer by", "An- und Abfahren länger um"};
constexpr Sentence ramp_name{"{number} ramp times of {time}", "{number} Rampenzeiten von {time}"};
constexpr Sentence none_enough{"none of them reduces the vibration to a quarter",
                               "keine verringert die Schwingung auf ein Viertel"};
constexpr Sentence needs_slope{
    "they act only with the slope {slope}: P-CHAN-00071 in the channel list, or #SLOPE [TYPE={slope}]",
    "sie wirken nur mit dem Slope {slope}: P-CHAN-00071 in der Kanalliste oder #SLOPE [TYPE={slope}]"};

}  // namespace axisc::says

namespace axisc {

namespace {

using namespace presentation;

constexpr std::array<std::string_view, 3> source_symbols = {"option", "channel_list", "default"};

Quantity milliseconds(double cycles, tuning::Task const& task) {
  return fixed(cycles * task.cycle_time.seconds() * 1e3, Unit::millisecond, 1);
}

Quantity time_of(tuning::RampCandidate const& candidate) {
  constexpr double us_per_ms = 1e3;
  return fixed(candidate.ramp_time / us_per_ms, Unit::millisecond, 3);
}

Table candidates_of(tuning::RampCandidates const& found, tuning::Task const& task) {
  bool const is_sine = task.dynamics.channel.slope == machine::Slope::sin2;
  Table table{.key = "candidates",
              .columns = {head_column("ramp_time_ms", says::ramp_time, Unit::millisecond),
                          {.key = {}, .label = says::periods, .audience = Audience::people},
                          data_column("periods"),
                          data_column("frequency_hz"),
                          column("remaining_vibration", says::vibration),
                          column("time_to_feed_ms", says::to_feed, Unit::millisecond),
                          data_column("time_to_rest_ms"),
                          column("longer_by_ms", says::longer, Unit::millisecond)}};
  for (auto const& one : found.candidates) {
    double const frequency = task.resonances[one.resonance].frequency;
    double const count = one.zero + (is_sine ? 0.5 : 0.0);
    Words const periods(says::periods_of,
                        {{"periods", exact(count)}, {"frequency", rounded(frequency, Unit::hertz, 4)}});
    table.rows.push_back({time_of(one), periods, count, frequency, fixed(one.vibration, Unit::share, 1),
                          milliseconds(one.up_time, task), milliseconds(one.down_time, task),
                          milliseconds(one.up_time - found.up_time + one.down_time - found.down_time, task)});
  }
  return table;
}

}  // namespace

Words ramps_name(RampAnswer const& answer) {
  return {says::ramp_name, {{"number", ramps_number}, {"time", time_of(*answer.quickest())}}};
}

void add_excitation(std::vector<Block>& blocks, Suggested const& suggested) {
  auto const& task = suggested.task;
  auto const slope = task.dynamics.channel.slope;
  auto const source = static_cast<std::size_t>(suggested.slope_source);
  blocks.emplace_back(
      Facts{{data("slope", slope_name(slope)), data("slope_from", source_symbols.at(source))}});
  Words const how = suggested.slope_source == SlopeSource::option
                        ? Words(says::slope_of_option, {{"slope", slope_name(slope)}})
                        : slope_words(task.dynamics.channel);
  blocks.emplace_back(Paragraph{Words(says::excitation, {{"slope", how}})});
  Table shares{.key = "excitation",
               .columns = data_columns({"frequency_hz", "share_of_step"}),
               .rows = {},
               .audience = Audience::programs};
  double const per_cycle = 2 * std::numbers::pi * task.cycle_time.seconds();
  auto const [up, down] = motion::axis_ramps(task.dynamics);
  for (auto const& resonance : task.resonances) {
    double const theta = per_cycle * resonance.frequency;
    double const share =
        std::max(tuning::envelope(up, task.velocity, theta), tuning::envelope(down, task.velocity, theta));
    shares.rows.push_back({resonance.frequency, share});
    if (slope == machine::Slope::step) continue;
    blocks.emplace_back(
        Paragraph{Words(says::envelope, {{"frequency", rounded(resonance.frequency, Unit::hertz, 4)},
                                         {"share", fixed(share, Unit::share, 2)}})});
  }
  blocks.emplace_back(std::move(shares));
  if (slope == machine::Slope::step) blocks.emplace_back(Paragraph{says::no_ramp_times});
  if (slope == machine::Slope::sin2) blocks.emplace_back(Paragraph{says::sin2_is_a_reading});
  if (slope == machine::Slope::hsc) blocks.emplace_back(Paragraph{says::hsc_is_a_reading});
}

Section ramp_section(Suggested const& suggested) {
  auto const& answer = *suggested.ramps;
  auto const& task = suggested.task;
  Section section{.key = "ramp_times",
                  .title = Words(says::ramp_heading, {{"axis", suggested.axis}}),
                  .blocks = {candidates_of(answer.found, task)}};
  if (answer.quickest() == nullptr) {
    section.blocks.emplace_back(Paragraph{says::none_enough});
    return section;
  }
  Section lines{.key = {}, .title = ramps_name(answer), .blocks = {}};
  add_lines(lines.blocks, answer.axes, answer.findings);
  if (suggested.slope_source == SlopeSource::option) {
    lines.blocks.emplace_back(
        Paragraph{Words(says::needs_slope, {{"slope", slope_name(task.dynamics.channel.slope)}})});
  }
  section.blocks.emplace_back(std::move(lines));
  section.identity = {data("number", ramps_number)};
  return section;
}

}  // namespace axisc
