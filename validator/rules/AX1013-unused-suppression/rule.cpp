#include "validator/engine/rule.hpp"

namespace axisc::validator::checks::ax1013 {

extern constinit Rule const rule{
    .severity = Severity::warning,
};

}  // namespace axisc::validator::checks::ax1013
