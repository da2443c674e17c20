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
