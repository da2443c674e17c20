#include "analysis/motion/point.hpp"
#include "axisc/answers/suggestion/suggest_formats.hpp"
#include "axisc/answers/text_table.hpp"
#include "diagnostics/format_number.hpp"

#include <algorithm>
#include <array>
#include <functional>

#include <fmt/format.h>

namespace axisc::says {

constexpr Sentence heading{
    "Axis {axis}, resonance {resonances}, F{feed} mm/min, tolerance {tolerance} mm; {count} settings "
    "compared",
    "Achse {axis}, Resonanz {resonances}, F{feed} mm/min, Toleranz {tolerance} mm; {count} Einstellungen "
    "verglichen"};
constexpr Sentence peak{
    "measured: {frequency} ± {uncertainty} Hz, damping {damping} ± {damping_uncertainty}",
    "gemessen: {frequency} ± {uncertainty} Hz, Dämpfung {damping} ± {damping_uncertainty}"};
constexpr Sentence coherent_peak{
    "measured: {frequency} ± {uncertainty} Hz, damping {damping} ± {damping_uncertainty}, coherence "
    "{coherence}",
    "gemessen: {frequency} ± {uncertainty} Hz, Dämpfung {damping} ± {damping_uncertainty}, Kohärenz "
    "{coherence}"};
constexpr Sentence spectrum{
    "a spectrum does not show what made the peaks: a tooth or a spindle may have; two signals show it",
    "ein Spektrum zeigt nicht, woher die Spitzen kommen: auch ein Zahn oder eine Spindel kann es sein; zwei "
    "Signale "
    "zeigen es"};
constexpr Sentence present{"present", "jetzt"};
constexpr Sentence least_deviation{"least deviation", "geringste Abweichung"};
constexpr Sentence balanced{"balanced", "ausgewogen"};
constexpr Sentence least_vibration{"least vibration", "geringste Schwingung"};
constexpr Sentence vibration{"remaining vibration, worst case [%]",
                             "verbleibende Schwingung, ungünstigst [%]"};
constexpr Sentence amplitude{"after a ramp, at {frequency} Hz [µm]",
                             "nach einer Rampe, bei {frequency} Hz [µm]"};
constexpr Sentence delay{"delay [ms]", "Verzögerung [ms]"};
constexpr Sentence overshoot{"overshoot of a step [%]", "Überschwingen eines Sprungs [%]"};
constexpr Sentence corner{"corner, 90°: axis error [µm]", "Ecke, 90°: Achsfehler [µm]"};
constexpr Sentence corner_deviation{"corner, 90°: deviation [µm]", "Ecke, 90°: Abweichung [µm]"};
constexpr Sentence corner_feed{"corner: feed within tolerance [mm/min]",
                               "Ecke: Vorschub in der Toleranz [mm/min]"};
constexpr Sentence circle{"circle, r = {radius} mm: deviation [µm]",
                          "Kreis, r = {radius} mm: Abweichung [µm]"};
constexpr Sentence circle_feed{"circle: feed within tolerance [mm/min]",
                               "Kreis: Vorschub in der Toleranz [mm/min]"};
constexpr Sentence any{"any", "beliebig"};
constexpr Sentence recommended{"recommended", "empfohlen"};
constexpr Sentence command{"NC program: {command}", "NC-Programm: {command}"};
constexpr Sentence no_command{"NC program: nothing to write; the filters work from start-up",
                              "NC-Programm: nichts zu schreiben; die Filter wirken ab Hochlauf"};
constexpr Sentence findings{"lists with this setting have findings: {codes}",
                            "Listen mit dieser Einstellung haben Befunde: {codes}"};
constexpr Sentence overshoots{
    "not suggested: {chain} leaves {vibration} % at a delay of {delay} ms, but overshoots by {overshoot} %",
    "nicht vorgeschlagen: {chain} lässt {vibration} % bei einer Verzögerung von {delay} ms, schwingt aber um "
    "{overshoot} % über"};
constexpr Sentence other_family{
    "not suggested: {chain} leaves {vibration} % at a delay of {delay} ms, but this control has other "
    "linear-phase "
    "filters (AX4007)",
    "nicht vorgeschlagen: {chain} lässt {vibration} % bei einer Verzögerung von {delay} ms, aber diese "
    "Steuerung hat "
    "andere linearphasige Filter (AX4007)"};

}  // namespace axisc::says

