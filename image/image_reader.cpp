#include "codegen/aligned_bytes.hpp"
#include "image/image_records.hpp"

#include <algorithm>

namespace axisc::image {
namespace {

/// No records where the image has no such section.
template <class RecordType>
Records<RecordType> find(std::span<std::byte const> image, SectionKind<RecordType> wanted) {
  ConstRecord<records::header> const header(image);
  std::size_t const entries = header.get(fields::header::section_count);
  Records<records::section> const table(
      image.subspan(header.get(fields::header::header_size), entries * records::section::bytes),
      records::section::bytes);
  for (std::uint32_t i = 0; i < table.count(); ++i) {
    if (table[i].get(fields::section::kind) != wanted.kind) continue;
    return {image.subspan(table[i].get(fields::section::offset), table[i].get(fields::section::size)),
            table[i].get(fields::section::element_size)};
  }
  return {};
}

std::string compiler_version(ConstRecord<records::header> header) {
  auto const octets = header.get(fields::header::compiler_version);
  return {octets.begin(), std::find(octets.begin(), octets.end(), std::uint8_t{0})};
}

ImageAxis read_axis(ImageRecords const& image, ConstRecord<records::axis> record) {
  return {.name = image.text(record, fields::axis::name_offset, fields::axis::name_size),
          .number = record.get(fields::axis::number),
          .type = record.get(fields::axis::type),
          .filters = read_chain(image, record.get(fields::axis::first_filter),
                                record.get(fields::axis::filter_count)),
          .interface_filters = read_chain(image, record.get(fields::axis::first_interface_filter),
                                          record.get(fields::axis::interface_filter_count)),
          .slot = std::nullopt,
          .control = std::nullopt,
          .position_window = record.get(fields::axis::position_window),
          .velocity_limit = record.get(fields::axis::velocity_limit),
          .acceleration_limit = record.get(fields::axis::acceleration_limit),
          .delay_cycles = record.get(fields::axis::delay_cycles),
          .peak_gain = record.get(fields::axis::peak_gain),
          .values = {}};
}

ImageList read_list(ImageRecords const& image, ConstRecord<records::list> record) {
  return {.name = image.text(record, fields::list::name_offset, fields::list::name_size),
          .sha256 = record.get(fields::list::sha256)};
}

ImageValue read_value(ImageRecords const& image, ConstRecord<records::value> record) {
  ConstRecord<records::list> const list = image.lists[record.get(fields::value::list)];
  return {.name = image.text(record, fields::value::name_offset, fields::value::name_size),
          .value = image.text(record, fields::value::text_offset, fields::value::text_size),
          .list = image.text(list, fields::list::name_offset, fields::list::name_size),
          .line = record.get(fields::value::line)};
}

ImageContents read(ImageRecords const& image) {
  ImageContents contents;
  contents.format_major = image.header.get(fields::header::format_major);
  contents.format_minor = image.header.get(fields::header::format_minor);
  contents.size = image.header.get(fields::header::total_size);
  contents.cycle_time.nanoseconds = image.header.get(fields::header::cycle_time_ns);
  contents.image_version = image.header.get(fields::header::image_version);
  contents.compiler_version = compiler_version(image.header);
  contents.source_digest = image.header.get(fields::header::source_digest);
  for (std::uint32_t i = 0; i < image.axes.count(); ++i) {
    contents.axes.push_back(read_axis(image, image.axes[i]));
  }
  for (std::uint32_t i = 0; i < image.kernels.count(); ++i) {
    contents.kernels.push_back(read_kernel(image, image.kernels[i]));
  }
  for (std::uint32_t i = 0; i < image.groups.count(); ++i) {
    contents.groups.push_back(read_group(image, image.groups[i]));
  }
  for (std::uint32_t i = 0; i < image.slots.count(); ++i) {
    contents.axes[image.slots[i].get(fields::slot::axis)].slot = read_slot(image.slots[i]);
  }
  for (std::uint32_t i = 0; i < image.controls.count(); ++i) {
    contents.axes[image.controls[i].get(fields::control::axis)].control =
        read_control(image, image.controls[i]);
  }
  for (std::uint32_t i = 0; i < image.lists.count(); ++i) {
    contents.lists.push_back(read_list(image, image.lists[i]));
  }
  for (std::uint32_t i = 0; i < image.values.count(); ++i) {
    contents.axes[image.values[i].get(fields::value::axis)].values.push_back(
        read_value(image, image.values[i]));
  }
  return contents;
}

}  // namespace

ImageRecords::ImageRecords(std::span<std::byte const> image)
    : header(image),
      axes(find(image, sections::axes)),
      filters(find(image, sections::filters)),
      coefficients(find(image, sections::coefficients)),
      kernels(find(image, sections::kernels)),
      tails(find(image, sections::tails)),
      slots(find(image, sections::slots)),
      groups(find(image, sections::groups)),
      members(find(image, sections::members)),
      banks(find(image, sections::banks)),
      choices(find(image, sections::choices)),
      controls(find(image, sections::controls)),
      stages(find(image, sections::stages)),
      names(find(image, sections::names)),
      self_tests(find(image, sections::self_tests)),
      lists(find(image, sections::lists)),
      values(find(image, sections::values)) {}

std::string ImageRecords::text(std::uint32_t offset, std::uint32_t size) const {
  auto const octets = names.bytes().subspan(offset, size);
  std::string characters(octets.size(), '\0');
  std::transform(octets.begin(), octets.end(), characters.begin(),
                 [](std::byte octet) { return static_cast<char>(octet); });
  return characters;
}

std::variant<ImageContents, axisrt_status> read_image(std::span<std::byte const> bytes) {
  // A vector's bytes need not lie at a multiple of 64.
  AlignedBytes const image(bytes);
  if (axisrt_status const status = axisrt_verify(image.data(), image.size()); status != AXISRT_OK) {
    return status;
  }
  return read(ImageRecords(image.bytes()));
}

}  // namespace axisc::image
