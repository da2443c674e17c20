#include "validator/engine/rule.hpp"

namespace axisc::validator::checks {

extern constinit Rule const ax9004{
    .code = Code{9004},
    .name = "not-an-image",
};

}  // namespace axisc::validator::checks
