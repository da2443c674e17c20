#include "codegen/aligned_bytes.hpp"
#include "codegen/image_contents.hpp"
#include "codegen/image_fields.hpp"
#include "codegen/record.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>

namespace axisc::codegen {
namespace {

/// Records of one section. A higher minor version may have longer ones; what is known stands at their
/// beginning.
template <class RecordType>
class Records {
 public:
  Records() = default;
  Records(std::span<std::byte const> bytes, std::size_t stride) : bytes_(bytes), stride_(stride) {}

  [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(bytes_.size() / stride_); }
  [[nodiscard]] ConstRecord<RecordType> operator[](std::size_t i) const {
    return ConstRecord<RecordType>(bytes_.subspan(i * stride_, stride_));
  }
  [[nodiscard]] std::span<std::byte const> bytes() const { return bytes_; }

 private:
  std::span<std::byte const> bytes_;
  std::size_t stride_ = RecordType::bytes;
};

/// Reads an image that axisrt_verify accepts, so that every range lies in its section.
class ImageReader {
 public:
  explicit ImageReader(std::span<std::byte const> image)
      : image_(image),
        header_(image),
        axes_(find(sections::axes)),
        filters_(find(sections::filters)),
        coefficients_(find(sections::coefficients)),
        names_(find(sections::names)),
        self_tests_(find(sections::self_tests)),
        lists_(find(sections::lists)),
        values_(find(sections::values)) {}

  [[nodiscard]] ImageContents read() const {
    ImageContents contents;
    contents.format_major = header_.get(fields::header::format_major);
    contents.format_minor = header_.get(fields::header::format_minor);
    contents.size = header_.get(fields::header::total_size);
    contents.cycle_time.nanoseconds = header_.get(fields::header::cycle_time_ns);
    contents.image_version = header_.get(fields::header::image_version);
    contents.compiler_version = compiler_version();
    contents.source_digest = header_.get(fields::header::source_digest);
    for (std::uint32_t i = 0; i < axes_.count(); ++i) contents.axes.push_back(axis(axes_[i]));
    for (std::uint32_t i = 0; i < lists_.count(); ++i) contents.lists.push_back(list(lists_[i]));
    for (std::uint32_t i = 0; i < values_.count(); ++i) {
      contents.axes[values_[i].get(fields::value::axis)].values.push_back(value(values_[i]));
    }
    return contents;
  }

 private:
  /// No records where the image has no such section.
  template <class RecordType>
  [[nodiscard]] Records<RecordType> find(SectionKind<RecordType> wanted) const {
    std::size_t const entries = header_.get(fields::header::section_count);
    Records<records::section> const table(
        image_.subspan(header_.get(fields::header::header_size), entries * records::section::bytes),
        records::section::bytes);
    for (std::uint32_t i = 0; i < table.count(); ++i) {
      if (table[i].get(fields::section::kind) != wanted.kind) continue;
      return {image_.subspan(table[i].get(fields::section::offset), table[i].get(fields::section::size)),
              table[i].get(fields::section::element_size)};
    }
    return {};
  }

  [[nodiscard]] std::string compiler_version() const {
    auto const octets = header_.get(fields::header::compiler_version);
    return {octets.begin(), std::find(octets.begin(), octets.end(), std::uint8_t{0})};
  }

  template <class RecordType>
  [[nodiscard]] std::string text(ConstRecord<RecordType> record, Field<RecordType, std::uint32_t> offset,
                                 Field<RecordType, std::uint32_t> size) const {
    auto const octets = names_.bytes().subspan(record.get(offset), record.get(size));
    std::string characters(octets.size(), '\0');
    std::transform(octets.begin(), octets.end(), characters.begin(),
                   [](std::byte octet) { return static_cast<char>(octet); });
    return characters;
  }

  [[nodiscard]] ImageAxis axis(ConstRecord<records::axis> record) const {
    return {.name = text(record, fields::axis::name_offset, fields::axis::name_size),
            .number = record.get(fields::axis::number),
            .type = record.get(fields::axis::type),
            .filters = chain(record.get(fields::axis::first_filter), record.get(fields::axis::filter_count)),
            .interface_filters = chain(record.get(fields::axis::first_interface_filter),
                                       record.get(fields::axis::interface_filter_count)),
            .position_window = record.get(fields::axis::position_window),
            .velocity_limit = record.get(fields::axis::velocity_limit),
            .acceleration_limit = record.get(fields::axis::acceleration_limit),
            .delay_cycles = record.get(fields::axis::delay_cycles),
            .peak_gain = record.get(fields::axis::peak_gain),
            .values = {}};
  }

