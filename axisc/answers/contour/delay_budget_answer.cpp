#include "axisc/answers/contour/delay_budget_answer.hpp"

#include "axisc/answers/labels.hpp"
#include "validator/views/delay_budget.hpp"
#include "validator/views/filter_view.hpp"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace axisc::says {

constexpr Sentence budget{"delay budget", "Verzögerungsbilanz"};
constexpr Sentence at_start{"{axis}, at the start of programs", "{axis}, am Programmanfang"};
constexpr Sentence after_g135{"{axis}, after G135", "{axis}, nach G135"};
constexpr Sentence start_word{"at the start", "am Anfang"};
constexpr Sentence g135_word{"after G135", "nach G135"};
constexpr Sentence item{"delay", "Verzögerung"};
constexpr Sentence position{"position", "Position"};
constexpr Sentence velocity{"velocity", "Geschwindigkeit"};
constexpr Sentence acceleration{"acceleration", "Beschleunigung"};
constexpr Sentence jerk{"jerk", "Ruck"};
constexpr Sentence set_in{"from", "aus"};
constexpr Sentence by_default{"default", "Standardwert"};
constexpr Sentence basis{"basis", "Grundlage"};
constexpr Sentence documented{"documented", "dokumentiert"};
constexpr Sentence reading{"reading", "Lesart"};
constexpr Sentence interpolator{"interpolator to position controller", "Interpolator bis Lageregler"};
constexpr Sentence lag{"lag of the position controller", "Nachlauf des Lagereglers"};
constexpr Sentence nothing{"{axis}: nothing delays the position", "{axis}: nichts verzögert die Position"};
constexpr Sentence unknown{"{axis}: unknown, because a filter cannot be designed",
                           "{axis}: unbekannt, weil ein Filter nicht berechnet werden kann"};
constexpr Sentence sums{
    "position {position}, velocity feedforward {velocity}: the velocity arrives {lead} before its position",
    "Position {position}, Geschwindigkeitsvorsteuerung {velocity}: Die Geschwindigkeit kommt {lead} vor "
    "ihrer "
    "Position an"};
constexpr Sentence sum_alone{"position {position}; nothing is fed forward",
                             "Position {position}; es wird nichts vorgesteuert"};
constexpr Sentence lead_deviation{"accelerating at the limit, the axis is {deviation} ahead",
                                  "beim Beschleunigen an der Grenze ist die Achse {deviation} voraus"};
constexpr Sentence in_step{"{channel}: the axes are in step", "{channel}: die Achsen laufen gleich"};
constexpr Sentence apart{
    "{channel}: {slow} and {fast} are {time} apart, at {feed} up to {deviation} on a line at 45° or a circle",
    "{channel}: {slow} und {fast} liegen {time} auseinander, bei {feed} bis zu {deviation} auf einer Geraden "
    "unter "
    "45° oder einem Kreis"};
constexpr Sentence of_drive{
    "The drives' own delays are in no list and not in these sums.",
    "Die eigenen Verzögerungen der Antriebe stehen in keiner Liste und sind nicht enthalten."};

}  // namespace axisc::says

namespace axisc {

using namespace presentation;
using validator::DelayBudget;
using validator::DelayItem;
using validator::DelayKind;
using validator::FeedforwardState;

namespace {

constexpr double mm_per_min_of_um_per_s = 0.06;

Quantity cycles(double value) {
  return rounded(value, Unit::cycle, 4);
}

class BudgetBlocks {
 public:
  BudgetBlocks(validator::LoadedMachine const& machine, SourceSet const& sources, std::optional<double> feed)
      : machine_(machine), sources_(sources), feed_(feed) {}

  Section section() {
    Section result{.key = "delay_budget", .title = Words(says::budget), .blocks = {}};
    Sections axes{.key = "axes", .items = {}};
    for (auto const& axis : machine_.axes) add_axis(axis, axes);
    result.blocks.emplace_back(std::move(axes));
    Sections channels{.key = "channels", .items = {}};
    for (auto const& group : machine_.groups) add_channel(group, channels);
    result.blocks.emplace_back(std::move(channels));
    result.blocks.emplace_back(Paragraph{says::of_drive});
    return result;
  }

