// Machines of every type, order, prototype, share and cycle time go all the way: design, image, verify, create with its
// self-tests, and a step from rest.
#include "codegen/image_writer.hpp"
#include "machines.hpp"
#include "support/catch.hpp"

#include <cmath>
#include <vector>

namespace axisc::codegen {

TEST_CASE("random machines compile, pass their self-tests and settle", "[image][random]") {
#ifdef NDEBUG
  constexpr int machines = 2000;
#else
  constexpr int machines = 60;
#endif
  constexpr int cycles = 400;
  test::Random random(1);
  for (int i = 0; i < machines; ++i) {
    CAPTURE(i);
    validator::Machine const machine = test::random_machine(random, 0.005);
    std::vector<std::byte> const image = write_image(machine, {});
    ImageContents const contents = test::contents_of(image);
    RuntimeHost runtime = test::runtime_for(image);

    bool sound = runtime.reset_all(1000) == AXISRT_OK;
    std::vector<double> values(machine.axes.size());
    for (int n = 0; n < cycles; ++n) {
      values.assign(values.size(), n == 0 ? 1000 : 2000);
      sound = sound && runtime.step(values, values) == AXISRT_OK;
      for (std::size_t axis = 0; axis < values.size(); ++axis) {
        // Nothing exceeds what Σ|h| allows for the step, on top of the steady output.
        double const bound = 1000 + 1000 * contents.axes[axis].peak_gain;
        sound = sound && std::isfinite(values[axis]) && std::abs(values[axis]) <= bound * (1 + 1e-9);
      }
    }
    CHECK(sound);
  }
}

}  // namespace axisc::codegen
