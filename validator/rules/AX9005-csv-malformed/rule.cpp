#include "validator/engine/rule.hpp"

namespace axisc::validator::checks {

extern constinit Rule const ax9005{
    .code = Code{9005},
    .name = "csv-malformed",
};

}  // namespace axisc::validator::checks
