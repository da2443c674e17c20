#include "design/filter_design.hpp"
