#include "axisc/answers/contour/delay_budget_answer.hpp"

#include "axisc/answers/labels.hpp"
#include "axisc/checking/compilable.hpp"
#include "axisc/checking/machine_input.hpp"
#include "design/units.hpp"
#include "validator/views/delay_budget.hpp"
#include "validator/views/drive.hpp"
#include "validator/views/filter_view.hpp"

#include <algorithm>
#include <cmath>
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
constexpr Sentence early{
    "position {position}, velocity feedforward {velocity}: the velocity arrives {lead} before its position",
    "Position {position}, Geschwindigkeitsvorsteuerung {velocity}: Die Geschwindigkeit kommt {lead} früher "
    "an als ihre Position"};
constexpr Sentence late{
    "position {position}, velocity feedforward {velocity}: the velocity arrives {lead} after its position",
    "Position {position}, Geschwindigkeitsvorsteuerung {velocity}: Die Geschwindigkeit kommt {lead} später "
    "an als ihre Position"};
constexpr Sentence together{
    "position {position}, velocity feedforward {velocity}: both arrive together",
    "Position {position}, Geschwindigkeitsvorsteuerung {velocity}: Beide kommen gleichzeitig an"};
constexpr Sentence of_it_lag{"of the position {lag} are the lag, which arises in the controller",
                             "von der Position sind {lag} Nachlauf, der erst im Regler entsteht"};
constexpr Sentence sum_alone{"position {position}; the velocity is not fed forward",
                             "Position {position}; die Geschwindigkeit wird nicht vorgesteuert"};
constexpr Sentence ahead{"accelerating at the limit, the axis is {deviation} ahead",
                         "beim Beschleunigen an der Grenze eilt die Achse {deviation} voraus"};
constexpr Sentence behind{"accelerating at the limit, the axis is {deviation} behind",
                          "beim Beschleunigen an der Grenze eilt die Achse {deviation} nach"};
constexpr Sentence no_gain{
    "no list gives Kv (P-AXIS-00099): the lag of a position controller in the NC is not in these sums",
    "keine Liste gibt Kv (P-AXIS-00099) an: der Nachlauf eines Lagereglers in der NC ist nicht enthalten"};
constexpr Sentence channel_unknown{"{channel}: unknown, because the delay of {axis} is",
                                   "{channel}: unbekannt, weil es die Verzögerung von {axis} ist"};
constexpr Sentence apart_alone{"{channel}: {slow} and {fast} are {time} apart",
                               "{channel}: {slow} und {fast} liegen {time} auseinander"};
constexpr Sentence in_step{"{channel}: the axes are in step", "{channel}: die Achsen laufen gleich"};
constexpr Sentence apart{
    "{channel}: {slow} and {fast} are {time} apart, at {feed} up to {deviation} on a line at 45° or a circle",
    "{channel}: {slow} und {fast} liegen {time} auseinander, bei {feed} bis zu {deviation} auf einer Geraden "
    "unter 45° oder einem Kreis"};
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

constexpr double rounding = 1e-9;  ///< cycles: sums of the same delays in another order

Quantity cycles(double value) {
  return rounded(value, Unit::cycle, 4);
}

class BudgetBlocks {
 public:
  BudgetBlocks(validator::LoadedMachine const& machine, design::CycleTime cycle_time,
               SourceSet const& sources, std::optional<double> feed)
      : machine_(machine), sources_(sources), feed_(feed), cycle_time_(cycle_time) {}

  Section section() {
    Section result{.key = "delay_budget", .title = {}, .blocks = {}};
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
    if (budget.feeds_velocity) {
      sums.push_back(data("velocity_cycles", cycles(budget.velocity)));
      sums.push_back(data("lead_cycles", cycles(budget.lead())));
      sums.push_back(data("lead_ms", time(budget.lead())));
      deviation = validator::deviation_of_lead(axis, budget.lead(), cycle_time_);
      if (deviation) sums.push_back(data("lead_deviation_um", rounded(*deviation, Unit::micrometre, 4)));
    }
    section.blocks.emplace_back(Facts{std::move(sums)});
    if (!budget.items.empty()) section.blocks.emplace_back(Paragraph{sums_of(budget)});
    if (budget.lag != 0 && budget.feeds_velocity) {
      section.blocks.emplace_back(Paragraph{Words(says::of_it_lag, {{"lag", time(budget.lag)}})});
    }
    if (deviation && std::abs(budget.lead()) > rounding) {
      section.blocks.emplace_back(
          Paragraph{Words(*deviation > 0 ? says::ahead : says::behind,
                          {{"deviation", rounded(std::abs(*deviation), Unit::micrometre, 4)}})});
    }
    bool const may_lag = validator::position_controller(axis) != machine::PositionController::drive;
    if (may_lag && !axis.merged.values.at("getriebe[].kv").set())
      section.blocks.emplace_back(Paragraph{says::no_gain});
    axes.items.push_back(std::move(section));
  }

