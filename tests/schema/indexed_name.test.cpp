#include "schema/indexed_name.hpp"

#include "support/catch.hpp"

#include <cstdint>
#include <limits>
#include <string_view>

namespace indexed_name_test {

namespace {

using namespace axisc::schema;

TEST_CASE("a name is taken apart at its dots and brackets") {
  auto const name = split_name("a.bc[12].d[0]");
  REQUIRE(name);
  REQUIRE(name->parts.size() == 3);
  CHECK(name->parts[0].name == "a");
  CHECK_FALSE(name->parts[0].index);
  CHECK(name->parts[1].name == "bc");
  CHECK(name->parts[1].index == 12U);
  CHECK(name->parts[2].index == 0U);
}

TEST_CASE("a bare name has no indices") {
  CHECK(bare_name("a.bc[12].d[0]") == "a.bc.d");
  CHECK(bare_name("a[0].b") == "a.b");
  CHECK(bare_name("a.b") == "a.b");
  CHECK(bare_name("a[1") == "a");
  CHECK(bare_name("").empty());
}

TEST_CASE("an index that does not fit is the largest number") {
  auto const name = split_name("a[4294967296]");
  REQUIRE(name);
  CHECK(name->parts[0].index == std::numeric_limits<std::uint32_t>::max());
}

TEST_CASE("a dot at the end begins no part") {
  auto const name = split_name("a[1].b.");
  REQUIRE(name);
  CHECK(name->parts.size() == 2);
  CHECK(bare_name("a[1].b.") == "a.b");
}

TEST_CASE("what is no name has no parts") {
  for (std::string_view const text : {"a[", "a[]", "a[1", "a[1]b", "a[x]", "a[-1]", "a[ 1]", "[1]", "[",
                                      "a[1][2]", "a[1.2]", "a[1]]", "a..b", ".a"}) {
    INFO(text);
    CHECK_FALSE(split_name(text));
  }
}

}  // namespace

}  // namespace indexed_name_test
