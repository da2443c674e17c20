#include "axisc/answers/contour/delay_budget_answer.hpp"

#include "axisc/answers/contour/delay_words.hpp"
#include "axisc/answers/labels.hpp"
#include "design/units.hpp"
#include "validator/views/delay_budget.hpp"
#include "validator/views/drive.hpp"
#include "validator/views/filter_view.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <vector>

namespace axisc::says {

constexpr Sentence budget{"delay budget", "Verzögerungsbilanz"};
constexpr Sentence at_start{"{axis}, at the start of programs", "{axis}, am Programmanfang"};
constexpr Sentence after_g135{"{axis}, after G135", "{axis}, nach G135"};
constexpr Sentence start_word{"at the start", "am Anfang"};
constexpr Sentence g135_word{"after G135", "nach G135"};
constexpr Sentence filters_on{"{axis}, after #FILTER ON or #VIB GUARD ON",
                              "{axis}, nach #FILTER ON oder #VIB GUARD ON"};
constexpr Sentence filters_word{"with all filters", "mit allen Filtern"};
constexpr Sentence in_drive{"in the drive", "im Antrieb"};
constexpr Sentence machine_file{"machine file", "Maschinendatei"};
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
constexpr Sentence no_gain{
    "no list gives Kv (P-AXIS-00099): the lag of a position controller in the NC is not in these sums",
    "keine Liste gibt Kv (P-AXIS-00099) an: der Nachlauf eines Lagereglers in der NC ist nicht enthalten"};
constexpr Sentence channel_unknown{"{channel}: unknown, because the delay of {axis} is",
                                   "{channel}: unbekannt, weil es die Verzögerung von {axis} ist"};
constexpr Sentence all_axes{"all axes", "alle Achsen"};
constexpr Sentence apart_alone{"{channel}: {slow} and {fast} are {time} apart",
                               "{channel}: {slow} und {fast} liegen {time} auseinander"};
constexpr Sentence in_step{"{channel}: the axes are in step", "{channel}: die Achsen laufen gleich"};
constexpr Sentence apart{
    "{channel}: {slow} and {fast} are {time} apart, at {feed} up to {deviation} on a line at 45° or a circle",
    "{channel}: {slow} und {fast} liegen {time} auseinander, bei {feed} bis zu {deviation} auf einer Geraden "
    "unter 45° oder einem Kreis"};
constexpr Sentence of_drive{
    "The drives' own delays are in no list; where the machine file does not give them (`drive_delay_us`), "
    "they are not in these sums.",
    "Die eigenen Verzögerungen der Antriebe stehen in keiner Liste; wo die Maschinendatei sie nicht angibt "
    "(`drive_delay_us`), sind sie nicht enthalten."};

}  // namespace axisc::says

namespace axisc {

using namespace presentation;
using validator::DelayBudget;
using validator::DelayItem;
using validator::DelayKind;
using validator::DelayState;

namespace {

Quantity cycles(double value) {
  return rounded(value, Unit::cycle, 4);
}

struct StateWords {
  DelayState state;
  std::string_view key;
  SentenceRef title, word;
};

StateWords const& words_of(DelayState state) {
  static constexpr std::array table{
      StateWords{DelayState::at_start, "start", says::at_start, says::start_word},
      StateWords{DelayState::fed_forward, "G135", says::after_g135, says::g135_word},
      StateWords{DelayState::filters_on, "filters_on", says::filters_on, says::filters_word}};
  return *std::find_if(table.begin(), table.end(),
                       [&](StateWords const& words) { return words.state == state; });
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
    bool const is_stated = std::all_of(machine_.axes.begin(), machine_.axes.end(),
                                       [](auto const& axis) { return axis.drive_delay_us > 0; });
    if (!is_stated) result.blocks.emplace_back(Paragraph{says::of_drive});
    return result;
  }

 private:
  [[nodiscard]] Quantity time(double in_cycles) const { return delay_time(in_cycles, cycle_time_); }

