// Memory at an address divisible by 64, exactly as long as asked for: a read behind its end is seen by the
// sanitizers.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <new>
#include <span>

namespace axisc::test {

class AlignedMemory {
 public:
  static constexpr std::align_val_t alignment{64};

  explicit AlignedMemory(std::size_t size)
      : bytes_(static_cast<std::uint8_t*>(::operator new(size, alignment))), size_(size) {
    std::fill_n(bytes_, size_, std::uint8_t{0xA5});  // nothing may rely on zeroed memory
  }
  explicit AlignedMemory(std::span<std::uint8_t const> content) : AlignedMemory(content.size()) {
    std::copy(content.begin(), content.end(), bytes_);
  }
  AlignedMemory(AlignedMemory const&) = delete;
  AlignedMemory& operator=(AlignedMemory const&) = delete;
  ~AlignedMemory() { ::operator delete(bytes_, alignment); }

  [[nodiscard]] std::uint8_t* data() { return bytes_; }
  [[nodiscard]] std::uint8_t const* data() const { return bytes_; }
  [[nodiscard]] std::size_t size() const { return size_; }

 private:
  std::uint8_t* bytes_;
  std::size_t size_;
};

}  // namespace axisc::test
