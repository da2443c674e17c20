#include "validator/engine/rule.hpp"

namespace axisc::validator::checks {

extern constinit Rule const ax9006{
    .code = Code{9006},
    .name = "cycle-time-assumed",
    .severity = Severity::note,
};

}  // namespace axisc::validator::checks
