#include "support/catch.hpp"
#include "tests/runtime/test_runtime.hpp"

#include <cstddef>

extern "C" int c_interface_run(void const* image, std::size_t image_size, void* memory,
                               std::size_t memory_size, double target, double* arrived);

TEST_CASE("a C11 program can use every function") {
  using namespace axisc::test;
  ImageRecord without_limits = complete_image();
  without_limits.axes[0].velocity_limit = 0;
  AlignedMemory const image(write_image(without_limits));
  AlignedMemory memory(1 << 16);
  double arrived = 0;
  REQUIRE(c_interface_run(image.data(), image.size(), memory.data(), memory.size(), 1e6, &arrived) == 0);
  CHECK(arrived == Approx(0.25e6));  // a quarter passes beside the band-pass
}
