// The checks of AX3 and AX6.
#pragma once

#include "validator/rule.hpp"
