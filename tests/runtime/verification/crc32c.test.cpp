#include "runtime/format/crc32c.hpp"

#include "support/catch.hpp"
#include "tests/runtime/image_builder.hpp"

#include <cstdint>
#include <string_view>
#include <vector>

namespace crc32c_test {

namespace {

std::vector<std::uint8_t> pattern(std::size_t size) {
  std::vector<std::uint8_t> bytes;
  std::uint32_t state = 1;
  while (bytes.size() < size) {
    state = state * 1664525U + 1013904223U;
    bytes.push_back(static_cast<std::uint8_t>(state >> 24U));
  }
  return bytes;
}

}  // namespace

TEST_CASE("CRC-32C of the check text is that of the standard") {
  CHECK(axim_crc32c(std::string_view("123456789")) == 0xE3069283U);
  CHECK(axim_crc32c(std::string_view("")) == 0);
}

TEST_CASE("CRC-32C equals the bitwise definition at every length and start") {
  std::vector<std::uint8_t> const bytes = pattern(100);
  for (std::size_t start = 0; start < 9; ++start) {
    for (std::size_t size = 0; start + size <= bytes.size(); ++size) {
      REQUIRE(axim_crc32c(bytes.data() + start, size) ==
              axisc::test::naive_crc32c(bytes.data() + start, size));
    }
  }
}

TEST_CASE("CRC-32C goes on where it stopped") {
  std::vector<std::uint8_t> const bytes = pattern(64);
  for (std::size_t cut = 0; cut <= bytes.size(); ++cut) {
    std::uint32_t const head = axim_crc32c(bytes.data(), cut);
    REQUIRE(axim_crc32c(bytes.data() + cut, bytes.size() - cut, head) == axim_crc32c(bytes));
  }
}

TEST_CASE("CRC-32C of long inputs equals the bitwise definition") {
  std::vector<std::uint8_t> const bytes = pattern(5000);
  for (std::size_t const size : {1023U, 1024U, 1025U, 1031U, 4096U, 4999U}) {
    for (std::size_t start = 0; start < 8 && start + size <= bytes.size(); ++start) {
      REQUIRE(axim_crc32c(bytes.data() + start, size) ==
              axisc::test::naive_crc32c(bytes.data() + start, size));
    }
  }
}

}  // namespace crc32c_test
