// Values as bytes and back, for files that only this program reads, on machines of the same kind.
#pragma once

#include "cli/fleet/digest.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace axisc::cli {

class ByteWriter {
 public:
  void number(std::uint64_t value) {
    // Small numbers, which are the most frequent, take one byte.
    for (; value >= 0x80U; value >>= 7U) bytes_ += static_cast<char>((value & 0x7FU) | 0x80U);
    bytes_ += static_cast<char>(value);
  }
  void text(std::string_view value) {
    number(value.size());
    bytes_ += value;
  }
  void digest(Digest const& value) {
    number(value.high);
    number(value.low);
  }
  [[nodiscard]] std::string take() && { return std::move(bytes_); }

 private:
  std::string bytes_;
};

/// Reads what ByteWriter wrote. After the end, or if the bytes are invalid, all values are 0 or empty, and ok() is
/// false.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : rest_(bytes) {}

  [[nodiscard]] std::uint64_t number() {
    std::uint64_t value = 0;
    for (unsigned shift = 0; shift < 64 && !rest_.empty(); shift += 7) {
      auto const byte = static_cast<unsigned char>(rest_.front());
      rest_.remove_prefix(1);
      value |= static_cast<std::uint64_t>(byte & 0x7FU) << shift;
      if (byte < 0x80U) return value;
    }
    ok_ = false;
    return 0;
  }
  /// A count of elements that take at least one byte each.
  [[nodiscard]] std::size_t count() {
    auto const value = number();
    if (value <= rest_.size()) return static_cast<std::size_t>(value);
    ok_ = false;
    return 0;
  }
  [[nodiscard]] std::string_view text() {
    auto const size = count();
    auto const value = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return value;
  }
  [[nodiscard]] Digest digest() {
    auto const high = number();
    return {.high = high, .low = number()};
  }
  [[nodiscard]] bool ok() const { return ok_; }
  [[nodiscard]] bool at_end() const { return rest_.empty(); }

 private:
  std::string_view rest_;
  bool ok_ = true;
};

}  // namespace axisc::cli
