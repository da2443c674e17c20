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
        kernels_(find(sections::kernels)),
        tails_(find(sections::tails)),
        slots_(find(sections::slots)),
        groups_(find(sections::groups)),
        members_(find(sections::members)),
        banks_(find(sections::banks)),
        choices_(find(sections::choices)),
        controls_(find(sections::controls)),
        stages_(find(sections::stages)),
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
    for (std::uint32_t i = 0; i < kernels_.count(); ++i) contents.kernels.push_back(kernel(kernels_[i]));
    for (std::uint32_t i = 0; i < groups_.count(); ++i) contents.groups.push_back(group(groups_[i]));
    for (std::uint32_t i = 0; i < slots_.count(); ++i) {
      contents.axes[slots_[i].get(fields::slot::axis)].slot = slot(slots_[i]);
    }
    for (std::uint32_t i = 0; i < controls_.count(); ++i) {
      contents.axes[controls_[i].get(fields::control::axis)].control = control(controls_[i]);
    }
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
            .slot = std::nullopt,
            .control = std::nullopt,
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
    read_samples(record.get(fields::filter::first_sample), record.get(fields::filter::sample_count), filter);
    return filter;
  }

  template <class Tested>
  void read_samples(std::uint32_t first, std::uint32_t count, Tested& tested) const {
    for (std::uint32_t i = 0; i < count; ++i) {
      tested.self_test_input.push_back(self_tests_[first + i].get(fields::sample::input));
      tested.self_test_output.push_back(self_tests_[first + i].get(fields::sample::output));
    }
  }

  [[nodiscard]] ImageKernel kernel(ConstRecord<records::kernel> record) const {
    ImageKernel kernel{
        .specification = {.type = static_cast<design::KernelType>(record.get(fields::kernel::type)),
                          .order = record.get(fields::kernel::order),
                          .frequency = {record.get(fields::kernel::frequency)},
                          .quality = record.get(fields::kernel::quality),
                          .share_percent = record.get(fields::kernel::share_percent)},
        .design = {},
        .peak_gain = record.get(fields::kernel::peak_gain),
        .overshoot = record.get(fields::kernel::overshoot),
        .tail_gain = record.get(fields::kernel::tail_gain),
        .self_test_input = {},
        .self_test_output = {}};
    kernel.design.half_width = record.get(fields::kernel::half_width);
    kernel.design.delay_cycles = record.get(fields::kernel::delay_cycles);
    kernel.design.group_delay_cycles = record.get(fields::kernel::group_delay);
    kernel.design.kernel_sum = record.get(fields::kernel::kernel_sum);
    double before = 1;
    kernel.design.taps.clear();
    for (std::uint32_t i = 0; i < record.get(fields::kernel::tail_count); ++i) {
      double const tail = tails_[record.get(fields::kernel::first_tail) + i].get(fields::tail::value);
      kernel.design.tail_sums.push_back(tail);
      kernel.design.taps.push_back(before - tail);
      before = tail;
    }
    kernel.design.taps.push_back(before);
    read_samples(record.get(fields::kernel::first_sample), record.get(fields::kernel::sample_count), kernel);
    return kernel;
  }

  static std::optional<std::size_t> optional_index(std::uint32_t index) {
    return index == AXIM_NONE ? std::nullopt : std::optional<std::size_t>(index);
  }

  [[nodiscard]] static ImageSlot slot(ConstRecord<records::slot> record) {
    return {.family = static_cast<validator::KernelFamily>(record.get(fields::slot::family)),
            .index = record.get(fields::slot::index),
            .kernel = optional_index(record.get(fields::slot::kernel)),
            .on_at_start = record.get(fields::slot::on_at_start) != 0,
            .group = optional_index(record.get(fields::slot::group))};
  }

  [[nodiscard]] ImageGroup group(ConstRecord<records::group> record) const {
    ImageGroup group{.name = text(record, fields::group::name_offset, fields::group::name_size),
                     .members = {},
                     .banks = {},
                     .off_fade_cycles = record.get(fields::group::off_fade_cycles)};
    std::uint32_t const members = record.get(fields::group::member_count);
    for (std::uint32_t i = 0; i < members; ++i) {
      group.members.push_back(
          members_[record.get(fields::group::first_member) + i].get(fields::member::axis));
    }
    for (std::uint32_t i = 0; i < record.get(fields::group::bank_count); ++i) {
      group.banks.push_back(bank(banks_[record.get(fields::group::first_bank) + i], members));
    }
    return group;
  }

  [[nodiscard]] ImageBank bank(ConstRecord<records::bank> record, std::uint32_t members) const {
    std::uint32_t const keywords = record.get(fields::bank::keywords);
    ImageBank bank;
    if ((keywords & axim_keyword_order) != 0) bank.parameters.order = record.get(fields::bank::order);
    if ((keywords & axim_keyword_share) != 0) bank.parameters.share_percent = record.get(fields::bank::share);
    if ((keywords & axim_keyword_fcut) != 0) {
      bank.parameters.frequency = design::Hertz{record.get(fields::bank::frequency)};
    }
    if ((keywords & axim_keyword_quality) != 0) bank.parameters.quality = record.get(fields::bank::quality);
    bank.hsc = (keywords & axim_keyword_hsc) != 0;
    bank.fade_cycles = record.get(fields::bank::fade_cycles);
    for (std::uint32_t i = 0; i < members; ++i) {
      bank.kernels.push_back(
          optional_index(choices_[record.get(fields::bank::first_choice) + i].get(fields::choice::kernel)));
    }
    return bank;
  }

  [[nodiscard]] ImageControl control(ConstRecord<records::control> record) const {
    ImageControl control{.source = record.get(fields::control::source),
                         .stages = {},
                         .scaling = {.controller = static_cast<validator::PositionController>(
                                         record.get(fields::control::controller)),
                                     .v_reso_num = record.get(fields::control::v_reso_num),
                                     .v_reso_denom = record.get(fields::control::v_reso_denom),
                                     .time_base = record.get(fields::control::time_base),
                                     .multi_gain_z = record.get(fields::control::multi_gain_z),
                                     .multi_gain_n = record.get(fields::control::multi_gain_n)},
                         .limit = record.get(fields::control::limit),
                         .limit_factor = record.get(fields::control::limit_factor),
                         .increments_per_velocity = record.get(fields::control::scale)};
    for (std::uint32_t i = 0; i < record.get(fields::control::stage_count); ++i) {
      control.stages.push_back(stage(stages_[record.get(fields::control::first_stage) + i]));
    }
    return control;
  }

  [[nodiscard]] ImageStage stage(ConstRecord<records::stage> record) const {
    std::uint32_t const first_filter = record.get(fields::stage::first_filter);
    return {.index = record.get(fields::stage::index),
            .mode = static_cast<validator::StageMode>(record.get(fields::stage::mode)),
            .has_oscillator = filters_[first_filter].get(fields::filter::type) == 0,
            .weight = record.get(fields::stage::weight),
            .weight_numerator = record.get(fields::stage::weight_numerator),
            .weight_denominator = record.get(fields::stage::weight_denominator),
            .filters = chain(first_filter, record.get(fields::stage::filter_count))};
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
  Records<records::kernel> kernels_;
  Records<records::tail> tails_;
  Records<records::slot> slots_;
  Records<records::group> groups_;
  Records<records::member> members_;
  Records<records::bank> banks_;
  Records<records::choice> choices_;
  Records<records::control> controls_;
  Records<records::stage> stages_;
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
