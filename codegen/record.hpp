// Records of the image in memory: little-endian values of fixed width at the offsets of the field table.
#pragma once

#include "codegen/image_fields.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

namespace axisc::codegen {

template <std::unsigned_integral T>
void store_little_endian(std::span<std::byte> to, T value) {
  for (std::size_t i = 0; i < sizeof(T); ++i) to[i] = static_cast<std::byte>((value >> (8U * i)) & 0xFFU);
}

template <std::unsigned_integral T>
[[nodiscard]] T load_little_endian(std::span<std::byte const> from) {
  T value = 0;
  for (std::size_t i = 0; i < sizeof(T); ++i) {
    value = static_cast<T>(value | static_cast<T>(std::to_integer<T>(from[i]) << (8U * i)));
  }
  return value;
}

/// A record that is being written. It does not own the bytes, which are as long as the record.
template <class RecordType>
class Record {
 public:
  explicit Record(std::span<std::byte> bytes) : bytes_(bytes) {}

  template <class T>
  void set(Field<RecordType, T> field, std::type_identity_t<T> const& value) {
    std::span<std::byte> const to = bytes_.subspan(field.offset, sizeof(T));
    if constexpr (std::is_same_v<T, double>) {
      store_little_endian(to, std::bit_cast<std::uint64_t>(value));
    } else if constexpr (std::is_integral_v<T>) {
      store_little_endian(to, value);
    } else {
      std::transform(value.begin(), value.end(), to.begin(),
                     [](std::uint8_t octet) { return std::byte{octet}; });
    }
  }

 private:
  std::span<std::byte> bytes_;
};

/// A record that is being read. It does not own the bytes, which are at least as long as the record.
template <class RecordType>
class ConstRecord {
 public:
  explicit ConstRecord(std::span<std::byte const> bytes) : bytes_(bytes) {}

  template <class T>
  [[nodiscard]] T get(Field<RecordType, T> field) const {
    std::span<std::byte const> const from = bytes_.subspan(field.offset, sizeof(T));
    if constexpr (std::is_same_v<T, double>) {
      return std::bit_cast<double>(load_little_endian<std::uint64_t>(from));
    } else if constexpr (std::is_integral_v<T>) {
      return load_little_endian<T>(from);
    } else {
      T value{};
      std::transform(from.begin(), from.end(), value.begin(),
                     [](std::byte octet) { return std::to_integer<std::uint8_t>(octet); });
      return value;
    }
  }

 private:
  std::span<std::byte const> bytes_;
};

}  // namespace axisc::codegen
