#include "image/stripped_image.hpp"

#include "codegen/image_layout.hpp"

#include <algorithm>
#include <initializer_list>
#include <string>

namespace axisc::image {
namespace {

using codegen::ConstRecord;
using codegen::SectionContent;
namespace fields = codegen::fields;
namespace records = codegen::records;

template <class RecordType>
using NumberFields = std::initializer_list<codegen::Field<RecordType, std::uint32_t>>;

template <class RecordType>
void clear(codegen::SectionKind<RecordType> kind, SectionContent& section,
           NumberFields<RecordType> to_clear) {
  if (section.kind != kind.kind) return;
  for (std::size_t at = 0; at < section.bytes.size(); at += section.element_size) {
    codegen::Record<RecordType> record(std::span(section.bytes).subspan(at, RecordType::bytes));
    for (auto const field : to_clear) record.set(field, 0);
  }
}

SectionContent section_of(std::span<std::byte const> image, ConstRecord<records::section> entry) {
  auto const content = image.subspan(static_cast<std::size_t>(entry.get(fields::section::offset)),
                                     static_cast<std::size_t>(entry.get(fields::section::size)));
  return {.kind = entry.get(fields::section::kind),
          .flags = entry.get(fields::section::flags),
          .element_size = entry.get(fields::section::element_size),
          .bytes = {content.begin(), content.end()}};
}

/// Places in sections that a stripped image does not have.
void clear_references(SectionContent& section) {
  clear(codegen::sections::axes, section, {fields::axis::name_offset, fields::axis::name_size});
  clear(codegen::sections::groups, section, {fields::group::name_offset, fields::group::name_size});
  clear(codegen::sections::filters, section, {fields::filter::first_sample, fields::filter::sample_count});
  clear(codegen::sections::kernels, section, {fields::kernel::first_sample, fields::kernel::sample_count});
}

}  // namespace

std::vector<std::byte> stripped_image(std::span<std::byte const> image) {
  ConstRecord<records::header> const header(image.first(records::header::bytes));
  std::vector<SectionContent> kept;
  for (std::uint32_t i = 0; i < header.get(fields::header::section_count); ++i) {
    auto const at = header.get(fields::header::header_size) + i * records::section::bytes;
    SectionContent section =
        section_of(image, ConstRecord<records::section>(image.subspan(at, records::section::bytes)));
    bool const is_dropped =
        (section.flags & axim_flag_optional) != 0 && section.kind != codegen::sections::bounds.kind;
    if (is_dropped) continue;
    clear_references(section);
    kept.push_back(std::move(section));
  }
  std::vector<SectionContent const*> sections;
  sections.reserve(kept.size());
  for (auto const& section : kept) sections.push_back(&section);
  auto const octets = header.get(fields::header::compiler_version);
  std::string const compiler(octets.begin(), octets.end());
  return codegen::assemble_image({.format_minor = header.get(fields::header::format_minor),
                                  .cycle_time_ns = header.get(fields::header::cycle_time_ns),
                                  .axis_count = header.get(fields::header::axis_count),
                                  .image_version = header.get(fields::header::image_version),
                                  .source_digest = header.get(fields::header::source_digest),
                                  .compiler_version = compiler},
                                 sections);
}

}  // namespace axisc::image
