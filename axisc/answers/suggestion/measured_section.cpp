#include "analysis/tuning/identification/thresholds.hpp"
#include "axisc/answers/execution/mapping_table.hpp"
#include "axisc/answers/labels.hpp"
#include "axisc/answers/suggestion/measured_resonances.hpp"
#include "diagnostics/format_number.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace axisc::says {

constexpr Sentence measured{"measured", "gemessen"};
constexpr Sentence uncertainty{"±", "±"};
constexpr Sentence coherence{"coherence", "Kohärenz"};
constexpr Sentence ratio{"|H|/s", "|H|/s"};
constexpr Sentence evidence{"evidence", "Beleg"};
constexpr Sentence by_response{"response", "Frequenzgang"};
constexpr Sentence by_ring_down{"ring-down", "Ausschwingen"};
constexpr Sentence by_lines{"lines", "Linien"};
constexpr Sentence by_spectrum{"spectrum", "Spektrum"};
constexpr Sentence spectrum{
    "a spectrum does not show what made the peaks: a tooth or a spindle may have; two signals show it",
    "ein Spektrum zeigt nicht, woher die Spitzen kommen: auch ein Zahn oder eine Spindel kann es sein; zwei "
    "Signale zeigen es"};
constexpr Sentence not_told_from_shaking{
    "lines alone: a fan would look the same; the axis must rest for {seconds} s after a motion to show what "
    "shakes it there as well",
    "nur Linien: ein Lüfter sähe ebenso aus; was die Achse auch im Stillstand erregt, zeigen erst "
    "{seconds} s Stillstand nach einer Bewegung"};
constexpr Sentence not_a_resonance{"not a resonance", "keine Resonanz"};
constexpr Sentence because{"because", "weil"};
constexpr Sentence proportional{"once every {distance}: moves with the speed",
                                "einmal je {distance}: bewegt sich mit der Geschwindigkeit"};
constexpr Sentence mains{"a multiple of 50 or 60 Hz", "ein Vielfaches von 50 oder 60 Hz"};
constexpr Sentence at_rest{"the axis shakes so at rest as well", "die Achse schwingt so auch im Stillstand"};
constexpr Sentence ambiguous{
    "a multiple of what comes once a turn, at each speed another one",
    "ein Vielfaches dessen, was einmal je Umdrehung kommt, je Geschwindigkeit ein anderes"};

}  // namespace axisc::says

namespace axisc {

namespace {

using namespace presentation;

struct Word {
  std::string_view symbol;
  SentenceRef words;
};
/// By tuning::Evidence.
constexpr std::array<Word, 4> evidences{{{"response", says::by_response},
                                         {"ring_down", says::by_ring_down},
                                         {"lines", says::by_lines},
                                         {"spectrum", says::by_spectrum}}};
/// By tuning::LineKind, of which none is constant.
constexpr std::array<std::string_view, 5> kinds{"constant", "proportional", "mains", "at_rest", "ambiguous"};

Names symbols_of(std::vector<tuning::Evidence> const& evidence) {
  Names names;
  for (auto const one : evidence) names.emplace_back(evidences.at(static_cast<std::size_t>(one)).symbol);
  return names;
}

Wording words_of(std::vector<tuning::Evidence> const& evidence) {
  Wording text;
  for (auto const one : evidence) {
    text += (text.empty() ? Wording() : Wording(", ")) +
            wording_of(evidences.at(static_cast<std::size_t>(one)).words);
  }
  return text;
}

Table modes_table(std::vector<tuning::FoundMode> const& modes) {
  return table_of("measured",
                  {column("frequency_hz", says::measured, Unit::hertz),
                   column("frequency_uncertainty_hz", says::uncertainty, Unit::hertz),
                   column("damping", labels::damping),
                   column("damping_uncertainty", says::uncertainty),
                   column("coherence", says::coherence),
                   column("ratio", says::ratio),
                   {.key = {}, .label = says::evidence, .audience = Audience::people},
                   data_column("evidence"),
                   data_column("told_from_shaking")},
                  modes, [](tuning::FoundMode const& mode) {
                    return Row{fixed(mode.frequency, Unit::hertz, 2),
                               fixed(mode.frequency_uncertainty, Unit::hertz, 2),
                               quantity_or({}, mode.damping, Unit::none, Digits::decimals(3)),
                               quantity_or({}, mode.damping_uncertainty, Unit::none, Digits::decimals(3)),
                               quantity_or({}, mode.coherence, Unit::none, Digits::decimals(2)),
                               quantity_or({}, mode.ratio, Unit::none, Digits::decimals(1)),
                               words_of(mode.evidence),
                               symbols_of(mode.evidence),
                               mode.is_told_from_shaking};
                  });
}

Words reason_of(tuning::SpectralLine const& line, std::string const& unit) {
  using tuning::LineKind;
  switch (line.kind) {
    case LineKind::mains: return says::mains;
    case LineKind::at_rest: return says::at_rest;
    case LineKind::ambiguous: return says::ambiguous;
    case LineKind::constant:
    case LineKind::proportional: break;
  }
  return {says::proportional,
          {{"distance", format_rounded(line.distance, 4) + (unit.empty() ? "" : " " + unit)}}};
}

Table others_table(MeasuredResonances const& measured) {
  auto const& unit = measured.unit;
  return table_of("not_resonances",
                  {column("frequency_hz", says::not_a_resonance, Unit::hertz),
                   data_column("kind"),
                   data_column("distance"),
                   data_column("unit"),
                   {.key = {}, .label = says::because, .audience = Audience::people}},
                  measured.found.others, [&](tuning::SpectralLine const& line) {
                    bool const has_distance = line.kind == tuning::LineKind::proportional;
                    return Row{fixed(line.frequency, Unit::hertz, 2),
                               kinds.at(static_cast<std::size_t>(line.kind)),
                               has_distance ? Value(line.distance) : Value(),
                               has_distance && !unit.empty() ? Value(unit) : Value(), reason_of(line, unit)};
                  });
}

}  // namespace

void add_measured(std::vector<Block>& blocks, MeasuredResonances const& measured) {
  blocks.emplace_back(modes_table(measured.found.modes));
  auto const& modes = measured.found.modes;
  bool const may_be_a_fan = std::any_of(modes.begin(), modes.end(), [](tuning::FoundMode const& mode) {
    return !mode.is_told_from_shaking && mode.evidence.back() == tuning::Evidence::lines;
  });
  if (may_be_a_fan) {
    blocks.emplace_back(Paragraph{
        {says::not_told_from_shaking, {{"seconds", format_rounded(2 * tuning::shortest_piece, 2)}}}});
  }
  if (measured.has_spectrum) blocks.emplace_back(Paragraph{says::spectrum});
  if (!measured.found.others.empty()) blocks.emplace_back(others_table(measured));
  if (measured.mapping.empty()) return;
  std::vector<std::string> signals;
  std::vector<MappedColumn> columns;
  for (auto const& one : measured.mapping) {
    signals.push_back(one.signal);
    columns.push_back(one.column);
  }
  blocks.emplace_back(mapping_table(signals, columns));
}

}  // namespace axisc
