#include "validator/engine/rule.hpp"

#include "validator/rules/command_mistakes.hpp"

namespace axisc::validator::checks::ax5001 {
namespace {

void filter_syntax(CommandContext const& context, Report& report) {
  report_mistakes(context, Code{5001}, report);
}

}  // namespace

extern constinit Rule const rule{
    .check = filter_syntax,
};

}  // namespace axisc::validator::checks::ax5001
