#include "axisc/answers/suggestion/suggest_answer.hpp"

#include "analysis/motion/point.hpp"
#include "axisc/answers/labels.hpp"
#include "diagnostics/format_number.hpp"

#include <array>
#include <iterator>

namespace axisc::says {

constexpr Sentence title{
    "axis {axis}, resonance {resonances}, F{feed} mm/min, tolerance {tolerance}; {count} settings compared",
    "Achse {axis}, Resonanz {resonances}, F{feed} mm/min, Toleranz {tolerance}; {count} Einstellungen "
    "verglichen"};
constexpr Sentence no_filters{"axis {axis}: no filters are suggested; {count} settings compared",
                              "Achse {axis}: keine Filter vorgeschlagen; {count} Einstellungen verglichen"};
constexpr Sentence recommended{"(recommended)", "(empfohlen)"};
constexpr Sentence alternative{"{senses}: {chain}", "{senses}: {chain}"};
constexpr Sentence command{"NC program: {command}", "NC-Programm: {command}"};
constexpr Sentence no_command{"NC program: nothing to write; the filters work from start-up",
                              "NC-Programm: nichts zu schreiben; die Filter wirken ab Hochlauf"};
constexpr Sentence overshoots{
    "not suggested: {chain} leaves {vibration} at a delay of {delay}, but overshoots by {overshoot}",
    "nicht vorgeschlagen: {chain} lässt {vibration} bei einer Verzögerung von {delay}, schwingt aber um "
    "{overshoot} über"};
constexpr Sentence other_family{
    "not suggested: {chain} leaves {vibration} at a delay of {delay}, but this control has other "
    "linear-phase filters (AX4007)",
    "nicht vorgeschlagen: {chain} lässt {vibration} bei einer Verzögerung von {delay}, aber diese "
    "Steuerung hat andere linearphasige Filter (AX4007)"};

constexpr Sentence excluded_guard{
    "not suggested: {chain} leaves {vibration} at a delay of {delay}, but a program uses #FILTER, with which "
    "no list may activate Vibration Guard (AX5004)",
    "nicht vorgeschlagen: {chain} lässt {vibration} bei einer Verzögerung von {delay}, aber ein Programm "
    "verwendet #FILTER, mit dem keine Liste den Vibration Guard aktivieren darf (AX5004)"};
constexpr Sentence excluded_kernel{
    "not suggested: {chain} leaves {vibration} at a delay of {delay}, but a program uses #VIB GUARD, which "
    "excludes FIR and HSC filters (AX5005, AX4005)",
    "nicht vorgeschlagen: {chain} lässt {vibration} bei einer Verzögerung von {delay}, aber ein Programm "
    "verwendet #VIB GUARD, das FIR- und HSC-Filter ausschließt (AX5005, AX4005)"};
constexpr Sentence present_guard{"present: {chain}", "jetzt: {chain}"};
constexpr Sentence replaces_guard{
    "the Vibration Guard of the lists is switched off; its parameters stay, unused (AX3029)",
    "der Vibration Guard der Listen wird ausgeschaltet; seine Parameter bleiben ungenutzt stehen (AX3029)"};

constexpr Sentence least_deviation{"least deviation", "geringste Abweichung"};
constexpr Sentence balanced{"balanced", "ausgewogen"};
constexpr Sentence least_vibration{"least vibration", "geringste Schwingung"};

}  // namespace axisc::says

