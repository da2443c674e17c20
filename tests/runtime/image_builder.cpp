#include "runtime/image_builder.hpp"

#include "runtime/section_writer.hpp"

#include <bit>
#include <stdexcept>
#include <utility>

namespace axisc::test {
namespace {

constexpr std::size_t header_size = 128;
constexpr std::size_t entry_size = 32;

void append_coefficients(SectionWriter& coefficients, SectionRecord const& section) {
  ByteWriter& out = coefficients.out();
  out.f64(section.p);
  out.f64(section.q);
  out.f64(section.k);
  out.f64(section.b);
  coefficients.end_record();
}

void append_axis(Sections& to, AxisRecord const& axis, std::uint32_t index, bool strip) {
  auto const [name_offset, name_size] = strip ? std::pair{0U, 0U} : append_text(to.names, axis.name);
  ByteWriter& out = to.axes.out();
  std::uint32_t const first_filter = to.filters.section.count;
  auto const filter_count = static_cast<std::uint32_t>(axis.filters.size());
  out.u32(name_offset);
  out.u32(name_size);
  out.u32(axis.number);
  out.u32(axis.type);
  out.u32(axis.type == 1 ? 0 : 1);  // position unit
  out.u32(first_filter);
  out.u32(filter_count);
  out.u32(first_filter + filter_count);
  out.u32(static_cast<std::uint32_t>(axis.interface_filters.size()));
  out.u32(0);
  out.f64(axis.position_window);
  out.f64(axis.velocity_limit);
  out.f64(axis.acceleration_limit);
  out.f64(axis.peak_gain);
  out.f64(0);  // delay
  out.zeros(48);
  to.axes.end_record();
  for (FilterRecord const& filter : axis.filters) append_filter(to, filter, index, 0, strip);
  for (FilterRecord const& filter : axis.interface_filters) append_filter(to, filter, index, 1, strip);
}

/// One list, and one value of each axis from it.
void append_source_map(Sections& to, ImageRecord const& image) {
  auto const [list_offset, list_size] = append_text(to.names, "x.lis");
  ByteWriter& list = to.lists.out();
  list.u32(list_offset);
  list.u32(list_size);
  list.u32(0);
  list.u32(0);
  for (std::uint8_t octet = 0; octet < 32; ++octet) list.bytes.push_back(octet);
  list.zeros(16);
  to.lists.end_record();
  for (std::uint32_t axis = 0; axis < image.axes.size(); ++axis) {
    auto const [name_offset, name_size] = append_text(to.names, "filter[0].order");
    auto const [text_offset, text_size] = append_text(to.names, "2");
    ByteWriter& value = to.values.out();
    value.u32(axis);
    value.u32(0);
    value.u32(axis + 1);
    value.u32(name_offset);
    value.u32(name_size);
    value.u32(text_offset);
    value.u32(text_size);
    value.u32(0);
    to.values.end_record();
  }
}

Bytes assemble(ImageRecord const& image, std::vector<SectionBytes const*> const& sections) {
  ByteWriter out;
  std::size_t const directory_end = header_size + sections.size() * entry_size;
  out.text("AXIM");
  out.u16(1);
  out.u16(image.format_minor);
  out.u32(header_size);
  out.u32(0);  // header checksum
  out.u64(0);  // total size
  out.u32(0);  // payload checksum
  out.u32(static_cast<std::uint32_t>(sections.size()));
  out.u32(image.cycle_time_ns);
  out.u32(static_cast<std::uint32_t>(image.axes.size()));
  out.u32(7);  // image version
  out.u32(0);
  for (std::uint8_t octet = 0; octet < 32; ++octet) out.bytes.push_back(octet);
  out.text("0.0.0-naive");
  out.zeros(5);
  out.zeros(32);

  std::size_t offset = (directory_end + 63) / 64 * 64;
  for (SectionBytes const* section : sections) {
    out.u32(section->kind);
    out.u32(section->flags);
    out.u64(offset);
    out.u64(section->content.bytes.size());
    out.u32(section->element_size);
    out.u32(section->count);
    offset += (section->content.bytes.size() + 63) / 64 * 64;
  }
  for (SectionBytes const* section : sections) {
    out.align(64);
    out.bytes.insert(out.bytes.end(), section->content.bytes.begin(), section->content.bytes.end());
  }
  out.align(64);
  poke(out.bytes, 16, out.bytes.size(), 8);
  repair_checksums(out.bytes);
  return out.bytes;
}

}  // namespace

void append_sample(SectionWriter& samples, SampleRecord const& sample) {
  samples.out().f64(sample.input);
  samples.out().f64(sample.output);
  samples.end_record();
}

void append_filter(Sections& to, FilterRecord const& filter, std::uint32_t axis, std::uint32_t port,
                   bool strip) {
  ByteWriter& out = to.filters.out();
  out.u32(axis);
  out.u32(port);
  out.u32(filter.index);
  out.u32(filter.realisation);
  out.u32(filter.activation);
  out.u32(filter.blocks_constant);
  out.u32(to.coefficients.section.count);
  out.u32(static_cast<std::uint32_t>(filter.sections.size()));
  out.u32(filter.delay_cycles);
  out.u32(filter.type);
  out.u32(filter.prototype);
  out.u32(2);  // order
  out.f64(filter.share);
  out.f64(filter.direct);
  out.f64(filter.direct_low);
  out.f64(30);                  // frequency
  out.f64(1);                   // quality
  out.f64(10000);               // time constant
  out.f64(filter.share * 100);  // share in percent
  double const gain_at_zero = filter.blocks_constant != 0 ? filter.direct : 1;
  for (double const proof : {0.9, gain_at_zero, 2.0, 1.0, 1.0, 0.0}) out.f64(proof);
  bool const tested = !strip && !filter.samples.empty();
  out.u32(tested ? to.samples.section.count : 0);
  out.u32(tested ? static_cast<std::uint32_t>(filter.samples.size()) : 0);
  out.zeros(32);
  to.filters.end_record();
  for (SectionRecord const& section : filter.sections) append_coefficients(to.coefficients, section);
  if (tested) {
    for (SampleRecord const& sample : filter.samples) append_sample(to.samples, sample);
  }
}

std::pair<std::uint32_t, std::uint32_t> append_text(SectionWriter& names, std::string const& text) {
  std::uint32_t const offset = names.section.count;
  for (char const letter : text) {
    names.out().text(std::string(1, letter));
    names.end_record();
  }
  return {offset, static_cast<std::uint32_t>(text.size())};
}

void ByteWriter::number(std::uint64_t value, int size) {
  for (int i = 0; i < size; ++i) bytes.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
}

void ByteWriter::f64(double value) {
  u64(std::bit_cast<std::uint64_t>(value));
}

void poke(Bytes& bytes, std::size_t offset, std::uint64_t value, int size) {
  for (int i = 0; i < size; ++i) {
    bytes.at(offset + static_cast<std::size_t>(i)) = static_cast<std::uint8_t>(value >> (8 * i));
  }
}

void poke_f64(Bytes& bytes, std::size_t offset, double value) {
  poke(bytes, offset, std::bit_cast<std::uint64_t>(value), 8);
}

std::uint64_t peek(Bytes const& bytes, std::size_t offset, int size) {
  std::uint64_t value = 0;
  for (int i = size - 1; i >= 0; --i) value = value << 8U | bytes.at(offset + static_cast<std::size_t>(i));
  return value;
}

std::uint32_t naive_crc32c(std::uint8_t const* bytes, std::size_t size) {
  std::uint32_t crc = 0xFFFFFFFF;
  for (std::size_t i = 0; i < size; ++i) {
    crc ^= bytes[i];
    for (int bit = 0; bit < 8; ++bit) crc = (crc & 1U) != 0 ? crc >> 1U ^ 0x82F63B78U : crc >> 1U;
  }
  return ~crc;
}

Bytes write_image(ImageRecord const& image) {
  Sections sections(image);
  for (std::uint32_t i = 0; i < image.axes.size(); ++i) append_axis(sections, image.axes[i], i, image.strip);
  append_kernels_and_controls(sections, image);
  if (!image.strip) append_source_map(sections, image);

  std::vector<SectionBytes const*> parts{&sections.axes.section, &sections.filters.section,
                                         &sections.coefficients.section};
  for (SectionWriter const* writer :
       {&sections.kernels, &sections.tails, &sections.slots, &sections.groups, &sections.members,
        &sections.banks, &sections.choices, &sections.controls, &sections.stages}) {
    if (writer->count() > 0) parts.push_back(&writer->section);
  }
  if (!image.strip) {
    parts.insert(parts.end(), {&sections.names.section, &sections.samples.section, &sections.lists.section,
                               &sections.values.section});
  }
  SectionBytes foreign;
  if (image.foreign) {
    foreign.kind = image.foreign->kind;
    foreign.flags = image.foreign->flags;
    foreign.element_size = image.foreign->element_size;
    foreign.count = static_cast<std::uint32_t>(image.foreign->content.size()) / foreign.element_size;
    foreign.content.bytes = image.foreign->content;
    parts.push_back(&foreign);
  }
  return assemble(image, parts);
}

void repair_checksums(Bytes& bytes) {
  if (bytes.size() < header_size) return;
  std::uint64_t const directory_end = peek(bytes, 8, 4) + peek(bytes, 28, 4) * entry_size;
  if (directory_end > bytes.size()) return;
  auto const payload = static_cast<std::size_t>(directory_end);
  poke(bytes, 24, naive_crc32c(bytes.data() + payload, bytes.size() - payload), 4);
  poke(bytes, 12, 0, 4);
  poke(bytes, 12, naive_crc32c(bytes.data(), payload), 4);
}

std::size_t entry_offset(Bytes const& bytes, std::uint32_t kind) {
  for (std::size_t i = 0; i < peek(bytes, 28, 4); ++i) {
    std::size_t const entry = header_size + i * entry_size;
    if (peek(bytes, entry, 4) == kind) return entry;
  }
  throw std::logic_error("no such section");
}

std::size_t section_offset(Bytes const& bytes, std::uint32_t kind) {
  return static_cast<std::size_t>(peek(bytes, entry_offset(bytes, kind) + 8, 8));
}

void set_share(FilterRecord& filter, double share) {
  filter.share = share;
  filter.direct = 1 - share;
  filter.direct_low = (1 - filter.direct) - share;
}

}  // namespace axisc::test
