// Records of one section of the naive image, one after the other.
#pragma once

#include "runtime/image_builder.hpp"

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>

namespace axisc::test {

struct SectionBytes {
  std::uint32_t kind = 0, flags = 0, element_size = 0, count = 0;
  ByteWriter content;
};

/// Appends records of one kind and counts them.
class SectionWriter {
 public:
  SectionWriter(std::uint32_t kind, std::uint32_t flags, std::uint32_t record_size, std::uint32_t longer)
      : longer_(longer) {
    section.kind = kind;
    section.flags = flags;
    section.element_size = record_size + longer;
  }
  ByteWriter& out() { return section.content; }
  void end_record() {
    section.content.bytes.insert(section.content.bytes.end(), longer_, 0xEE);
    ++section.count;
    if (section.content.bytes.size() != std::size_t{section.element_size} * section.count) {
      throw std::logic_error("a record has the wrong size");
    }
  }
  [[nodiscard]] std::uint32_t count() const { return section.count; }
  SectionBytes section;

 private:
  std::uint32_t longer_;
};

struct Sections {
  explicit Sections(ImageRecord const& image)
      : axes(axes_kind, 0, 128, image.longer_records),
        filters(filters_kind, 0, 192, image.longer_records),
        coefficients(coefficients_kind, 0, 32, image.longer_records),
        kernels(kernels_kind, 0, 128, image.longer_records),
        tails(tails_kind, 0, 8, image.longer_records),
        slots(slots_kind, 0, 32, image.longer_records),
        groups(groups_kind, 0, 32, image.longer_records),
        members(members_kind, 0, 4, image.longer_records),
        banks(banks_kind, 0, 64, image.longer_records),
        choices(choices_kind, 0, 4, image.longer_records),
        controls(controls_kind, 0, 128, image.longer_records),
        stages(stages_kind, 0, 64, image.longer_records),
        names(names_kind, 1, 1, 0),
        samples(self_tests_kind, 1, 16, image.longer_records),
        lists(lists_kind, 1, 64, image.longer_records),
        values(values_kind, 1, 32, image.longer_records) {}
  SectionWriter axes, filters, coefficients, kernels, tails, slots, groups, members, banks, choices, controls,
      stages, names, samples, lists, values;
};

/// Offset and size.
[[nodiscard]] std::pair<std::uint32_t, std::uint32_t> append_text(SectionWriter& names,
                                                                  std::string const& text);
void append_sample(SectionWriter& samples, SampleRecord const& sample);
void append_filter(Sections& to, FilterRecord const& filter, std::uint32_t axis, std::uint32_t port,
                   bool strip);
/// Kernels, slots, groups and position control.
void append_kernels_and_controls(Sections& to, ImageRecord const& image);

}  // namespace axisc::test
