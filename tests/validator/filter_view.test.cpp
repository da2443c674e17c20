#include "validator/views/filter_view.hpp"

#include "support/catch.hpp"

#include <string>

namespace filter_view_test {

namespace {

using namespace axisc;
using namespace axisc::validator;
using design::CycleTime;
using design::FilterType;

constexpr CycleTime one_millisecond{1'000'000};

// Values as if a list had set them, each on the next line.
class Values {
 public:
  Values& set(std::string const& name, double number, Origin origin = Origin::axis_list) {
    EffectiveValue& value = entry(name, origin);
    value.value.number = number;
    return *this;
  }
  Values& spoil(std::string const& name) {
    entry(name, Origin::axis_list).unusable = true;
    return *this;
  }
  [[nodiscard]] FilterView setpoint(std::uint32_t index = 0) const {
    return {values_, FilterPort::setpoint, index};
  }
  [[nodiscard]] FilterView interface() const { return {values_, FilterPort::additional_interface, 0}; }
  [[nodiscard]] EffectiveValues const& all() const { return values_; }

 private:
  EffectiveValue& entry(std::string const& name, Origin origin) {
    auto const lookup = schema::find(name);
    REQUIRE(lookup.status == schema::NameLookup::Status::found);
    EffectiveValue& value = values_.edit(lookup.slot);
    value.origin = origin;
    value.line = ++line_;
    value.has_value = true;
    value.value_span = {.begin = line_, .end = line_ + 1};
    return value;
  }