 private:
  [[nodiscard]] Quantity time(double in_cycles) const {
    return rounded(in_cycles * cycle_time_.microseconds() / 1e3, Unit::millisecond, 4);
  }

  void add_axis(validator::LoadedAxis const& axis, Sections& axes) {
    auto const start = validator::delay_budget(axis, cycle_time_);
    if (!start) {
      axes.items.push_back({.key = {},
                            .title = {},
                            .blocks = {Paragraph{Words(says::unknown, {{"axis", axis.name}})}},
                            .identity = {data("axis", axis.name)}});
      return;
    }
    add_state(axis, *start, FeedforwardState::at_start, axes);
    auto const on = validator::delay_budget(axis, cycle_time_, FeedforwardState::on);
    if (on->feeds_forward && !start->feeds_forward) add_state(axis, *on, FeedforwardState::on, axes);
  }

  void add_state(validator::LoadedAxis const& axis, DelayBudget const& budget, FeedforwardState state,
                 Sections& axes) const {
    bool const is_start = state == FeedforwardState::at_start;
    Section section{.key = {},
                    .title = Words(is_start ? says::at_start : says::after_g135, {{"axis", axis.name}}),
                    .blocks = {},
                    .identity = {data("axis", axis.name),
                                 data("state", Symbol{is_start ? "start" : "G135",
                                                      is_start ? says::start_word : says::g135_word})}};
    if (budget.items.empty()) {
      section.blocks.emplace_back(Paragraph{Words(says::nothing, {{"axis", axis.name}})});
    } else {
      Table items{.key = "items"};
      for (auto const& item : budget.items) add_row(items, row_of(item, budget.feeds_forward));
      section.blocks.emplace_back(std::move(items));
    }
    std::vector<Field> sums{data("position_cycles", cycles(budget.position)),
                            data("position_ms", time(budget.position))};
    auto deviation = std::optional<double>{};
    if (budget.feeds_forward) {
      sums.push_back(data("velocity_cycles", cycles(budget.velocity)));
      sums.push_back(data("lead_cycles", cycles(budget.lead())));
      sums.push_back(data("lead_ms", time(budget.lead())));
      deviation = validator::deviation_of_lead(axis, budget.lead(), cycle_time_);
      if (deviation) sums.push_back(data("lead_deviation_um", rounded(*deviation, Unit::micrometre, 4)));
    }
    section.blocks.emplace_back(Facts{std::move(sums)});
    if (!budget.items.empty()) section.blocks.emplace_back(Paragraph{sums_of(budget)});
    if (deviation && budget.lead() != 0) {
      section.blocks.emplace_back(
          Paragraph{Words(says::lead_deviation, {{"deviation", rounded(*deviation, Unit::micrometre, 4)}})});
    }
    axes.items.push_back(std::move(section));
  }

  [[nodiscard]] Words sums_of(DelayBudget const& budget) const {
    if (!budget.feeds_forward) return {says::sum_alone, {{"position", time(budget.position)}}};
    return {says::sums,
            {{"position", time(budget.position)},
             {"velocity", time(budget.velocity)},
             {"lead", time(budget.lead())}}};
  }

  [[nodiscard]] static Value name_of(DelayItem const& item) {
    switch (item.kind) {
      case DelayKind::filter: return item.filter;
      case DelayKind::interpolator: return Symbol{"interpolator", says::interpolator};
      case DelayKind::lag: return Symbol{"lag", says::lag};
      case DelayKind::shift:
      case DelayKind::quantity:
      case DelayKind::balancing: break;
    }
    return validator::parameter_name(*item.cause);
  }

  [[nodiscard]] Value place_of(DelayItem const& item) const {
    if (item.cause == nullptr || !item.cause->value_place()) return Symbol{"default", says::by_default};
    auto const& source = sources_[item.cause->source];
    return source.name() + ":" + std::to_string(item.cause->line - source.lines_before());
  }