namespace axisc {

namespace {

constexpr double percent = 100;

std::string say(Language language, SentenceRef text, std::vector<Argument> arguments = {}) {
  return render({.sentence = text, .arguments = std::move(arguments)}, language);
}

Wording micrometres(double units) {
  return format_fixed(units / motion::units_per_um, 2);
}

using Rows = std::vector<std::vector<std::string>>;

/// "2 balanced*, 3 least vibration": every sense that the alternative stands for, with its number.
std::string senses_text(Suggestion const& suggestion, std::size_t index, std::string const& mark,
                        Language language) {
  std::string text;
  for (auto const sense : suggestion.senses_of(index)) {
    text += fmt::format("{}{} {}{}", text.empty() ? "" : ", ", static_cast<std::size_t>(sense) + 1,
                        sense_name(sense, language), sense == suggestion.recommended ? mark : "");
  }
  return text;
}

class Table {
 public:
  Table(Suggestion const& suggestion, Language language) : suggestion_(suggestion), language_(language) {}

  std::string text() {
    std::vector<std::string> head{""};
    if (suggestion_.present) head.push_back(say(language_, says::present));
    for (std::size_t i = 0; i < tuning::senses; ++i) {
      auto name = senses_text(suggestion_, i, "*", language_);
      if (!name.empty()) head.push_back(std::move(name));
    }
    rows_.push_back(std::move(head));
    add_figures();
    return text_table(rows_, 2);
  }

 private:
  using Cell = std::function<Wording(Setting const&)>;

  void add(std::string name, Cell const& cell) {
    std::vector<std::string> row{std::move(name)};
    if (suggestion_.present) row.push_back(cell(*suggestion_.present).in(language_));
    for (std::size_t i = 0; i < tuning::senses; ++i) {
      if (suggestion_.proposed.at(i) == i) {
        row.push_back(cell(suggestion_.alternatives.at(i).setting).in(language_));
      }
    }
    rows_.push_back(std::move(row));
  }
  [[nodiscard]] Wording feed(std::optional<double> const& value) const {
    return value ? format_fixed(*value, 0) : say(language_, says::any);
  }

  void add_figures() {
    add(say(language_, says::vibration),
        [](Setting const& setting) { return format_fixed(setting.figures.vibration * percent, 1); });
    for (std::size_t i = 0; i < suggestion_.task.resonances.size(); ++i) {
      auto const frequency = format_rounded(suggestion_.task.resonances[i].frequency, 4);
      add(say(language_, says::amplitude, {{"frequency", frequency}}),
          [i](Setting const& setting) { return micrometres(setting.figures.resonances[i].amplitude); });
    }
    double const milli = suggestion_.cycle_time.seconds() * 1e3;
    add(say(language_, says::delay),
        [milli](Setting const& setting) { return format_fixed(setting.figures.delay * milli, 1); });
    add(say(language_, says::overshoot),
        [](Setting const& setting) { return format_fixed(setting.figures.overshoot * percent, 1); });
    add(say(language_, says::corner),
        [](Setting const& setting) { return micrometres(setting.corner.largest_axis_error()); });
    add(say(language_, says::corner_deviation),
        [](Setting const& setting) { return micrometres(setting.corner.deviation); });
    add(say(language_, says::corner_feed),
        [this](Setting const& setting) { return feed(setting.corner_feed); });
    add(say(language_, says::circle, {{"radius", format_rounded(suggestion_.radius_mm, 6)}}),
        [](Setting const& setting) { return micrometres(setting.circle.deviation); });
    add(say(language_, says::circle_feed),
        [this](Setting const& setting) { return feed(setting.circle_feed); });
  }

