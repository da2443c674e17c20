#include "validator/engine/rule.hpp"

namespace axisc::validator::checks::ax9007 {

extern constinit Rule const rule{
    .severity = Severity::warning,
};

}  // namespace axisc::validator::checks::ax9007