  /// Of what is fed forward only where something is.
  [[nodiscard]] std::vector<Field> row_of(DelayItem const& item, bool feeds_forward) const {
    auto const forward = [&](double value) { return feeds_forward ? Value(cycles(value)) : Value(); };
    return {{"item", says::item, name_of(item)},
            {"position_cycles", says::position, cycles(item.position)},
            {"velocity_cycles", says::velocity, forward(item.velocity)},
            {"acceleration_cycles", says::acceleration, forward(item.acceleration)},
            {"jerk_cycles", says::jerk, forward(item.jerk)},
            {"parameter", labels::parameter,
             item.cause != nullptr ? Value(validator::parameter_number(*item.cause)) : Value()},
            {"from", says::set_in, place_of(item)},
            {"basis", says::basis,
             Symbol{item.is_reading ? "reading" : "documented",
                    item.is_reading ? says::reading : says::documented}}};
  }

  /// The largest difference between two axes of a channel, at the start of programs.
  void add_channel(validator::LoadedGroup const& group, Sections& channels) const {
    validator::LoadedAxis const* slow = nullptr;
    validator::LoadedAxis const* fast = nullptr;
    double most = -std::numeric_limits<double>::infinity(), least = -most;
    double limit = std::numeric_limits<double>::infinity();
    for (auto const index : group.axes) {
      auto const& axis = machine_.axes[index];
      auto const budget = validator::delay_budget(axis, cycle_time_);
      if (!budget) return;
      if (budget->position > most) std::tie(most, slow) = std::pair(budget->position, &axis);
      if (budget->position < least) std::tie(least, fast) = std::pair(budget->position, &axis);
      auto const& velocity = axis.merged.values.at("getriebe[].dynamik.vb_max");
      if (!velocity.unusable) limit = std::min(limit, velocity.value.number);
    }
    if (group.axes.size() < 2) return;
    double const feed = feed_.value_or(limit * mm_per_min_of_um_per_s);
    double const deviation =
        validator::deviation_of_mismatch(feed / mm_per_min_of_um_per_s, most - least, cycle_time_);
    Section section{.key = {}, .title = {}, .blocks = {}, .identity = {data("channel", group.name)}};
    section.blocks.emplace_back(Facts{
        {data("mismatch_cycles", cycles(most - least)), data("mismatch_ms", time(most - least)),
         data("feed_mm_per_min", exact(feed)), data("deviation_um", rounded(deviation, Unit::none, 4))}});
    Words const channel(labels::one_channel, {{"name", group.name}});
    section.blocks.emplace_back(Paragraph{
        most - least == 0 ? Words(says::in_step, {{"channel", channel}})
                          : Words(says::apart, {{"channel", channel},
                                                {"slow", slow->name},
                                                {"fast", fast->name},
                                                {"time", time(most - least)},
                                                {"feed", rounded(feed, Unit::millimetre_per_minute, 6)},
                                                {"deviation", rounded(deviation, Unit::micrometre, 4)}})});
    channels.items.push_back(std::move(section));
  }

  validator::LoadedMachine const& machine_;
  SourceSet const& sources_;
  std::optional<double> feed_;
  design::CycleTime cycle_time_ = machine_.cycle_time.value_or(design::CycleTime{});
};

}  // namespace

Section delay_budget_section(validator::LoadedMachine const& machine, SourceSet const& sources,
                             std::optional<double> feed) {
  return BudgetBlocks(machine, sources, feed).section();
}

Document delay_budget_answer(validator::LoadedMachine const& machine, SourceSet const& sources,
                             std::optional<double> feed) {
  auto section = delay_budget_section(machine, sources, feed);
  Document document{.version = 2, .title = says::budget, .blocks = {}, .csv_table = "items"};
  document.blocks.emplace_back(
      Facts{{data("cycle_time_us", exact(machine.cycle_time.value_or(design::CycleTime{}).microseconds()))}});
  section.title.reset();
  document.blocks.emplace_back(std::move(section));
  return document;
}

}  // namespace axisc
