#include "validator/engine/rule.hpp"

namespace axisc::validator::checks::ax9005 {

extern constinit Rule const rule{};

}  // namespace axisc::validator::checks::ax9005