namespace axisc {

namespace {

using namespace presentation;

constexpr std::array<std::string_view, tuning::senses> sense_symbols = {"least_deviation", "balanced",
                                                                        "least_vibration"};

constexpr std::array<SentenceRef, tuning::senses> sense_names = {says::least_deviation, says::balanced,
                                                                 says::least_vibration};

Paragraph command_of(Alternative const& alternative) {
  if (!alternative.command) return {says::no_command};
  return {Words(says::command, {{"command", *alternative.command}})};
}

Words title_of(Suggestion const& suggestion, std::size_t index) {
  auto const mark = " " + wording_of(says::recommended);
  return {says::alternative,
          {{"senses", senses_of(suggestion, index, mark)},
           {"chain", name_of(suggestion.alternatives.at(index).setting.chain)}}};
}

Section alternative_section(Suggestion const& suggestion, std::size_t index) {
  auto const& alternative = suggestion.alternatives.at(index);
  Names senses;
  for (auto const sense : suggestion.senses_of(index)) {
    senses.emplace_back(sense_symbols.at(static_cast<std::size_t>(sense)));
  }
  Section section{.key = {},
                  .title = title_of(suggestion, index),
                  .blocks = {Facts{{data("sense", sense_symbols.at(index)), data("senses", std::move(senses)),
                                    data("command", alternative.command)}},
                             setting_section({}, suggestion, alternative.setting)},
                  .identity = {data("number", index + 1)}};
  if (alternative.setting.guard) {
    section.blocks.emplace_back(Paragraph{coverage_words(*alternative.setting.guard)});
  }
  add_lines(section.blocks, alternative.axes, alternative.findings);
  if (alternative.replaces_guard) section.blocks.emplace_back(Paragraph{says::replaces_guard});
  section.blocks.emplace_back(command_of(alternative));
  return section;
}

SentenceRef why_not_suggested(tuning::Candidate const& candidate, tuning::Task const& task) {
  if (candidate.figures.overshoot > tuning::largest_overshoot) return says::overshoots;
  if (tuning::has_guard(candidate.chain)) return says::excluded_guard;
  bool const is_excluded = candidate.chain.kernel && task.kernels == tuning::Standing::excluded;
  return is_excluded ? SentenceRef(says::excluded_kernel) : says::other_family;
}

/// What weighs less than the balanced setting.
Paragraph not_suggested(Suggestion const& suggestion) {
  auto const& figures = suggestion.not_clean->figures;
  return {Words(why_not_suggested(*suggestion.not_clean, suggestion.task),
                {{"chain", name_of(suggestion.not_clean->chain)},
                 {"vibration", fixed(figures.vibration, Unit::share, 1)},
                 {"delay", delay_of(suggestion, figures)},
                 {"overshoot", fixed(figures.overshoot, Unit::share, 1)}})};
}

void add_filters(presentation::Document& answer, Suggestion const& suggestion) {
  auto& blocks = answer.blocks;
  auto const tolerance = rounded(suggestion.tolerance_mm, Unit::millimetre, 6);
  auto const feed = rounded(suggestion.feed, Unit::none, 6);
  answer.title = Words(says::title, {{"axis", suggestion.axis},
                                     {"resonances", resonances_of(suggestion.task)},
                                     {"feed", feed},
                                     {"tolerance", tolerance},
                                     {"count", suggestion.looked_at}});
  blocks.emplace_back(Facts{
      {data("axes", Names(suggestion.axes)), data("cycle_time_us", suggestion.cycle_time.microseconds()),
       data("feed_mm_per_min", feed), data("tolerance_mm", tolerance),
       data("radius_mm", suggestion.radius_mm),
       data("recommended", suggestion.proposed.at(static_cast<std::size_t>(suggestion.recommended)) + 1)}});
  auto resonances = table_of("resonances", data_columns({"frequency_hz", "uncertainty_hz", "damping"}),
                             suggestion.task.resonances, [](tuning::Resonance const& one) {
                               return Row{one.frequency, one.uncertainty, one.damping};
                             });
  resonances.audience = Audience::programs;
  blocks.emplace_back(std::move(resonances));
  if (suggestion.measured) add_measured(blocks, *suggestion.measured);
  if (suggestion.present) {
    blocks.emplace_back(setting_section("present", suggestion, *suggestion.present));
  } else {
    blocks.emplace_back(Facts{{data("present", {})}});
  }
  blocks.emplace_back(settings_table(suggestion));
  if (suggestion.present && suggestion.present->guard) {
    blocks.emplace_back(
        Paragraph{Words(says::present_guard, {{"chain", name_of(suggestion.present->chain)}})});
    blocks.emplace_back(Paragraph{coverage_words(*suggestion.present->guard)});
  }
  if (suggestion.not_clean) blocks.emplace_back(not_suggested(suggestion));
  Sections alternatives{.key = "alternatives", .items = {}};
  for (std::size_t i = 0; i < tuning::senses; ++i) {
    if (suggestion.proposed.at(i) == i) alternatives.items.push_back(alternative_section(suggestion, i));
  }
  blocks.emplace_back(std::move(alternatives));
}

}  // namespace

Wording senses_of(Suggestion const& suggestion, std::size_t index, Wording const& mark) {
  Wording text;
  for (auto const sense : suggestion.senses_of(index)) {
    auto const number = static_cast<std::size_t>(sense);
    text += (text.empty() ? "" : ", ") + std::to_string(number + 1) + " " +
            wording_of(sense_names.at(number)) + (sense == suggestion.recommended ? mark : Wording());
  }
  return text;
}

Wording resonances_of(tuning::Task const& task) {
  Wording text;
  for (auto const& resonance : task.resonances) {
    text += (text.empty() ? "" : ", ") + format_rounded(resonance.frequency, 4) + " Hz";
  }
  return text;
}

presentation::Document suggest_answer(Suggested const& suggested) {
  auto const* const suggestion = suggested.suggestion();
  auto const count =
      suggestion != nullptr ? suggestion->looked_at : std::get<NoSuggestion>(suggested.filters).looked_at;
  presentation::Document answer{
      .title = Words(says::no_filters, {{"axis", suggested.axis}, {"count", count}}),
      .blocks = {Facts{
          {data("axis", suggested.axis), data("group", suggested.group), data("settings_compared", count)}}},
      .csv_table = "lines"};
  add_excitation(answer.blocks, suggested);
  if (suggestion != nullptr) {
    add_filters(answer, *suggestion);
  } else {
    answer.blocks.emplace_back(Sections{.key = "alternatives", .items = {}});
  }
  if (suggested.ramps) answer.blocks.emplace_back(ramp_section(suggested));
  if (suggested.damping) answer.blocks.emplace_back(damping_section(suggested));
  return answer;
}

presentation::Document chosen_answer(Suggestion const& suggestion, std::size_t index) {
  return {.title = title_of(suggestion, index), .blocks = {command_of(suggestion.alternatives.at(index))}};
}

Quantity length_of(double units) {
  return fixed(units / motion::units_per_um, Unit::micrometre, 2);
}

}  // namespace axisc
