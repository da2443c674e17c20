// Text that is written before its place comes: kept in memory while it is small, else in a file without name.
#pragma once

#include "system/file.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace axisc::cli {

class Spool {
 public:
  /// Failure (AX9002) where the folder for temporary files is full.
  void add(std::uint64_t mark, std::string_view text);
  /// Hands over what was added, in order.
  void replay(std::function<void(std::uint64_t, std::string_view)> const& take);

 private:
  void spill();

  std::string buffer_;
  system::File file_;
};

}  // namespace axisc::cli
