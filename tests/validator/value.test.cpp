#include "schema/value.hpp"

#include "support/catch.hpp"

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>

namespace value_test {

using namespace axisc;
using axisc::schema::DataType;

namespace {

axisc::schema::Parameter const& parameter(std::string_view name) {
  return axisc::schema::parameter(axisc::schema::find(name).parameter);
}

}  // namespace

TEST_CASE("integers fit their type or not, also beyond 64 bits") {
  struct Row {
    DataType type;
    char const* lowest;
    char const* below;
    char const* highest;
    char const* above;
  };
  for (Row const& row :
       {Row{DataType::uns08, "0", "-1", "255", "256"}, Row{DataType::uns16, "0", "-1", "65535", "0x10000"},
        Row{DataType::uns32, "0", "-1", "4294967295", "4294967296"},
        Row{DataType::uns64, "0", "-1", "18446744073709551615", "18446744073709551616"},
        Row{DataType::sgn08, "-128", "-129", "127", "128"},
        Row{DataType::sgn16, "-32768", "-32769", "32767", "32768"},
        Row{DataType::sgn32, "-2147483648", "-2147483649", "2147483647", "2147483648"},
        Row{DataType::sgn64, "-9223372036854775808", "-9223372036854775809", "9223372036854775807",
            "9223372036854775808"}}) {
    INFO(axisc::schema::data_type_name(row.type));
    CHECK(schema::read_integer(row.lowest, row.type).status == schema::NumberStatus::good);
    CHECK(schema::read_integer(row.below, row.type).status == schema::NumberStatus::out_of_data_range);
    CHECK(schema::read_integer(row.highest, row.type).status == schema::NumberStatus::good);
    CHECK(schema::read_integer(row.above, row.type).status == schema::NumberStatus::out_of_data_range);
    CHECK(schema::read_integer("99999999999999999999999", row.type).number ==
          std::numeric_limits<double>::infinity());
  }
  CHECK(schema::read_integer("-0", DataType::uns08).status == schema::NumberStatus::good);
  CHECK(schema::read_integer("+5", DataType::uns08).number == 5);
  CHECK(schema::read_integer("0x400001", DataType::uns32).number == 0x400001);
}

TEST_CASE("reals are the nearest doubles") {
  CHECK(schema::read_real("1.8").number == 1.8);
  CHECK(schema::read_real(".5").number == 0.5);
  CHECK(schema::read_real("1.").number == 1.0);
  CHECK(schema::read_real("3.000000e+001").number == 30.0);
  CHECK(schema::read_real("-0.1").number == -0.1);
  CHECK(schema::read_real("+7").number == 7.0);
  CHECK(schema::read_real("9007199254740993").number == 9007199254740992.0);
  CHECK(schema::read_real("0x10").number == 16.0);
  CHECK(schema::read_real("1e-999").status == schema::NumberStatus::good);
  CHECK(schema::read_real("1e-999").number == 0.0);
}

TEST_CASE("decimals of every length are what the C library reads") {
  std::mt19937_64 random(1990);
  for (int i = 0; i < 200'000; ++i) {
    std::size_t const digits = 1 + random() % 20;
    std::string text(1, static_cast<char>('1' + random() % 9));
    while (text.size() < digits) text += static_cast<char>('0' + random() % 10);
    CAPTURE(text);
    if (digits < 20)
      REQUIRE(schema::read_integer(text, DataType::uns64).number == std::strtod(text.c_str(), nullptr));
    std::size_t const point = random() % (digits + 1);
    bool const leads = point == 0 && random() % 2 == 0;
    text = (leads ? "0" : "") + text.insert(point, ".");
    CAPTURE(text);
    REQUIRE(schema::read_real(text).status == schema::NumberStatus::good);
    REQUIRE(schema::read_real(text).number == std::strtod(text.c_str(), nullptr));
    REQUIRE(schema::read_real("-" + text).number == -schema::read_real(text).number);
  }
}

TEST_CASE("what is no number says why") {
  for (char const* text : {"", "-", ".", "-.", "1.2.3", "1..", "12a", "1 2", "1:2", "4/2"}) {
    CAPTURE(text);
    CHECK(schema::read_real(text).status == schema::NumberStatus::not_a_number);
    CHECK(schema::read_integer(text, DataType::sgn32).status == schema::NumberStatus::not_a_number);
  }
  CHECK(schema::read_real("1e999").status == schema::NumberStatus::exponent_too_big);
  CHECK(schema::read_real("007").status == schema::NumberStatus::leading_zero);
  CHECK(schema::read_real("-01.5").status == schema::NumberStatus::leading_zero);
  CHECK(schema::read_real("0.5").status == schema::NumberStatus::good);
  for (char const* const text : {"", "+", "-", ".", "e5", "12abc", "0x", "1e", "1,8", "nan", "inf", "- 1"}) {
    INFO(text);
    CHECK(schema::read_real(text).status == schema::NumberStatus::not_a_number);
    CHECK_FALSE(schema::is_complete_number(text));
  }
}

TEST_CASE("symbols by word, by number, in another letter case") {
  auto const& type = parameter("filter[0].type");
  CHECK(schema::read_symbol(type, "PT1").symbol->number == 6);
  CHECK_FALSE(schema::read_symbol(type, "PT1").folded);
  CHECK(schema::read_symbol(type, "pt1").folded);
  CHECK(schema::read_symbol(type, "PT3").symbol == nullptr);
  CHECK(schema::symbol_of_number(type, 6)->word == "PT1");
  CHECK(schema::symbol_of_number(type, 14) == nullptr);
  CHECK(schema::symbol_of_number(parameter("kenngr.set_refpos_mode"), 1) == nullptr);
  CHECK(schema::symbol_of_number(parameter("kenngr.inverse_rotation_direction"), 1)->word == "TRUE");
}

TEST_CASE("documented defaults in every form") {
  CHECK(schema::default_value(parameter("filter[0].fg_f0"))->number == 30);
  CHECK(schema::default_value(parameter("kenngr.antr_typ"))->number == 4);
  CHECK(schema::default_value(parameter("filter[0].type"))->number == 1);
  CHECK(schema::default_value(parameter("filter[0].type"))->text == "LOWPASS");
  CHECK(schema::default_value(parameter("lr_param.add_interface.enable"))->flag());
  CHECK(schema::default_value(parameter("kopf.log_achs_name"))->text == "X_Achse");
  CHECK_FALSE(schema::default_value(parameter("getriebe[0].dynamik.a_w_max")).has_value());
}

TEST_CASE("defaults that were read when the program was built are what their texts say") {
  std::size_t count = 0;
  for (axisc::schema::Parameter const& parameter : axisc::schema::parameters()) {
    if (std::isnan(parameter.default_number)) continue;
    INFO(parameter.name << " " << parameter.default_text);
    schema::NumberReading const reading = schema::read_real(parameter.default_text);
    CHECK(reading.status == schema::NumberStatus::good);
    CHECK(reading.number == parameter.default_number);
    ++count;
  }
  CHECK(count > 400);
}

}  // namespace value_test
