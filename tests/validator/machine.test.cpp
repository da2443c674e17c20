// The typed machine that image and runtime are made from.
#include "validator/machine.hpp"

#include "support/catch.hpp"
#include "support/checked.hpp"

namespace {

using namespace axisc;
using tests::Checked;
using tests::Lines;

constexpr char const* filters =
    "kopf.achs_nr 7\n"
    "kopf.log_achs_name \"X (links)\"\n"
    "kenngr.achs_typ ACHSTYP_ROTATOR\n"
    "getriebe[0].dynamik.vb_max 600000\n"
    "getriebe[0].dynamik.a_max 2000\n"
    "filter[2].enable 1\n"
    "filter[2].order 1\n"
    "filter[2].type PT1\n"
    "filter[2].time_constant 4000\n"
    "filter[0].enable 1\n"
    "filter[0].order 2\n"
    "filter[0].fg_f0 20\n"
    "filter[1].order 2\n"
    "lr_param.add_interface.filter[0].enable 1\n"
    "lr_param.add_interface.filter[0].time_constant 5000\n";

}  // namespace

TEST_CASE("a list without errors becomes a machine of one axis") {
  Checked const checked({{"lists/x.lis", filters}}, "lists/x.lis");
  REQUIRE(checked.found().empty());
  REQUIRE(checked.result.machine);
  validator::Machine const& machine = *checked.result.machine;
  CHECK(machine.name == "X (links)");
  CHECK(machine.cycle_time == tests::one_millisecond);
  REQUIRE(machine.axes.size() == 1);
  validator::AxisConfiguration const& axis = machine.axes.front();
  CHECK(axis.name == "X (links)");
  CHECK(axis.number == 7);
  CHECK(axis.type == validator::AxisType::rotary);
  CHECK(axis.velocity_limit == 600000);
  CHECK(axis.acceleration_limit == 2000);
  CHECK(axis.position_window == 0.4);
  REQUIRE(axis.filters.size() == 2);
  CHECK(axis.filters[0].index == 0);
  CHECK(axis.filters[0].specification.frequency.value == 20);
  CHECK(axis.filters[1].index == 2);
  CHECK(axis.filters[1].specification.type == design::FilterType::pt1);
  REQUIRE(axis.interface_filters.size() == 1);
  CHECK(axis.interface_filters[0].specification.type == design::FilterType::pt2);
  REQUIRE(axis.values.size() == 15);
  CHECK(axis.values[1].name == "kopf.log_achs_name");
  CHECK(axis.values[1].text == "\"X (links)\"");
  CHECK(axis.values[1].line == 2);
  REQUIRE(machine.lists.size() == 1);
  CHECK(machine.lists[0].name == "x.lis");
  CHECK(machine.lists[0].content == filters);
}

TEST_CASE("an axis without a name in its list is named by its file") {
  CHECK(Checked({{"a/b/tisch.v2.lis", ""}}, "a/b/tisch.v2.lis").result.machine->axes[0].name == "tisch.v2");
}

TEST_CASE("an interface that is off has no filters") {
  Checked const checked(std::string(filters) + "lr_param.add_interface.enable 0\n");
  REQUIRE(checked.result.machine);
  CHECK(checked.result.machine->axes[0].interface_filters.empty());
}

TEST_CASE("a machine keeps its lists under the names of the machine file") {
  std::string const machine = R"({"machine": "mill", "cycle_time_us": 62.5, "default_list": "../d.lis",
      "axes": [{"name": "X", "list": "lists/x.lis"}, {"name": "S", "list": "/abs/s.lis", "type": "S"}]})";
  Checked const checked({{"p/m.json", machine},
                         {"p/../d.lis", "filter[0].enable 1\nfilter[0].order 1\n"},
                         {"p/lists/x.lis", "filter[0].fg_f0 25\nfilter[0].order 2\n"},
                         {"/abs/s.lis", "kopf.achs_nr 2\n"}},
                        "p/m.json", {});
  REQUIRE(checked.found().empty());
  REQUIRE(checked.result.machine);
  validator::Machine const& built = *checked.result.machine;
  CHECK(built.name == "mill");
  CHECK(built.cycle_time.nanoseconds == 62500);
  REQUIRE(built.lists.size() == 3);
  CHECK(built.lists[0].name == "../d.lis");
  CHECK(built.lists[0].is_default_list);
  CHECK(built.lists[1].name == "lists/x.lis");
  CHECK(built.lists[2].name == "s.lis");
  CHECK(built.axes[0].filters[0].specification.order == 2);
  CHECK(built.axes[1].filters[0].specification.order == 1);
  CHECK(built.axes[1].type == validator::AxisType::spindle);
  REQUIRE(built.axes[0].values.size() == 3);
  CHECK(built.axes[0].values[0].name == "filter[0].enable");
  CHECK(built.axes[0].values[0].list == 0);
  CHECK(built.axes[0].values[2].name == "filter[0].order");
  CHECK(built.axes[0].values[2].list == 1);
  CHECK(checked.result.files == Lines{"p/m.json", "p/../d.lis", "p/lists/x.lis", "/abs/s.lis"});
}

TEST_CASE("no machine where there is an error") {
  CHECK_FALSE(Checked("filter[0].guete 11\n").result.machine.has_value());
  CHECK(Checked("hugo 11\n").result.machine.has_value());
}

TEST_CASE("features that an image cannot hold are named, never left out in silence") {
  struct Row {
    char const* list;
    Text feature;
  };
  for (Row const& row :
       {Row{"filter_fir.enable 1\nfilter_fir.type 1\nfilter_fir.order 10\n", Text::not_compiled_fir},
        Row{"filter[0].prototype HSC\nfilter[0].order 10\n", Text::not_compiled_hsc},
        Row{"lr_param.improved_position_control.enable 1\n"
            "lr_param.improved_position_control.stage[1].mode DIRECT\n",
            Text::not_compiled_ipc},
        Row{"filter[0].enable 1\nfilter[0].order 2\nfilter[0].fg_f0 900 ( axisc: allow AX3002\n",
            Text::not_compiled_filter},
        Row{"filter[0].enable 1\nfilter[0].order 2,0 ( axisc: allow AX1005\n", Text::not_compiled_filter}}) {
    Checked const checked(row.list);
    INFO(row.list);
    REQUIRE(checked.result.machine);
    REQUIRE(checked.result.not_compiled.size() == 1);
    CHECK(checked.result.not_compiled[0].feature.text == row.feature);
  }
  for (char const* const list :
       {"filter_fir.enable 1\nfilter_fir.type 1\n", "filter_fir.type 1\nfilter_fir.order 10\n",
        "lr_param.improved_position_control.enable 1\n"}) {
    INFO(list);
    CHECK(Checked(list).result.not_compiled.empty());
  }
}
