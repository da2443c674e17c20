#include "validator/engine/rule.hpp"

namespace axisc::validator::checks {

extern constinit Rule const ax1013{
    .code = Code{1013},
    .name = "unused-suppression",
    .severity = Severity::warning,
};

}  // namespace axisc::validator::checks
