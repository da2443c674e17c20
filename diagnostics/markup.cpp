#include "diagnostics/markup.hpp"

namespace axisc {

std::string escaped(std::string_view text) {
  std::string result;
  for (char const byte : text) {
    switch (byte) {
      case '&': result += "&amp;"; break;
      case '<': result += "&lt;"; break;
      case '>': result += "&gt;"; break;
      case '"': result += "&quot;"; break;
      default: result += byte;
    }
  }
  return result;
}

}  // namespace axisc
