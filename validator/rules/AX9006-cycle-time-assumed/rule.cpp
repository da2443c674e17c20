#include "validator/engine/rule.hpp"

namespace axisc::validator::checks {

extern constinit Rule const ax9006{
    .severity = Severity::note,
};

}  // namespace axisc::validator::checks
