// The tables hold exactly what the data file says; read here by another path than the generator's.
#include "schema/catalogue.hpp"
#include "support/catch.hpp"
#include "support/golden.hpp"
#include "support/sarif_schema.hpp"

#include <cstddef>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace data_test {

namespace {

using namespace axisc::schema;

nlohmann::json read_data() {
  std::ifstream file(std::string(AXISC_SOURCE_DIR) + "/schema/axis-parameters.json");
  REQUIRE(file.good());
  return nlohmann::json::parse(file).at("parameters");
}

void check_limit(Limit const& limit, nlohmann::json const& row, std::string const& key) {
  std::string const open_key = "exclusive_" + key;
  bool const open = row.contains(open_key);
  if (!open && !row.contains(key)) {
    REQUIRE(limit.kind == Limit::Kind::none);
    return;
  }
  REQUIRE(limit.open == open);
  auto const& value = row.at(open ? open_key : key);
  if (value.is_number()) {
    REQUIRE(limit.kind == Limit::Kind::number);
    REQUIRE(limit.number == value.get<double>());
  } else if (value.get<std::string>().starts_with("P-AXIS-")) {
    REQUIRE(limit.kind == Limit::Kind::parameter);
    REQUIRE(p_axis_text(limit.p_axis) == value.get<std::string>());
    REQUIRE_FALSE(find_number(limit.p_axis).empty());
  } else {
    REQUIRE(limit.kind == Limit::Kind::number);
    std::string const type = value.get<std::string>().substr(4, 5);
    if (type == "UNS16") REQUIRE(limit.number == std::numeric_limits<std::uint16_t>::max());
    if (type == "UNS32") REQUIRE(limit.number == std::numeric_limits<std::uint32_t>::max());
    if (type == "SGN16") REQUIRE(std::abs(limit.number) >= std::numeric_limits<std::int16_t>::max());
    if (type == "SGN32") REQUIRE(std::abs(limit.number) >= std::numeric_limits<std::int32_t>::max());
    REQUIRE((limit.number < 0) == value.get<std::string>().starts_with("MIN"));
  }
}

TEST_CASE("the tables repeat the data file row by row") {
  auto const rows = read_data();
  REQUIRE(rows.size() == parameters().size());
  CHECK(rows.size() == 823);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Parameter const& parameter = parameters()[i];
    auto const& row = rows[i];
    INFO(parameter.name);
    REQUIRE(parameter.name == row.at("name").get<std::string>());
    REQUIRE(p_axis_text(parameter.p_axis) == row.value("id", ""));
    REQUIRE(data_type_name(parameter.type) == row.at("type").get<std::string>());
    REQUIRE(parameter.has_default == row.contains("default"));
    REQUIRE(parameter.default_text == row.value("default", ""));
    REQUIRE(parameter.max_length == row.value("max_length", 0));
    REQUIRE(parameter.former_name == row.value("former_name", ""));
    REQUIRE(parameter.since == row.value("since", ""));
    std::size_t const own_symbols = row.contains("symbols") ? row.at("symbols").size() : 0;
    REQUIRE(parameter.symbols.size() == own_symbols + (parameter.type == DataType::boolean ? 2U : 0U));
    for (Symbol const& symbol : parameter.symbols) {
      if (!row.contains("symbols") || !row.at("symbols").contains(symbol.word)) continue;
      auto const& number = row.at("symbols").at(std::string(symbol.word));
      REQUIRE(symbol.number.has_value() == !number.is_null());
      if (symbol.number) REQUIRE(*symbol.number == number.get<int>());
    }
    auto const array = row.value("array", nlohmann::json::array());
    REQUIRE(parameter.index_count() == array.size());
    for (std::size_t k = 0; k < array.size(); ++k) REQUIRE(parameter.array.at(k) == array[k].get<int>());
    check_limit(parameter.minimum, row, "minimum");
    check_limit(parameter.maximum, row, "maximum");
  }
}

std::vector<std::string> complaints_about(std::string const& data) {
  return axisc::test::schema_complaints(
      data, axisc::test::read_source_file("docs/schemas/schema-file.schema.json"));
}

std::string document(std::string const& rows) {
  return R"({"version": 1, "parameters": [)" + rows + "]}";
}

void forbids(std::string const& data, std::string const& reason) {
  INFO(data);
  std::string complaints;
  for (auto const& complaint : complaints_about(data)) complaints += complaint + "\n";
  CHECK_THAT(complaints, !Catch::Matchers::Equals("") && Catch::Matchers::Contains(reason));
}

TEST_CASE("the catalogue follows its JSON schema") {
  CHECK(complaints_about(axisc::test::read_source_file("schema/axis-parameters.json")).empty());
}

TEST_CASE("its JSON schema forbids what is not a row") {
  forbids("[]", "");
  forbids(R"({"version": 2, "parameters": [{"name": "a", "type": "UNS08"}]})", "version");
  forbids(document(R"({"name": "a", "type": "UNS12"})"), "type");
  forbids(document(R"({"name": "A", "type": "UNS08"})"), "name");
  forbids(document(R"({"name": "a", "type": "UNS08", "defualt": "1"})"), "defualt");
  forbids(document(R"({"name": "a", "type": "UNS08", "minimum": 1, "exclusive_minimum": 1})"), "[0]");
  forbids(document(R"json({"name": "a", "type": "UNS08", "minimum": "MIN(UNS12)"})json"), "minimum");
  forbids(document(R"({"id": "P-AXIS-1", "name": "a", "type": "UNS08"})"), "id");
  forbids(document(R"({"name": "a[]", "type": "UNS08", "array": [0]})"), "array");
  forbids(document(R"({"name": "a", "type": "UNS08", "since": "3075"})"), "since");
}

}  // namespace

}  // namespace data_test
