#include "cli/fleet/unique_name.hpp"

#include "cli/fleet/digest.hpp"

#include <atomic>
#include <chrono>
#include <cstdint>
#include <unistd.h>

namespace axisc::cli {

std::string unique_name() {
  static std::atomic<std::uint64_t> count{0};
  auto const now = std::chrono::system_clock::now().time_since_epoch().count();
  char host[256] = {};
  static_cast<void>(::gethostname(host, sizeof(host) - 1));
  Hasher hasher;
  hasher.number(static_cast<std::uint64_t>(::getpid()));
  hasher.number(count++);
  hasher.number(static_cast<std::uint64_t>(now));
  hasher.text(host);
  return hexadecimal(hasher.finish());
}

}  // namespace axisc::cli
