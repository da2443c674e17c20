#include "analysis/motion/point.hpp"
#include "analysis/tuning/position_control/control_lines.hpp"
#include "axisc/answers/suggestion/damping_formats.hpp"
#include "axisc/answers/suggestion/suggest_formats.hpp"
#include "axisc/answers/text_table.hpp"
#include "diagnostics/format_number.hpp"

#include <fmt/format.h>

namespace axisc::says {

constexpr Sentence heading{
    "Improved Position Control of axis {axis}, simulated with {plant}, Kv {kv} 1/s; {count} settings "
    "compared",
    "Optimierte Lageregelung der Achse {axis}, simuliert mit {plant}, Kv {kv} 1/s; {count} Einstellungen "
    "verglichen"};
constexpr Sentence without{"without", "ohne"};
constexpr Sentence with{"{number} with", "{number} mit"};
constexpr Sentence vibration{"load, at {frequency} Hz [m/s²]", "Last, bei {frequency} Hz [m/s²]"};
constexpr Sentence worst{"the same, worst case [m/s²]", "dasselbe, ungünstigst [m/s²]"};
constexpr Sentence circle{"circle, r = {radius} mm: shift of the load [µm]",
                          "Kreis, r = {radius} mm: Verschiebung der Last [µm]"};
constexpr Sentence shift{"while accelerating: shift of the load [µm]",
                         "beim Beschleunigen: Verschiebung der Last [µm]"};
constexpr Sentence distance{"largest distance of the load from the setpoint [µm]",
                            "größter Abstand der Last vom Sollwert [µm]"};
constexpr Sentence additive{"largest additive velocity [mm/min]", "größte additive Geschwindigkeit [mm/min]"};
constexpr Sentence other_axes{"{axes}: nothing to write; their setpoints and lists stay as they are",
                              "{axes}: nichts zu schreiben; ihre Sollwerte und Listen bleiben, wie sie sind"};
constexpr Sentence findings{"lists with this setting have findings: {codes}",
                            "Listen mit dieser Einstellung haben Befunde: {codes}"};
constexpr Sentence not_in_plant{"no stage for {frequency} Hz: the plant does not resonate there",
                                "keine Stufe für {frequency} Hz: die Strecke hat dort keine Resonanz"};
constexpr Sentence no_stage{
    "no stage for {frequency} Hz takes away a quarter of the vibration and leaves the loop its margin",
    "keine Stufe für {frequency} Hz nimmt ein Viertel der Schwingung weg und lässt dem Regelkreis seine "
    "Reserve"};
constexpr Sentence nowhere{
    "Improved Position Control: the plant of axis {axis} in {plant} does not resonate at {resonances}",
    "Optimierte Lageregelung: die Strecke der Achse {axis} in {plant} hat keine Resonanz bei {resonances}"};
constexpr Sentence still{
    "Improved Position Control: in this move the load of axis {axis} swings by less than {noticeable} m/s² "
    "at "
    "{resonances}; name the --feed at which it swings",
    "Optimierte Lageregelung: bei dieser Bewegung schwingt die Last der Achse {axis} bei {resonances} um "
    "weniger als {noticeable} m/s²; mit --feed den Vorschub angeben, bei dem sie schwingt"};
constexpr Sentence still_stage{
    "no stage for {frequency} Hz: the load swings there by less than {noticeable} m/s²",
    "keine Stufe für {frequency} Hz: die Last schwingt dort um weniger als "
    "{noticeable} m/s²"};
constexpr Sentence diverges{
    "Improved Position Control: the loop of axis {axis} with {plant} oscillates even without it; a lower "
    "kv_per_s comes first",
    "Optimierte Lageregelung: der Regelkreis der Achse {axis} mit {plant} schwingt schon ohne sie auf; "
    "zuerst "
    "ein kleineres kv_per_s wählen"};
constexpr Sentence not_enough{
    "Improved Position Control: none of {count} settings takes away a quarter of the vibration of axis "
    "{axis}, "
    "keeps the tolerance on the circle and leaves the loop its margin",
    "Optimierte Lageregelung: keine von {count} Einstellungen nimmt ein Viertel der Schwingung der Achse "
    "{axis} weg, hält auf dem Kreis die Toleranz ein und lässt dem Regelkreis seine Reserve"};
constexpr Sentence gantry{
    "Improved Position Control: axis {axis} belongs to a gantry, and {plant} does not say how its axes are "
    "coupled; none is suggested",
    "Optimierte Lageregelung: Achse {axis} gehört zu einem Gantry, und {plant} sagt nicht, wie dessen Achsen "
    "gekoppelt sind; keine wird vorgeschlagen"};

}  // namespace axisc::says

