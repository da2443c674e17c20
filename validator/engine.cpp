#include "validator/rule.hpp"
