#include "validator/engine/rule.hpp"

namespace axisc::validator::checks {

extern constinit Rule const ax4020{
    .code = Code{4020},
    .name = "machine-file",
};

}  // namespace axisc::validator::checks
