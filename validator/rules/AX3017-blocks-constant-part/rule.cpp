#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"

namespace axisc::validator::checks::ax3017::says {

constexpr Sentence headline{"`{type}` blocks the constant part of the position setpoint",
                            "`{type}` sperrt den Gleichanteil des Positionssollwerts"};
constexpr Sentence label{"with a share of {share} %, {left} % of a constant position remains",
                         "bei {share} % Signalanteil bleiben {left} % einer konstanten Position übrig"};
constexpr Sentence to_zero{
    "the axis goes to position 0 and stays there, whatever the program commands",
    "die Achse fährt auf Position 0 und bleibt dort, was das Programm auch kommandiert"};
constexpr Sentence note{
    "the filters act on absolute positions; with share s only 1 - s of the constant part remains",
    "die Filter wirken auf absolute Positionen; beim Anteil s bleibt nur 1 - s des Gleichanteils"};
constexpr Sentence help{"`{parameter} LOWPASS` or `{parameter} BANDSTOP` is nearly always what is meant",
                        "gemeint ist fast immer `{parameter} LOWPASS` oder `{parameter} BANDSTOP`"};

}  // namespace axisc::validator::checks::ax3017::says

namespace axisc::validator::checks::ax3017 {
namespace {

void blocks_constant_part(FilterContext const& context, Report& report) {
  FilterView const& filter = context.filter;
  if (!filter.active() || filter.port != FilterPort::setpoint) return;
  if (!design::kind_of(*filter.standard_type).blocks_constant) return;
  Finding& finding =
      report.add(filter.anchor(filter.type), {says::headline, {{"type", std::string(filter.type_word())}}});
  if (!filter.share.unusable) {
    double const share = filter.share.value.number / 100;
    finding.label = share == 1
                        ? Message{says::to_zero, {}}
                        : Message{says::label, {{"share", percent(share)}, {"left", percent(1 - share)}}};
  }
  finding.notes.push_back({says::note, {}});
  finding.help.push_back({says::help, {{"parameter", parameter_name(filter.type)}}});
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::warning,
    .parameters = "filter[].type filter[].share_percent filter[].enable filter[].order",
    .check = blocks_constant_part,
};

}  // namespace axisc::validator::checks::ax3017
