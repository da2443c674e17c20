#include "validator/rule.hpp"

namespace axisc::validator::checks {
namespace {

void nameless_axis(AxisContext const& axis, Report& report) {
  EffectiveValue const& name = axis.values.at("kopf.log_achs_name");
  if (name.unusable || name.value.text != "NONAME") return;
  report.add(name, {Text::fixed_placeholder, {{"text", "the axis has no name of its own"}}});
}

}  // namespace

extern constinit Rule const ax2099{
    .code = Code{2099},
    .name = "nameless-axis",
    .severity = Severity::warning,
    .check = nameless_axis,
};

}  // namespace axisc::validator::checks
