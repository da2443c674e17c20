#include "validator/engine/rule.hpp"

namespace axisc::validator::checks {

extern constinit Rule const ax9001{};

}  // namespace axisc::validator::checks
