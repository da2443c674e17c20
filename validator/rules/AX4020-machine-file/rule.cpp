#include "validator/engine/rule.hpp"

namespace axisc::validator::checks {

extern constinit Rule const ax4020{};

}  // namespace axisc::validator::checks
