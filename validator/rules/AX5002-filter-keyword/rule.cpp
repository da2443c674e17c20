#include "validator/engine/rule.hpp"

#include "validator/commands/command_keywords.hpp"
#include "validator/rules/command_mistakes.hpp"
#include "validator/rules/control_numbers.hpp"

namespace axisc::validator::checks::ax5002 {
namespace {

void filter_keyword(CommandContext const& context, Report& report) {
  report_mistakes(context, Code{5002}, report);
}

}  // namespace

extern constinit Rule const rule{
    .control =
        control_numbers<keyword_repeated, mode_refused, damping_refused, share_refused, quality_refused>,
    .check = filter_keyword,
};

}  // namespace axisc::validator::checks::ax5002
