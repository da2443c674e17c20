#include "analysis/motion/point.hpp"
#include "axisc/answers/labels.hpp"
#include "axisc/answers/suggestion/suggest_answer.hpp"

namespace axisc::says {

constexpr Sentence setting{"setting", "Einstellung"};
constexpr Sentence worst_vibration{"remaining vibration, worst case", "verbleibende Schwingung, ungünstigst"};
constexpr Sentence amplitude{"after a ramp, at {frequency}", "nach einer Rampe, bei {frequency}"};
constexpr Sentence corner{"corner, 90°: axis error", "Ecke, 90°: Achsfehler"};
constexpr Sentence corner_deviation{"corner, 90°: deviation", "Ecke, 90°: Abweichung"};
constexpr Sentence corner_feed{"corner: feed within tolerance", "Ecke: Vorschub in der Toleranz"};
constexpr Sentence circle_deviation{"circle, r {radius}: deviation", "Kreis, r {radius}: Abweichung"};
constexpr Sentence circle_feed{"circle: feed within tolerance", "Kreis: Vorschub in der Toleranz"};
constexpr Sentence any{"any", "beliebig"};

}  // namespace axisc::says

namespace axisc {

using namespace presentation;

namespace {

Quantity share(double value) {
  return fixed(value, Unit::share, 1);
}

Value feed(std::optional<double> const& value) {
  return quantity_or(Nothing{Words(says::any)}, value, Unit::millimetre_per_minute, Digits::decimals(0));
}

/// The figures of a setting; people compare those that have a label.
std::vector<Field> figures_of(Suggestion const& suggestion, Setting const& setting) {
  auto const& [chain, figures, corner, circle, corner_feed, circle_feed, guard] = setting;
  std::vector<Field> fields{data("chain", name_of(chain).in(Language::english)),
                            {"remaining_vibration", says::worst_vibration, share(figures.vibration)}};
  for (std::size_t i = 0; i < suggestion.task.resonances.size(); ++i) {
    auto const frequency = rounded(suggestion.task.resonances[i].frequency, Unit::hertz, 4);
    fields.push_back({.key = {},
                      .label = Words(says::amplitude, {{"frequency", frequency}}),
                      .value = length_of(figures.resonances[i].amplitude),
                      .audience = Audience::people});
  }
  Words const on_circle(says::circle_deviation,
                        {{"radius", rounded(suggestion.radius_mm, Unit::millimetre, 6)}});
  for (Field& field : std::vector<Field>{
           data("delay_cycles", figures.delay),
           {"delay_ms", labels::delay, delay_of(suggestion, figures)},
           {"overshoot", labels::step_overshoot, share(figures.overshoot)},
           {"corner", says::corner, length_of(corner.largest_axis_error()), {}, "max_axis_error_um"},
           {"corner", says::corner_deviation, length_of(corner.deviation), {}, "contour_deviation_um"},
           {"corner", says::corner_feed, feed(corner_feed), {}, "allowed_feed_mm_per_min"},
           data("circle", length_of(circle.largest_axis_error()), "max_axis_error_um"),
           {"circle", on_circle, length_of(circle.deviation), {}, "contour_deviation_um"},
           {"circle", says::circle_feed, feed(circle_feed), {}, "allowed_feed_mm_per_min"}}) {
    fields.push_back(std::move(field));
  }
  return fields;
}

}  // namespace

Section setting_section(std::string key, Suggestion const& suggestion, Setting const& setting) {
  Table resonances{
      .key = "resonances",
      .columns = data_columns({"frequency_hz", "remaining_vibration", "amplitude_um", "unfiltered_um"}),
      .rows = {}};
  for (std::size_t i = 0; i < setting.figures.resonances.size(); ++i) {
    auto const& [worst, amplitude, unfiltered] = setting.figures.resonances[i];
    resonances.rows.push_back({suggestion.task.resonances[i].frequency, worst,
                               amplitude / motion::units_per_um, unfiltered / motion::units_per_um});
  }
  auto section = data_section(std::move(key), figures_of(suggestion, setting));
  section.blocks.emplace_back(std::move(resonances));
  if (setting.guard) section.blocks.emplace_back(coverage_section(*setting.guard));
  return section;
}

Table settings_table(Suggestion const& suggestion) {
  Table table{
      .key = {}, .columns = {head_column({}, says::setting)}, .rows = {}, .audience = Audience::people};
  std::vector<std::vector<Field>> settings;
  if (suggestion.present) {
    table.columns.push_back(column({}, labels::present));
    settings.push_back(figures_of(suggestion, *suggestion.present));
  }
  for (std::size_t i = 0; i < tuning::senses; ++i) {
    std::string numbers;
    for (auto const sense : suggestion.senses_of(i)) {
      numbers += (numbers.empty() ? "" : ", ") + std::to_string(static_cast<std::size_t>(sense) + 1) +
                 (sense == suggestion.recommended ? "*" : "");
    }
    if (numbers.empty()) continue;
    table.columns.push_back(column({}, Words(says::as_given, {{"text", numbers}})));
    settings.push_back(figures_of(suggestion, suggestion.alternatives.at(i).setting));
  }
  for (std::size_t k = 0; k < settings.front().size(); ++k) {
    auto const& first = settings.front()[k];
    if (first.audience == Audience::programs) continue;
    auto& row = table.rows.emplace_back(std::vector<Value>{first.label});
    for (auto& figures : settings) row.push_back(std::move(figures[k].value));
  }
  return table;
}

Wording name_of(tuning::Chain const& chain) {
  return {tuning::short_name(chain, Language::english), tuning::short_name(chain, Language::german)};
}

Quantity delay_of(Suggestion const& suggestion, tuning::Figures const& figures) {
  return fixed(figures.delay * suggestion.cycle_time.seconds() * 1e3, Unit::millisecond, 1);
}

}  // namespace axisc
