// A naive writer of coefficient images. It appends the fields one after the other, as docs/image-format.md
// lists them, and must not use the format's table: it is the second opinion on the layout.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace axisc::test {

using Bytes = std::vector<std::uint8_t>;

/// Little-endian numbers, one after the other.
class ByteWriter {
 public:
  void u16(std::uint16_t value) { number(value, 2); }
  void u32(std::uint32_t value) { number(value, 4); }
  void u64(std::uint64_t value) { number(value, 8); }
  void f64(double value);
  void text(std::string const& value) { bytes.insert(bytes.end(), value.begin(), value.end()); }
  void zeros(std::size_t count) { bytes.insert(bytes.end(), count, 0); }
  void align(std::size_t alignment) { zeros((alignment - bytes.size() % alignment) % alignment); }

  Bytes bytes;

 private:
  void number(std::uint64_t value, int size);
};

void poke(Bytes& bytes, std::size_t offset, std::uint64_t value, int size);
void poke_f64(Bytes& bytes, std::size_t offset, double value);
[[nodiscard]] std::uint64_t peek(Bytes const& bytes, std::size_t offset, int size);

/// Bit by bit, as the definition says.
[[nodiscard]] std::uint32_t naive_crc32c(std::uint8_t const* bytes, std::size_t size);

/// A section in increment form: 32 bytes.
struct SectionRecord {
  double p = 0, q = 0, k = 1, b = 1;
};

/// 16 bytes.
struct SampleRecord {
  double input = 0, output = 0;
};

/// What a test says about a filter; the writer numbers sections and samples itself.
struct FilterRecord {
  std::uint32_t index = 0;
  std::uint32_t realisation = 1;
  std::uint32_t activation = 0;
  std::uint32_t blocks_constant = 0;
  std::uint32_t delay_cycles = 0;
  std::uint32_t type = 4;
  std::uint32_t prototype = 2;
  double share = 1, direct = 0, direct_low = 0;
  std::vector<SectionRecord> sections;
  std::vector<SampleRecord> samples;
};

/// Instead of an index.
inline constexpr std::uint32_t none = 0xFFFFFFFF;

struct KernelRecord {
  std::uint32_t type = 0;
  std::uint32_t half_width = 0;
  std::uint32_t delay_cycles = 0;
  std::vector<double> tails;
  std::vector<SampleRecord> samples;
  double peak_gain = 1;
};

/// Taps half[|k|], k = -h..h, divided by their sum.
[[nodiscard]] KernelRecord symmetric_kernel(std::vector<double> const& half);
[[nodiscard]] KernelRecord moving_average(std::uint32_t half_width);
[[nodiscard]] KernelRecord delay_kernel(std::uint32_t cycles, double share = 1);

/// Family: 1 HSC, 2 FIR. The writer finds its place in its group.
struct SlotRecord {
  std::uint32_t axis = 0;
  std::uint32_t family = 2;
  std::uint32_t index = 0;
  std::uint32_t kernel = 0;
  std::uint32_t on_at_start = 1;
  std::uint32_t history = 0;
  std::uint32_t group = none;
};

struct BankRecord {
  std::uint32_t keywords = 0;
  std::uint32_t order = 0;
  double share = 0, frequency = 0, quality = 0;
  std::uint32_t fade_cycles = 0;
  std::vector<std::uint32_t> choices;
};

struct GroupRecord {
  std::string name;
  std::vector<std::uint32_t> members;
  std::vector<BankRecord> banks;
  std::uint32_t off_fade_cycles = 0;
};

/// Mode: 1 DIRECT, 2 INDIRECT, 3 SET_POINT.
struct StageRecord {
  std::uint32_t index = 0;
  std::uint32_t mode = 1;
  double weight = 1;
  std::vector<FilterRecord> filters;
};

struct ControlRecord {
  std::uint32_t axis = 0;
  std::uint32_t source = 0;
  std::vector<StageRecord> stages;
  std::uint32_t controller = 1;
  std::uint32_t time_base = 0;
  double limit = 0, scale = 0;
};

struct AxisRecord {
  std::string name;
  std::uint32_t number = 1;
  std::uint32_t type = 1;
  double position_window = 0.4;
  double velocity_limit = 200'000;
  double acceleration_limit = 2'000;
  double peak_gain = 1;
  std::vector<FilterRecord> filters;
  std::vector<FilterRecord> interface_filters;
};

/// A section of a kind that this writer does not know.
struct ForeignSection {
  std::uint32_t kind = 0;
  std::uint32_t flags = 1;
  Bytes content;
  std::uint32_t element_size = 1;
};

struct ImageRecord {
  std::uint32_t cycle_time_ns = 1'000'000;
  std::uint16_t format_minor = 1;
  std::uint32_t longer_records = 0;  ///< bytes appended to every record, as a later minor version may do
  bool strip = false;                ///< neither names, self-tests, lists nor values
  std::vector<AxisRecord> axes;
  std::vector<KernelRecord> kernels;
  std::vector<SlotRecord> slots;
  std::vector<GroupRecord> groups;
  std::vector<ControlRecord> controls;
  std::optional<ForeignSection> foreign;
};

/// The whole image. Kinds stand in ascending order; those of kernels and position control only where there
/// are records, those that may be skipped only if it is not stripped.
[[nodiscard]] Bytes write_image(ImageRecord const& image);

/// Computes both checksums anew from what the header says, as far as it can be followed.
void repair_checksums(Bytes& bytes);

/// Offset of the first record of a section.
[[nodiscard]] std::size_t section_offset(Bytes const& bytes, std::uint32_t kind);
/// Offset of the entry in the section table.
[[nodiscard]] std::size_t entry_offset(Bytes const& bytes, std::uint32_t kind);

inline constexpr std::uint32_t axes_kind = 1, filters_kind = 2, coefficients_kind = 3, kernels_kind = 4,
                               tails_kind = 5, slots_kind = 6, groups_kind = 7, members_kind = 8,
                               banks_kind = 9, choices_kind = 10, controls_kind = 11, stages_kind = 12,
                               names_kind = 16, self_tests_kind = 17, lists_kind = 18, values_kind = 19;

/// Share s with 1 - s in two parts.
void set_share(FilterRecord& filter, double share);

}  // namespace axisc::test
