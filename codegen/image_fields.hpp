// The fields of the image format with their types, made from the format's own table: a writer or reader that
// names a field gets its offset and its width, and the compiler checks both.
#pragma once

#include "runtime/format/image_format.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace axisc::codegen {

/// Place of a value of type Value in a record of type RecordType.
template <class RecordType, class Value>
struct Field {
  std::size_t offset = 0;
};

/// One row of the format's list of sections.
template <class RecordType>
struct SectionKind {
  std::uint32_t kind = 0;
  std::uint32_t flags = 0;
};

namespace format_types {
template <std::size_t Size>
using u8x = std::array<std::uint8_t, Size>;
using u8x4 = u8x<4>;
using u8x8 = u8x<8>;
using u8x16 = u8x<16>;
using u8x32 = u8x<32>;
using u8x48 = u8x<48>;
using u8x64 = u8x<64>;
using u16 = std::uint16_t;
using u32 = std::uint32_t;
using u64 = std::uint64_t;
using f64 = double;
inline constexpr std::uint32_t mandatory = 0;
inline constexpr std::uint32_t critical = 0;
inline constexpr std::uint32_t optional = axim_flag_optional;
}  // namespace format_types

// Names are tokens that cannot be parenthesised.
// NOLINTBEGIN(bugprone-macro-parentheses)

/// records::axis, records::filter, ...: names of the kinds of records.
namespace records {
#define AXIM_RECORD(record, size, meaning)         \
  struct record {                                  \
    static constexpr std::uint32_t bytes = (size); \
  };
#define AXIM_FIELD(record, field, type, offset, meaning)
#define AXIM_SECTION(name, kind, record, flags, meaning)
#include "runtime/format/fields.inc"
#undef AXIM_RECORD
#undef AXIM_FIELD
#undef AXIM_SECTION
}  // namespace records

/// fields::axis::number, fields::filter::share, ...
namespace fields {
#define AXIM_RECORD(record, size, meaning)
#define AXIM_FIELD(record, field, type, offset, meaning)                          \
  namespace record {                                                              \
  inline constexpr Field<records::record, format_types::type> field{(offset)};    \
  static_assert((offset) + sizeof(format_types::type) <= records::record::bytes); \
  }
#define AXIM_SECTION(name, kind, record, flags, meaning)
#include "runtime/format/fields.inc"
#undef AXIM_RECORD
#undef AXIM_FIELD
#undef AXIM_SECTION
}  // namespace fields

/// sections::axes, sections::filters, ...
namespace sections {
#define AXIM_RECORD(record, size, meaning)
#define AXIM_FIELD(record, field, type, offset, meaning)
#define AXIM_SECTION(name, kind, record, flags, meaning) \
  inline constexpr SectionKind<records::record> name{(kind), format_types::flags};
#include "runtime/format/fields.inc"
#undef AXIM_RECORD
#undef AXIM_FIELD
#undef AXIM_SECTION
}  // namespace sections
// NOLINTEND(bugprone-macro-parentheses)

}  // namespace axisc::codegen
