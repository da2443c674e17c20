#include "codegen/aligned_bytes.hpp"
#include "image/image_records.hpp"

#include <algorithm>

namespace axisc::image {
namespace {

/// No records where the image has no such section.
template <class RecordType>
Records<RecordType> find(std::span<std::byte const> image, codegen::SectionKind<RecordType> wanted) {
  codegen::ConstRecord<codegen::records::header> const header(image);
  std::size_t const entries = header.get(codegen::fields::header::section_count);
  Records<codegen::records::section> const table(
      image.subspan(header.get(codegen::fields::header::header_size),
                    entries * codegen::records::section::bytes),
      codegen::records::section::bytes);
  for (std::uint32_t i = 0; i < table.count(); ++i) {
    if (table[i].get(codegen::fields::section::kind) != wanted.kind) continue;
    return {image.subspan(table[i].get(codegen::fields::section::offset),
                          table[i].get(codegen::fields::section::size)),
            table[i].get(codegen::fields::section::element_size)};
  }
  return {};
}

std::string compiler_version(codegen::ConstRecord<codegen::records::header> header) {
  auto const octets = header.get(codegen::fields::header::compiler_version);
  return {octets.begin(), std::find(octets.begin(), octets.end(), std::uint8_t{0})};
}

ImageAxis read_axis(ImageRecords const& image, codegen::ConstRecord<codegen::records::axis> record) {
  return {.name = image.text(record, codegen::fields::axis::name_offset, codegen::fields::axis::name_size),
          .number = record.get(codegen::fields::axis::number),
          .type = record.get(codegen::fields::axis::type),
          .filters = read_chain(image, record.get(codegen::fields::axis::first_filter),
                                record.get(codegen::fields::axis::filter_count)),
          .interface_filters = read_chain(image, record.get(codegen::fields::axis::first_interface_filter),
                                          record.get(codegen::fields::axis::interface_filter_count)),
          .slot = std::nullopt,
          .control = std::nullopt,
          .position_window = record.get(codegen::fields::axis::position_window),
          .velocity_limit = record.get(codegen::fields::axis::velocity_limit),
          .acceleration_limit = record.get(codegen::fields::axis::acceleration_limit),
          .delay_cycles = record.get(codegen::fields::axis::delay_cycles),
          .peak_gain = record.get(codegen::fields::axis::peak_gain),
          .values = {}};
}

ImageList read_list(ImageRecords const& image, codegen::ConstRecord<codegen::records::list> record) {
  return {.name = image.text(record, codegen::fields::list::name_offset, codegen::fields::list::name_size),
          .sha256 = record.get(codegen::fields::list::sha256)};
}

ImageValue read_value(ImageRecords const& image, codegen::ConstRecord<codegen::records::value> record) {
  codegen::ConstRecord<codegen::records::list> const list =
      image.lists[record.get(codegen::fields::value::list)];
  return {.name = image.text(record, codegen::fields::value::name_offset, codegen::fields::value::name_size),
          .value = image.text(record, codegen::fields::value::text_offset, codegen::fields::value::text_size),
          .list = image.text(list, codegen::fields::list::name_offset, codegen::fields::list::name_size),
          .line = record.get(codegen::fields::value::line)};
}

ImageContents read(ImageRecords const& image) {
  ImageContents contents;
  contents.format_major = image.header.get(codegen::fields::header::format_major);
  contents.format_minor = image.header.get(codegen::fields::header::format_minor);
  contents.size = image.header.get(codegen::fields::header::total_size);
  contents.cycle_time.nanoseconds = image.header.get(codegen::fields::header::cycle_time_ns);
  contents.image_version = image.header.get(codegen::fields::header::image_version);
  contents.compiler_version = compiler_version(image.header);
  contents.source_digest = image.header.get(codegen::fields::header::source_digest);
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
    contents.axes[image.slots[i].get(codegen::fields::slot::axis)].slot = read_slot(image.slots[i]);
  }
  for (std::uint32_t i = 0; i < image.controls.count(); ++i) {
    contents.axes[image.controls[i].get(codegen::fields::control::axis)].control =
        read_control(image, image.controls[i]);
  }
  for (std::uint32_t i = 0; i < image.lists.count(); ++i) {
    contents.lists.push_back(read_list(image, image.lists[i]));
  }
  for (std::uint32_t i = 0; i < image.values.count(); ++i) {
    contents.axes[image.values[i].get(codegen::fields::value::axis)].values.push_back(
        read_value(image, image.values[i]));
  }
  return contents;
}

}  // namespace

ImageRecords::ImageRecords(std::span<std::byte const> image)
    : header(image),
      axes(find(image, codegen::sections::axes)),
      filters(find(image, codegen::sections::filters)),
      coefficients(find(image, codegen::sections::coefficients)),
      kernels(find(image, codegen::sections::kernels)),
      tails(find(image, codegen::sections::tails)),
      slots(find(image, codegen::sections::slots)),
      groups(find(image, codegen::sections::groups)),
      members(find(image, codegen::sections::members)),
      banks(find(image, codegen::sections::banks)),
      choices(find(image, codegen::sections::choices)),
      controls(find(image, codegen::sections::controls)),
      stages(find(image, codegen::sections::stages)),
      names(find(image, codegen::sections::names)),
      self_tests(find(image, codegen::sections::self_tests)),
      lists(find(image, codegen::sections::lists)),
      values(find(image, codegen::sections::values)) {}

std::string ImageRecords::text(std::uint32_t offset, std::uint32_t size) const {
  auto const octets = names.bytes().subspan(offset, size);
  std::string characters(octets.size(), '\0');
  std::transform(octets.begin(), octets.end(), characters.begin(),
                 [](std::byte octet) { return static_cast<char>(octet); });
  return characters;
}

std::variant<ImageContents, axisrt_status> read_image(std::span<std::byte const> bytes) {
  // A vector's bytes need not lie at a multiple of 64.
  codegen::AlignedBytes const image(bytes);
  if (axisrt_status const status = axisrt_verify(image.data(), image.size()); status != AXISRT_OK) {
    return status;
  }
  return read(ImageRecords(image.bytes()));
}

}  // namespace axisc::image
