// 32 bytes in a vector.
#define AXISC_LEVEL avx2
#include "grammar/levels/regular_lines_def.hpp"
