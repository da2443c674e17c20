#include "runtime/verification/image_view.hpp"

#include "runtime/format/crc32c.hpp"

namespace axisc::runtime {
namespace {

using SectionEntry = Record<record::section>;

constexpr uint32_t magic = 0x4D495841U;  // "AXIM", little-endian
constexpr size_t magic_size = 4;
constexpr uint32_t trailer_magic = 0x47535841U;  // "AXSG"
constexpr uint32_t trailer_version = 1;
constexpr uint64_t section_entry_size = record::section::bytes;

bool is_aligned(uint64_t offset) {
  return offset % axim_alignment == 0;
}

/// End of the section table; expects a checked header.
uint64_t directory_end(Record<record::header> header) {
  return header[field::header::header_size] + header[field::header::section_count] * section_entry_size;
}

/// `size` bytes after the image.
axisrt_status check_trailer(uint8_t const* bytes, size_t size) {
  if (size == 0) return AXISRT_OK;
  if (size < record::trailer::bytes || load_u32(bytes) != trailer_magic) return AXISRT_WRONG_SIZE;
  if (Record<record::trailer>(bytes)[field::trailer::version] != trailer_version) return AXISRT_WRONG_VERSION;
  return size == record::trailer::bytes ? AXISRT_OK : AXISRT_WRONG_SIZE;
}

}  // namespace

axisrt_status check_header(uint8_t const* image, size_t size) {
  if (size < magic_size) return AXISRT_TOO_SHORT;
  if (load_u32(image) != magic) return AXISRT_WRONG_MAGIC;
  if (size < record::header::bytes) return AXISRT_TOO_SHORT;

  Record<record::header> const header(image);
  if (header[field::header::format_major] != axim_major) return AXISRT_WRONG_VERSION;
  uint64_t const total_size = header[field::header::total_size];
  if (total_size > size) return AXISRT_TOO_SHORT;
  bool const is_newer = header[field::header::format_minor] > axim_minor;
  uint32_t const header_size = header[field::header::header_size];
  if (header_size < record::header::bytes) return AXISRT_OUT_OF_BOUNDS;
  if (header_size > record::header::bytes && !is_newer) return AXISRT_OUT_OF_BOUNDS;
  if (directory_end(header) > total_size) return AXISRT_OUT_OF_BOUNDS;
  auto const image_size = static_cast<size_t>(total_size);  // no more than `size`
  return check_trailer(image + image_size, size - image_size);
}

namespace {

axisrt_status check_checksums(uint8_t const* image) {
  Record<record::header> const header(image);
  auto const directory = static_cast<size_t>(directory_end(header));
  auto const size = static_cast<size_t>(header[field::header::total_size]);
  constexpr uint8_t zero[4] = {};
  constexpr size_t behind_checksum = axim_header_header_checksum_offset + sizeof zero;
  uint32_t crc = axim_crc32c(image, axim_header_header_checksum_offset);
  crc = axim_crc32c(zero, sizeof zero, crc);
  crc = axim_crc32c(image + behind_checksum, directory - behind_checksum, crc);
  if (crc != header[field::header::header_checksum]) return AXISRT_WRONG_CHECKSUM;
  if (axim_crc32c(image + directory, size - directory) != header[field::header::payload_checksum]) {
    return AXISRT_WRONG_CHECKSUM;
  }
  return AXISRT_OK;
}

/// `free_from` is the end of the section before, and becomes the end of this one.
axisrt_status check_place(SectionEntry entry, uint64_t total_size, uint64_t& free_from) {
  uint64_t const offset = entry[field::section::offset];
  uint64_t const size = entry[field::section::size];
  if (offset > total_size || size > total_size - offset) return AXISRT_OUT_OF_BOUNDS;
  if (!is_aligned(offset) || offset < free_from) return AXISRT_OVERLAP;
  uint64_t const element_size = entry[field::section::element_size];
  if (size != element_size * entry[field::section::count]) return AXISRT_OUT_OF_BOUNDS;
  free_from = offset + size;
  return AXISRT_OK;
}

template <class RecordType>
axisrt_status read_section(SectionEntry entry, ImageView& view, bool is_newer, Table<RecordType>& table) {
  if (table.first != nullptr) return AXISRT_OUT_OF_BOUNDS;  // a second section of one kind
  uint32_t const stride = entry[field::section::element_size];
  if (stride < RecordType::bytes) return AXISRT_OUT_OF_BOUNDS;
  if (stride > RecordType::bytes && (!is_newer || RecordType::bytes == 1)) return AXISRT_OUT_OF_BOUNDS;
  table.first = view.image + static_cast<size_t>(entry[field::section::offset]);
  table.count = entry[field::section::count];
  table.stride = stride;
  return AXISRT_OK;
}

axisrt_status read_section(SectionEntry entry, ImageView& view) {
  bool const is_newer = view.header()[field::header::format_minor] > axim_minor;
  switch (entry[field::section::kind]) {
#define AXIM_RECORD(record, size, meaning)
#define AXIM_FIELD(record, field, type, offset, meaning)
#define AXIM_SECTION(name, kind, record, flags, meaning) \
  case kind:                                             \
    return read_section(entry, view, is_newer, view.name);
#include "runtime/format/fields.inc"
#undef AXIM_RECORD
#undef AXIM_FIELD
#undef AXIM_SECTION
    default: break;
  }
  bool const may_be_skipped = entry[field::section::flags] == axim_flag_optional;
  return may_be_skipped ? AXISRT_OK : AXISRT_UNKNOWN_KIND;
}

axisrt_status check_mandatory_sections(ImageView const& view) {
  constexpr bool mandatory = true;
  constexpr bool critical = false;
  constexpr bool optional = false;
  bool complete = true;
#define AXIM_RECORD(record, size, meaning)
#define AXIM_FIELD(record, field, type, offset, meaning)
#define AXIM_SECTION(name, kind, record, flags, meaning) \
  complete = complete && (!(flags) || view.name.first != nullptr);
#include "runtime/format/fields.inc"
#undef AXIM_RECORD
#undef AXIM_FIELD
#undef AXIM_SECTION
  return complete ? AXISRT_OK : AXISRT_OUT_OF_BOUNDS;
}

axisrt_status read_sections(ImageView& view) {
  Record<record::header> const header = view.header();
  Table<record::section> const entries{.first = view.image + header[field::header::header_size],
                                       .count = header[field::header::section_count],
                                       .stride = record::section::bytes};
  uint64_t free_from = directory_end(header);
  for (uint32_t i = 0; i < entries.count; ++i) {
    axisrt_status status = check_place(entries[i], header[field::header::total_size], free_from);
    if (status == AXISRT_OK) status = read_section(entries[i], view);
    if (status != AXISRT_OK) return status;
  }
  return check_mandatory_sections(view);
}

}  // namespace

axisrt_status open_image(void const* image, size_t size, ImageView& view) {
  if (image == nullptr) return AXISRT_BAD_ARGUMENT;
  if (!is_aligned(reinterpret_cast<uintptr_t>(image))) return AXISRT_MISALIGNED;
  auto const* bytes = static_cast<uint8_t const*>(image);
  axisrt_status status = check_header(bytes, size);
  if (status == AXISRT_OK) status = check_checksums(bytes);
  if (status != AXISRT_OK) return status;
  view = ImageView{};
  view.image = bytes;
  return read_sections(view);
}

}  // namespace axisc::runtime