  EffectiveValues values_;
  std::uint32_t line_ = 0;
};

Values active(FilterType type) {
  Values values;
  values.set("filter[0].enable", 1).set("filter[0].order", 1).set("filter[0].type", static_cast<int>(type));
  return values;
}

bool designable(Values const& values, CycleTime cycle_time = one_millisecond) {
  return values.setpoint().specification(cycle_time).has_value();
}

}  // namespace

TEST_CASE("a filter that no list mentions is not touched") {
  Values values;
  CHECK(touched_filters(values.all()).empty());
  values.set("filter[2].guete", 2).set("lr_param.add_interface.filter[0].order", 1);
  auto const filters = touched_filters(values.all());
  REQUIRE(filters.size() == 2);
  CHECK(filters[0].port == FilterPort::setpoint);
  CHECK(filters[0].index == 2);
  CHECK(filters[1].port == FilterPort::additional_interface);
}

TEST_CASE("the words of the filter types are the catalogue's symbols") {
  for (char const* const name : {"filter[0].type", "lr_param.add_interface.filter[0].type"}) {
    auto const& row = axisc::schema::parameter(axisc::schema::find(name).parameter);
    for (axisc::design::FilterKind const& kind : axisc::design::filter_kinds) {
      INFO(name << ' ' << kind.word);
      auto const* const symbol =
          axisc::schema::symbol_of_number(row, static_cast<double>(static_cast<int>(kind.type)));
      REQUIRE(symbol != nullptr);
      CHECK(symbol->word == kind.word);
    }
  }
}

TEST_CASE("the two ports have defaults of their own") {
  Values const values;
  FilterView const setpoint = values.setpoint();
  CHECK(setpoint.type_number() == 1);
  CHECK(setpoint.type_word() == "LOWPASS");
  CHECK(setpoint.order.value.number == 0);
  CHECK(setpoint.time_constant.value.number == 10000);
  FilterView const interface = values.interface();
  CHECK(interface.type_number() == 10);
  CHECK(interface.type_word() == "PT2");
  CHECK(interface.order.value.number == 2);
  CHECK(interface.time_constant.value.number == 0);
}

TEST_CASE("prototype HSC makes HSC mean the default type of a setpoint filter") {
  Values values;
  values.set("filter[0].prototype", 5);
  CHECK(values.setpoint().is_hsc());
  CHECK(values.setpoint().type_number() == 8);
  CHECK(values.setpoint().type_word() == "HSC_MEAN");
  CHECK_FALSE(values.setpoint().standard_type);
  values.set("filter[0].type", 12);
  CHECK(values.setpoint().type_number() == 12);
}

TEST_CASE("only documented standard types are standard") {
  for (int type = 1; type <= 13; ++type) {
    Values values;
    values.set("filter[0].type", type);
    bool const standard = type <= 6 || type == 10 || type == 11;
    INFO("type " << type);
    CHECK(values.setpoint().standard_type.has_value() == standard);
  }
}

TEST_CASE("a filter is active with enable 1, an order and a standard type") {
  Values values;
  values.set("filter[0].enable", 1);
  CHECK_FALSE(values.setpoint().active());
  values.set("filter[0].order", 2);
  CHECK(values.setpoint().active());
  SECTION("not when switched off") {
    values.set("filter[0].enable", 0);
  }
  SECTION("not with an HSC type") {
    values.set("filter[0].type", 8);
  }
  SECTION("not with the HSC prototype") {
    values.set("filter[0].prototype", 5);
  }
  SECTION("not when the switch cannot be read") {
    values.spoil("filter[0].enable");
  }
  SECTION("not when the order cannot be read") {
    values.spoil("filter[0].order");
  }
  SECTION("not when the type cannot be read") {
    values.spoil("filter[0].type");
  }
  CHECK_FALSE(values.setpoint().active());
}

TEST_CASE("the filter of the additional interface has an order by default") {
  Values values;
  values.set("lr_param.add_interface.filter[0].enable", 1);
  CHECK(values.interface().active());
}

TEST_CASE("a spoilt prototype hides the type only where the type depends on it") {
  Values values;
  values.spoil("filter[0].prototype");
  CHECK(values.setpoint().type_unusable());
  values.set("filter[0].type", 1);
  CHECK_FALSE(values.setpoint().type_unusable());
  Values interface;
  interface.spoil("lr_param.add_interface.filter[0].prototype");
  CHECK_FALSE(interface.interface().type_unusable());
}

TEST_CASE("a finding stands at its value, else at enable, else at the first line of the filter") {
  Values values;
  values.set("filter[0].guete", 2).set("filter[0].fg_f0", 20).set("filter[0].type", 1, Origin::default_list);
  FilterView const late = values.setpoint();
  CHECK(&late.anchor(late.frequency) == &late.frequency);
  CHECK(&late.anchor(late.order) == &late.type);
  values.set("filter[0].enable", 1);
  FilterView const enabled = values.setpoint();
  CHECK(&enabled.anchor(enabled.order) == &enabled.enable);
}

TEST_CASE("an inactive filter has no specification") {
  CHECK_FALSE(designable(Values()));
}

TEST_CASE("a specification carries what its type uses, and nothing else") {
  Values values = active(FilterType::bandstop);
  values.set("filter[0].order", 2).set("filter[0].prototype", 2).set("filter[0].fg_f0", 42);
  values.set("filter[0].guete", 4).set("filter[0].share_percent", 80).set("filter[0].time_constant", 5000);
  auto const bandstop = values.setpoint().specification(one_millisecond);
  CHECK(bandstop == design::FilterSpecification{.type = FilterType::bandstop,
                                                .prototype = design::Prototype::butterworth,
                                                .order = 2,
                                                .frequency = {42},
                                                .quality = 4,
                                                .share_percent = 80});
  values.set("filter[0].type", 6).set("filter[0].order", 1);
  auto const pt1 = values.setpoint().specification(one_millisecond);
  CHECK(pt1 == design::FilterSpecification{
                   .type = FilterType::pt1, .order = 1, .time_constant = {5000}, .share_percent = 80});
}

TEST_CASE("orders a design accepts") {
  auto const fits = [](FilterType type, double order) {
    return designable(active(type).set("filter[0].order", order));
  };
  for (FilterType const type : {FilterType::lowpass, FilterType::highpass, FilterType::allpass}) {
    CHECK(fits(type, 6));
    CHECK_FALSE(fits(type, 7));
  }
  for (FilterType const type : {FilterType::bandpass, FilterType::bandstop}) {
    CHECK(fits(type, 3));
    CHECK_FALSE(fits(type, 4));
  }
}

TEST_CASE("frequencies a design accepts") {
  auto const fits = [](double frequency, CycleTime cycle_time) {
    return designable(active(FilterType::lowpass).set("filter[0].fg_f0", frequency), cycle_time);
  };
  CHECK(fits(499.999, one_millisecond));
  CHECK_FALSE(fits(500, one_millisecond));
  CHECK(fits(3999, CycleTime{125'000}));
  CHECK_FALSE(fits(4000, CycleTime{125'000}));
  CHECK_FALSE(fits(0, one_millisecond));
  CHECK_FALSE(fits(-1, one_millisecond));
}

TEST_CASE("qualities and shares a design accepts") {
  CHECK(designable(active(FilterType::bandstop).set("filter[0].guete", 10)));
  CHECK_FALSE(designable(active(FilterType::bandstop).set("filter[0].guete", 10.5)));
  CHECK_FALSE(designable(active(FilterType::bandstop).set("filter[0].guete", 0.5)));
  CHECK(designable(active(FilterType::lowpass).set("filter[0].guete", 0.5)));
  CHECK(designable(active(FilterType::lowpass).set("filter[0].share_percent", 0)));
  CHECK_FALSE(designable(active(FilterType::lowpass).set("filter[0].share_percent", 101)));
  CHECK_FALSE(designable(active(FilterType::lowpass).set("filter[0].share_percent", -1)));
}

TEST_CASE("time constants a design accepts") {
  auto const fits = [](FilterType type, double time) {
    return designable(active(type).set("filter[0].time_constant", time), CycleTime{250'000});
  };
  for (FilterType const type : {FilterType::pt1, FilterType::pt2}) {
    CHECK(fits(type, 250));
    CHECK_FALSE(fits(type, 249));
  }
  CHECK(fits(FilterType::time_delay, 0));
  CHECK(fits(FilterType::time_delay, 1499));
  CHECK_FALSE(fits(FilterType::time_delay, 1500));
}

TEST_CASE("a spoilt value counts only where the type uses it") {
  CHECK_FALSE(designable(active(FilterType::lowpass).spoil("filter[0].fg_f0")));
  CHECK_FALSE(designable(active(FilterType::lowpass).spoil("filter[0].prototype")));
  CHECK_FALSE(designable(active(FilterType::bandstop).spoil("filter[0].guete")));
  CHECK_FALSE(designable(active(FilterType::pt1).spoil("filter[0].time_constant")));
  CHECK_FALSE(designable(active(FilterType::pt1).spoil("filter[0].share_percent")));
  CHECK(designable(active(FilterType::pt1).spoil("filter[0].fg_f0")));
  CHECK(designable(active(FilterType::lowpass).spoil("filter[0].guete")));
}

}  // namespace filter_view_test
