#include "runtime/exact_kernel.hpp"
#include "runtime/test_runtime.hpp"

namespace axisc::test {
namespace {

constexpr Quad T = Quad{1} / 1000;

KernelRecord tested(KernelRecord kernel) {
  ExactKernel exact(kernel.tails, 0);
  for (double const input : {0x1p-6, 0x1p-6, -0x1p-7, 0.0, 0.0, 1.0}) {
    kernel.samples.push_back({.input = input, .output = static_cast<double>(exact.step(input))});
  }
  return kernel;
}

FilterRecord oscillator(Quad f, Quad damping) {
  FilterRecord record = exact::lowpass(f, T, 1 / (2 * damping)).record();
  record.type = 0;
  return record;
}

AxisRecord axis(char const* name, std::vector<ExactFilter> const& filters, std::uint32_t first_index) {
  AxisRecord axis;
  axis.name = name;
  for (ExactFilter const& filter : filters) {
    axis.filters.push_back(filter.record());
    axis.filters.back().index = first_index++;
  }
  return axis;
}

}  // namespace

ImageRecord channel_image() {
  ImageRecord image;
  image.axes = {axis("X", {exact::pt1(40, T)}, 0), axis("Y", {exact::lowpass(30, T, 1)}, 1),
                axis("Z", {}, 0)};
  image.kernels = {tested(moving_average(2)), tested(moving_average(4)), tested(symmetric_kernel({5, 3, 1})),
                   tested(delay_kernel(3, 0.5))};
  image.slots = {
      {.axis = 0, .family = 2, .kernel = 0, .on_at_start = 1, .history = 8, .group = 0},
      {.axis = 1, .family = 1, .index = 0, .kernel = 2, .on_at_start = 0, .history = 4, .group = 0}};
  image.groups = {
      {.name = "channel",
       .members = {0, 2, 1},
       .banks = {{.fade_cycles = 40, .choices = {0, none, none}},
                 {.keywords = 1, .order = 8, .fade_cycles = 0, .choices = {1, none, none}},
                 {.keywords = 3, .order = 3, .share = 50, .fade_cycles = 20, .choices = {3, none, none}},
                 {.keywords = 4, .frequency = 80, .fade_cycles = 7, .choices = {0, none, none}},
                 {.keywords = 8, .quality = 0.5, .fade_cycles = 9, .choices = {2, none, none}},
                 {.keywords = 16, .fade_cycles = 30, .choices = {none, none, 2}}},
       .off_fade_cycles = 25}};
  image.controls = {
      {.axis = 0,
       .source = 0,
       .stages = {{.index = 0, .mode = 1, .weight = 3, .filters = {exact::bandpass(53, T, 2).record()}},
                  {.index = 2,
                   .mode = 2,
                   .weight = 1.9,
                   .filters = {oscillator(11, Quad{4} / 5), exact::bandpass(11, T, 2).record()}}},
       .limit = 5000,
       .scale = 0.25},
      {.axis = 2, .source = 0, .stages = {}, .controller = 2, .limit = 5000, .scale = 3}};
  return image;
}

}  // namespace axisc::test
