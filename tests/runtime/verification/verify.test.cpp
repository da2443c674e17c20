#include "axisrt.h"
#include "support/catch.hpp"
#include "tests/runtime/mutation.hpp"
#include "tests/runtime/test_runtime.hpp"

#include <vector>

namespace verify_test {

using namespace axisc::test;

namespace {

std::vector<Mutation> mutations() {
  constexpr std::uint64_t huge = 0xFFFF'FFFF'FFFF'FFC0U;
  return {
      // container
      header_u32("magic", 0, 0x4D495842, AXISRT_WRONG_MAGIC),
      {"major version", [](Bytes& b) { poke(b, 4, 2, 2); }, AXISRT_WRONG_VERSION},
      header_u32("header too small", 8, 64, AXISRT_OUT_OF_BOUNDS),
      header_u32("header longer than this version's", 8, 192, AXISRT_OUT_OF_BOUNDS),
      header_u32("section table behind the end", 28, 0x7FFFFFFF, AXISRT_OUT_OF_BOUNDS),
      {"total size larger", [](Bytes& b) { poke(b, 16, b.size() + 64, 8); }, AXISRT_TOO_SHORT},
      {"total size smaller", [](Bytes& b) { poke(b, 16, b.size() - 64, 8); }, AXISRT_WRONG_SIZE},
      header_u32("cycle time 0", 32, 0, AXISRT_INCONSISTENT_CYCLE),
      header_u32("cycle time beyond 1 s", 32, 1'000'000'001, AXISRT_INCONSISTENT_CYCLE),
      header_u32("axis count", 36, 3, AXISRT_OUT_OF_BOUNDS),
      // section table
      entry("section behind the end", filters_kind, 8, huge, 8, AXISRT_OUT_OF_BOUNDS),
      entry("section longer than the image", filters_kind, 16, huge, 8, AXISRT_OUT_OF_BOUNDS),
      entry("section not aligned", values_kind, 8, 0x48, 8, AXISRT_OVERLAP),
      {"section inside the header", [](Bytes& b) { poke(b, entry_offset(b, axes_kind) + 8, 64, 8); },
       AXISRT_OVERLAP},
      {"section inside another",
       [](Bytes& b) { poke(b, entry_offset(b, filters_kind) + 8, section_offset(b, axes_kind), 8); },
       AXISRT_OVERLAP},
      entry("element size 0", axes_kind, 24, 0, 4, AXISRT_OUT_OF_BOUNDS),
      {"records shorter than known",
       [](Bytes& b) {
         std::size_t const at = entry_offset(b, axes_kind);
         poke(b, at + 24, 64, 4);
         poke(b, at + 28, 4, 4);
       },
       AXISRT_OUT_OF_BOUNDS},
      {"records longer than this version's",
       [](Bytes& b) {
         std::size_t const at = entry_offset(b, axes_kind);
         poke(b, at + 24, 256, 4);
         poke(b, at + 28, 1, 4);
       },
       AXISRT_OUT_OF_BOUNDS},
      entry("count does not fit the size", filters_kind, 28, 4, 4, AXISRT_OUT_OF_BOUNDS),
      entry("unknown optional section", values_kind, 0, 99, 4, AXISRT_OK),
      {"unknown mandatory section",
       [](Bytes& b) {
         std::size_t const at = entry_offset(b, values_kind);
         poke(b, at, 99, 4);
         poke(b, at + 4, 0, 4);
       },
       AXISRT_UNKNOWN_KIND},
      entry("flags of a known section", values_kind, 4, 3, 4, AXISRT_OK),
      {"section twice", [](Bytes& b) { poke(b, entry_offset(b, values_kind), lists_kind, 4); },
       AXISRT_OUT_OF_BOUNDS},
      {"mandatory section missing",
       [](Bytes& b) {
         std::size_t const at = entry_offset(b, coefficients_kind);
         poke(b, at, 99, 4);
         poke(b, at + 4, 1, 4);
       },
       AXISRT_OUT_OF_BOUNDS},
      // axes
      u32("axis type", axes_kind, 0, 12, 3, AXISRT_UNKNOWN_KIND),
      u32("position unit", axes_kind, 0, 16, 2, AXISRT_UNKNOWN_KIND),
      u32("name behind the names", axes_kind, 1, 0, 0xFFFFFFFF, AXISRT_OUT_OF_BOUNDS),
      u32("name too long", axes_kind, 1, 4, 0xFFFFFFFF, AXISRT_OUT_OF_BOUNDS),
      u32("chain begins elsewhere", axes_kind, 1, 20, 0, AXISRT_OUT_OF_BOUNDS),
      u32("four filters", axes_kind, 0, 24, 4, AXISRT_OUT_OF_BOUNDS),
      u32("a filter too few", axes_kind, 0, 24, 2, AXISRT_OUT_OF_BOUNDS),
      u32("chain behind the end", axes_kind, 1, 20, 0xFFFFFFFF, AXISRT_OUT_OF_BOUNDS),
      u32("interface chain begins elsewhere", axes_kind, 1, 28, 0, AXISRT_OUT_OF_BOUNDS),
      u32("two interface filters", axes_kind, 1, 32, 2, AXISRT_OUT_OF_BOUNDS),
      u32("filter that no chain has", axes_kind, 1, 32, 0, AXISRT_OUT_OF_BOUNDS),
      f64("position window", axes_kind, 0, 40, not_a_number, AXISRT_NOT_FINITE),
      f64("velocity", axes_kind, 0, 48, infinity, AXISRT_NOT_FINITE),
      f64("acceleration", axes_kind, 0, 56, -infinity, AXISRT_NOT_FINITE),
      f64("peak gain of the axis", axes_kind, 0, 64, not_a_number, AXISRT_NOT_FINITE),
      f64("delay of the axis", axes_kind, 0, 72, not_a_number, AXISRT_NOT_FINITE),
      // Proofs that cannot be true: the sum of |h| is at least |H(1)|, poles of a stable filter lie within
      // the circle.
      f64("an axis that amplifies nothing", axes_kind, 0, 64, 0, AXISRT_OUT_OF_BOUNDS),
      f64("a negative peak gain of the axis", axes_kind, 0, 64, -1, AXISRT_OUT_OF_BOUNDS),
      f64("an axis' peak gain below its gain at 0 Hz", axes_kind, 1, 64, 0.999, AXISRT_OUT_OF_BOUNDS),
      f64("an axis' peak gain that lacks what was not summed up", axes_kind, 1, 64, 1 - 0x1p-21, AXISRT_OK),
      f64("a pole outside", filters_kind, 0, 104, 7, AXISRT_OUT_OF_BOUNDS),
      f64("a negative pole radius", filters_kind, 0, 104, -0.5, AXISRT_OUT_OF_BOUNDS),
      f64("another gain at 0 Hz", filters_kind, 0, 112, -3, AXISRT_OUT_OF_BOUNDS),
      f64("a sum of the kernel", filters_kind, 0, 128, 2, AXISRT_OUT_OF_BOUNDS),
      f64("a filter that amplifies nothing", filters_kind, 0, 136, 0, AXISRT_OUT_OF_BOUNDS),
      f64("a peak gain below the gain at 0 Hz", filters_kind, 0, 136, 1 - 0x1p-19, AXISRT_OUT_OF_BOUNDS),
      f64("a peak gain that lacks what was not summed up", filters_kind, 0, 136, 1 - 0x1p-21, AXISRT_OK),
      f64("a negative overshoot", filters_kind, 0, 144, -1e-9, AXISRT_OUT_OF_BOUNDS),
      // filters
      u32("filter of another axis", filters_kind, 0, 0, 1, AXISRT_OUT_OF_BOUNDS),
      u32("port", filters_kind, 0, 4, 3, AXISRT_UNKNOWN_KIND),
      u32("filter of a stage among those of an axis", filters_kind, 0, 4, 2, AXISRT_OUT_OF_BOUNDS),
      u32("oscillator among the filters of an axis", filters_kind, 0, 36, 0, AXISRT_UNKNOWN_KIND),
      u32("filter of the other port", filters_kind, 0, 4, 1, AXISRT_OUT_OF_BOUNDS),
      u32("index twice", filters_kind, 1, 8, 0, AXISRT_OUT_OF_BOUNDS),
      u32("index too large", filters_kind, 2, 8, 3, AXISRT_OUT_OF_BOUNDS),
      u32("realisation", filters_kind, 0, 12, 3, AXISRT_UNKNOWN_KIND),
      u32("activation", filters_kind, 0, 16, 1, AXISRT_UNKNOWN_KIND),
      u32("blocks constant", filters_kind, 0, 20, 2, AXISRT_OUT_OF_BOUNDS),
      u32("delay that blocks", filters_kind, 1, 20, 1, AXISRT_OUT_OF_BOUNDS),
      u32("first section", filters_kind, 0, 24, 0xFFFFFFFE, AXISRT_OUT_OF_BOUNDS),
      u32("sections behind the end", filters_kind, 4, 24, 6, AXISRT_OUT_OF_BOUNDS),
      u32("no sections", filters_kind, 0, 28, 0, AXISRT_OUT_OF_BOUNDS),
      u32("seven sections", filters_kind, 0, 28, 7, AXISRT_OUT_OF_BOUNDS),
      u32("delay with sections", filters_kind, 1, 28, 1, AXISRT_OUT_OF_BOUNDS),
      u32("delay too long", filters_kind, 1, 32, 101, AXISRT_KERNEL_TOO_LONG),
      u32("filter type", filters_kind, 0, 36, 7, AXISRT_UNKNOWN_KIND),
      u32("filter type beyond all", filters_kind, 0, 36, 33, AXISRT_UNKNOWN_KIND),
      u32("prototype", filters_kind, 0, 40, 4, AXISRT_UNKNOWN_KIND),
      f64("share not finite", filters_kind, 0, 48, not_a_number, AXISRT_NOT_FINITE),
      f64("share above 1", filters_kind, 0, 48, 1.5, AXISRT_OUT_OF_BOUNDS),
      f64("share below 0", filters_kind, 0, 48, -0.5, AXISRT_OUT_OF_BOUNDS),
      f64("direct above 1", filters_kind, 0, 56, 1.5, AXISRT_OUT_OF_BOUNDS),
      f64("direct that does not complete the share", filters_kind, 0, 56, 0x1p-40, AXISRT_OUT_OF_BOUNDS),
      f64("low part too large", filters_kind, 0, 64, 0x1p-52, AXISRT_OUT_OF_BOUNDS),
      f64("proof not finite", filters_kind, 0, 104, infinity, AXISRT_NOT_FINITE),
      f64("overshoot not finite", filters_kind, 0, 144, not_a_number, AXISRT_NOT_FINITE),
      u32("first sample", filters_kind, 0, 152, 0xFFFFFFFF, AXISRT_OUT_OF_BOUNDS),
      u32("samples behind the end", filters_kind, 0, 156, 31, AXISRT_OUT_OF_BOUNDS),
      u32("too many samples", filters_kind, 0, 156, 1025, AXISRT_OUT_OF_BOUNDS),
      // coefficients
      f64("p", coefficients_kind, 0, 0, not_a_number, AXISRT_NOT_FINITE),
      f64("p too large", coefficients_kind, 0, 0, 64.5, AXISRT_UNSTABLE),
      f64("q too large", coefficients_kind, 0, 8, -64.5, AXISRT_UNSTABLE),
      f64("q", coefficients_kind, 0, 8, infinity, AXISRT_NOT_FINITE),
      f64("k = 0", coefficients_kind, 0, 16, 0, AXISRT_UNSTABLE),
      f64("k < 0", coefficients_kind, 0, 16, -1e-9, AXISRT_UNSTABLE),
      f64("k too large", coefficients_kind, 0, 16, 4, AXISRT_UNSTABLE),
      f64("b = 0", coefficients_kind, 0, 24, 0, AXISRT_UNSTABLE),
      f64("b = 2", coefficients_kind, 0, 24, 2, AXISRT_UNSTABLE),
      f64("last section", coefficients_kind, 5, 16, 0, AXISRT_UNSTABLE),
      // samples, lists, values
      f64("sample", self_tests_kind, 0, 0, not_a_number, AXISRT_NOT_FINITE),
      f64("sample too large", self_tests_kind, 0, 0, 0x1.8p53, AXISRT_OUT_OF_BOUNDS),
      f64("expected output", self_tests_kind, 29, 8, infinity, AXISRT_NOT_FINITE),
      u32("role", lists_kind, 0, 8, 3, AXISRT_UNKNOWN_KIND),
      u32("name of a list", lists_kind, 0, 4, 1000, AXISRT_OUT_OF_BOUNDS),
      u32("axis of a value", values_kind, 0, 0, 2, AXISRT_OUT_OF_BOUNDS),
      u32("list of a value", values_kind, 0, 4, 1, AXISRT_OUT_OF_BOUNDS),
      u32("line 0", values_kind, 0, 8, 0, AXISRT_OUT_OF_BOUNDS),
      u32("name of a value", values_kind, 1, 12, 1000, AXISRT_OUT_OF_BOUNDS),
      u32("text of a value", values_kind, 1, 24, 1000, AXISRT_OUT_OF_BOUNDS),
  };
}

}  // namespace

TEST_CASE("a sound image is accepted") {
  CHECK(verify(write_image(complete_image())) == AXISRT_OK);
  ImageRecord stripped = complete_image();
  stripped.strip = true;
  CHECK(verify(write_image(stripped)) == AXISRT_OK);
  CHECK(verify(write_image(ImageRecord{})) == AXISRT_OK);
}

TEST_CASE("each fault has its status, also when the checksums are right") {
  check_mutations(complete_image(), mutations());
}

TEST_CASE("a changed byte is a wrong checksum") {
  Bytes bytes = write_image(complete_image());
  bytes.back() ^= 1U;
  CHECK(verify(bytes) == AXISRT_WRONG_CHECKSUM);
  bytes = write_image(complete_image());
  bytes[60] ^= 1U;  // digest, in the header
  CHECK(verify(bytes) == AXISRT_WRONG_CHECKSUM);
}

TEST_CASE("what is no image is said to be none") {
  CHECK(verify(Bytes{'#', ' ', 'a', 'x', 'i', 's'}) == AXISRT_WRONG_MAGIC);
  CHECK(verify(Bytes{'A', 'X'}) == AXISRT_TOO_SHORT);
  CHECK(axisrt_verify(nullptr, 1000) == AXISRT_BAD_ARGUMENT);
}

TEST_CASE("an image at an odd address is refused") {
  Bytes bytes = write_image(complete_image());
  bytes.insert(bytes.begin(), 8, 0);
  AlignedMemory const memory(bytes);
  CHECK(axisrt_verify(memory.data() + 8, memory.size() - 8) == AXISRT_MISALIGNED);
}

TEST_CASE("a later minor version may have longer records and sections of new kinds") {
  ImageRecord image = complete_image();
  image.foreign = ForeignSection{.kind = 77, .flags = 1, .content = Bytes(100, 3)};
  CHECK(verify(write_image(image)) == AXISRT_OK);
  image.foreign->flags = 0;
  CHECK(verify(write_image(image)) == AXISRT_UNKNOWN_KIND);
  image.foreign->flags = 1;
  image.longer_records = 16;
  CHECK(verify(write_image(image)) == AXISRT_OUT_OF_BOUNDS);
  image.format_minor = 3;
  CHECK(verify(write_image(image)) == AXISRT_OK);
  // and such an image is executed as the same filters
  TestRuntime later(write_image(image));
  TestRuntime now(write_image(complete_image()));
  REQUIRE(later.status == AXISRT_OK);
  axisrt_reset(later.runtime, 0, 5);
  axisrt_reset(now.runtime, 0, 5);
  for (int i = 0; i < 50; ++i) REQUIRE(later.step(5.0 + i) == now.step(5.0 + i));
}

}  // namespace verify_test
