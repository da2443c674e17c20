// Bounds of an axis: the worst of its kernels, whether the image stores them or not.
#include "image/proved_bounds.hpp"

#include "runtime/bounds/bounded_image.hpp"
#include "runtime/exact_filter.hpp"
#include "support/catch.hpp"

using namespace axisc;
using namespace axisc::test;

TEST_CASE("bounds of an axis are the same whether the image stores them or not") {
  constexpr Quad T = Quad{1} / 1000;
  ImageRecord image = image_of({exact::bandstop(40, T, 2).record()});
  image.axes.emplace_back();
  image.kernels = {moving_average(10)};
  image.slots = {{.axis = 0, .kernel = 0, .history = 20}};
  AlignedMemory const without(write_image(image));
  AlignedMemory const with(with_bounds(image));
  auto const bytes = [](AlignedMemory const& memory) {
    return std::span(reinterpret_cast<std::byte const*>(memory.data()), memory.size());
  };
  auto const computed = image::proved_bounds(bytes(without), 0);
  auto const stored = image::proved_bounds(bytes(with), 0);
  CHECK(computed.gain_high == stored.gain_high);
  CHECK(computed.overshoot_high == stored.overshoot_high);
  CHECK(computed.rest_cycles == stored.rest_cycles);
  // A band-stop amplifies more alone than behind a moving average.
  CHECK(stored.gain_high > 1.4);
  CHECK(stored.rest_cycles > 40U);
  auto const unfiltered = image::proved_bounds(bytes(with), 1);
  CHECK(unfiltered.gain_high == 1);
  CHECK(unfiltered.rest_cycles == 0U);
}
