
#include "analysis/motion/point.hpp"
#include "analysis/tuning/position_control/control_lines.hpp"
#include "axisc/answers/suggestion/suggest_answer.hpp"

#include <array>

namespace axisc::says {

constexpr Sentence heading{
    "Improved Position Control of axis {axis}, simulated with {plant}, Kv {kv} 1/s; {count} settings "
    "compared",
    "Optimierte Lageregelung der Achse {axis}, simuliert mit {plant}, Kv {kv} 1/s; {count} Einstellungen "
    "verglichen"};
constexpr Sentence name{"{number} {stages}", "{number} {stages}"};
constexpr Sentence load{"at", "bei"};
constexpr Sentence without{"without", "ohne"};
constexpr Sentence with{"with", "mit"};
constexpr Sentence worst_without{"worst without", "höchste ohne"};
constexpr Sentence worst_with{"worst with", "höchste mit"};
constexpr Sentence circle{"shift of the load on a circle, r {radius}",
                          "Verschiebung der Last auf einem Kreis, r {radius}"};
constexpr Sentence shift{"shift of the load while accelerating", "Verschiebung der Last beim Beschleunigen"};
constexpr Sentence distance{"largest distance of the load from the setpoint, without",
                            "größter Abstand der Last vom Sollwert, ohne"};
constexpr Sentence distance_with{"the same, with", "dasselbe, mit"};
constexpr Sentence additive{"largest additive velocity", "größte additive Geschwindigkeit"};
constexpr Sentence not_in_plant{"no stage for {frequency}: the plant does not resonate there",
                                "keine Stufe für {frequency}: die Strecke hat dort keine Resonanz"};
constexpr Sentence no_stage{
    "no stage for {frequency} takes away a quarter of the vibration and leaves the loop its margin",
    "keine Stufe für {frequency} nimmt ein Viertel der Schwingung weg und lässt dem Regelkreis seine "
    "Reserve"};
constexpr Sentence still_stage{
    "no stage for {frequency}: the load swings there by less than {noticeable}",
    "keine Stufe für {frequency}: die Last schwingt dort um weniger als {noticeable}"};
constexpr Sentence nowhere{
    "Improved Position Control: the plant of axis {axis} in {plant} does not resonate at {resonances}",
    "Optimierte Lageregelung: die Strecke der Achse {axis} in {plant} hat keine Resonanz bei {resonances}"};
constexpr Sentence still{
    "Improved Position Control: in this move the load of axis {axis} swings by less than {noticeable} at "
    "{resonances}; name the --feed at which it swings",
    "Optimierte Lageregelung: bei dieser Bewegung schwingt die Last der Achse {axis} bei {resonances} um "
    "weniger als {noticeable}; mit --feed den Vorschub angeben, bei dem sie schwingt"};
constexpr Sentence diverges{
    "Improved Position Control: the loop of axis {axis} with {plant} oscillates even without it; a lower "
    "kv_per_s comes first",
    "Optimierte Lageregelung: der Regelkreis der Achse {axis} mit {plant} schwingt schon ohne sie auf; "
    "zuerst ein kleineres kv_per_s wählen"};
constexpr Sentence not_enough{
    "Improved Position Control: none of {count} settings takes away a quarter of the vibration of axis "
    "{axis}, keeps the tolerance on the circle and leaves the loop its margin",
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

using namespace presentation;

constexpr auto m_per_s2 = Unit::metre_per_second_squared;
constexpr auto noticeable = exact(tuning::noticeable_swing, m_per_s2);

/// By NoDamping.
constexpr std::array<std::string_view, 4> reasons{"diverges", "no_resonance", "still", "not_enough"};
constexpr std::array<SentenceRef, 4> reason_sentences{says::diverges, says::nowhere, says::still,
                                                      says::not_enough};

Section refusal(Suggested const& suggested) {
  auto const& answer = *suggested.damping;
  auto const* const none = std::get_if<tuning::NoDampingFound>(&answer.found);
  auto const reason = none != nullptr ? static_cast<std::size_t>(none->reason) : 0;
  auto const count = none != nullptr ? none->looked_at : 0;
  auto const sentence = none != nullptr ? reason_sentences.at(reason) : SentenceRef(says::gantry);
  return {.key = "position_control",
          .title = {},
          .blocks = {Facts{{data("plant", answer.plant_path),
                            data("refusal", none != nullptr ? reasons.at(reason) : "gantry"),
                            data("settings_compared", count)}},
                     Paragraph{Words(sentence, {{"axis", suggested.axis},
                                                {"plant", answer.plant_path},
                                                {"resonances", resonances_of(suggested.task)},
                                                {"noticeable", noticeable},
                                                {"count", count}})}}};
}

Table resonances(tuning::Damping const& damping, tuning::Task const& task) {
  Table table{.key = "resonances",
              .columns = {head_column("frequency_hz", says::load, Unit::hertz),
                          column("amplitude_without_m_per_s2", says::without, m_per_s2),
                          column("amplitude_with_m_per_s2", says::with, m_per_s2),
                          column("worst_amplitude_without_m_per_s2", says::worst_without, m_per_s2),
                          column("worst_amplitude_with_m_per_s2", says::worst_with, m_per_s2),
                          data_column("is_in_plant"), data_column("is_noticeable"), data_column("stage")},
              .rows = {}};
  for (std::size_t i = 0; i < damping.resonances.size(); ++i) {
    auto const& found = damping.resonances[i];
    auto& row = table.rows.emplace_back();
    row.emplace_back(rounded(task.resonances[i].frequency, Unit::hertz, 4));
    for (double const value : {found.without, found.with, found.worst_without, found.worst}) {
      row.emplace_back(fixed(value, m_per_s2, 3));
    }
    row.insert(row.end(), {found.is_in_plant, found.is_noticeable, found.stage});
  }
  return table;
}

/// Why a resonance has no stage.
SentenceRef reason_of(tuning::DampedResonance const& resonance) {
  if (!resonance.is_in_plant) return says::not_in_plant;
  return resonance.is_noticeable ? says::no_stage : says::still_stage;
}

}  // namespace

Words damping_name(tuning::Damping const& damping) {
  auto const& control = damping.control;
  return {says::name,
          {{"number", damping_number},
           {"stages", Wording(tuning::short_name(control, Language::english),
                              tuning::short_name(control, Language::german))}}};
}

Section damping_section(Suggested const& suggested) {
  auto const& answer = *suggested.damping;
  auto const* const damping = answer.damping();
  if (damping == nullptr) return refusal(suggested);
  auto const& task = suggested.task;
  Words const on_circle(says::circle,
                        {{"radius", rounded(task.radius / motion::units_per_mm, Unit::millimetre, 6)}});
  Section lines{.key = {}, .title = damping_name(*damping), .blocks = {}};
  add_lines(lines.blocks, answer.axes, answer.findings);
  for (std::size_t i = 0; i < damping->resonances.size(); ++i) {
    if (damping->resonances[i].stage) continue;
    lines.blocks.emplace_back(Paragraph{Words(
        reason_of(damping->resonances[i]),
        {{"frequency", rounded(task.resonances[i].frequency, Unit::hertz, 4)}, {"noticeable", noticeable}})});
  }
  return {.key = "position_control",
          .title = Words(says::heading, {{"axis", suggested.axis},
                                         {"plant", answer.plant_path},
                                         {"kv", rounded(answer.kv, Unit::none, 6)},
                                         {"count", damping->looked_at}}),
          .blocks = {Facts{{data("plant", answer.plant_path), data("settings_compared", damping->looked_at),
                            data("stages", tuning::short_name(damping->control, Language::english))}},
                     resonances(*damping, task),
                     Facts{{{"shift_on_circle_um", on_circle, length_of(damping->circle)},
                            {"largest_shift_um", says::shift, length_of(damping->shift)},
                            {"distance_from_setpoint_um",
                             says::distance,
                             length_of(damping->error_without),
                             {},
                             "without"},
                            {"distance_from_setpoint_um",
                             says::distance_with,
                             length_of(damping->error_with),
                             {},
                             "with"},
                            {"max_additive_velocity_um_per_s", says::additive,
                             fixed(damping->additive_velocity, Unit::micrometre_per_second, 0)}}},
                     std::move(lines)},
          .identity = {data("number", damping_number)}};
}

}  // namespace axisc
