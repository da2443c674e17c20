#include "naive_image.hpp"

#include "design/filter_analysis.hpp"
#include "design/filter_design.hpp"
#include "design/oscillator.hpp"
#include "naive_bytes.hpp"
#include "naive_kernels.hpp"

#include <algorithm>
#include <array>
#include <sodium/crypto_hash_sha256.h>
#include <string>

namespace axisc::test {
namespace {

using Bytes = NaiveBytes;
using design::FilterDesign;

std::array<unsigned char, 32> hash_of(std::string const& text) {
  std::array<unsigned char, 32> hash{};
  crypto_hash_sha256(hash.data(), reinterpret_cast<unsigned char const*>(text.data()), text.size());
  return hash;
}

std::string digest_input(machine::Machine const& machine) {
  std::string input;
  for (auto const& list : machine.lists) {
    input += list.name + '\0';
    for (std::size_t i = 0; i < 8; ++i) input += static_cast<char>(list.content.size() >> (8 * i) & 0xFF);
    input += list.content;
  }
  return input;
}

/// y = H x in 100 digits with the textbook's direct form, whose coefficients follow exactly from the stored
/// ones.
std::vector<Wide> direct_form(design::IncrementSection const& section, bool blocks_constant,
                              std::vector<Wide> const& x) {
  Wide const a2 = 1 - Wide(section.b);
  Wide const a1 = Wide(section.k) + section.b - 2;
  Wide const b0 = blocks_constant ? Wide(section.p) : 1 + Wide(section.p);
  Wide const b1 = Wide(section.q) - section.p + (blocks_constant ? Wide(0) : a1);
  Wide const b2 = blocks_constant ? -Wide(section.q) : Wide(section.k - b0 - b1);
  std::vector<Wide> y;
  for (std::size_t n = 0; n < x.size(); ++n) {
    Wide value = b0 * x[n];
    if (n >= 1) value += b1 * x[n - 1] - a1 * y[n - 1];
    if (n >= 2) value += b2 * x[n - 2] - a2 * y[n - 2];
    y.push_back(value);
  }
  return y;
}

std::vector<NaiveSample> self_test(FilterDesign const& filter) {
  std::vector<double> const input = naive_test_input(filter.delay_cycles);
  std::vector<Wide> signal(input.begin(), input.end());
  if (filter.realisation == design::Realisation::delay) {
    for (std::size_t n = input.size(); n-- > 0;)
      signal[n] = n < filter.delay_cycles ? 0 : input[n - filter.delay_cycles];
  }
  for (auto const& section : filter.sections) signal = direct_form(section, filter.blocks_constant, signal);

  std::vector<NaiveSample> samples;
  for (std::size_t n = 0; n < input.size(); ++n) {
    Wide const x = input[n];
    Wide const direct = Wide(filter.share.direct) + filter.share.direct_low;
    Wide output = x + filter.share.filtered * (signal[n] - x);
    if (filter.blocks_constant) output = filter.share.filtered * signal[n] + direct * x;
    if (filter.realisation == design::Realisation::delay) output = signal[n] + direct * (x - signal[n]);
    samples.push_back({input[n], static_cast<double>(output)});
  }
  return samples;
}

struct Section {
  std::uint32_t kind, flags, element_size;
  Bytes bytes;
};

class Writer {
 public:
  Writer(machine::Machine const& machine, NaiveOptions const& options)
      : machine_(machine), options_(options) {}

  Bytes write() {
    for (std::uint32_t i = 0; i < machine_.axes.size(); ++i) write_axis(i);
    for (std::uint32_t i = 0; i < machine_.axes.size(); ++i) write_control(i);
    NaiveKernelSections const kernels =
        naive_kernel_sections(machine_, options_.strip, stores_,
                              [this](machine::AxisConfiguration const& axis) { return peak_gain_of(axis); });
    if (!options_.strip) {
      for (auto const& list : machine_.lists) write_list(list);
      for (std::uint32_t i = 0; i < machine_.axes.size(); ++i) write_values(i);
    }
    std::vector<Section> sections = {{1, 0, 128, axes_}, {2, 0, 192, filters_}, {3, 0, 32, coefficients_}};
    for (Section const& section :
         {Section{4, 0, 128, kernels.kernels}, Section{5, 0, 8, kernels.tails},
          Section{6, 0, 32, kernels.slots}, Section{7, 0, 32, kernels.groups},
          Section{8, 0, 4, kernels.members}, Section{9, 0, 64, kernels.banks},
          Section{10, 0, 4, kernels.choices}, Section{11, 0, 128, controls_}, Section{12, 0, 64, stages_}}) {
      if (!section.bytes.empty()) sections.push_back(section);
    }
    if (!options_.strip) {
      sections.push_back({16, 1, 1, stores_.names});
      sections.push_back({17, 1, 16, stores_.samples});
      sections.push_back({18, 1, 64, lists_});
      sections.push_back({19, 1, 32, values_});
    }
    return assemble(sections);
  }