  void add_axis(validator::LoadedAxis const& axis, Sections& axes) {
    auto const start = validator::delay_budget(axis, cycle_time_);
    if (!start) {
      axes.items.push_back({.key = {},
                            .title = {},
                            .blocks = {Paragraph{Words(says::unknown, {{"axis", axis.name}})}},
                            .identity = {data("axis", axis.name)}});
      return;
    }
    add_state(axis, *start, DelayState::at_start, axes);
    auto const forward = validator::delay_budget(axis, cycle_time_, DelayState::fed_forward);
    if (forward->feeds_forward && !start->feeds_forward) {
      add_state(axis, *forward, DelayState::fed_forward, axes);
    }
    if (!start->has_filter_off) return;
    add_state(axis, *validator::delay_budget(axis, cycle_time_, DelayState::filters_on),
              DelayState::filters_on, axes);
  }

  void add_state(validator::LoadedAxis const& axis, DelayBudget const& budget, DelayState state,
                 Sections& axes) const {
    auto const& words = words_of(state);
    Section section{.key = {},
                    .title = Words(words.title, {{"axis", axis.name}}),
                    .blocks = {},
                    .identity = {data("axis", axis.name), data("state", Symbol{words.key, words.word})}};
    if (budget.items.empty()) {
      section.blocks.emplace_back(Paragraph{Words(says::nothing, {{"axis", axis.name}})});
    } else {
      Table items{.key = "items"};
      for (auto const& item : budget.items) add_row(items, row_of(item, budget.feeds_forward));
      section.blocks.emplace_back(std::move(items));
    }
    std::vector<Field> sums{data("position_cycles", cycles(budget.position)),
                            data("position_ms", time(budget.position))};
    if (budget.feeds_velocity) {
      sums.push_back(data("velocity_cycles", cycles(budget.velocity)));
      sums.push_back(data("lead_cycles", cycles(budget.lead())));
      sums.push_back(data("lead_ms", time(budget.lead())));
      auto const deviation = validator::deviation_of_lead(axis, budget.lead(), cycle_time_);
      if (deviation) sums.push_back(data("lead_deviation_um", rounded(*deviation, Unit::micrometre, 4)));
    }
    section.blocks.emplace_back(Facts{std::move(sums)});
    for (auto& sentence : delay_words(axis, budget, cycle_time_)) {
      section.blocks.emplace_back(Paragraph{std::move(sentence)});
    }
    bool const may_lag = validator::position_controller(axis) != machine::PositionController::drive;
    if (may_lag && !axis.merged.values.at("getriebe[].kv").set()) {
      section.blocks.emplace_back(Paragraph{says::no_gain});
    }
    axes.items.push_back(std::move(section));
  }

  [[nodiscard]] static Value name_of(DelayItem const& item) {
    switch (item.kind) {
      case DelayKind::filter: return item.filter;
      case DelayKind::interpolator: return Symbol{"interpolator", says::interpolator};
      case DelayKind::lag: return Symbol{"lag", says::lag};
      case DelayKind::drive: return Symbol{"drive", says::in_drive};
      case DelayKind::shift:
      case DelayKind::quantity:
      case DelayKind::balancing: break;
    }
    return validator::parameter_name(*item.cause);
  }

  [[nodiscard]] Value place_of(DelayItem const& item) const {
    if (item.kind == DelayKind::drive) return Symbol{"machine_file", says::machine_file};
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
    Words const channel =
        group.name.empty() ? Words(says::all_axes) : Words(labels::one_channel, {{"name", group.name}});
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
    if (mismatch <= delay_rounding) {
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

Section delay_budget_section(validator::LoadedMachine const& machine, SourceSet const& sources,
                             std::optional<double> feed) {
  return BudgetBlocks(machine, *machine.cycle_time, sources, feed).section();
}

std::optional<Document> delay_budget_answer(Workspace& workspace, DelayBudgetQuestion const& question,
                                            ErrorSink const& errors) {
  RequestedMachine const requested(workspace, question.machine, errors);
  if (!requested.checked) return std::nullopt;
  auto const& loaded = *requested.loaded;
  Document document{.version = 2, .title = says::budget, .blocks = {}, .csv_table = "items"};
  document.blocks.emplace_back(Facts{{data("cycle_time_us", exact(loaded.cycle_time->microseconds()))}});
  document.blocks.emplace_back(delay_budget_section(loaded, requested.sources, question.feed));
  return document;
}

}  // namespace axisc
