#include "axisc/settings/sentences.hpp"

namespace axisc::says {

constinit Sentence const settings_build{
    "\"{value}\" is not a build of the control; write it as V3.1.3075.04",
    "\"{value}\" ist kein Stand der Steuerung; Schreibweise V3.1.3075.04"};

}  // namespace axisc::says
