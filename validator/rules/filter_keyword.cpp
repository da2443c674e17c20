#include "validator/rules/command_mistakes.hpp"
#include "validator/rules/program_checks.hpp"

namespace axisc::validator::checks {

void filter_keyword(CommandContext const& context, Report& report) {
  report_mistakes(context, Code{5002}, report);
}

}  // namespace axisc::validator::checks
