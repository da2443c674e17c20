#include "grammar/levels/every_byte.hpp"

namespace axisc::grammar {

constinit EveryByte const every_byte;

}  // namespace axisc::grammar
