#include "diagnostics/source_text.hpp"
