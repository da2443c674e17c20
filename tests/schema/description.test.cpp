#include "schema/descriptions/description.hpp"

#include "support/catch.hpp"

#include <algorithm>
#include <string>

namespace description_test {

using namespace axisc;
using namespace axisc::schema;

namespace {

Description of(std::string_view name) {
  auto const rows = parameters();
  auto const found =
      std::find_if(rows.begin(), rows.end(), [name](Parameter const& row) { return row.name == name; });
  REQUIRE(found != rows.end());
  return description_of(*found);
}

}  // namespace

TEST_CASE("every parameter has a meaning in both languages") {
  std::size_t inferred = 0;
  for (Parameter const& parameter : parameters()) {
    auto const description = description_of(parameter);
    INFO(parameter.name);
    CHECK_FALSE(description.what.english.empty());
    CHECK_FALSE(description.what.german.empty());
    for (auto const& value : description.values) CHECK_FALSE(value.meaning.german.empty());
    if (description.inferred) ++inferred;
  }
  CHECK(inferred < 150);
}

TEST_CASE("values are described with their names") {
  auto const type = of("filter_fir.type");
  CHECK_FALSE(type.inferred);
  REQUIRE(type.values.size() == 5);
  CHECK(type.values[2].value == "2");
  CHECK(type.values[2].meaning.english == "Gaussian");
  CHECK(type.values[2].meaning.german == "Gau\xC3\x9F");
  CHECK(of("kenngr.achs_mode").values.size() >= 7);
}

TEST_CASE("a name without a description has that of its number, else that of its family") {
  CHECK(of("lr_param.improved_position_control.stage[].filter[].order").what.english ==
        of("lr_param.improved_position_control.stage[].filter.order").what.english);
  auto const data = of("antr.canopen.in[].offset");
  CHECK(data.inferred);
  CHECK(data.what.english == "process data that a CANopen drive sends");
}

TEST_CASE("what the control reads at start-up only") {
  for (std::string_view const name : {"kopf.achs_nr", "kenngr.achs_typ", "kenngr.antr_typ",
                                      "lr_hw[].da_channel", "getriebe[].wegaufz", "trafo.actual_pos.id"}) {
    INFO(name);
    CHECK(of(name).restart);
  }
  CHECK_FALSE(of("filter[].fg_f0").restart);
  CHECK_FALSE(of("kopf.log_achs_name").restart);
}

TEST_CASE("words of an enumeration are described by the words that it has") {
  for (Parameter const& parameter : parameters()) {
    if (!parameter.is_enumeration()) continue;
    for (auto const& value : description_of(parameter).values) {
      INFO(parameter.name << ' ' << value.value);
      bool const is_symbol = std::any_of(parameter.symbols.begin(), parameter.symbols.end(),
                                         [&](Symbol const& symbol) { return symbol.word == value.value; });
      bool const is_number = value.value.find_first_not_of("0123456789") == std::string_view::npos;
      CHECK((is_symbol || is_number));
    }
  }
}

}  // namespace description_test
