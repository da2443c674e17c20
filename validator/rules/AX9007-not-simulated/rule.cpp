#include "validator/engine/rule.hpp"

namespace axisc::validator::checks {

extern constinit Rule const ax9007{
    .code = Code{9007},
    .name = "not-simulated",
    .severity = Severity::warning,
};

}  // namespace axisc::validator::checks
