// Typed access to the records of an image. The format's one table determines which record has which field of
// which type at which offset; a field outside its record does not compile.
#pragma once

#include "axisrt.h"
#include "runtime/format/image_format.h"
#include "runtime/little_endian.hpp"

#include <stddef.h>
#include <stdint.h>

namespace axisc::runtime {

/// Type of the table's u8xN fields, which are only compared or copied.
template <size_t Size>
struct Octets {
  uint8_t octets[Size];
};

namespace field_types {
using u8x4 = Octets<4>;
using u8x8 = Octets<8>;
using u8x16 = Octets<16>;
using u8x32 = Octets<32>;
using u8x48 = Octets<48>;
using u8x64 = Octets<64>;
using u16 = uint16_t;
using u32 = uint32_t;
using u64 = uint64_t;
using f64 = double;
}  // namespace field_types

/// Records as types: record::axis, record::filter, ...
namespace record {
#define AXIM_RECORD(record, size, meaning)    \
  struct record {                             \
    static constexpr uint32_t bytes = (size); \
  };
#define AXIM_FIELD(record, field, type, offset, meaning)
#define AXIM_SECTION(name, kind, record, flags, meaning)
#include "runtime/format/fields.inc"
#undef AXIM_RECORD
#undef AXIM_FIELD
#undef AXIM_SECTION
}  // namespace record

template <class RecordType, class ValueType, size_t Offset>
struct Field {
  static_assert(Offset + sizeof(ValueType) <= RecordType::bytes);
};

/// Fields as constants: field::axis::type, field::filter::share, ...
namespace field {
// NOLINTBEGIN(bugprone-macro-parentheses): a name that is declared cannot be in parentheses
#define AXIM_RECORD(record, size, meaning)
#define AXIM_FIELD(record_name, field, type, offset, meaning)                       \
  namespace record_name {                                                           \
  inline constexpr Field<record::record_name, field_types::type, (offset)> field{}; \
  }
#define AXIM_SECTION(name, kind, record, flags, meaning)
#include "runtime/format/fields.inc"
#undef AXIM_RECORD
#undef AXIM_FIELD
#undef AXIM_SECTION
// NOLINTEND(bugprone-macro-parentheses)
}  // namespace field

/// One record; the image's bytes belong to the caller.
template <class RecordType>
class Record {
 public:
  explicit constexpr Record(uint8_t const* bytes) : bytes_(bytes) {}

  template <size_t Offset>
  [[nodiscard]] constexpr uint16_t operator[](Field<RecordType, uint16_t, Offset>) const {
    return load_u16(bytes_ + Offset);
  }
  template <size_t Offset>
  [[nodiscard]] constexpr uint32_t operator[](Field<RecordType, uint32_t, Offset>) const {
    return load_u32(bytes_ + Offset);
  }
  template <size_t Offset>
  [[nodiscard]] constexpr uint64_t operator[](Field<RecordType, uint64_t, Offset>) const {
    return load_u64(bytes_ + Offset);
  }
  template <size_t Offset>
  [[nodiscard]] constexpr double operator[](Field<RecordType, double, Offset>) const {
    return load_f64(bytes_ + Offset);
  }

 private:
  uint8_t const* bytes_;
};

/// Records of one section. A higher minor version may have longer records; known fields are at their
/// beginning.
template <class RecordType>
struct Table {
  uint8_t const* first = nullptr;
  uint32_t count = 0;
  uint32_t stride = RecordType::bytes;

  /// Expects index < count.
  [[nodiscard]] constexpr Record<RecordType> operator[](uint32_t index) const {
    return Record<RecordType>(first + static_cast<size_t>(index) * stride);
  }
  /// [begin, begin + length) is inside.
  [[nodiscard]] constexpr bool holds(uint32_t begin, uint32_t length) const {
    return begin <= count && length <= count - begin;
  }
};

/// The sections of an image whose container was found sound: every record of every table is inside the
/// image. Sections that the image does not have are empty.
struct ImageView {
  uint8_t const* image = nullptr;
#define AXIM_RECORD(record, size, meaning)
#define AXIM_FIELD(record, field, type, offset, meaning)
#define AXIM_SECTION(name, kind, record_name, flags, meaning) Table<record::record_name> name;
#include "runtime/format/fields.inc"
#undef AXIM_RECORD
#undef AXIM_FIELD
#undef AXIM_SECTION

  [[nodiscard]] Record<record::header> header() const {
    return Record<record::header>(image);
  }
};

/// Checks the header's magic, version and sizes, and what follows the image: nothing, or a trailer.
[[nodiscard]] axisrt_status check_header(uint8_t const* image, size_t size);

/// Checks the container: magic, version, sizes, checksums and the section table.
[[nodiscard]] axisrt_status open_image(void const* image, size_t size, ImageView& view);

/// Checks everything inside the sections: counts, indices, numbers, stability.
[[nodiscard]] axisrt_status check_contents(ImageView const& view);

/// Both checks. An accepted image can be laid out and executed without any further check.
[[nodiscard]] axisrt_status verify_image(void const* image, size_t size, ImageView& view);

}  // namespace axisc::runtime