 private:
  void write_axis(std::uint32_t index) {
    auto const& axis = machine_.axes[index];
    auto const first = static_cast<std::uint32_t>(filters_.size() / 192);
    for (auto const& filter : axis.filters) write_filter(index, 0, filter);
    auto const first_interface = static_cast<std::uint32_t>(filters_.size() / 192);
    for (auto const& filter : axis.interface_filters) write_filter(index, 1, filter);

    NaiveKernelFigures const kernel = kernel_at_start(axis, machine_.cycle_time);
    std::size_t const at = axes_.size();
    axes_.resize(at + 128);
    if (!options_.strip) stores_.write_text_range(axes_, at, axis.name);
    put32(axes_, at + 8, axis.number);
    put32(axes_, at + 12, static_cast<std::uint32_t>(axis.type));
    put32(axes_, at + 16, axis.type == machine::AxisType::translatory ? 0 : 1);
    put32(axes_, at + 20, axis.filters.empty() ? 0 : first);
    put32(axes_, at + 24, axis.filters.size());
    put32(axes_, at + 28, axis.interface_filters.empty() ? 0 : first_interface);
    put32(axes_, at + 32, axis.interface_filters.size());
    put_double(axes_, at + 40, axis.position_window);
    put_double(axes_, at + 48, axis.velocity_limit);
    put_double(axes_, at + 56, axis.acceleration_limit);
    double const gain = peak_gain_of(axis);
    bool const is_exact = gain == 1 || kernel.peak_gain == 1;
    double const product = gain * kernel.peak_gain;
    put_double(axes_, at + 64, is_exact ? product : std::nextafter(product, 1e300));
    put_double(axes_, at + 72, design::chain_delay_cycles(chain_of(axis)) + kernel.delay_cycles);
  }

  [[nodiscard]] std::vector<FilterDesign> chain_of(machine::AxisConfiguration const& axis) const {
    std::vector<FilterDesign> chain;
    for (auto const& filter : axis.filters) chain.push_back(design_of(filter.specification));
    return chain;
  }
  [[nodiscard]] double peak_gain_of(machine::AxisConfiguration const& axis) const {
    return axis.filters.empty() ? 1 : figures(chain_of(axis)).peak_gain_bound;
  }

  void write_filter(std::uint32_t axis, std::uint32_t port, machine::ConfiguredFilter const& configured) {
    auto const& specification = configured.specification;
    std::size_t const at = write_design(axis, port, configured.index, design_of(specification));
    put32(filters_, at + 36, static_cast<std::uint32_t>(specification.type));
    put32(filters_, at + 40, static_cast<std::uint32_t>(specification.prototype));
    put32(filters_, at + 44, specification.order);
    put_double(filters_, at + 72, specification.frequency.value);
    put_double(filters_, at + 80, specification.quality);
    put_double(filters_, at + 88, specification.time_constant.value);
    put_double(filters_, at + 96, specification.share_percent);
  }

  void write_oscillator(std::uint32_t axis, design::OscillatorSpecification const& oscillator) {
    std::size_t const at = write_design(
        axis, 2, 0, design::design_oscillator(oscillator, machine_.cycle_time, design::Precision::exact));
    put32(filters_, at + 40, 1);
    put32(filters_, at + 44, 2);
    put_double(filters_, at + 72, oscillator.frequency.value);
    put_double(filters_, at + 80, oscillator.damping);
    put_double(filters_, at + 96, 100);
  }

