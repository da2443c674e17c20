#include "editor/meaning/delay_notes.hpp"

#include "axisc/answers/contour/delay_words.hpp"
#include "diagnostics/format_number.hpp"
#include "editor/reading/requests.hpp"
#include "schema/value.hpp"
#include "validator/views/delay_budget.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace axisc::editor::says {

constexpr Sentence share{"Its share: {paths}.", "Ihr Anteil: {paths}."};
constexpr Sentence of_position{"position {cycles} cycles ({time} ms)",
                               "Position {cycles} Zyklen ({time} ms)"};
constexpr Sentence of_velocity{"velocity feedforward {cycles} cycles ({time} ms)",
                               "Geschwindigkeitsvorsteuerung {cycles} Zyklen ({time} ms)"};
constexpr Sentence of_acceleration{"acceleration feedforward {cycles} cycles ({time} ms)",
                                   "Beschleunigungsvorsteuerung {cycles} Zyklen ({time} ms)"};
constexpr Sentence of_jerk{"jerk feedforward {cycles} cycles ({time} ms)",
                           "Ruckvorsteuerung {cycles} Zyklen ({time} ms)"};
constexpr Sentence at_start{"At the start of programs: {sums}.", "Am Programmanfang: {sums}."};
constexpr Sentence in_cycles{"{cycles} cycles", "{cycles} Zyklen"};
constexpr Sentence leads{"velocity feedforward leads by {cycles} cycles",
                         "die Geschwindigkeitsvorsteuerung eilt {cycles} Zyklen vor"};
constexpr Sentence lags{"velocity feedforward lags by {cycles} cycles",
                        "die Geschwindigkeitsvorsteuerung eilt {cycles} Zyklen nach"};
constexpr Sentence with_deviation{"{lead}: {deviation} µm at a_max", "{lead}: {deviation} µm bei a_max"};

}  // namespace axisc::editor::says

namespace axisc::editor {
namespace {

using validator::DelayBudget;
using validator::DelayItem;

constexpr int delay_digits = 4;

/// The parameters that make delays, or decide whether there are any.
bool makes_delays(std::string_view name) {
  constexpr std::array<std::string_view, 13> names{"vorsteuer.vorsteuerung",
                                                   "vorsteuer.default_active",
                                                   "vorsteuer.global_disable",
                                                   "vorsteuer.feedforward_without_delay",
                                                   "vorsteuer.shift_time",
                                                   "vorsteuer.velocity_delay_time",
                                                   "vorsteuer.acceleration_delay_time",
                                                   "vorsteuer.jerk_delay_time",
                                                   "vorsteuer.timeconst_sym_filter",
                                                   "vorsteuer.vs_v_faktor",
                                                   "vorsteuer.vs_v_nenner",
                                                   "kenngr.delay_filter_only_position",
                                                   "getriebe[].kv"};
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string short_number(double value, Language language) {
  return format_rounded(value, delay_digits).in(language);
}

std::string share_of(DelayItem const& item, design::CycleTime cycle_time, Language language) {
  struct Path {
    SentenceRef text;
    double cycles;
  };
  std::array const paths{Path{says::of_position, item.position}, Path{says::of_velocity, item.velocity},
                         Path{says::of_acceleration, item.acceleration}, Path{says::of_jerk, item.jerk}};
  std::string text;
  for (auto const& [sentence, cycles] : paths) {
    if (cycles == 0) continue;
    double const milliseconds = cycles * cycle_time.microseconds() / 1000;
    text += (text.empty() ? "" : ", ") + say(sentence, language,
                                             {{"cycles", format_rounded(cycles, delay_digits)},
                                              {"time", format_rounded(milliseconds, delay_digits)}});
  }
  return text;
}

std::optional<DelayBudget> budget_of(OpenList const& list) {
  if (list.axis() == nullptr) return std::nullopt;
  return validator::delay_budget(*list.axis(), list.cycle_time());
}

}  // namespace

std::string delay_sentences(OpenList const& list, schema::NameLookup const& found, Language language) {
  if (found.row == nullptr || !makes_delays(found.row->name)) return {};
  auto const budget = budget_of(list);
  if (!budget || budget->items.empty()) return {};
  auto const& value = list.axis()->merged.values[found.slot];
  std::string text;
  for (auto const& item : budget->items) {
    if (item.cause != &value) continue;
    text +=
        "\n" + say(says::share, language, {{"paths", share_of(item, list.cycle_time(), language)}}) + "\n";
  }
  std::string sums;
  for (auto const& words : delay_words(*list.axis(), *budget, list.cycle_time())) {
    sums += (sums.empty() ? "" : "; ") + presentation::text_of(words, language);
  }
  return text + "\n" + say(says::at_start, language, {{"sums", sums}}) + "\n";
}

std::string delay_in_cycles(OpenList const& list, schema::NameLookup const& found,
                            grammar::Assignment const& line, Language language) {
  bool const is_delay = found.row != nullptr && std::string_view(found.row->name).ends_with("_delay_time") &&
                        makes_delays(found.row->name);
  if (!is_delay) return {};
  auto const number = schema::read_real(list.slice(line.value));
  if (number.status != schema::NumberStatus::good) return {};
  double const cycles = list.cycle_time().cycles({number.number});
  return say(says::in_cycles, language, {{"cycles", format_rounded(cycles, delay_digits)}});
}

std::string lead_line(OpenList const& list, Language language) {
  auto const budget = budget_of(list);
  if (!budget || !budget->feeds_velocity || std::abs(budget->lead()) <= delay_rounding) return {};
  auto const lead = say(budget->lead() > 0 ? says::leads : says::lags, language,
                        {{"cycles", format_rounded(std::abs(budget->lead()), delay_digits)}});
  auto const deviation = validator::deviation_of_lead(*list.axis(), budget->lead(), list.cycle_time());
  if (!deviation) return lead;
  return say(says::with_deviation, language,
             {{"lead", lead}, {"deviation", short_number(std::abs(*deviation), language)}});
}

}  // namespace axisc::editor
