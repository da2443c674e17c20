#include "codegen/source_digest.hpp"

#include "support/catch.hpp"

#include <string>

namespace axisc::codegen {
namespace {

std::string hex(Sha256 const& digest) {
  std::string text;
  for (std::uint8_t const octet : digest) {
    text += "0123456789abcdef"[octet >> 4U];
    text += "0123456789abcdef"[octet & 0xFU];
  }
  return text;
}

}  // namespace

TEST_CASE("SHA-256 gives the published values", "[image]") {
  CHECK(hex(sha256("")) == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  CHECK(hex(sha256("abc")) == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST_CASE("the digest of the sources tells names and contents apart", "[image]") {
  using Lists = std::vector<machine::MachineList>;
  Lists const lists = {{.name = "ab", .content = "c"}, {.name = "d", .content = ""}};
  CHECK(source_digest(lists) == sha256(std::string("ab\0\1\0\0\0\0\0\0\0cd\0\0\0\0\0\0\0\0\0", 22)));

  CHECK(source_digest(lists) !=
        source_digest(Lists{{.name = "a", .content = "bc"}, {.name = "d", .content = ""}}));
  CHECK(source_digest(lists) != source_digest(Lists{lists[1], lists[0]}));
  CHECK(source_digest(Lists{}) == sha256(""));
}

}  // namespace axisc::codegen
