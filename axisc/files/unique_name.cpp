#include "axisc/files/unique_name.hpp"

#include "system/process.hpp"

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>

#include <fmt/format.h>

namespace axisc {

std::string unique_name() {
  static std::atomic<std::uint64_t> count{0};
  auto const now = std::chrono::system_clock::now().time_since_epoch().count();
  system::ProcessName const process = system::process_name();
  // Names of hosts may be long: only their hash is needed, and only where hosts share a folder.
  return fmt::format("{:x}-{:x}-{:x}-{:x}", std::hash<std::string>()(process.host), process.number, now,
                     count++);
}

}  // namespace axisc
