#include "system/process.hpp"

namespace axisc::system {

std::string build_identity() {
  return {};
}

}  // namespace axisc::system
