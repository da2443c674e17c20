#include "validator/engine/rule.hpp"

namespace axisc::validator::checks::ax2099::says {

constexpr Sentence headline{"the axis has no name of its own", "die Achse hat keinen eigenen Namen"};
constexpr Sentence help{"write the name that programs use", "den Namen schreiben, den Programme verwenden"};

}  // namespace axisc::validator::checks::ax2099::says

namespace axisc::validator::checks::ax2099 {
namespace {

void nameless_axis(AxisContext const& axis, Report& report) {
  EffectiveValue const& name = axis.values.at("kopf.log_achs_name");
  if (name.unusable || name.value.text != "NONAME") return;
  Finding& finding = report.add(name, {says::headline, {}});
  finding.help.push_back({says::help, {}});
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::warning,
    .parameters = "kopf.log_achs_name",
    .check = nameless_axis,
};

}  // namespace axisc::validator::checks::ax2099
