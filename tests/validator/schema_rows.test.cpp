// The catalogue with rows of schema files, as checks see it.
#include "diagnostics/writers/writers.hpp"
#include "schema/parameter_row.hpp"
#include "support/catch.hpp"
#include "support/checked.hpp"
#include "support/random_lists.hpp"

#include <string>

namespace schema_rows_test {

namespace {

using namespace axisc;
using tests::Checked;
using tests::Lines;

validator::CheckOptions with_rows(std::vector<schema::ParameterRow> rows) {
  validator::CheckOptions options = tests::with_cycle_time();
  options.catalogue = schema::Catalogue().with(std::move(rows));
  return options;
}

schema::ParameterRow row_of(std::string_view name) {
  for (schema::Parameter const& parameter : schema::parameters()) {
    if (parameter.name == name) return schema::ParameterRow::from(parameter);
  }
  FAIL("no such row");
  return {};
}

std::string report_of(Checked const& checked) {
  std::string text;
  for (Finding const& finding : checked.result.findings) text += write_text(finding, checked.sources, {});
  return text;
}

}  // namespace

TEST_CASE("rows that say what is built in change nothing") {
  std::vector<schema::ParameterRow> rows;
  for (schema::Parameter const& parameter : schema::parameters()) {
    rows.push_back(schema::ParameterRow::from(parameter));
  }
  validator::CheckOptions const none = with_rows({});
  validator::CheckOptions const all = with_rows(std::move(rows));
  for (std::uint32_t seed = 0; seed < 300; ++seed) {
    std::string const list = tests::random_list(seed);
    INFO(list);
    std::string const expected = report_of(Checked(list));
    CHECK(report_of(Checked(list, none)) == expected);
    CHECK(report_of(Checked(list, all)) == expected);
  }
}

TEST_CASE("another default is what counts where no list sets the parameter") {
  std::string const list = "filter[0].enable 1\nfilter[0].order 1\nfilter[0].type TIME_DELAY\n";
  CHECK(Checked(list).found() == Lines{"1:18 AX3005"});
  schema::ParameterRow row = row_of("filter[].time_constant");
  row.default_text = "3000";
  CHECK(Checked(list, with_rows({row})).found().empty());
}

TEST_CASE("more entries of an array are looked at like the others") {
  schema::ParameterRow row = row_of("getriebe[].dynamik.a_max");
  std::uint16_t const entries = row.array[0];
  row.array[0] = static_cast<std::uint16_t>(entries + 2);
  std::string const list =
      "getriebe[" + std::to_string(entries) + "].dynamik.a_max -1\ngetriebe[0].dynamik.a_max -1\n";
  CHECK(Checked(list).found() == Lines{"1:1 AX2002", "2:27 AX2004"});
  CHECK(Checked(list, with_rows({row})).found() == Lines{"1:27 AX2004", "2:27 AX2004"});
}

TEST_CASE("limits and references reach what a schema file adds") {
  schema::ParameterRow limit;
  limit.name = "kopf.new_limit";
  limit.p_axis = 900;
  limit.type = schema::DataType::uns32;
  limit.default_text = "10";
  schema::ParameterRow limited = limit;
  limited.name = "kopf.new_value";
  limited.p_axis = 901;
  limited.maximum = {.number = 0, .p_axis = 900, .kind = schema::Limit::Kind::parameter, .open = false};
  auto const options = with_rows({limit, limited});
  CHECK(Checked("kopf.new_value 11\n", options).found() == Lines{"1:16 AX2015"});
  CHECK(Checked("kopf.new_value 11\nkopf.new_limit 12\n", options).found().empty());
  CHECK(Checked("kopf.new_value P-AXIS-00900\nkopf.new_limit 12\n", options).found().empty());
  CHECK(Checked("kopf.new_value P-AXIS-00902\n", options).found() == Lines{"1:16 AX2010"});
}

TEST_CASE("a row of several entries may be for some axis types only") {
  schema::ParameterRow row;
  row.name = "kopf.new_value[]";
  row.p_axis = 901;
  row.type = schema::DataType::uns32;
  row.array = {3, 0};
  row.axis_types = "R";
  auto const options = with_rows({row});
  std::string const list = "kopf.new_value[0] 1\nkopf.achs_nr 1\nkopf.new_value[2] 1\n";
  CHECK(Checked(list, options).found() == Lines{"1:19 AX2009", "3:19 AX2009"});
  CHECK(Checked(list + "kenngr.achs_typ 2\n", options).found().empty());
}

}  // namespace schema_rows_test
