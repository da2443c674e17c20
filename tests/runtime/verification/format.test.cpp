// The format's table itself: no gaps, no overlaps, and the layout that the naive writer has written down.
#include "runtime/format/image_format.h"
#include "support/catch.hpp"
#include "tests/runtime/test_runtime.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace {

struct FieldRow {
  std::string record, name, type;
  unsigned offset = 0;
};

unsigned size_of(std::string const& type) {
  if (type == "u16") return 2;
  if (type == "u32") return 4;
  if (type == "u64" || type == "f64") return 8;
  REQUIRE(type.rfind("u8x", 0) == 0);
  return static_cast<unsigned>(std::stoul(type.substr(3)));
}

std::map<std::string, unsigned> record_sizes() {
  return {
#define AXIM_RECORD(record, size, meaning) {#record, size},
#define AXIM_FIELD(record, field, type, offset, meaning)
#define AXIM_SECTION(name, kind, record, flags, meaning)
#include "runtime/format/fields.inc"
#undef AXIM_RECORD
#undef AXIM_FIELD
#undef AXIM_SECTION
  };
}

std::vector<FieldRow> field_rows() {
  return {
#define AXIM_RECORD(record, size, meaning)
#define AXIM_FIELD(record, field, type, offset, meaning) {#record, #field, #type, offset},
#define AXIM_SECTION(name, kind, record, flags, meaning)
#include "runtime/format/fields.inc"
#undef AXIM_RECORD
#undef AXIM_FIELD
#undef AXIM_SECTION
  };
}

}  // namespace

TEST_CASE("the fields of each record stand one behind the other and fill it") {
  std::map<std::string, unsigned> ends;
  for (FieldRow const& row : field_rows()) {
    INFO(row.record << "." << row.name);
    CHECK(row.offset == ends[row.record]);
    ends[row.record] = row.offset + size_of(row.type);
    CHECK(row.offset % (row.type[1] == '8' ? 1 : size_of(row.type)) == 0);
  }
  for (auto const& [record, size] : record_sizes()) {
    INFO(record);
    CHECK((record == "byte" || ends[record] == size));
  }
}

TEST_CASE("the table's offsets are those of the naive writer") {
  using namespace axisc::test;
  Bytes const image = write_image(complete_image());
  CHECK(peek(image, axim_header_total_size_offset, 8) == image.size());
  CHECK(peek(image, axim_header_cycle_time_ns_offset, 4) == 1'000'000);
  CHECK(peek(image, axim_header_axis_count_offset, 4) == 2);
  std::size_t const axis = section_offset(image, axim_kind_axes) + axim_axis_size;
  CHECK(peek(image, axis + axim_axis_number_offset, 4) == 2);
  CHECK(peek(image, axis + axim_axis_first_filter_offset, 4) == 3);
  CHECK(peek(image, axis + axim_axis_first_interface_filter_offset, 4) == 4);
  std::size_t const filter = section_offset(image, axim_kind_filters) + 4 * axim_filter_size;
  CHECK(peek(image, filter + axim_filter_axis_offset, 4) == 1);
  CHECK(peek(image, filter + axim_filter_port_offset, 4) == axim_port_interface);
  CHECK(peek(image, filter + axim_filter_sample_count_offset, 4) == 6);
}

TEST_CASE("the offsets of kernels and position control are those of the naive writer") {
  using namespace axisc::test;
  Bytes const image = write_image(channel_image());
  CHECK(peek(image, axim_header_format_minor_offset, 2) == 1);
  std::size_t const kernel = section_offset(image, axim_kind_kernels) + axim_kernel_size;
  CHECK(peek(image, kernel + axim_kernel_half_width_offset, 4) == 4);
  CHECK(peek(image, kernel + axim_kernel_first_tail_offset, 4) == 4);
  CHECK(peek(image, kernel + axim_kernel_tail_count_offset, 4) == 8);
  CHECK(peek(image, kernel + axim_kernel_sample_count_offset, 4) == 6);
  CHECK(peek(image, entry_offset(image, axim_kind_tails) + axim_section_count_offset, 4) == 19);
  std::size_t const slot = section_offset(image, axim_kind_slots) + axim_slot_size;
  CHECK(peek(image, slot + axim_slot_family_offset, 4) == axim_family_hsc);
  CHECK(peek(image, slot + axim_slot_kernel_offset, 4) == 2);
  CHECK(peek(image, slot + axim_slot_history_offset, 4) == 4);
  CHECK(peek(image, slot + axim_slot_member_offset, 4) == 2);
  std::size_t const group = section_offset(image, axim_kind_groups);
  CHECK(peek(image, group + axim_group_member_count_offset, 4) == 3);
  CHECK(peek(image, group + axim_group_bank_count_offset, 4) == 6);
  CHECK(peek(image, group + axim_group_off_fade_cycles_offset, 4) == 25);
  CHECK(peek(image, section_offset(image, axim_kind_members) + axim_member_size, 4) == 2);
  std::size_t const bank = section_offset(image, axim_kind_banks) + std::size_t{5} * axim_bank_size;
  CHECK(peek(image, bank + axim_bank_keywords_offset, 4) == axim_keyword_hsc);
  CHECK(peek(image, bank + axim_bank_first_choice_offset, 4) == 15);
  CHECK(peek(image, bank + axim_bank_fade_cycles_offset, 4) == 30);
  CHECK(peek(image, section_offset(image, axim_kind_choices), 4) == 0);
  std::size_t const control = section_offset(image, axim_kind_controls) + axim_control_size;
  CHECK(peek(image, control + axim_control_axis_offset, 4) == 2);
  CHECK(peek(image, control + axim_control_controller_offset, 4) == 2);
  std::size_t const stage = section_offset(image, axim_kind_stages) + axim_stage_size;
  CHECK(peek(image, stage + axim_stage_mode_offset, 4) == 2);
  CHECK(peek(image, stage + axim_stage_first_filter_offset, 4) == 3);
  CHECK(peek(image, stage + axim_stage_filter_count_offset, 4) == 2);
}
