// The section `bounds` of compiled images: one section more, and nothing else.
#include "codegen/aligned_bytes.hpp"
#include "codegen/image_writer.hpp"
#include "image/checked_bounds.hpp"
#include "machines.hpp"
#include "support/catch.hpp"

#include <cstring>
#include <map>
#include <utility>
#include <vector>

namespace axisc::codegen::bound_records_test {
namespace {

using Bytes = std::vector<std::byte>;

template <class Number>
Number number_at(Bytes const& image, std::size_t at) {
  Number number{};
  std::memcpy(&number, &image.at(at), sizeof number);
  return number;
}

/// The bytes of each section by its kind.
std::map<std::uint32_t, Bytes> sections_of(Bytes const& image) {
  std::map<std::uint32_t, Bytes> found;
  for (std::uint32_t i = 0; i < number_at<std::uint32_t>(image, 28); ++i) {
    std::size_t const entry = 128 + 32 * std::size_t{i};
    auto const first =
        image.begin() + static_cast<std::ptrdiff_t>(number_at<std::uint64_t>(image, entry + 8));
    auto const size = static_cast<std::ptrdiff_t>(number_at<std::uint64_t>(image, entry + 16));
    found.emplace(number_at<std::uint32_t>(image, entry), Bytes(first, first + size));
  }
  return found;
}

image::CheckedBounds checked(Bytes const& image) {
  AlignedBytes const aligned(image);
  return image::check_bounds(aligned.bytes());
}

}  // namespace

TEST_CASE("an image with bounds is the image without them and one section more", "[image][bounds]") {
  bool const strip = GENERATE(false, true);
  for (machine::Machine const& machine : {test::sample_machine(), test::kernel_machine()}) {
    Bytes const plain = write_image(machine, {.strip = strip, .image_version = 3});
    Bytes const bounded = write_image(machine, {.strip = strip, .bounds = true, .image_version = 3});
    auto sections = sections_of(bounded);
    REQUIRE(sections.count(20) == 1);
    CHECK(sections.at(20).size() % 128 == 0);
    CHECK(bounded.size() ==
          plain.size() + (sections.at(20).size() + 63) / 64 * 64 +
              (number_at<std::uint64_t>(bounded, 128 + 8) - number_at<std::uint64_t>(plain, 128 + 8)));
    sections.erase(20);
    CHECK(sections == sections_of(plain));
    CHECK(number_at<std::uint16_t>(bounded, 6) == 2);
    CHECK(number_at<std::uint16_t>(plain, 6) == 1);
    // The header besides: sizes, checksums and the number of sections.
    CHECK(std::equal(bounded.begin() + 32, bounded.begin() + 128, plain.begin() + 32));
  }
}

TEST_CASE("bounds of random machines hold, whatever their chains are", "[image][bounds]") {
  test::Random random(20261127);
  for (int i = 0; i < 20; ++i) {
    machine::Machine const machine = test::random_kernel_machine(random, 0.01);
    Bytes const image = write_image(machine, {.strip = true, .bounds = true});
    static_cast<void>(test::contents_of(image));  // accepted
    image::CheckedBounds const bounds = checked(image);
    CHECK(bounds.is_in_image);
    CHECK(bounds.failures() == 0);
  }
}

TEST_CASE("an image without bounds claims nothing", "[image][bounds]") {
  image::CheckedBounds const bounds = checked(write_image(test::kernel_machine(), {}));
  CHECK_FALSE(bounds.is_in_image);
  CHECK(bounds.records.size() > 3);
  CHECK(bounds.failures() == 0);
}

}  // namespace axisc::codegen::bound_records_test
