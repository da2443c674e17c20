#include "validator/engine/rule.hpp"

namespace axisc::validator::checks {

extern constinit Rule const ax9001{
    .code = Code{9001},
    .name = "cannot-read",
};

}  // namespace axisc::validator::checks
