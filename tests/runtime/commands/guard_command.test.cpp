// #VIB GUARD: slots of family 3, switched beside the FIR and HSC filters of other axes of the group.
#include "axisrt.h"
#include "support/catch.hpp"
#include "tests/runtime/test_runtime.hpp"

#include <vector>

namespace guard_command_test {

using namespace axisc::test;

namespace {

constexpr std::uint32_t guard = AXISRT_KEYWORD_GUARD;
constexpr std::uint32_t mode = AXISRT_KEYWORD_ORDER;
constexpr std::uint32_t share = AXISRT_KEYWORD_SHARE;

/// Two impulses, one as long as a kernel may be elsewhere, and more.
KernelRecord guard_kernel(std::size_t cycles) {
  KernelRecord kernel;
  kernel.type = 5;
  kernel.delay_cycles = static_cast<std::uint32_t>(cycles);
  kernel.tails.assign(cycles, 0.4);
  return kernel;
}

/// X has a FIR filter, Z a guard that works from start-up, Y keeps its HSC filter.
ImageRecord guarded_image(std::size_t cycles = 300) {
  ImageRecord image = channel_image();
  image.format_minor = 2;
  auto const first = static_cast<std::uint32_t>(image.kernels.size());
  image.kernels.push_back(guard_kernel(cycles));
  image.kernels.push_back(guard_kernel(20));
  image.slots.push_back({.axis = 2,
                         .family = 3,
                         .kernel = first,
                         .on_at_start = 1,
                         .history = static_cast<std::uint32_t>(cycles),
                         .group = 0});
  auto& banks = image.groups[0].banks;
  banks.push_back({.keywords = guard, .fade_cycles = 30, .choices = {none, first, none}});
  banks.push_back(
      {.keywords = guard | mode, .order = 2, .fade_cycles = 30, .choices = {none, first + 1, none}});
  return image;
}

axisrt_status verified(ImageRecord const& image) {
  return TestRuntime(write_image(image)).status;
}

}  // namespace

TEST_CASE("a guard may have 960 tail sums, other kernels 200") {
  CHECK(verified(guarded_image(960)) == AXISRT_OK);
  CHECK(verified(guarded_image(961)) == AXISRT_KERNEL_TOO_LONG);
  ImageRecord fir = guarded_image(300);
  fir.kernels[4].type = 3;
  CHECK(verified(fir) == AXISRT_KERNEL_TOO_LONG);
  ImageRecord slot = guarded_image(300);
  slot.slots.back().family = 2;
  CHECK(verified(slot) == AXISRT_KERNEL_TOO_LONG);
}

TEST_CASE("what a guard's command cannot name is not known") {
  CHECK(verified(guarded_image()) == AXISRT_OK);
  for (std::uint32_t const keywords : {guard | share, guard | AXISRT_KEYWORD_HSC, 64U}) {
    ImageRecord image = guarded_image();
    image.groups[0].banks.back().keywords = keywords;
    CHECK(verified(image) == AXISRT_UNKNOWN_KIND);
  }
  ImageRecord kernel = guarded_image();
  kernel.kernels[5].type = 6;
  CHECK(verified(kernel) == AXISRT_UNKNOWN_KIND);
  ImageRecord family = guarded_image();
  family.slots.back().family = 4;
  CHECK(verified(family) == AXISRT_UNKNOWN_KIND);
}

TEST_CASE("commands reach guards, or the other filters, never both") {
  TestRuntime runtime(write_image(guarded_image()));
  REQUIRE(runtime.status == AXISRT_OK);
  runtime.reset_all(0);
  struct Step {
    axisrt_action action;
    std::uint32_t keywords, order, kernel_x, kernel_z;
  };
  std::vector<Step> const steps = {
      {AXISRT_ACTION_ON, guard | mode, 2, 0, 5},   {AXISRT_ACTION_ON, mode, 8, 1, 5},
      {AXISRT_ACTION_SET, guard, 0, 1, 4},  // what #FILTER said before is none of its values
      {AXISRT_ACTION_SET, guard | mode, 2, 1, 5},  {AXISRT_ACTION_SET, guard, 0, 1, 5},
      {AXISRT_ACTION_OFF, guard, 0, 1, none},      {AXISRT_ACTION_SET, guard | mode, 2, 1, none},
      {AXISRT_ACTION_OFF, 0, 0, none, none},       {AXISRT_ACTION_ON, guard, 0, none, 4},
      {AXISRT_ACTION_OFF, mode, 0, none, 4},       {AXISRT_ACTION_OFF, guard | mode, 77, none, none},
      {AXISRT_ACTION_PROGRAM_END, guard, 0, 0, 4},
  };
  for (Step const& step : steps) {
    INFO(step.action << " " << step.keywords);
    REQUIRE(runtime.command(step.action, step.keywords, step.order) == AXISRT_OK);
    CHECK(runtime.state(0).kernel == step.kernel_x);
    CHECK(runtime.state(2).kernel == step.kernel_z);
  }
  CHECK(runtime.command(AXISRT_ACTION_ON, guard | mode, 3) == AXISRT_NO_BANK);
}

TEST_CASE("a long guard answers a step with its impulses") {
  TestRuntime runtime(write_image(guarded_image(700)));
  REQUIRE(runtime.status == AXISRT_OK);
  runtime.reset_all(0);
  for (int cycle = 0; cycle < 720; ++cycle) {
    double const expected = cycle < 700 ? 60.0 : 100.0;
    CHECK(runtime.step_all({0, 0, 100})[2] == Approx(expected).margin(1e-9));
  }
}

}  // namespace guard_command_test
