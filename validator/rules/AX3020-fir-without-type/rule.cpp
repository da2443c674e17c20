#include "validator/engine/rule.hpp"

#include "validator/views/fir_view.hpp"
#include "validator/rules/filter_words.hpp"

namespace axisc::validator::checks {
namespace {

void fir_without_type(AxisContext const& axis, Report& report) {
  FirView const& fir = axis.fir;
  if (fir.enable.unusable || fir.type.unusable) return;
  if (!fir.enable.value.flag() || fir.type.value.number != 0) return;
  Finding& finding = report.add(fir.anchor(fir.type), {Text::ax3020, {}});
  finding.notes.push_back({Text::ax3020_types, {{"p_axis", parameter_number(fir.type)}}});
  note_default(finding, fir.type);
  finding.help.push_back({Text::ax3020_help, {}});
  react(finding, {Text::kernel_reaction_not_active, {}});
}

}  // namespace

extern constinit Rule const ax3020{
    .code = Code{3020},
    .name = "fir-without-type",
    .severity = Severity::warning,
    .control = "110634/51043",
    .check = fir_without_type,
};

}  // namespace axisc::validator::checks
