#include "codegen/image_writer.hpp"

#include "machines.hpp"
#include "naive_image.hpp"
#include "support/catch.hpp"

#include <algorithm>

namespace axisc::codegen::image_writer_test {
namespace {

using test::contents_of;
using test::kernel_machine;
using test::sample_machine;

/// The bytes are equal; else the last offset at which they differ (the first one is always the checksum's).
void check_equal_bytes(std::vector<std::byte> const& actual, std::vector<std::byte> const& expected) {
  REQUIRE(actual.size() == expected.size());
  auto const [at, other] = std::mismatch(actual.rbegin(), actual.rend(), expected.rbegin());
  INFO("last difference at offset " << actual.rend() - at - 1);
  CHECK((at == actual.rend()));
}

std::string version_of(std::vector<std::byte> const& image) {
  return contents_of(image).compiler_version;
}

}  // namespace

TEST_CASE("a naive writer that only knows the document builds the same bytes", "[image]") {
  machine::Machine const machine = GENERATE(sample_machine(), kernel_machine());
  bool const strip = GENERATE(false, true);
  std::vector<std::byte> const image = write_image(machine, {.strip = strip, .image_version = 17});
  check_equal_bytes(
      image, test::naive_image(machine,
                               {.strip = strip, .image_version = 17, .compiler_version = version_of(image)}));
}

TEST_CASE("a naive writer agrees on random machines", "[image]") {
  test::Random random(20240607);
  for (int i = 0; i < 40; ++i) {
    machine::Machine const machine = test::random_kernel_machine(random, 0.002);
    std::vector<std::byte> const image = write_image(machine, {.strip = true});
    check_equal_bytes(image,
                      test::naive_image(machine, {.strip = true, .compiler_version = version_of(image)}));
  }
}

TEST_CASE("a machine without axes or filters has an image too", "[image]") {
  machine::Machine machine;
  std::vector<std::byte> const empty = write_image(machine, {});
  check_equal_bytes(empty, test::naive_image(machine, {.compiler_version = version_of(empty)}));
  CHECK(contents_of(empty).axes.empty());

  machine.axes.resize(1);
  CHECK(contents_of(write_image(machine, {})).axes.size() == 1);
}

TEST_CASE("equal machines give equal bytes", "[image]") {
  check_equal_bytes(write_image(sample_machine(), {}), write_image(sample_machine(), {}));
  check_equal_bytes(write_image(kernel_machine(), {}), write_image(kernel_machine(), {}));
}

TEST_CASE("the machine's own name is not in the image", "[image]") {
  machine::Machine renamed = sample_machine();
  renamed.name = "/home/somebody/other";
  check_equal_bytes(write_image(renamed, {}), write_image(sample_machine(), {}));
}

TEST_CASE("equal filters share coefficients and self-tests", "[image]") {
  machine::Machine const once = sample_machine();
  machine::Machine twice = once;
  twice.axes.push_back(once.axes[0]);
  twice.axes.back().values.clear();
  // One axis record, two filters of the chain and one of the interface, and no other record.
  CHECK(write_image(twice, {}).size() == write_image(once, {}).size() + 128 + 3 * 192);
}

TEST_CASE("a stripped image is small, says the same about filters and runs", "[image]") {
  std::vector<std::byte> const whole = write_image(sample_machine(), {});
  std::vector<std::byte> const stripped = write_image(sample_machine(), {.strip = true});
  CHECK(stripped.size() < whole.size() / 2);

  image::ImageContents const contents = contents_of(stripped);
  CHECK(contents.source_digest == contents_of(whole).source_digest);
  CHECK(contents.lists.empty());
  REQUIRE(contents.axes.size() == 4);
  for (std::size_t i = 0; i < contents.axes.size(); ++i) {
    image::ImageAxis const& axis = contents.axes[i];
    image::ImageAxis const expected = contents_of(whole).axes[i];
    CHECK(axis.name.empty());
    CHECK(axis.values.empty());
    CHECK(axis.peak_gain == expected.peak_gain);
    REQUIRE(axis.filters.size() == expected.filters.size());
    for (std::size_t j = 0; j < axis.filters.size(); ++j) {
      CHECK(axis.filters[j].design.sections == expected.filters[j].design.sections);
      CHECK(axis.filters[j].self_test_input.empty());
    }
  }
  CHECK(test::runtime_for(stripped).axis_name(0).empty());
}

}  // namespace axisc::codegen::image_writer_test
