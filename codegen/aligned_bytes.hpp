// Memory aligned as the runtime demands it.
#pragma once

#include "axisrt.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <new>
#include <span>

namespace axisc::codegen {

/// Bytes at a multiple of AXISRT_ALIGNMENT. Moving keeps them where they are.
class AlignedBytes {
 public:
  /// All zero.
  explicit AlignedBytes(std::size_t size)
      : bytes_(static_cast<std::byte*>(::operator new(size, alignment))), size_(size) {
    std::fill_n(bytes_.get(), size, std::byte{0});
  }
  explicit AlignedBytes(std::span<std::byte const> content) : AlignedBytes(content.size()) {
    std::copy(content.begin(), content.end(), bytes_.get());
  }

  [[nodiscard]] std::byte* data() const { return bytes_.get(); }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::span<std::byte const> bytes() const { return {bytes_.get(), size_}; }

 private:
  static constexpr std::align_val_t alignment{AXISRT_ALIGNMENT};
  struct Release {
    void operator()(std::byte* bytes) const { ::operator delete(bytes, alignment); }
  };
  std::unique_ptr<std::byte, Release> bytes_;
  std::size_t size_;
};

}  // namespace axisc::codegen
