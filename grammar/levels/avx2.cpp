// 32 bytes in a vector.
#define AXISC_LEVEL avx2
#include "grammar/levels/regular_lines_def.hpp"

namespace axisc::grammar::avx2 {

std::size_t read_regular_lines(RegularLines& lines, Assignment* out, std::size_t room) {
  return read_lines(lines, out, room);
}

}  // namespace axisc::grammar::avx2