  [[nodiscard]] std::vector<ImageFilter> chain(std::uint32_t first, std::uint32_t count) const {
    std::vector<ImageFilter> filters;
    filters.reserve(count);
    for (std::uint32_t i = 0; i < count; ++i) filters.push_back(filter(filters_[first + i]));
    return filters;
  }

  [[nodiscard]] ImageFilter filter(ConstRecord<records::filter> record) const {
    ImageFilter filter{.index = record.get(fields::filter::index),
                       .specification = specification(record),
                       .design = design(record),
                       .peak_gain = record.get(fields::filter::peak_gain),
                       .overshoot = record.get(fields::filter::overshoot),
                       .kernel_sum = record.get(fields::filter::kernel_sum),
                       .self_test_input = {},
                       .self_test_output = {}};
    std::uint32_t const first = record.get(fields::filter::first_sample);
    std::uint32_t const count = record.get(fields::filter::sample_count);
    for (std::uint32_t i = 0; i < count; ++i) {
      filter.self_test_input.push_back(self_tests_[first + i].get(fields::sample::input));
      filter.self_test_output.push_back(self_tests_[first + i].get(fields::sample::output));
    }
    return filter;
  }

  [[nodiscard]] static design::FilterSpecification specification(ConstRecord<records::filter> record) {
    return {.type = static_cast<design::FilterType>(record.get(fields::filter::type)),
            .prototype = static_cast<design::Prototype>(record.get(fields::filter::prototype)),
            .order = record.get(fields::filter::order),
            .frequency = {record.get(fields::filter::frequency)},
            .quality = record.get(fields::filter::quality),
            .time_constant = {record.get(fields::filter::time_constant)},
            .share_percent = record.get(fields::filter::share_percent)};
  }

  [[nodiscard]] design::FilterDesign design(ConstRecord<records::filter> record) const {
    design::FilterDesign design;
    design.realisation = static_cast<design::Realisation>(record.get(fields::filter::realisation));
    design.sections =
        cascade(record.get(fields::filter::first_section), record.get(fields::filter::section_count));
    design.blocks_constant = record.get(fields::filter::blocks_constant) != 0;
    design.delay_cycles = record.get(fields::filter::delay_cycles);
    design.share = {.filtered = record.get(fields::filter::share),
                    .direct = record.get(fields::filter::direct),
                    .direct_low = record.get(fields::filter::direct_low)};
    design.pole_radius = record.get(fields::filter::pole_radius);
    design.dc_gain = record.get(fields::filter::dc_gain);
    design.group_delay_cycles = record.get(fields::filter::group_delay);
    return design;
  }

  [[nodiscard]] std::vector<design::IncrementSection> cascade(std::uint32_t first,
                                                              std::uint32_t count) const {
    std::vector<design::IncrementSection> sections;
    sections.reserve(count);
    for (std::uint32_t i = 0; i < count; ++i) {
      ConstRecord<records::coefficients> const record = coefficients_[first + i];
      sections.push_back({.p = record.get(fields::coefficients::p),
                          .q = record.get(fields::coefficients::q),
                          .k = record.get(fields::coefficients::k),
                          .b = record.get(fields::coefficients::b)});
    }
    return sections;
  }

  [[nodiscard]] ImageList list(ConstRecord<records::list> record) const {
    return {.name = text(record, fields::list::name_offset, fields::list::name_size),
            .sha256 = record.get(fields::list::sha256)};
  }

  [[nodiscard]] ImageValue value(ConstRecord<records::value> record) const {
    ConstRecord<records::list> const list = lists_[record.get(fields::value::list)];
    return {.name = text(record, fields::value::name_offset, fields::value::name_size),
            .value = text(record, fields::value::text_offset, fields::value::text_size),
            .list = text(list, fields::list::name_offset, fields::list::name_size),
            .line = record.get(fields::value::line)};
  }

  std::span<std::byte const> image_;
  ConstRecord<records::header> header_;
  Records<records::axis> axes_;
  Records<records::filter> filters_;
  Records<records::coefficients> coefficients_;
  Records<records::byte> names_;
  Records<records::sample> self_tests_;
  Records<records::list> lists_;
  Records<records::value> values_;
};

}  // namespace

std::variant<ImageContents, axisrt_status> read_image(std::span<std::byte const> bytes) {
  // A vector's bytes need not lie at a multiple of 64.
  AlignedBytes const image(bytes);
  if (axisrt_status const status = axisrt_verify(image.data(), image.size()); status != AXISRT_OK) {
    return status;
  }
  return ImageReader(image.bytes()).read();
}

}  // namespace axisc::codegen
