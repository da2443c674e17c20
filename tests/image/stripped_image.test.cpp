// Stripping an image gives what the compiler writes with --strip.
#include "image/stripped_image.hpp"

#include "codegen/image_writer.hpp"
#include "image/image_contents.hpp"
#include "support/catch.hpp"
#include "tests/codegen/machines.hpp"

namespace axisc::codegen {

TEST_CASE("a stripped image is the one that the compiler strips", "[image]") {
  test::Random random(5);
  for (auto const& machine :
       {test::sample_machine(), test::kernel_machine(), test::random_kernel_machine(random, 1e-3)}) {
    auto const whole = write_image(machine, {.strip = false, .image_version = 7});
    CHECK(image::stripped_image(whole) == write_image(machine, {.strip = true, .image_version = 7}));
  }
}

TEST_CASE("stripping a stripped or a signed image changes nothing else", "[image]") {
  auto whole = write_image(test::kernel_machine(), {});
  auto const stripped = image::stripped_image(whole);
  CHECK(image::stripped_image(stripped) == stripped);
  whole.resize(whole.size() + 80);  // where a signature is
  CHECK(image::stripped_image(whole) == stripped);
}

}  // namespace axisc::codegen
