// What this processor computes for an image at level portable, for comparison with another processor.
//
//   reference_outputs IMAGE            every output of the motion, one hexadecimal number a line, each with a
//   comma: the
//                                      initialisers of a C array
//   reference_outputs --memory IMAGE   bytes that the runtime needs at its best level, and at level portable
#include "axisrt.h"
#include "tests/runtime/aligned_memory.hpp"

#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <vector>

extern "C" {
#include "tests/bare_metal/motion.h"
}

namespace {

using axisc::test::AlignedMemory;

axisrt_config configuration(AlignedMemory const& image, std::uint32_t level) {
  axisrt_config config{};
  config.size = sizeof config;
  config.cycle_time_ns = 1'000'000;
  config.image = image.data();
  config.image_size = image.size();
  config.level = level;
  return config;
}

std::size_t memory_size(AlignedMemory const& image, std::uint32_t level) {
  axisrt_config const config = configuration(image, level);
  std::size_t size = 0;
  std::size_t alignment = 0;
  return axisrt_memory_size(&config, &size, &alignment) == AXISRT_OK ? size : 0;
}

void print_output(void*, std::uint64_t bits) {
  std::printf("0x%016llxULL,\n", static_cast<unsigned long long>(bits));
}

int print_outputs(AlignedMemory const& image) {
  AlignedMemory memory(memory_size(image, AXISRT_LEVEL_PORTABLE));
  axisrt_config config = configuration(image, AXISRT_LEVEL_PORTABLE);
  config.memory = memory.data();
  config.memory_size = memory.size();
  axisrt* runtime = nullptr;
  axisrt_status const status = axisrt_create(&config, &runtime);
  if (status != AXISRT_OK) {
    std::fprintf(stderr, "reference_outputs: %s\n", axisrt_status_text(status));
    return 1;
  }
  return motion_execute(runtime, print_output, nullptr);
}

}  // namespace

int main(int argc, char* argv[]) {
  bool const wants_memory = argc == 3 && std::strcmp(argv[1], "--memory") == 0;
  if (argc != 2 && !wants_memory) {
    std::fputs("usage: reference_outputs [--memory] IMAGE\n", stderr);
    return 2;
  }
  std::ifstream file(argv[argc - 1], std::ios::binary);
  std::vector<std::uint8_t> const bytes{std::istreambuf_iterator<char>(file), {}};
  AlignedMemory const image(bytes);
  if (!wants_memory) return print_outputs(image);
  std::printf("%zu %zu\n", memory_size(image, AXISRT_LEVEL_AUTOMATIC),
              memory_size(image, AXISRT_LEVEL_PORTABLE));
  return 0;
}
