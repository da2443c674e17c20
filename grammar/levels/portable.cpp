// What every processor of the family has: SSE2 on 64-bit x86, a table elsewhere.
#define AXISC_LEVEL portable
#include "grammar/levels/regular_lines_def.hpp"

namespace axisc::grammar::portable {

std::size_t read_regular_lines(RegularLines& lines, Assignment* out, std::size_t room) {
  return read_lines(lines, out, room);
}

}  // namespace axisc::grammar::portable
