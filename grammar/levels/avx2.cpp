// 32 bytes in a vector.
#define AXISC_LEVEL avx2
#include "grammar/levels/plain_lines_def.hpp"

namespace axisc::grammar::avx2 {

extern PlainLineReader const plain_line_reader;
constinit PlainLineReader const plain_line_reader{.find = find_lines, .split = split_lines};

}  // namespace axisc::grammar::avx2
