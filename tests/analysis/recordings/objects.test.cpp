#include "analysis/recordings/objects.hpp"

#include "analysis/recordings/scaling.hpp"
#include "support/catch.hpp"

namespace axisc::recordings::objects_test {
namespace {

Channel object(std::uint64_t port, std::uint64_t group, std::uint64_t offset) {
  return {.name = "any", .port = port, .index_group = group, .index_offset = offset};
}

TEST_CASE("objects are known by port, group and offset together") {
  auto found = object_of(object(551, 0x121301, 0x10061));
  REQUIRE(found);
  CHECK((found->object == Object::position_unfiltered && found->channel == 1 && found->axis == 1));
  found = object_of(object(551, 0x121302, 0x3001C));
  REQUIRE(found);
  CHECK((found->object == Object::position_filtered && found->channel == 2 && found->axis == 3));
  // Addressed physically.
  CHECK(object_of(object(551, 0x021301, 0x1001C))->object == Object::position_filtered);
  found = object_of(object(551, 0x120300, 0x5000D));
  CHECK((found->object == Object::velocity && found->axis == 5));
  CHECK(object_of(object(551, 0x120300, 0x10250))->object == Object::additive_velocity);
  CHECK(object_of(object(553, 0x120200, 0x10003))->object == Object::actual_position);
  // Leadscrew correction; a variable of a PLC; another port.
  CHECK_FALSE(object_of(object(551, 0x120300, 0x1001C)));
  CHECK_FALSE(object_of(object(851, 0x4040, 385040)));
  CHECK_FALSE(object_of(object(851, 0x121301, 0x10061)));
  CHECK_FALSE(object_of({.name = "any", .index_group = 0x121301}));
  // A header without ports.
  CHECK(object_of({.name = "any", .index_group = 0x121301, .index_offset = 0x10061}));
}

TEST_CASE("the control's names of objects") {
  CHECK(object_of({.name = "x", .symbol = "dig_drv.act_torque"})->object == Object::torque);
  auto const found = object_of({.name = "active position (1)"});
  REQUIRE(found);
  CHECK((found->object == Object::position_unfiltered && !found->is_by_index));
  CHECK(template_name("X", Object::position_filtered) == "X filtered");
  CHECK(plain_name("x (1)") == "x");
  CHECK(plain_name("x (a)") == "x (a)");
  CHECK(plain_name("(1)") == "(1)");
  CHECK(plain_name("x [mm]") == "x");
  CHECK(plain_name("x [mm] (1)") == "x");
  CHECK(plain_name("[mm]") == "[mm]");
  CHECK(unit_in_brackets("x [mm]") == "mm");
  CHECK(unit_in_brackets("x[0]").empty());
}

Channel scaled(std::string const& type, std::vector<double> const& values, Scale const& scale) {
  return {.name = "any", .values = values, .data_type = type, .scale = scale};
}

TEST_CASE("numbers are raw or scaled where only one of them fits the type") {
  Scale const tenth{.factor = 0.1};
  CHECK(scaling_of(scaled("INT32", {0.1, 2.5}, {})) == Scaling::none);
  CHECK(scaling_of(scaled("INT32", {0.1, 2.5}, tenth)) == Scaling::shown);
  CHECK(scaling_of(scaled("INT16", {1, 20000}, tenth)) == Scaling::raw);
  CHECK(scaling_of(scaled("INT32", {1, 20000}, tenth)) == Scaling::open);
  CHECK(scaling_of(scaled("REAL64", {0.1, 2.5}, tenth)) == Scaling::open);
  CHECK(scaling_of(scaled("INT32", {0.15}, tenth)) == Scaling::neither);
  CHECK(scaling_of(scaled("UINT8", {-1, 3}, {.factor = -1})) == Scaling::neither);
  CHECK(scaling_of(scaled("UINT8", {-1, -3}, {.factor = -1})) == Scaling::shown);
  CHECK(scaling_of(scaled("UINT8", {12}, {.unit_factor = -10, .unit_offset = 2})) == Scaling::raw);
  auto known = scaled("REAL64", {0.1}, tenth);
  known.is_raw = true;
  CHECK(scaling_of(known) == Scaling::raw);
}

TEST_CASE("units of headers") {
  CHECK(thousandths_in("mm (Length)") == 1000.0);
  CHECK(thousandths_in("\xC2\xB5m") == 1.0);
  CHECK(thousandths_in("\xC2\xB0 (Angle)") == 1000.0);
  CHECK_FALSE(thousandths_in("(None)"));
  CHECK_FALSE(thousandths_in("dV (Voltage)"));
  CHECK_FALSE(names_unit("(None)"));
  CHECK(names_unit("dV (Voltage)"));
}

}  // namespace
}  // namespace axisc::recordings::objects_test
