// Changes of images take the proved distance of kernel and filters together.
#include "bounded_image.hpp"
#include "runtime/exact_filter.hpp"
#include "runtime/test_runtime.hpp"

namespace change_test {

using namespace axisc::test;

namespace {

constexpr Quad T = Quad{1} / 1000;

/// The kernel amplifies what the low-pass then takes away.
ImageRecord filtered() {
  ImageRecord image = image_of({exact::lowpass(60, T, 0.7).record()});
  image.kernels = {symmetric_kernel({1, -0.2})};
  image.slots = {{.axis = 0, .family = 1, .kernel = 0, .history = 2}};
  return image;
}

/// Cycles of the fade from an image to itself, in motion.
int fade_between(Bytes const& bytes) {
  TestRuntime active(bytes);
  REQUIRE(active.status == AXISRT_OK);
  active.reset_all(0);
  AlignedMemory const image(bytes);
  AlignedMemory memory(active.memory_size);
  axisrt_config const config{.size = sizeof(axisrt_config),
                             .cycle_time_ns = 1'000'000,
                             .image = image.data(),
                             .image_size = image.size(),
                             .memory = memory.data(),
                             .memory_size = memory.size(),
                             .level = test_level(),
                             .reserved = 0,
                             .verify_signature = nullptr,
                             .verify_context = nullptr};
  axisrt* prepared = nullptr;
  REQUIRE(axisrt_prepare(active.runtime, &config, 0, &prepared) == AXISRT_OK);
  double x = 0;
  for (int n = 0; n < 500; ++n) {
    active.step(x += 10);
    REQUIRE(axisrt_shadow_step(prepared) == AXISRT_OK);
  }
  REQUIRE(axisrt_swap(prepared) == AXISRT_OK);
  int cycles = 0;
  for (; axisrt_swap_done(prepared) == 0 && cycles < 5000; ++cycles) {
    double y = x += 10;
    REQUIRE(axisrt_step(prepared, &y, &y, nullptr) == AXISRT_OK);
  }
  return cycles;
}

}  // namespace

TEST_CASE("with bounds a change of images takes the distance of kernel and filters together", "[bounds]") {
  int const product = fade_between(write_image(filtered()));
  int const joint = fade_between(with_bounds(filtered()));
  CAPTURE(product, joint);
  CHECK(joint < product);
  CHECK(joint > product / 4);
}

}  // namespace change_test
