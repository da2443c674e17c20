#include "validator/engine/rule.hpp"

namespace axisc::validator::checks {

extern constinit Rule const ax9008{
    .code = Code{9008},
    .name = "cannot-simulate",
};

}  // namespace axisc::validator::checks
