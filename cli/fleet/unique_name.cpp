#include "cli/fleet/unique_name.hpp"

#include "cli/fleet/digest.hpp"
#include "system/process.hpp"

#include <atomic>
#include <chrono>
#include <cstdint>

namespace axisc::cli {

std::string unique_name() {
  static std::atomic<std::uint64_t> count{0};
  auto const now = std::chrono::system_clock::now().time_since_epoch().count();
  system::ProcessName const process = system::process_name();
  Hasher hasher;
  hasher.number(process.number);
  hasher.number(count++);
  hasher.number(static_cast<std::uint64_t>(now));
  hasher.text(process.host);
  return hexadecimal(hasher.finish());
}

}  // namespace axisc::cli
