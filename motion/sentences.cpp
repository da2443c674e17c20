#include "motion/sentences.hpp"

namespace axisc::motion::says {

constinit Sentence const cannot_simulate{
    "`{word}` cannot be simulated: it would change the path or the filters",
    "`{word}` ist nicht simulierbar: es würde die Bahn oder die Filter ändern"};

}  // namespace axisc::motion::says