  Suggestion const& suggestion_;
  Language language_;
  Rows rows_;
};

std::string command_text(Alternative const& alternative, Language language) {
  return "  " +
         (alternative.command ? say(language, says::command, {{"command", *alternative.command}})
                              : say(language, says::no_command)) +
         "\n";
}

std::string title_text(Suggestion const& suggestion, std::size_t index, Language language) {
  return senses_text(suggestion, index, " (" + say(language, says::recommended) + ")", language) + ": " +
         tuning::short_name(suggestion.alternatives.at(index).setting.chain, language) + "\n";
}

/// Empty where another alternative does the same.
std::string alternative_text(Suggestion const& suggestion, std::size_t index, Language language) {
  if (suggestion.proposed.at(index) != index) return "";
  auto const& alternative = suggestion.alternatives.at(index);
  std::string text = "\n" + title_text(suggestion, index, language);
  text += fragments_text(alternative.axes);
  text += command_text(alternative, language);
  if (!alternative.findings.empty()) {
    std::string codes;
    for (auto const& code : alternative.findings) codes += (codes.empty() ? "" : ", ") + code;
    text += "  " + say(language, says::findings, {{"codes", codes}}) + "\n";
  }
  return text;
}

}  // namespace

Wording resonances_text(tuning::Task const& task) {
  Wording text;
  for (auto const& resonance : task.resonances) {
    text += (text.empty() ? "" : ", ") + format_rounded(resonance.frequency, 4) + " Hz";
  }
  return text;
}

std::string fragments_text(std::vector<AxisLines> const& axes) {
  std::string text;
  std::vector<bool> told(axes.size());
  for (std::size_t i = 0; i < axes.size(); ++i) {
    if (told[i]) continue;
    std::string names;
    for (std::size_t k = i; k < axes.size(); ++k) {
      if (axes[k].lines != axes[i].lines) continue;
      told[k] = true;
      names += (names.empty() ? "" : ", ") + axes[k].axis + " (" + axes[k].list + ")";
    }
    text += "  " + names + ":\n";
    std::size_t width = 0;
    for (auto const& line : axes[i].lines) width = std::max(width, line.name.size());
    for (auto const& line : axes[i].lines) text += "    " + padded(line.name, width + 4) + line.value + "\n";
  }
  return text;
}

std::string chosen_text(Suggestion const& suggestion, std::size_t index, Language language) {
  return title_text(suggestion, index, language) + command_text(suggestion.alternatives.at(index), language);
}

std::string sense_name(tuning::Sense sense, Language language) {
  switch (sense) {
    case tuning::Sense::least_deviation:
      return say(language, says::least_deviation);
    case tuning::Sense::balanced:
      return say(language, says::balanced);
    case tuning::Sense::least_vibration:
      break;
  }
  return say(language, says::least_vibration);
}

namespace {

std::string measured_text(MeasuredResonances const& measured, Language language) {
  std::string text;
  for (auto const& peak : measured.peaks) {
    text += say(language, peak.coherence ? SentenceRef(says::coherent_peak) : SentenceRef(says::peak),
                {{"frequency", format_fixed(peak.frequency, 2)},
                 {"uncertainty", format_fixed(peak.frequency_uncertainty, 2)},
                 {"damping", format_fixed(peak.damping, 3)},
                 {"damping_uncertainty", format_fixed(peak.damping_uncertainty, 3)},
                 {"coherence", format_fixed(peak.coherence.value_or(0), 2)}}) +
            "\n";
  }
  if (measured.kind == tuning::MeasurementKind::spectrum) text += say(language, says::spectrum) + "\n";
  return text;
}

}  // namespace

std::string suggest_text(Suggestion const& suggestion, Language language) {
  std::string text = suggestion.measured ? measured_text(*suggestion.measured, language) : "";
  text += say(language, says::heading,
              {{"axis", suggestion.axis},
               {"resonances", resonances_text(suggestion.task)},
               {"feed", format_rounded(suggestion.feed, 6)},
               {"tolerance", format_rounded(suggestion.tolerance_mm, 6)},
               {"count", std::to_string(suggestion.looked_at)}}) +
          "\n";
  text += Table(suggestion, language).text();
  for (std::size_t i = 0; i < tuning::senses; ++i) text += alternative_text(suggestion, i, language);
  if (suggestion.not_clean) {
    auto const& chain = suggestion.not_clean->chain;
    auto const& figures = suggestion.not_clean->figures;
    text += "\n" +
            say(language,
                figures.overshoot > tuning::largest_overshoot ? SentenceRef(says::overshoots)
                                                              : SentenceRef(says::other_family),
                {{"chain", tuning::short_name(chain, language)},
                 {"vibration", format_fixed(figures.vibration * percent, 1)},
                 {"delay", format_fixed(figures.delay * suggestion.cycle_time.seconds() * 1e3, 1)},
                 {"overshoot", format_fixed(figures.overshoot * percent, 1)}}) +
            "\n";
  }
  return text;
}

}  // namespace axisc
