#include "validator/engine/rule.hpp"

namespace axisc::validator::checks {

extern constinit Rule const ax9009{
    .code = Code{9009},
    .name = "plant-file",
};

}  // namespace axisc::validator::checks
