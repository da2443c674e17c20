#include "schema/catalogue.hpp"

#include "schema/indexed_name.hpp"
#include "support/catch.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace catalogue_test {

namespace {

using namespace axisc::schema;
using Status = NameLookup::Status;

std::string upper_case(std::string text) {
  for (char& byte : text) {
    if (byte >= 'a' && byte <= 'z') byte = static_cast<char>(byte - 'a' + 'A');
  }
  return text;
}

std::string_view row_name(NameLookup const& lookup) {
  return parameter(lookup.parameter).name;
}

TEST_CASE("every concrete name finds its slot, and every slot tells its name") {
  std::set<std::string> names;
  for (std::size_t i = 0; i < slot_count(); ++i) {
    auto const slot = static_cast<Slot>(i);
    std::string const name = slot_name(slot);
    names.insert(name);
    NameLookup const lookup = find(name);
    INFO(name);
    REQUIRE(lookup.status == Status::found);
    REQUIRE(lookup.slot == slot);
    REQUIRE(lookup.parameter == parameter_of(slot));
    REQUIRE(lookup.index == indices_of(slot));
    REQUIRE_FALSE(lookup.case_folded);
    REQUIRE(slot_of(lookup.parameter, lookup.index[0], lookup.index[1]) == slot);
  }
  CHECK(names.size() == slot_count());
  CHECK(slot_count() == 2595);
}

TEST_CASE("a name of which one byte differs is no name, or that of another slot") {
  for (std::size_t i = 0; i < slot_count(); ++i) {
    std::string const name = slot_name(static_cast<Slot>(i));
    std::vector<std::string> changed(name.size(), name);
    for (std::size_t place = 0; place < name.size(); ++place) {
      changed[place][place] = static_cast<char>(changed[place][place] ^ 1);
    }
    for (std::size_t first = 0; first < changed.size(); first += names_at_once) {
      std::size_t const count = std::min(changed.size() - first, names_at_once);
      std::vector<std::string_view> const names(changed.begin() + static_cast<std::ptrdiff_t>(first),
                                                changed.begin() + static_cast<std::ptrdiff_t>(first + count));
      std::array<PlainParameter, names_at_once> found;
      find_plain(names, found);
      for (std::size_t k = 0; k < count; ++k) {
        bool const is_found = found[k].values != nullptr;
        if (is_found && slot_name(found[k].slot) != names[k]) FAIL(names[k]);
        ConcreteParameter const exact = find_exact(names[k]);
        if (static_cast<bool>(exact) != is_found || (is_found && exact.slot != found[k].slot)) FAIL(names[k]);
      }
    }
  }
}

TEST_CASE("every concrete name is found after case folding") {
  for (std::size_t i = 0; i < slot_count(); ++i) {
    auto const slot = static_cast<Slot>(i);
    NameLookup const lookup = find(upper_case(slot_name(slot)));
    REQUIRE(lookup.status == Status::found);
    REQUIRE(lookup.slot == slot);
    REQUIRE(lookup.case_folded);
  }
  CHECK(find("Lr_param.add_interface.enable").case_folded);
  CHECK(row_name(find("Lr_param.add_interface.enable")) == "lr_param.add_interface.enable");
}

TEST_CASE("every row is known by its name without indices") {
  for (Parameter const& parameter : parameters()) {
    std::string const bare = without_brackets(parameter.name);
    NameLookup const lookup = find(bare);
    INFO(bare);
    // Of rows with one name those with fewer indices are nearer.
    REQUIRE(lookup.row != nullptr);
    REQUIRE(without_brackets(lookup.row->name) == bare);
    REQUIRE(lookup.row->index_count() <= parameter.index_count());
    REQUIRE(lookup.status == (lookup.row->index_count() == 0 ? Status::found : Status::index_missing));
  }
}

TEST_CASE("the slots of the rows are dense and in order") {
  std::size_t next = 0;
  for (Parameter const& row : parameters()) {
    INFO(row.name);
    REQUIRE(static_cast<std::size_t>(row.first_slot) == next);
    next += row.slots;
    std::size_t const brackets = static_cast<std::size_t>(std::count(row.name.begin(), row.name.end(), '['));
    REQUIRE(row.index_count() == brackets);
  }
  CHECK(next == slot_count());
}

TEST_CASE("a name just outside of its array is out of range, at the right index") {
  for (std::size_t i = 0; i < parameters().size(); ++i) {
    Parameter const& row = parameters()[i];
    for (std::size_t position = 0; position < row.index_count(); ++position) {
      std::string name;
      std::size_t seen = 0;
      for (char const byte : row.name) {
        name += byte;
        if (byte == '[') name += seen++ == position ? std::to_string(row.array.at(position)) : "0";
      }
      NameLookup const lookup = find(name);
      INFO(name);
      REQUIRE(lookup.status == Status::index_out_of_range);
      REQUIRE(lookup.parameter == static_cast<ParameterId>(i));
      REQUIRE(lookup.index_position == position);
      REQUIRE(lookup.array_size == row.array.at(position));
      REQUIRE(lookup.index.at(position) == row.array.at(position));
    }
  }
}

TEST_CASE("an index too large for any number is out of range") {
  CHECK(find("filter[99999999999999999999].order").status == Status::index_out_of_range);
}

TEST_CASE("a name without its index, or with one too many, names the row it means") {
  NameLookup const missing = find("filter.order");
  CHECK(missing.status == Status::index_missing);
  CHECK(row_name(missing) == "filter[].order");
  CHECK(missing.array_size == 3);

  NameLookup const superfluous = find("kopf[0].achs_nr");
  CHECK(superfluous.status == Status::index_superfluous);
  CHECK(row_name(superfluous) == "kopf.achs_nr");

  NameLookup const misplaced = find("filter.order[0]");
  CHECK(misplaced.status == Status::index_missing);
  CHECK(row_name(misplaced) == "filter[].order");

  NameLookup const second = find("filter[0].order[1]");
  CHECK(second.status == Status::index_superfluous);
  CHECK(second.index_position == 1);

  NameLookup const folded = find("Filter.Order");
  CHECK(folded.status == Status::index_missing);
  CHECK(folded.case_folded);
}

TEST_CASE("two generations of one name are told apart by their indices") {
  std::string const stage = "lr_param.improved_position_control.stage";
  CHECK(row_name(find(stage + "[0].filter.order")) == stage + "[].filter.order");
  CHECK(row_name(find(stage + "[0].filter[1].order")) == stage + "[].filter[].order");

  NameLookup const outside = find(stage + "[0].filter[2].order");
  CHECK(outside.status == Status::index_out_of_range);
  CHECK(outside.index_position == 1);
  CHECK(outside.array_size == 2);

  NameLookup const without_stage_index = find(stage + ".filter[0].order");
  CHECK(without_stage_index.status == Status::index_missing);
  CHECK(row_name(without_stage_index) == stage + "[].filter[].order");
  CHECK(row_name(find(stage + ".filter.order")) == stage + "[].filter.order");
}

TEST_CASE("other names are unknown") {
  for (std::string_view const name :
       {"", ".", "filter", "filter[0]", "filter[0].", "filter[0].ordr", "filter[0]..order", "filter[].order",
        "filter[x].order", "filter[-1].order", "filter[0]order", "filter[0", "[0].order", "order", "x.y.z",
        "filter[0].order.x", "kopf.achs_nr ", "\x80", "filter_order"}) {
    INFO(name);
    CHECK(find(name).status == Status::unknown);
    CHECK_FALSE(find(name).case_folded);
  }
}

TEST_CASE("any name of up to three bytes is answered") {
  std::string name(3, '\0');
  for (unsigned first = 0; first < 256; ++first) {
    for (unsigned second = 0; second < 256; second += 5) {
      name[0] = static_cast<char>(first);
      name[2] = static_cast<char>(second);
      REQUIRE(find(name).status == Status::unknown);
    }
  }
}

TEST_CASE("numbers lead to all names that share them") {
  std::size_t rows = 0;
  for (std::uint32_t number = 0; number <= UINT16_MAX; ++number) {
    for (ParameterId const id : find_number(static_cast<std::uint16_t>(number))) {
      REQUIRE(parameter(id).p_axis == number);
      ++rows;
    }
  }
  std::size_t const numbered = static_cast<std::size_t>(std::count_if(
      parameters().begin(), parameters().end(), [](Parameter const& row) { return row.p_axis != 0; }));
  CHECK(rows == numbered);
  CHECK(find_number(0).empty());
  CHECK(find_number(140).size() == 1);
  CHECK(find_number(750).size() == 2);
  CHECK(find_number(849).size() == 1);
  CHECK(find_number(UINT16_MAX).empty());
}

TEST_CASE("numbers are written with five digits") {
  CHECK(p_axis_text(140) == "P-AXIS-00140");
  CHECK(p_axis_text(65535) == "P-AXIS-65535");
  CHECK(p_axis_text(0).empty());
}

TEST_CASE("every data type has its name") {
  CHECK(data_type_name(DataType::boolean) == "BOOLEAN");
  CHECK(data_type_name(DataType::uns08) == "UNS08");
  CHECK(data_type_name(DataType::sgn64) == "SGN64");
  CHECK(data_type_name(DataType::real64) == "REAL64");
  CHECK(data_type_name(DataType::string) == "STRING");
}

TEST_CASE("words of enumerations are known as such") {
  for (Parameter const& row : parameters()) {
    for (Symbol const& symbol : row.symbols) REQUIRE(is_symbol_of_any_parameter(symbol.word));
  }
  CHECK_FALSE(is_symbol_of_any_parameter("lowpass"));
  CHECK_FALSE(is_symbol_of_any_parameter("LOWPAS"));
  CHECK_FALSE(is_symbol_of_any_parameter(""));
  CHECK_FALSE(is_symbol_of_any_parameter("SERCOS"));  // a name for people, not for lists
}

}  // namespace

}  // namespace catalogue_test
