#include "grammar/axis_list.hpp"
