#include "schema/parameter_row.hpp"
#include "support/catch.hpp"

#include <string>
#include <vector>

namespace extension_test {

using namespace axisc::schema;

namespace {

ParameterRow row_of(std::string_view name) {
  for (Parameter const& parameter : parameters()) {
    if (parameter.name == name) return ParameterRow::from(parameter);
  }
  FAIL("no such row");
  return {};
}

ParameterRow new_row() {
  ParameterRow row;
  row.name = "getriebe[].new_limit";
  row.p_axis = 900;
  row.type = DataType::uns16;
  row.array = {6, 0};
  row.default_text = "7";
  row.file = "extra.json";
  return row;
}

}  // namespace

TEST_CASE("the catalogue without schema files is the built-in one") {
  Catalogue const catalogue;
  CHECK(catalogue.is_built_in());
  CHECK(catalogue.parameters().data() == parameters().data());
  CHECK(catalogue.slot_count() == slot_count());
  NameLookup const found = catalogue.find("filter[1].order");
  CHECK(found.slot == find("filter[1].order").slot);
  CHECK(found.row == &parameter(found.parameter));
}

TEST_CASE("an added parameter is known by name, number and slot") {
  Catalogue const catalogue = Catalogue().with({new_row()});
  NameLookup const found = catalogue.find("getriebe[2].new_limit");
  REQUIRE(found.status == NameLookup::Status::found);
  CHECK(found.row->p_axis == 900);
  CHECK(found.index[0] == 2);
  CHECK(slot_name(*found.row, found.slot) == "getriebe[2].new_limit");
  CHECK(indices_of(*found.row, found.slot)[0] == 2);
  CHECK(&catalogue.parameter_of(found.slot) == found.row);
  CHECK(catalogue.slot_count() == slot_count() + 6);
  REQUIRE(catalogue.find_number(900).size() == 1);
  CHECK(&catalogue.parameter(catalogue.find_number(900)[0]) == found.row);
  CHECK(catalogue.file_of(*found.row) == "extra.json");

  CHECK(catalogue.find("Getriebe[2].New_limit").case_folded);
  NameLookup const beyond = catalogue.find("getriebe[6].new_limit");
  CHECK(beyond.status == NameLookup::Status::index_out_of_range);
  CHECK(beyond.array_size == 6);
  CHECK(catalogue.find("getriebe.new_limit").status == NameLookup::Status::index_missing);
  CHECK(catalogue.find("getriebe[2].other_limit").status == NameLookup::Status::unknown);
  CHECK(catalogue.suggest_names("getriebe[2].new_limt").names ==
        std::vector<std::string>{"getriebe[2].new_limit"});
}

TEST_CASE("what a schema file does not name stays as it is built in") {
  Catalogue const catalogue = Catalogue().with({new_row()});
  for (std::size_t i = 0; i < slot_count(); ++i) {
    auto const slot = static_cast<Slot>(i);
    std::string const name = slot_name(slot);
    NameLookup const found = catalogue.find(name);
    REQUIRE(found.status == NameLookup::Status::found);
    CHECK(found.slot == slot);
    CHECK(found.row == &catalogue.parameter_of(slot));
    CHECK(slot_name(*found.row, slot) == name);
  }
  CHECK(catalogue.file_of(catalogue.parameters().front()).empty());
}

TEST_CASE("a row of a known name replaces that row and keeps its slots") {
  ParameterRow row = row_of("filter[].type");
  row.symbols = {{"LOWPASS", 1}, {"NEWPASS", 30}};
  row.file = "extra.json";
  Catalogue const catalogue = Catalogue().with({row});
  NameLookup const found = catalogue.find("filter[2].type");
  CHECK(found.slot == find("filter[2].type").slot);
  CHECK(found.parameter == find("filter[2].type").parameter);
  REQUIRE(found.row->symbols.size() == 2);
  CHECK(found.row->symbols[1].word == "NEWPASS");
  CHECK(catalogue.slot_count() == slot_count());
  CHECK(catalogue.is_symbol_of_any_parameter("NEWPASS"));
  CHECK(catalogue.is_symbol_of_any_parameter("BANDPASS"));
  CHECK_FALSE(Catalogue().is_symbol_of_any_parameter("NEWPASS"));
}

TEST_CASE("more entries get slots of their own") {
  ParameterRow row = row_of("getriebe[].dynamik.vb_max");
  row.array = {9, 0};
  Catalogue const catalogue = Catalogue().with({row});
  NameLookup const first = catalogue.find("getriebe[0].dynamik.vb_max");
  NameLookup const last = catalogue.find("getriebe[8].dynamik.vb_max");
  REQUIRE(last.status == NameLookup::Status::found);
  CHECK(static_cast<std::size_t>(first.slot) == slot_count());
  CHECK(static_cast<std::size_t>(last.slot) == slot_count() + 8);
  CHECK(slot_name(*last.row, last.slot) == "getriebe[8].dynamik.vb_max");
  CHECK(first.parameter == find("getriebe[0].dynamik.vb_max").parameter);
}

TEST_CASE("later rows win over earlier ones of the same name") {
  ParameterRow later = new_row();
  later.default_text = "8";
  Catalogue const catalogue = Catalogue().with({new_row()}).with({later});
  CHECK(catalogue.find("getriebe[0].new_limit").row->default_text == "8");
  CHECK(catalogue.slot_count() == slot_count() + 6);
}

TEST_CASE("rows live as long as a copy of their catalogue") {
  Catalogue copy;
  Parameter const* row = nullptr;
  {
    Catalogue const catalogue = Catalogue().with({new_row()});
    row = catalogue.find("getriebe[0].new_limit").row;
    copy = catalogue;
  }
  CHECK(row->name == "getriebe[].new_limit");
  CHECK(copy.find("getriebe[0].new_limit").row == row);
}

}  // namespace extension_test
