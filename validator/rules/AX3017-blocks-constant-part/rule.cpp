#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"

namespace axisc::validator::checks {
namespace {

void blocks_constant_part(FilterContext const& context, Report& report) {
  FilterView const& filter = context.filter;
  if (!filter.active() || filter.port != FilterPort::setpoint) return;
  if (!design::kind_of(*filter.standard_type).blocks_constant) return;
  Finding& finding =
      report.add(filter.anchor(filter.type), {Text::ax3017, {{"type", std::string(filter.type_word())}}});
  if (!filter.share.unusable) {
    double const share = filter.share.value.number / 100;
    finding.label = Message{Text::ax3017_label, {{"share", percent(share)}, {"left", percent(1 - share)}}};
  }
  finding.notes.push_back({Text::ax3017_note, {}});
}

}  // namespace

extern constinit Rule const ax3017{
    .code = Code{3017},
    .name = "blocks-constant-part",
    .severity = Severity::warning,
    .check = blocks_constant_part,
};

}  // namespace axisc::validator::checks
