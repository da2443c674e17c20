#include "schema/plain_values.hpp"

#include "schema/catalogue.hpp"
#include "support/catch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

namespace {

using namespace axisc::schema;

PlainValues plain_values_of_name(std::string_view name) {
  std::array<PlainParameter, 1> found;
  find_plain(std::array{name}, found);
  REQUIRE(found[0].values != nullptr);
  return *found[0].values;
}

Parameter real_between(Limit minimum, Limit maximum) {
  Parameter parameter;
  parameter.type = DataType::real64;
  parameter.minimum = minimum;
  parameter.maximum = maximum;
  return parameter;
}

constexpr Limit limit(double number, bool open) {
  return {.number = number, .p_axis = 0, .kind = Limit::Kind::number, .open = open};
}

}  // namespace

TEST_CASE("open limits end at the next double") {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (double const number : {0.0, 1.0, -1.0, 1e-300, -1e300, 0.1}) {
    PlainValues const open = plain_values_of(real_between(limit(number, true), limit(number + 2, true)));
    CHECK(open.lowest == std::nextafter(number, infinity));
    CHECK(open.highest == std::nextafter(number + 2, -infinity));
    PlainValues const closed = plain_values_of(real_between(limit(number, false), limit(number + 2, false)));
    CHECK(closed.lowest == number);
    CHECK(closed.highest == number + 2);
  }
  PlainValues const any = plain_values_of(real_between({}, {}));
  CHECK(any.lowest == -infinity);
  CHECK(any.highest == infinity);
}

TEST_CASE("what a parameter plainly takes follows from its type") {
  CHECK(plain_values_of_name("filter[0].order").kind == PlainKind::integer);
  CHECK(plain_values_of_name("filter[0].fg_f0").kind == PlainKind::real);
  CHECK(plain_values_of_name("filter[0].enable").kind == PlainKind::boolean);
  CHECK(plain_values_of_name("kopf.log_achs_name").kind == PlainKind::text);
  PlainValues const type = plain_values_of_name("filter[0].type");
  CHECK(type.kind == PlainKind::symbol);
  CHECK(type.words().front().word == "LOWPASS");
}

TEST_CASE("integers stay within their type, and within what doubles hold exactly") {
  for (Parameter const& parameter : parameters()) {
    PlainValues const plain = plain_values_of(parameter);
    if (plain.kind != PlainKind::integer) continue;
    INFO(parameter.name);
    CHECK(plain.lowest >= -9007199254740992.0);
    CHECK(plain.highest <= 9007199254740992.0);
    CHECK(plain.lowest <= plain.highest);
  }
}

TEST_CASE("words that may be bits of a mask are looked at more closely") {
  Parameter mask;
  mask.type = DataType::string;
  std::array const symbols{Symbol{.word = "A", .number = std::nullopt},
                           Symbol{.word = "B", .number = std::nullopt}};
  mask.symbols = symbols;
  mask.default_text = "0x0001";
  CHECK(plain_values_of(mask).kind == PlainKind::none);
  mask.default_text = "B";
  CHECK(plain_values_of(mask).kind == PlainKind::symbol);
  mask.max_length = 1;
  CHECK(plain_values_of(mask).kind == PlainKind::symbol);
  std::array const longer{Symbol{.word = "AB", .number = 1}};
  mask.symbols = longer;
  CHECK(plain_values_of(mask).kind == PlainKind::none);
}

TEST_CASE("slots that others limit are those of their rows") {
  auto const slots = slots_limited_by_others();
  CHECK(std::is_sorted(slots.begin(), slots.end()));
  std::size_t count = 0;
  for (Parameter const& parameter : parameters())
    count += is_limited_by_another(parameter) ? parameter.slots : 0U;
  CHECK(slots.size() == count);
  for (Slot const slot : slots) CHECK(is_limited_by_another(parameter(parameter_of(slot))));
}
