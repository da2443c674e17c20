#include "schema/value.hpp"

#include "support/catch.hpp"

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>

using namespace axisc::validator;
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
    CHECK(read_integer(row.lowest, row.type).status == NumberStatus::good);
    CHECK(read_integer(row.below, row.type).status == NumberStatus::out_of_data_range);
    CHECK(read_integer(row.highest, row.type).status == NumberStatus::good);
    CHECK(read_integer(row.above, row.type).status == NumberStatus::out_of_data_range);
    CHECK(read_integer("99999999999999999999999", row.type).number ==
          std::numeric_limits<double>::infinity());
  }
  CHECK(read_integer("-0", DataType::uns08).status == NumberStatus::good);
  CHECK(read_integer("+5", DataType::uns08).number == 5);
  CHECK(read_integer("0x400001", DataType::uns32).number == 0x400001);
}

TEST_CASE("reals are the nearest doubles") {
  CHECK(read_real("1.8").number == 1.8);
  CHECK(read_real(".5").number == 0.5);
  CHECK(read_real("1.").number == 1.0);
  CHECK(read_real("3.000000e+001").number == 30.0);
  CHECK(read_real("-0.1").number == -0.1);
  CHECK(read_real("+7").number == 7.0);
  CHECK(read_real("9007199254740993").number == 9007199254740992.0);
  CHECK(read_real("0x10").number == 16.0);
  CHECK(read_real("1e-999").status == NumberStatus::good);
  CHECK(read_real("1e-999").number == 0.0);
}

TEST_CASE("decimals of every length are what the C library reads") {
  std::mt19937_64 random(1990);
  for (int i = 0; i < 200'000; ++i) {
    std::size_t const digits = 1 + random() % 20;
    std::string text(1, static_cast<char>('1' + random() % 9));
    while (text.size() < digits) text += static_cast<char>('0' + random() % 10);
    CAPTURE(text);
    if (digits < 20)
      REQUIRE(read_integer(text, DataType::uns64).number == std::strtod(text.c_str(), nullptr));
    std::size_t const point = random() % (digits + 1);
    bool const leads = point == 0 && random() % 2 == 0;
    text = (leads ? "0" : "") + text.insert(point, ".");
    CAPTURE(text);
    REQUIRE(read_real(text).status == NumberStatus::good);
    REQUIRE(read_real(text).number == std::strtod(text.c_str(), nullptr));
    REQUIRE(read_real("-" + text).number == -read_real(text).number);
  }
}

TEST_CASE("what is no number says why") {
  for (char const* text : {"", "-", ".", "-.", "1.2.3", "1..", "12a", "1 2", "1:2", "4/2"}) {
    CAPTURE(text);
    CHECK(read_real(text).status == NumberStatus::not_a_number);
    CHECK(read_integer(text, DataType::sgn32).status == NumberStatus::not_a_number);
  }
  CHECK(read_real("1e999").status == NumberStatus::exponent_too_big);
  CHECK(read_real("007").status == NumberStatus::leading_zero);
  CHECK(read_real("-01.5").status == NumberStatus::leading_zero);
  CHECK(read_real("0.5").status == NumberStatus::good);
  for (char const* const text : {"", "+", "-", ".", "e5", "12abc", "0x", "1e", "1,8", "nan", "inf", "- 1"}) {
    INFO(text);
    CHECK(read_real(text).status == NumberStatus::not_a_number);
    CHECK_FALSE(is_complete_number(text));
  }
}

TEST_CASE("symbols by word, by number, in another letter case") {
  auto const& type = parameter("filter[0].type");
  CHECK(read_symbol(type, "PT1").symbol->number == 6);
  CHECK_FALSE(read_symbol(type, "PT1").folded);
  CHECK(read_symbol(type, "pt1").folded);
  CHECK(read_symbol(type, "PT3").symbol == nullptr);
  CHECK(symbol_of_number(type, 6)->word == "PT1");
  CHECK(symbol_of_number(type, 14) == nullptr);
  CHECK(symbol_of_number(parameter("kenngr.set_refpos_mode"), 1) == nullptr);
  CHECK(symbol_of_number(parameter("kenngr.inverse_rotation_direction"), 1)->word == "TRUE");
}

TEST_CASE("documented defaults in every form") {
  CHECK(default_value(parameter("filter[0].fg_f0"))->number == 30);
  CHECK(default_value(parameter("kenngr.antr_typ"))->number == 4);
  CHECK(default_value(parameter("filter[0].type"))->number == 1);
  CHECK(default_value(parameter("filter[0].type"))->text == "LOWPASS");
  CHECK(default_value(parameter("lr_param.add_interface.enable"))->flag());
  CHECK(default_value(parameter("kopf.log_achs_name"))->text == "X_Achse");
  CHECK_FALSE(default_value(parameter("getriebe[0].dynamik.a_w_max")).has_value());
}

TEST_CASE("defaults that were read when the program was built are what their texts say") {
  std::size_t count = 0;
  for (axisc::schema::Parameter const& parameter : axisc::schema::parameters()) {
    if (std::isnan(parameter.default_number)) continue;
    INFO(parameter.name << " " << parameter.default_text);
    NumberReading const reading = read_real(parameter.default_text);
    CHECK(reading.status == NumberStatus::good);
    CHECK(reading.number == parameter.default_number);
    ++count;
  }
  CHECK(count > 400);
}
