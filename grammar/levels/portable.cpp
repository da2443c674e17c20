// What every processor of the family has: SSE2 on 64-bit x86, a table elsewhere.
#define AXISC_LEVEL portable
#include "grammar/levels/plain_lines_def.hpp"

namespace axisc::grammar::portable {

extern PlainLineReader const plain_line_reader;
constinit PlainLineReader const plain_line_reader{.find = find_lines, .split = split_lines};

}  // namespace axisc::grammar::portable
