// Lists of every kind as names and texts.
#include "configuration/listed_values.hpp"

#include "support/catch.hpp"

namespace {

using namespace axisc;
using configuration::as_number;
using configuration::listed_values;
using configuration::match_name;

std::vector<std::string> texts_of(std::string bytes) {
  SourceText const source("a.lis", std::move(bytes));
  std::vector<std::string> texts;
  for (auto const& listed : listed_values(source, SourceId{})) {
    texts.push_back(std::string(listed.name) + "=" + listed.value.text);
  }
  return texts;
}

}  // namespace

TEST_CASE("a value is a number, a quoted text, or all up to the comment") {
  using Texts = std::vector<std::string>;
  CHECK(texts_of("zahl_mds 6   # six axes\n") == Texts{"zahl_mds=6"});
  CHECK(texts_of("achs_mds[0]  ./listen/a b.lis   ( P-STUP-00015\n") ==
        Texts{"achs_mds[0]=./listen/a b.lis"});
  CHECK(texts_of("achs_mds[0]  .\\LISTEN\\A.LIS\n") == Texts{"achs_mds[0]=.\\LISTEN\\A.LIS"});
  CHECK(texts_of("hand_mds \"x (1).lis\"  ( comment\n") == Texts{"hand_mds=x (1).lis"});
  CHECK(texts_of("x 1\nEnde\ny 2\n") == Texts{"x=1"});
  CHECK(texts_of("bezeichnung Fr\xE4se\n") == Texts{"bezeichnung=Fräse"});
  CHECK(texts_of("( a comment\n\n?\n").empty());
}

TEST_CASE("a name is matched with a pattern, in any letter case") {
  CHECK((*match_name("achs_mds[12]", "achs_mds[]"))[0] == 12);
  auto const both = match_name("Gruppe[0].Achse[31].log_achs_nr", "gruppe[].achse[].log_achs_nr");
  REQUIRE(both);
  CHECK((*both)[0] == 0);
  CHECK((*both)[1] == 31);
  CHECK(match_name("zahl_mds", "zahl_mds"));
  for (char const* const other : {"achs_mds", "achs_mds[", "achs_mds[]", "achs_mds[x]", "achs_mds[1]x",
                                  "achs_mds[1", "achs_mds[99999999999]", "xachs_mds[1]", ""}) {
    INFO(other);
    CHECK_FALSE(match_name(other, "achs_mds[]"));
  }
}

TEST_CASE("only whole decimal numbers are numbers") {
  CHECK(as_number({.text = "32", .place = {}}) == 32U);
  CHECK_FALSE(as_number({.text = "3x", .place = {}}));
  CHECK_FALSE(as_number({.text = "", .place = {}}));
  CHECK_FALSE(as_number({.text = "-1", .place = {}}));
}
