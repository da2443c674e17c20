#include "validator/engine/rule.hpp"

namespace axisc::validator::checks::ax4020 {

extern constinit Rule const rule{};

}  // namespace axisc::validator::checks::ax4020