  /// Everything but what was configured; returns the record's offset.
  std::size_t write_design(std::uint32_t axis, std::uint32_t port, std::uint32_t index,
                           FilterDesign const& design) {
    std::vector<NaiveSample> const samples = options_.strip ? std::vector<NaiveSample>{} : self_test(design);
    auto const first_section = place_sections(design);
    std::size_t const at = filters_.size();
    filters_.resize(at + 192);
    put32(filters_, at, axis);
    put32(filters_, at + 4, port);
    put32(filters_, at + 8, index);
    put32(filters_, at + 12, static_cast<std::uint32_t>(design.realisation));
    put32(filters_, at + 20, design.blocks_constant ? 1 : 0);
    put32(filters_, at + 24, first_section);
    put32(filters_, at + 28, design.sections.size());
    put32(filters_, at + 32, design.delay_cycles);
    put_double(filters_, at + 48, design.share.filtered);
    put_double(filters_, at + 56, design.share.direct);
    put_double(filters_, at + 64, design.share.direct_low);
    put_double(filters_, at + 104, design.pole_radius);
    put_double(filters_, at + 112, design.dc_gain);
    put_double(filters_, at + 120, design.group_delay_cycles);
    put_double(filters_, at + 128, 1);
    put_double(filters_, at + 136, figures({design}).peak_gain_bound);
    put_double(filters_, at + 144, figures({design}).overshoot);
    put32(filters_, at + 152, stores_.place_samples(samples));
    put32(filters_, at + 156, samples.size());
    return at;
  }

  void write_control(std::uint32_t index) {
    auto const& axis = machine_.axes[index];
    std::size_t const source = axis.gantry_master ? *axis.gantry_master : index;
    auto const& control = machine_.axes[source].position_control;
    if (!control) return;
    bool const own = source == index;
    std::size_t const at = controls_.size();
    controls_.resize(at + 128);
    put32(controls_, at, index);
    put32(controls_, at + 4, source);
    put32(controls_, at + 8, own ? stages_.size() / 64 : 0);
    put32(controls_, at + 12, own ? control->stages.size() : 0);
    auto const& drive = axis.drive_scaling;
    put32(controls_, at + 16, static_cast<std::uint32_t>(drive.controller));
    put32(controls_, at + 20, drive.time_base);
    put_double(
        controls_, at + 24,
        static_cast<double>(Wide(control->limit_factor) * machine_.axes[source].velocity_limit / 1000));
    put_double(controls_, at + 32, static_cast<double>(scale_of(drive)));
    put_double(controls_, at + 40, control->limit_factor);
    put_double(controls_, at + 48, drive.v_reso_num);
    put_double(controls_, at + 56, drive.v_reso_denom);
    put_double(controls_, at + 64, drive.multi_gain_z);
    put_double(controls_, at + 72, drive.multi_gain_n);
    if (own) {
      for (auto const& stage : control->stages) write_stage(index, stage);
    }
  }

  [[nodiscard]] Wide scale_of(machine::DriveScaling const& drive) const {
    if (drive.controller == machine::PositionController::unknown) return 0;
    if (drive.controller == machine::PositionController::cnc) {
      return Wide(drive.multi_gain_z) / drive.multi_gain_n * 6 / 100'000;
    }
    Wide const per_second = Wide(drive.v_reso_num) / drive.v_reso_denom;
    if (drive.time_base == 0) return per_second * 60;
    return drive.time_base == 1 ? per_second : Wide(per_second * machine_.cycle_time.nanoseconds / 1e9);
  }

  void write_stage(std::uint32_t axis, machine::PositionControlStage const& stage) {
    std::size_t const first = filters_.size() / 192;
    std::uint32_t index = 0;
    if (stage.oscillator) {
      write_oscillator(axis, *stage.oscillator);
      ++index;
    }
    for (auto const& filter : stage.filters) {
      write_filter(axis, 2, {.index = index, .specification = filter});
      ++index;
    }
    std::size_t const at = stages_.size();
    stages_.resize(at + 64);
    put32(stages_, at, stage.index);
    put32(stages_, at + 4, static_cast<std::uint32_t>(stage.mode));
    put32(stages_, at + 8, first);
    put32(stages_, at + 12, index);
    put_double(stages_, at + 16, std::min(stage.weight_numerator / stage.weight_denominator, 7.0));
    put_double(stages_, at + 24, stage.weight_numerator);
    put_double(stages_, at + 32, stage.weight_denominator);
  }

  /// All runs of records that were stored, each with the index of its first record.
  template <class Run>
  using Stored = std::vector<std::pair<Run, std::uint32_t>>;

