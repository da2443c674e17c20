#include "validator/engine/rule.hpp"

namespace axisc::validator::checks {

extern constinit Rule const ax9007{
    .severity = Severity::warning,
};

}  // namespace axisc::validator::checks
