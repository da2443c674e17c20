// Facts that the manuals state or that the language definition corrects, by hand.
#include "schema/catalogue.hpp"
#include "support/catch.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace facts_test {

namespace {

using namespace axisc::schema;

Parameter const& row(std::string_view concrete_name) {
  NameLookup const lookup = find(concrete_name);
  INFO(concrete_name);
  REQUIRE(lookup.status == NameLookup::Status::found);
  return parameter(lookup.parameter);
}

std::optional<int> number_of(Parameter const& parameter, std::string_view word) {
  for (Symbol const& symbol : parameter.symbols) {
    if (symbol.word == word) return symbol.number;
  }
  FAIL("no symbol " << word);
  return std::nullopt;
}

std::string interval(Parameter const& parameter) {
  auto const text = [](Limit const& limit) {
    if (limit.kind == Limit::Kind::none) return std::string();
    if (limit.kind == Limit::Kind::parameter) return p_axis_text(limit.p_axis);
    std::string number = std::to_string(limit.number);
    number.erase(number.find_last_not_of('0') + 1);
    if (number.back() == '.') number.pop_back();
    return number;
  };
  return (parameter.minimum.open ? "(" : "[") + text(parameter.minimum) + ", " + text(parameter.maximum) +
         (parameter.maximum.open ? ")" : "]");
}

struct Fact {
  std::string_view name;
  std::uint16_t p_axis;
  DataType type;
  std::string_view default_text;
  std::string_view range;
  std::string_view unit;
};

TEST_CASE("the parameters of the compiled families are as documented") {
  std::string const control = "lr_param.improved_position_control";
  std::string const interface_filter = "lr_param.add_interface.filter[0]";
  std::vector<std::string> const built = {interface_filter + ".order",
                                          interface_filter + ".fg_f0",
                                          interface_filter + ".guete",
                                          interface_filter + ".share_percent",
                                          interface_filter + ".time_constant",
                                          control + ".enable",
                                          control + ".v_add_max_fact",
                                          control + ".stage[2].filter.order",
                                          control + ".stage[2].filter[1].order",
                                          control + ".stage[0].filter[0].fg_f0",
                                          control + ".stage[0].filter[0].q_factor",
                                          control + ".stage[0].osc_damping",
                                          control + ".stage[0].filter.damping"};
  std::vector<Fact> const facts = {
      {"filter[0].fg_f0", 67, DataType::real64, "3.000000e+001", "[0, ]", "Hz"},
      {"filter[0].guete", 80, DataType::real64, "1.0", "[1, 10]", ""},
      {"filter[0].order", 140, DataType::uns32, "0", "[, ]", ""},
      {"filter[0].prototype", 153, DataType::string, "CRIT_DAMPING", "[, ]", ""},
      {"filter[0].share_percent", 164, DataType::real64, "1.000000e+002", "[0, 100]", "%"},
      {"filter[0].type", 204, DataType::string, "LOWPASS", "[, ]", ""},
      {"filter[0].enable", 319, DataType::boolean, "FALSE", "[, ]", ""},
      {"filter[0].time_constant", 357, DataType::uns32, "10000", "[, ]", "us"},
      {"filter_fir.enable", 573, DataType::boolean, "FALSE", "[, ]", ""},
      {"filter_fir.fcut", 585, DataType::real64, "30", "[1, ]", "Hz"},
      {"filter_fir.type", 586, DataType::uns32, "0", "[0, 4]", ""},
      {"filter_fir.order", 587, DataType::uns32, "0", "[, ]", ""},
      {"filter_fir.share", 590, DataType::uns32, "100", "[0, 100]", "%"},
      {"filter_fir.order_time", 591, DataType::uns32, "0", "[, ]", "us"},
      {"filter_fir.quality", 593, DataType::real64, "1.0", "(0, 1]", ""},
      {"vib_guard.damping", 568, DataType::real64, "0.1", "[0, 1]", ""},
      {"vib_guard.mode", 571, DataType::uns32, "1", "[1, 4]", ""},
      {"lr_param.add_interface.enable", 732, DataType::boolean, "TRUE", "[, ]", ""},
      {built[0], 736, DataType::uns32, "2", "[, ]", ""},
      {built[1], 739, DataType::real64, "30", "(0, ]", "Hz"},
      {built[2], 740, DataType::real64, "1.0", "[1, 10]", ""},
      {built[3], 741, DataType::real64, "1.000000e+002", "[0, 100]", "%"},
      {built[4], 742, DataType::uns32, "0", "[, ]", "us"},
      {built[5], 758, DataType::boolean, "FALSE", "[, ]", ""},
      {built[6], 757, DataType::uns16, "0", "[0, 2000]", "0.1 %"},
      {built[7], 750, DataType::uns32, "0", "[1, 3]", ""},
      {built[8], 750, DataType::uns32, "0", "[1, 3]", ""},
      {built[9], 751, DataType::real64, "-1", "(0, 500]", "Hz"},
      {built[10], 752, DataType::real64, "-1", "[1, 10]", ""},
      {built[11], 850, DataType::real64, "-1", "[, ]", ""},
      {built[12], 756, DataType::real64, "-1", "[, ]", ""},
      {"kenngr.filter_position_window", 351, DataType::real64, "0.4", "[0.01, ]", "0.1 um"},
  };
  for (Fact const& fact : facts) {
    Parameter const& parameter = row(fact.name);
    INFO(fact.name);
    CHECK(parameter.p_axis == fact.p_axis);
    CHECK(parameter.type == fact.type);
    CHECK(parameter.has_default);
    CHECK(parameter.default_text == fact.default_text);
    CHECK(interval(parameter) == fact.range);
    CHECK(parameter.unit_translatory == fact.unit);
  }
}

TEST_CASE("three standard filters, one in the additional interface, three stages of two filters") {
  CHECK(row("filter[0].order").array[0] == 3);
  CHECK(row("lr_param.add_interface.filter[0].order").array[0] == 1);
  auto const& stage = row("lr_param.improved_position_control.stage[0].filter[0].order").array;
  CHECK(stage[0] == 3);
  CHECK(stage[1] == 2);
}

TEST_CASE("the same words and numbers choose prototype and type in both places") {
  for (std::string_view const name : {"filter[0].prototype", "lr_param.add_interface.filter[0].prototype"}) {
    Parameter const& prototype = row(name);
    CHECK(number_of(prototype, "CRIT_DAMPING") == 1);
    CHECK(number_of(prototype, "BUTTERWORTH") == 2);
    CHECK(number_of(prototype, "BESSEL") == 3);
    CHECK(number_of(prototype, "HSC") == 5);
    CHECK(prototype.symbols.size() == 4);
  }
  for (std::string_view const name : {"filter[0].type", "lr_param.add_interface.filter[0].type"}) {
    Parameter const& type = row(name);
    CHECK(number_of(type, "LOWPASS") == 1);
    CHECK(number_of(type, "HIGHPASS") == 2);
    CHECK(number_of(type, "BANDPASS") == 3);
    CHECK(number_of(type, "BANDSTOP") == 4);
    CHECK(number_of(type, "ALLPASS") == 5);
    CHECK(number_of(type, "PT1") == 6);
    CHECK(number_of(type, "HSC_SINE") == 7);
    CHECK(number_of(type, "HSC_MEAN") == 8);
    CHECK(number_of(type, "HSC_GAUSS") == 9);
    CHECK(number_of(type, "PT2") == 10);
    CHECK(number_of(type, "TIME_DELAY") == 11);
    CHECK(number_of(type, "HSC_SHAPER") == 12);
    CHECK(number_of(type, "PT2_FD") == 13);
    CHECK(type.symbols.size() == 13);
  }
  CHECK(row("lr_param.add_interface.filter[0].type").default_text == "PT2");
}

TEST_CASE("the filters of a stage are chosen by words only") {
  Parameter const& type = row("lr_param.improved_position_control.stage[0].filter[1].type");
  CHECK(type.p_axis == 849);
  CHECK(type.symbols.size() == 3);
  for (std::string_view const word : {"NO_FILTER", "BANDPASS", "ALLPASS"}) CHECK_FALSE(number_of(type, word));
}

TEST_CASE("drive types have names for people and no words for lists") {
  Parameter const& drive = row("kenngr.antr_typ");
  CHECK(drive.p_axis == 20);
  CHECK(drive.type == DataType::uns16);
  CHECK_FALSE(drive.is_enumeration());
  std::vector<std::pair<int, std::string_view>> const expected = {
      {1, "conventional"}, {2, "SERCOS"},      {3, "PROFIDRIVE"}, {4, "simulation"}, {5, "Lightbus"},
      {6, "terminal"},     {7, "RT Ethernet"}, {8, "CANopen"},    {16, "virtual"},   {32, "CAN"}};
  REQUIRE(drive.number_names.size() == expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    CHECK(drive.number_names[i].number == expected[i].first);
    CHECK(drive.number_names[i].word == expected[i].second);
  }
}

TEST_CASE("only the Gaussian's quality is not for every axis") {
  for (Parameter const& parameter : parameters()) {
    INFO(parameter.name);
    CHECK(parameter.axis_types == (parameter.p_axis == 593 ? "TR" : ""));
  }
}

TEST_CASE("booleans know FALSE and TRUE") {
  for (Parameter const& parameter : parameters()) {
    if (parameter.type != DataType::boolean) continue;
    CHECK(number_of(parameter, "FALSE") == 0);
    CHECK(number_of(parameter, "TRUE") == 1);
    CHECK_FALSE(parameter.is_enumeration());
  }
}

TEST_CASE("limits of data types and of other parameters") {
  Parameter const& number = row("kopf.achs_nr");
  CHECK(number.p_axis == 16);
  CHECK(interval(number) == "(0, 65535)");
  Parameter const& acceleration = row("getriebe[5].slope_profil.a_beschl");
  CHECK(interval(acceleration) == "[1, P-AXIS-00008]");
  CHECK(acceleration.unit_translatory == "mm/s^2");
  CHECK(acceleration.unit_rotary == "deg/s^2");
}

TEST_CASE("defaults: empty, none, or the value of another parameter") {
  Parameter const& empty = row("antr.ethercat_master_name");
  CHECK(empty.has_default);
  CHECK(empty.default_text.empty());
  CHECK(empty.max_length == 29);
  Parameter const& none = row("kenngr.homing_type");
  CHECK_FALSE(none.has_default);
  CHECK(none.p_axis == 0);
  CHECK_FALSE(row("getriebe[0].dynamik.a_w_max").has_default);
  CHECK(row("lr_param.ext_comp.max_a").default_text == "P-AXIS-00008");
}

TEST_CASE("builds that introduced a family") {
  CHECK(row("filter_fir.order").since == "V3.1.3075.00");
  CHECK(row("filter_fir.quality").since == "V3.1.3075.04");
  CHECK(row("vib_guard.active").since == "V3.1.3075.00");
  CHECK(row("lr_param.improved_position_control.stage[0].mode").since == "V3.1.3077.08");
  CHECK(row("lr_param.improved_position_control.stage[0].filter[0].order").since == "V3.1.3132.0");
  CHECK(row("lr_param.improved_position_control.stage[0].osc_damping").since == "V3.1.3132.0");
  CHECK(row("filter[0].order").since.empty());
}

}  // namespace

}  // namespace facts_test
