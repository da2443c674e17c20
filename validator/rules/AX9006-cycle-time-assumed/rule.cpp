#include "validator/engine/rule.hpp"

namespace axisc::validator::checks::ax9006 {

extern constinit Rule const rule{
    .severity = Severity::note,
};

}  // namespace axisc::validator::checks::ax9006
