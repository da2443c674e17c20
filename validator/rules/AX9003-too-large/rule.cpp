#include "validator/engine/rule.hpp"

namespace axisc::validator::checks {

extern constinit Rule const ax9003{
    .code = Code{9003},
    .name = "too-large",
};

}  // namespace axisc::validator::checks