namespace axisc {

namespace {

std::string say(Language language, SentenceRef text, std::vector<Argument> arguments = {}) {
  return render({.sentence = text, .arguments = std::move(arguments)}, language);
}

SentenceRef reason_sentence(tuning::NoDamping reason) {
  switch (reason) {
    case tuning::NoDamping::no_resonance:
      return says::nowhere;
    case tuning::NoDamping::still:
      return says::still;
    case tuning::NoDamping::diverges:
      return says::diverges;
    case tuning::NoDamping::not_enough:
      break;
  }
  return says::not_enough;
}

std::string refusal_text(DampingAnswer const& answer, std::string const& axis, tuning::Task const& task,
                         Language language) {
  auto const* const none = std::get_if<tuning::NoDampingFound>(&answer.found);
  std::vector<Argument> arguments{{"axis", axis}};
  if (none == nullptr) {
    arguments.push_back({"plant", answer.plant_path});
    return say(language, says::gantry, std::move(arguments));
  }
  switch (none->reason) {
    case tuning::NoDamping::no_resonance:
      arguments.push_back({"plant", answer.plant_path});
      arguments.push_back({"resonances", resonances_text(task)});
      break;
    case tuning::NoDamping::still:
      arguments.push_back({"noticeable", exact_number(tuning::noticeable_swing)});
      arguments.push_back({"resonances", resonances_text(task)});
      break;
    case tuning::NoDamping::diverges:
      arguments.push_back({"plant", answer.plant_path});
      break;
    case tuning::NoDamping::not_enough:
      arguments.push_back({"count", std::to_string(none->looked_at)});
      break;
  }
  return say(language, reason_sentence(none->reason), std::move(arguments));
}

std::string figures_text(tuning::Damping const& damping, tuning::Task const& task, Language language) {
  std::vector<std::vector<std::string>> rows{
      {"", say(language, says::without),
       say(language, says::with, {{"number", std::to_string(damping_number)}})}};
  auto const add = [&](std::string name, Wording const& without, Wording const& with) {
    rows.push_back({std::move(name), without.in(language), with.in(language)});
  };
  auto const acceleration = [](double value) { return format_fixed(value, 3); };
  auto const um = [](double units) { return format_fixed(units / motion::units_per_um, 2); };
  for (std::size_t i = 0; i < damping.resonances.size(); ++i) {
    auto const& resonance = damping.resonances[i];
    add(say(language, says::vibration, {{"frequency", format_rounded(task.resonances[i].frequency, 4)}}),
        acceleration(resonance.without), acceleration(resonance.with));
    add("  " + say(language, says::worst), acceleration(resonance.worst_without),
        acceleration(resonance.worst));
  }
  add(say(language, says::circle, {{"radius", format_rounded(task.radius / motion::units_per_mm, 6)}}), "",
      um(damping.circle));
  add(say(language, says::shift), "", um(damping.shift));
  add(say(language, says::distance), um(damping.error_without), um(damping.error_with));
  constexpr double mm_per_min_of_um_per_s = 0.06;
  add(say(language, says::additive), "", format_fixed(damping.additive_velocity * mm_per_min_of_um_per_s, 1));
  return text_table(rows, 2);
}

/// Empty where there is a stage.
std::string without_stage_text(tuning::DampedResonance const& resonance, double frequency,
                               Language language) {
  if (resonance.stage) return "";
  std::vector<Argument> arguments{{"frequency", format_rounded(frequency, 4)}};
  SentenceRef sentence = says::no_stage;
  if (!resonance.is_in_plant) {
    sentence = says::not_in_plant;
  } else if (!resonance.is_noticeable) {
    sentence = says::still_stage;
    arguments.push_back({"noticeable", exact_number(tuning::noticeable_swing)});
  }
  return "  " + say(language, sentence, std::move(arguments)) + "\n";
}

}  // namespace

std::string chosen_text(DampingAnswer const& answer, Language language) {
  return fmt::format("{} {}\n", damping_number, tuning::short_name(answer.damping()->control, language));
}

std::string damping_text(DampingAnswer const& answer, SuggestionSubject const& subject,
                         tuning::Task const& task, Language language) {
  auto const& axis = subject.machine.axes[subject.axis].name;
  auto const* const damping = answer.damping();
  if (damping == nullptr) return refusal_text(answer, axis, task, language) + "\n";
  std::string text = say(language, says::heading,
                         {{"axis", axis},
                          {"plant", answer.plant_path},
                          {"kv", format_rounded(answer.kv, 6)},
                          {"count", std::to_string(damping->looked_at)}}) +
                     "\n" + figures_text(*damping, task, language);
  text += "\n" + chosen_text(answer, language);
  std::vector<AxisLines> changed;
  std::string others;
  for (auto const& lines : answer.axes) {
    if (!lines.lines.empty()) changed.push_back(lines);
    if (lines.lines.empty()) others += (others.empty() ? "" : ", ") + lines.axis + " (" + lines.list + ")";
  }
  text += fragments_text(changed);
  if (!others.empty()) text += "  " + say(language, says::other_axes, {{"axes", others}}) + "\n";
  for (std::size_t i = 0; i < damping->resonances.size(); ++i) {
    text += without_stage_text(damping->resonances[i], task.resonances[i].frequency, language);
  }
  if (!answer.findings.empty()) {
    std::string codes;
    for (auto const& code : answer.findings) codes += (codes.empty() ? "" : ", ") + code;
    text += "  " + say(language, says::findings, {{"codes", codes}}) + "\n";
  }
  return text;
}

}  // namespace axisc
