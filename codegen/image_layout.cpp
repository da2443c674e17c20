#include "codegen/image_layout.hpp"

#include "runtime/format/crc32c.hpp"

#include <algorithm>
#include <iterator>

namespace axisc::codegen {
namespace {

std::size_t aligned(std::size_t size) {
  return (size + axim_alignment - 1) / axim_alignment * axim_alignment;
}

template <std::size_t Size>
std::array<std::uint8_t, Size> fixed_text(std::string_view text) {
  std::array<std::uint8_t, Size> octets{};
  std::transform(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(std::min(text.size(), Size)),
                 octets.begin(), [](char character) { return static_cast<std::uint8_t>(character); });
  return octets;
}

}  // namespace

TextRange TextPool::add(std::string_view text) {
  if (text.empty()) return {};
  TextRange const next{.offset = content_.count(), .size = static_cast<std::uint32_t>(text.size())};
  auto const [entry, is_new] = ranges_.try_emplace(std::string(text), next);
  if (is_new) {
    std::transform(text.begin(), text.end(), std::back_inserter(content_.bytes),
                   [](char character) { return static_cast<std::byte>(character); });
  }
  return entry->second;
}

std::vector<std::byte> assemble_image(ImageHeader const& header,
                                      std::span<SectionContent const* const> sections) {
  std::size_t const table_end = records::header::bytes + sections.size() * records::section::bytes;
  std::size_t total_size = aligned(table_end);
  for (SectionContent const* section : sections) total_size += aligned(section->bytes.size());
  std::vector<std::byte> image(total_size);
  std::span<std::byte> const bytes(image);

  std::size_t entry_offset = records::header::bytes;
  std::size_t offset = aligned(table_end);
  for (SectionContent const* section : sections) {
    Record<records::section> entry(bytes.subspan(entry_offset, records::section::bytes));
    entry.set(fields::section::kind, section->kind);
    entry.set(fields::section::flags, section->flags);
    entry.set(fields::section::offset, offset);
    entry.set(fields::section::size, section->bytes.size());
    entry.set(fields::section::element_size, section->element_size);
    entry.set(fields::section::count, section->count());
    std::copy(section->bytes.begin(), section->bytes.end(),
              bytes.begin() + static_cast<std::ptrdiff_t>(offset));
    entry_offset += records::section::bytes;
    offset += aligned(section->bytes.size());
  }

  Record<records::header> record(bytes.first(records::header::bytes));
  record.set(fields::header::magic, {'A', 'X', 'I', 'M'});
  record.set(fields::header::format_major, axim_major);
  record.set(fields::header::format_minor, header.format_minor);
  record.set(fields::header::header_size, records::header::bytes);
  record.set(fields::header::total_size, total_size);
  record.set(fields::header::section_count, static_cast<std::uint32_t>(sections.size()));
  record.set(fields::header::cycle_time_ns, header.cycle_time_ns);
  record.set(fields::header::axis_count, header.axis_count);
  record.set(fields::header::image_version, header.image_version);
  record.set(fields::header::source_digest, header.source_digest);
  record.set(fields::header::compiler_version, fixed_text<16>(header.compiler_version));
  // The header's checksum covers the payload's, its own field still being zero.
  record.set(fields::header::payload_checksum, axim_crc32c(bytes.subspan(table_end)));
  record.set(fields::header::header_checksum, axim_crc32c(bytes.first(table_end)));
  return image;
}

}  // namespace axisc::codegen
