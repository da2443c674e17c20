#include "validator/engine/rule.hpp"

#include "diagnostics/format_number.hpp"
#include "grammar/number.hpp"
#include "validator/rules/helpers.hpp"

namespace axisc::validator::checks::ax5012::says {

constexpr Sentence headline{"AX_DEV allows each axis an error of {millimetres} mm",
                            "AX_DEV erlaubt jeder Achse einen Fehler von {millimetres} mm"};
constexpr Sentence note{
    "AX_DEV is in mm, or in inch where the machine file says so; tolerances are some µm: `AX_DEV=0.01`",
    "AX_DEV ist in mm, oder in Zoll, wo die Maschinendatei es sagt; üblich sind einige µm: `AX_DEV=0.01`"};

}  // namespace axisc::validator::checks::ax5012::says

namespace axisc::validator::checks::ax5012 {
namespace {

constexpr double generous_mm = 1;
constexpr double mm_per_inch = 25.4;

void generous_tolerance(ProgramContext const& context, Report& report) {
  for (grammar::NcCommand const& command : context.program.tree.commands) {
    grammar::Keyword const* const keyword = find_keyword(command, context.text, "AX_DEV");
    if (keyword == nullptr) continue;
    auto const value = grammar::real_value(
        context.text.substr(keyword->value.begin, keyword->value.end - keyword->value.begin));
    if (!value) continue;
    double const millimetres = *value * (context.whole.machine.inch ? mm_per_inch : 1);
    if (!(millimetres > generous_mm)) continue;
    Finding& finding = report.add(Place{.source = context.program.source, .span = keyword->value},
                                  message(says::headline, {{"millimetres", format_rounded(millimetres, 4)}}));
    finding.notes.push_back(message(says::note));
  }
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::note,
    .check = generous_tolerance,
};

}  // namespace axisc::validator::checks::ax5012
