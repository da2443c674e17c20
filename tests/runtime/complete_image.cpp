#include "runtime/test_runtime.hpp"

namespace axisc::test {
namespace {

/// Samples with the output of the exact filter.
void add_self_test(FilterRecord& record, ExactFilter const& filter) {
  ExactChain chain({filter}, 0);
  for (double const input : {0x1p-6, 0x1p-6, -0x1p-7, 0.0, 0.0, 1.0}) {
    record.samples.push_back({.input = input, .output = static_cast<double>(chain.step(input))});
  }
}

FilterRecord tested(ExactFilter const& filter, std::uint32_t index) {
  FilterRecord record = filter.record();
  record.index = index;
  add_self_test(record, filter);
  return record;
}

}  // namespace

ImageRecord complete_image() {
  Quad const T = Quad{1} / 1000;
  AxisRecord x;
  x.name = "X";
  x.filters = {tested(exact::bandstop_of_order_3(20, T, 4), 0),
               tested(exact::with_share(exact::delay(3), 0.25), 1),
               tested(exact::with_share(exact::bandpass(40, T, 2), 0.75), 2)};
  AxisRecord c;
  c.name = "Spindel ä";
  c.number = 2;
  c.type = 4;
  c.filters = {tested(exact::lowpass(30, T, Quad{1}), 1)};
  c.interface_filters = {tested(exact::pt1(8, T), 0)};
  ImageRecord image;
  image.axes = {x, c};
  return image;
}

}  // namespace axisc::test
