// Text that must be written later: kept in memory while it is small, otherwise in an unnamed temporary file.
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
  /// Passes on everything added, in order.
  void replay(std::function<void(std::uint64_t, std::string_view)> const& take);

 private:
  void spill();

  std::string buffer_;
  system::File file_;
};

}  // namespace axisc::cli
