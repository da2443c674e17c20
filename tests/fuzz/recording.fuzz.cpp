// A recording in which any words were changed, with right checksums: it is refused, or executed without a bad
// access.
#include "image/recording.hpp"

#include "axisrt.h"
#include "image/runtime_host.hpp"
#include "runtime/format/crc32c.hpp"
#include "runtime/format/recording_format.h"
#include "tests/runtime/test_runtime.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <span>
#include <variant>
#include <vector>

namespace {

using namespace axisc::test;

constexpr std::size_t word = 8;

void require(bool condition) {
  if (!condition) std::abort();
}

Bytes const& image() {
  static Bytes const bytes = write_image(channel_image());
  return bytes;
}

/// Some cycles with commands and resets, at level portable and the best one.
Bytes record(std::uint32_t level) {
  auto host = axisc::image::RuntimeHost::create(std::as_bytes(std::span(image())), std::nullopt, level);
  require(std::holds_alternative<axisc::image::RuntimeHost>(host));
  auto& runtime = std::get<axisc::image::RuntimeHost>(host);
  require(runtime.record(20) == AXISRT_OK);
  require(runtime.reset_all(0) == AXISRT_OK);
  std::vector<double> out(3);
  for (int cycle = 0; cycle < 45; ++cycle) {
    std::vector<double> const in = {10.0 * cycle, -5.0 * cycle, 0.0};
    if (cycle == 35) require(runtime.end_program(0) == AXISRT_OK);
    if (cycle == 40) require(runtime.rebase(1, 16) == AXISRT_OK);
    require(runtime.step(in, out) == AXISRT_OK);
    require(runtime.step_velocity({.set = in, .motor = in, .direct = in}, out, out) == AXISRT_OK);
  }
  auto const bytes = runtime.recording();
  Bytes dump(bytes.size());
  std::memcpy(dump.data(), bytes.data(), bytes.size());
  return dump;
}

void repair(Bytes& dump) {
  if (dump.size() < axrd_header_words * word) return;
  std::size_t const header = axrd_header_words * word;
  poke(dump, 6 * word, axim_crc32c(dump.data() + header, dump.size() - header), 8);
  poke(dump, 6 * word + 4, axim_crc32c(dump.data(), header), 4);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  static Bytes const portable = record(AXISRT_LEVEL_PORTABLE);
  static Bytes const best = record(AXISRT_LEVEL_AUTOMATIC);
  if (size == 0) return 0;
  Bytes dump = data[0] % 2 == 0 ? portable : best;
  // Changes of ten bytes: which word, and what it becomes.
  for (std::size_t at = 1; at + 10 <= size; at += 10) {
    std::size_t const index =
        (data[at] | static_cast<std::size_t>(data[at + 1]) << 8U) % (dump.size() / word);
    std::memcpy(dump.data() + index * word, data + at + 2, word);
  }
  repair(dump);
  auto recording =
      axisc::image::Recording::open(std::as_bytes(std::span(image())), std::as_bytes(std::span(dump)));
  if (auto const* const status = std::get_if<axisrt_status>(&recording)) {
    require(*status == AXISRT_BAD_RECORDING || *status == AXISRT_OTHER_IMAGE || *status == AXISRT_NO_LEVEL);
    return 0;
  }
  axisc::image::ReplayedEntry entry;
  while (std::get<axisc::image::Recording>(recording).next(entry)) {
  }
  return 0;
}
