#include "schema/name_hash.hpp"

#include "support/catch.hpp"

#include <cstddef>
#include <cstdint>
#include <set>
#include <string>

namespace {

using namespace axisc::schema;

TEST_CASE("a name has one hash, while the program is compiled and while it runs") {
  constexpr std::uint64_t compiled = hash_name("getriebe[0].dynamik.a_emergency");
  CHECK(hash_name(std::string("getriebe[0].dynamik.a_emergency")) == compiled);
}

// Else there may be no perfect hash for a catalogue with the names of an array.
TEST_CASE("names that differ in one character have different hashes") {
  for (std::size_t size = 1; size <= 70; ++size) {
    std::string name;
    for (std::size_t i = 0; i < size; ++i) name += static_cast<char>('a' + i % 26);
    std::uint64_t const hash = hash_name(name);
    for (std::size_t at = 0; at < size; ++at) {
      std::string other = name;
      std::size_t same = 0;
      for (int character = 0; character < 128; ++character) {
        other[at] = static_cast<char>(character);
        if (hash_name(other) == hash) ++same;
      }
      INFO("byte " << at << " of " << name);
      REQUIRE(same == 1);
    }
  }
}

TEST_CASE("names of different sizes have different hashes") {
  std::set<std::uint64_t> hashes;
  for (std::size_t size = 0; size <= 70; ++size) hashes.insert(hash_name(std::string(size, 'a')));
  CHECK(hashes.size() == 71);
}

}  // namespace
