#include "validator/engine/rule.hpp"

namespace axisc::validator::checks {

extern constinit Rule const ax1013{
    .severity = Severity::warning,
};

}  // namespace axisc::validator::checks