  std::uint32_t place_sections(FilterDesign const& design) {
    if (design.sections.empty()) return 0;
    for (auto const& [run, first] : stored_sections_) {
      if (run == design.sections) return first;
    }
    auto const first = static_cast<std::uint32_t>(coefficients_.size() / 32);
    for (auto const& section : design.sections) {
      std::size_t const at = coefficients_.size();
      coefficients_.resize(at + 32);
      put_double(coefficients_, at, section.p);
      put_double(coefficients_, at + 8, section.q);
      put_double(coefficients_, at + 16, section.k);
      put_double(coefficients_, at + 24, section.b);
    }
    stored_sections_.emplace_back(design.sections, first);
    return first;
  }

  void write_list(machine::MachineList const& list) {
    std::size_t const at = lists_.size();
    lists_.resize(at + 64);
    stores_.write_text_range(lists_, at, list.name);
    put32(lists_, at + 8, list.is_default_list ? 1 : 0);
    auto const hash = hash_of(list.content);
    for (std::size_t i = 0; i < 32; ++i) lists_[at + 16 + i] = static_cast<std::byte>(hash[i]);
  }

  void write_values(std::uint32_t axis) {
    for (auto const& value : machine_.axes[axis].values) {
      std::size_t const at = values_.size();
      values_.resize(at + 32);
      put32(values_, at, axis);
      put32(values_, at + 4, value.list);
      put32(values_, at + 8, value.line);
      stores_.write_text_range(values_, at + 12, value.name);
      stores_.write_text_range(values_, at + 20, value.text);
    }
  }

  [[nodiscard]] FilterDesign design_of(design::FilterSpecification const& specification) const {
    return design::design_filter(specification, machine_.cycle_time, design::Precision::exact);
  }
  static design::StepFigures figures(std::vector<FilterDesign> const& chain) {
    return design::step_figures(chain, 1U << 21U, 1e-9);
  }

  [[nodiscard]] Bytes assemble(std::vector<Section> const& sections) const {
    auto const next_place = [](std::size_t offset) {
      while (offset % 64 != 0) ++offset;
      return offset;
    };
    std::size_t const table_end = 128 + 32 * sections.size();
    Bytes image(next_place(table_end));
    for (std::size_t i = 0; i < sections.size(); ++i) {
      Section const& section = sections[i];
      std::size_t const entry = 128 + 32 * i;
      put32(image, entry, section.kind);
      put32(image, entry + 4, section.flags);
      put64(image, entry + 8, image.size());
      put64(image, entry + 16, section.bytes.size());
      put32(image, entry + 24, section.element_size);
      put32(image, entry + 28, section.bytes.size() / section.element_size);
      image.insert(image.end(), section.bytes.begin(), section.bytes.end());
      image.resize(next_place(image.size()));
    }
    put_text(image, 0, "AXIM");
    put16(image, 4, 1);
    put16(image, 6, 1);
    put32(image, 8, 128);
    put64(image, 16, image.size());
    put32(image, 28, sections.size());
    put32(image, 32, machine_.cycle_time.nanoseconds);
    put32(image, 36, machine_.axes.size());
    put32(image, 40, options_.image_version);
    auto const digest = hash_of(digest_input(machine_));
    for (std::size_t i = 0; i < 32; ++i) image[48 + i] = static_cast<std::byte>(digest[i]);
    put_text(image, 80, options_.compiler_version);
    put32(image, 24, naive_crc32c(image, table_end, image.size()));
    put32(image, 12, naive_crc32c(image, 0, table_end));
    return image;
  }

  machine::Machine const& machine_;
  NaiveOptions const& options_;
  Bytes axes_, filters_, coefficients_, controls_, stages_, lists_, values_;
  NaiveStores stores_;
  Stored<std::vector<design::IncrementSection>> stored_sections_;
};

}  // namespace

std::uint32_t naive_crc32c(std::vector<std::byte> const& bytes, std::size_t begin, std::size_t end) {
  std::uint32_t crc = 0xFFFFFFFF;
  for (std::size_t i = begin; i < end; ++i) {
    crc ^= std::to_integer<std::uint32_t>(bytes.at(i));
    for (int bit = 0; bit < 8; ++bit) crc = crc % 2 != 0 ? crc / 2 ^ 0x82F63B78 : crc / 2;
  }
  return ~crc;
}

std::vector<std::byte> naive_image(machine::Machine const& machine, NaiveOptions const& options) {
  return Writer(machine, options).write();
}

}  // namespace axisc::test
