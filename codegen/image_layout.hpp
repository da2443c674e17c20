// Where the sections of an image are, and the checksums over them.
#pragma once

#include "codegen/image_fields.hpp"
#include "codegen/record.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace axisc::codegen {

/// One section of an image: its row in the section table and its bytes.
struct SectionContent {
  std::uint32_t kind = 0;
  std::uint32_t flags = 0;
  std::uint32_t element_size = 1;
  std::vector<std::byte> bytes;

  [[nodiscard]] std::uint32_t count() const {
    return static_cast<std::uint32_t>(bytes.size() / element_size);
  }
};

/// A section while its records are added.
template <class RecordType>
class SectionTable {
 public:
  explicit SectionTable(SectionKind<RecordType> kind)
      : content_{.kind = kind.kind, .flags = kind.flags, .element_size = RecordType::bytes, .bytes = {}} {}

  /// A new record of zeros at the end; valid until the next call.
  [[nodiscard]] Record<RecordType> append() {
    content_.bytes.resize(content_.bytes.size() + RecordType::bytes);
    return Record<RecordType>(std::span(content_.bytes).last(RecordType::bytes));
  }
  [[nodiscard]] std::uint32_t count() const { return content_.count(); }
  [[nodiscard]] SectionContent const& content() const { return content_; }

 private:
  SectionContent content_;
};

/// A place in the names section.
struct TextRange {
  std::uint32_t offset = 0;
  std::uint32_t size = 0;
};

/// The names section: every text once, in the order of first use.
class TextPool {
 public:
  /// An empty text is {0, 0}.
  [[nodiscard]] TextRange add(std::string_view text);
  [[nodiscard]] SectionContent const& content() const { return content_; }

 private:
  SectionContent content_{
      .kind = sections::names.kind, .flags = sections::names.flags, .element_size = 1, .bytes = {}};
  std::unordered_map<std::string, TextRange> ranges_;
};

/// The contents of the header besides sizes and checksums.
struct ImageHeader {
  std::uint16_t format_minor = axim_minor;
  std::uint32_t cycle_time_ns = 0;
  std::uint32_t axis_count = 0;
  std::uint32_t image_version = 0;
  std::array<std::uint8_t, 32> source_digest{};
  std::string_view compiler_version;
};

/// Header, section table and the sections in the given order; each begins at the next multiple of 64, gaps
/// and the end of the image are filled with zeros up to such a multiple.
[[nodiscard]] std::vector<std::byte> assemble_image(ImageHeader const& header,
                                                    std::span<SectionContent const* const> sections);

}  // namespace axisc::codegen
