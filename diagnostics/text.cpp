#include "diagnostics/text.hpp"