  [[nodiscard]] Words sums_of(DelayBudget const& budget) const {
    if (!budget.feeds_velocity) return {says::sum_alone, {{"position", time(budget.position)}}};
    bool const is_together = std::abs(budget.lead()) <= rounding;
    SentenceRef const ahead_or_behind = budget.lead() > 0 ? says::early : says::late;
    SentenceRef const text = is_together ? SentenceRef(says::together) : ahead_or_behind;
    std::vector<NamedValue> values{{"position", time(budget.position)}, {"velocity", time(budget.velocity)}};
    if (!is_together) values.push_back({"lead", time(std::abs(budget.lead()))});
    return {text, std::move(values)};
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
    if (group.axes.size() < 2) return;
    Section section{.key = {}, .title = {}, .blocks = {}, .identity = {data("channel", group.name)}};
    Words const channel(labels::one_channel, {{"name", group.name}});
    struct Delayed {
      std::string name;
      double cycles = 0;
    };
    std::vector<Delayed> delayed;
    for (auto const index : group.axes) {
      auto const& axis = machine_.axes[index];
      auto const budget = validator::delay_budget(axis, cycle_time_);
      if (!budget) {
        section.blocks.emplace_back(
            Paragraph{Words(says::channel_unknown, {{"channel", channel}, {"axis", axis.name}})});
        channels.items.push_back(std::move(section));
        return;
      }
      delayed.push_back({axis.name, budget->position});
    }
    auto const less = [](Delayed const& left, Delayed const& right) { return left.cycles < right.cycles; };
    auto const [fast, slow] = std::minmax_element(delayed.begin(), delayed.end(), less);
    double const mismatch = slow->cycles - fast->cycles;
    auto const limit = validator::lowest_velocity_limit(machine_, group);
    double const feed = feed_.value_or(limit.value_or(0) * design::mm_per_min_of_um_per_s);
    std::vector<Field> facts{data("mismatch_cycles", cycles(mismatch)), data("mismatch_ms", time(mismatch))};
    if (mismatch <= rounding) {
      section.blocks.emplace_back(Paragraph{Words(says::in_step, {{"channel", channel}})});
    } else if (feed <= 0) {
      section.blocks.emplace_back(Paragraph{Words(
          says::apart_alone,
          {{"channel", channel}, {"slow", slow->name}, {"fast", fast->name}, {"time", time(mismatch)}})});
    } else {
      auto const deviation = rounded(
          validator::deviation_of_mismatch(feed / design::mm_per_min_of_um_per_s, mismatch, cycle_time_),
          Unit::micrometre, 4);
      facts.push_back(data("feed_mm_per_min", exact(feed)));
      facts.push_back(data("deviation_um", deviation));
      section.blocks.emplace_back(
          Paragraph{Words(says::apart, {{"channel", channel},
                                        {"slow", slow->name},
                                        {"fast", fast->name},
                                        {"time", time(mismatch)},
                                        {"feed", rounded(feed, Unit::millimetre_per_minute, 6)},
                                        {"deviation", deviation}})});
    }
    section.blocks.emplace_back(Facts{std::move(facts)});
    channels.items.push_back(std::move(section));
  }

  validator::LoadedMachine const& machine_;
  SourceSet const& sources_;
  std::optional<double> feed_;
  design::CycleTime cycle_time_;
};

}  // namespace

std::optional<Document> delay_budget_answer(Workspace& workspace, DelayBudgetQuestion const& question,
                                            ErrorSink const& errors) {
  auto const path = machine_of_input(workspace, question.machine).machine;
  SourceSet sources;
  std::optional<validator::LoadedMachine> loaded;
  auto const checked = check_machine(workspace, path, errors, sources, loaded);
  if (!checked) return std::nullopt;
  require_cycle_time(path, *checked);
  auto const cycle_time = *loaded->cycle_time;
  Document document{.version = 2, .title = says::budget, .blocks = {}, .csv_table = "items"};
  document.blocks.emplace_back(Facts{{data("cycle_time_us", exact(cycle_time.microseconds()))}});
  document.blocks.emplace_back(BudgetBlocks(*loaded, cycle_time, sources, question.feed).section());
  return document;
}

}  // namespace axisc
