// What every processor of the family has: SSE2 on 64-bit x86, a table elsewhere.
#define AXISC_LEVEL portable
#include "grammar/levels/regular_lines_def.hpp"
