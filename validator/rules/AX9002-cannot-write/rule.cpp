#include "validator/engine/rule.hpp"

namespace axisc::validator::checks {

extern constinit Rule const ax9002{
    .code = Code{9002},
    .name = "cannot-write",
};

}  // namespace axisc::validator::checks
