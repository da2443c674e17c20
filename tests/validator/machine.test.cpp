// The typed machine that image and runtime are made from.
#include "configuration/machine/machine.hpp"

#include "configuration/machine/interface_filter.hpp"
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
  machine::Machine const& machine = *checked.result.machine;
  CHECK(machine.name == "X (links)");
  CHECK(machine.cycle_time == tests::one_millisecond);
  REQUIRE(machine.axes.size() == 1);
  machine::AxisConfiguration const& axis = machine.axes.front();
  CHECK(axis.name == "X (links)");
  CHECK(axis.number == 7);
  CHECK(axis.type == machine::AxisType::rotary);
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

TEST_CASE("the older time constant of the interface is the PT2 that its successor writes out") {
  std::string const older = "kenngr.in_add_interface_filter_time 5000\n";
  std::string const newer =
      "lr_param.add_interface.filter[0].enable 1\nlr_param.add_interface.filter[0].time_constant 5000\n";
  auto const filters_of = [](std::string const& list) {
    Checked const checked(list);
    REQUIRE(checked.result.machine);
    return checked.result.machine->axes[0].interface_filters;
  };
  REQUIRE(filters_of(older).size() == 1);
  REQUIRE(filters_of(newer).size() == 1);
  auto successor = filters_of(newer)[0].specification;
  successor.order = filters_of(older)[0].specification.order;  // a PT2 computes its own
  CHECK(filters_of(older)[0].specification == successor);
  CHECK(filters_of(older)[0].index == machine::interface_filter_time);
  CHECK(filters_of(older + "lr_param.add_interface.enable 0\n").empty());
  CHECK(filters_of("kenngr.in_add_interface_filter_time 0\n").empty());
  Checked const both(older + newer);
  CHECK(both.result.not_compiled.size() == 1);
  REQUIRE(both.result.machine);
  CHECK(both.result.machine->axes[0].interface_filters[0].index == 0);
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
  machine::Machine const& built = *checked.result.machine;
  CHECK(built.name == "mill");
  CHECK(built.cycle_time.nanoseconds == 62500);
  REQUIRE(built.lists.size() == 3);
  CHECK(built.lists[0].name == "../d.lis");
  CHECK(built.lists[0].is_default_list);
  CHECK(built.lists[1].name == "lists/x.lis");
  CHECK(built.lists[2].name == "s.lis");
  CHECK(built.axes[0].filters[0].specification.order == 2);
  CHECK(built.axes[1].filters[0].specification.order == 1);
  CHECK(built.axes[1].type == machine::AxisType::spindle);
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

TEST_CASE("features whose error was silenced are named, never left out in silence") {
  for (char const* const list :
       {"filter[0].enable 1\nfilter[0].order 2\nfilter[0].fg_f0 900 ( axisc: allow AX3002\n",
        "filter[0].enable 1\nfilter[0].order 2,0 ( axisc: allow AX1005\n",
        "filter_fir.enable 1\nfilter_fir.type 1\nfilter_fir.order 201 ( axisc: allow AX3001\n",
        "filter_fir.type 5,0 ( axisc: allow AX1005\n",
        "filter_fir.enable 1\nfilter_fir.type 5 ( axisc: allow AX2005\nfilter_fir.order 20\n",
        "filter[0].prototype HSC\nfilter[0].order 201 ( axisc: allow AX3001\n",
        "lr_param.add_interface.enable off ( axisc: allow AX2003\n"
        "lr_param.add_interface.filter[0].enable 1\nlr_param.add_interface.filter[0].type LOWPASS\n"
        "lr_param.add_interface.filter[0].order 2\n"
        "lr_param.add_interface.filter[0].fg_f0 20\n",
        "lr_param.improved_position_control.enable on ( axisc: allow AX2003\n"
        "lr_param.improved_position_control.stage[1].mode DIRECT\n",
        "lr_param.improved_position_control.enable 1\n"
        "lr_param.improved_position_control.v_add_max_fact 1000\n"
        "lr_param.improved_position_control.stage[1].filter.order 1\n"
        "lr_param.improved_position_control.stage[1].filter.fg_f0 50\n"
        "lr_param.improved_position_control.stage[1].filter.q_factor 2\n"
        "lr_param.improved_position_control.stage[1].mode DIREKT ( axisc: allow AX2007\n",
        "lr_param.improved_position_control.enable 1\n"
        "lr_param.improved_position_control.v_add_max_fact 1000\n"
        "lr_param.improved_position_control.stage[1].filter.order 1\n"
        "lr_param.improved_position_control.stage[1].filter.fg_f0 500 ( axisc: allow AX3002\n"
        "lr_param.improved_position_control.stage[1].filter.q_factor 2\n"
        "lr_param.improved_position_control.stage[1].mode DIRECT\n"}) {
    Checked const checked(list);
    INFO(list);
    REQUIRE(checked.result.machine);
    REQUIRE(checked.result.not_compiled.size() == 1);
    CHECK(checked.result.not_compiled[0].feature.sentence.in(Language::english) ==
          "the filter `{filter}` of axis \"{axis}\", whose values cannot be used");
  }
}

TEST_CASE("the FIR filter of an axis") {
  auto const kernel = [](std::string const& lines) {
    Checked const checked(lines);
    INFO(lines);
    REQUIRE(checked.result.machine);
    CHECK(checked.result.not_compiled.empty());
    return checked.result.machine->axes[0].kernel;
  };
  CHECK_FALSE(kernel("filter_fir.enable 1\nfilter_fir.order 10\n").has_value());

  auto const mean =
      kernel("filter_fir.enable 1\nfilter_fir.type 1\nfilter_fir.order 10\nfilter_fir.share 80\n");
  REQUIRE(mean);
  CHECK(mean->family == machine::KernelFamily::fir);
  CHECK(mean->on_at_start);
  CHECK(mean->specification == design::KernelSpecification{.type = design::KernelType::moving_average,
                                                           .order = 10,
                                                           .share_percent = 80});

  auto const timed = kernel("filter_fir.type 4\nfilter_fir.order_time 10400\n");
  REQUIRE(timed);
  CHECK_FALSE(timed->on_at_start);
  CHECK(timed->specification.type == design::KernelType::time_delay);
  CHECK(timed->specification.order == 10);

  auto const none = kernel("filter_fir.type 2\nfilter_fir.quality 0.5\n");
  REQUIRE(none);
  CHECK(none->specification.order == 0);
  CHECK(none->specification.quality == 0.5);

  auto const sinc = kernel("filter_fir.type 3\nfilter_fir.order 40\nfilter_fir.fcut 100\n");
  REQUIRE(sinc);
  CHECK(sinc->specification.frequency.value == 100);
}

TEST_CASE("the HSC filter of an axis") {
  auto const kernel = [](std::string const& lines) {
    Checked const checked("filter[0].prototype HSC\n" + lines);
    INFO(lines);
    REQUIRE(checked.result.machine);
    CHECK(checked.result.not_compiled.empty());
    CHECK(checked.result.machine->axes[0].filters.empty());
    return checked.result.machine->axes[0].kernel;
  };
  auto const by_default = kernel("");
  REQUIRE(by_default);
  CHECK(by_default->family == machine::KernelFamily::hsc);
  CHECK_FALSE(by_default->on_at_start);
  CHECK(by_default->specification.type == design::KernelType::moving_average);
  CHECK(by_default->specification.order == 10);
  CHECK(kernel("filter[0].order 20\nfilter[0].time_constant 5000\n")->specification.order == 20);
  CHECK(kernel("filter[0].time_constant 133000\nfilter[0].share_percent 88.9\n")->specification.order == 133);

  auto const novib = kernel("filter[0].type HSC_SHAPER\nfilter[0].order 7\nfilter[0].fg_f0 17\n");
  REQUIRE(novib);
  CHECK(novib->specification ==
        design::KernelSpecification{.type = design::KernelType::novib, .order = 1, .frequency = {17}});
  CHECK_FALSE(kernel("filter[0].type HSC_SHAPER\nfilter[0].fg_f0 17\n").has_value());
}

TEST_CASE("Improved Position Control in the older spelling") {
  std::string const lines =
      "kenngr.antr_typ 2\n"
      "antr.v_reso_num 100\n"
      "lr_param.improved_position_control.enable TRUE\n"
      "lr_param.improved_position_control.v_add_max_fact 1000\n"
      "lr_param.improved_position_control.stage[0].mode DIRECT\n"
      "lr_param.improved_position_control.stage[0].filter.order 1\n"
      "lr_param.improved_position_control.stage[0].filter.fg_f0 53\n"
      "lr_param.improved_position_control.stage[0].filter.q_factor 10\n"
      "lr_param.improved_position_control.stage[0].filter.damping 1\n"
      "lr_param.improved_position_control.stage[0].weight_fact_num 300\n"
      "lr_param.improved_position_control.stage[0].weight_fact_denom 100\n"
      "lr_param.improved_position_control.stage[2].mode INDIRECT\n"
      "lr_param.improved_position_control.stage[2].filter.order 2\n"
      "lr_param.improved_position_control.stage[2].filter.fg_f0 11\n"
      "lr_param.improved_position_control.stage[2].filter.q_factor 2\n"
      "lr_param.improved_position_control.stage[2].filter.damping 0.8\n";
  Checked const checked(lines);
  REQUIRE(checked.result.machine);
  machine::AxisConfiguration const& axis = checked.result.machine->axes[0];
  REQUIRE(axis.position_control);
  CHECK(axis.position_control->limit_factor == 1000);
  REQUIRE(axis.position_control->stages.size() == 2);
  machine::PositionControlStage const& direct = axis.position_control->stages[0];
  CHECK(direct.mode == machine::StageMode::direct);
  CHECK_FALSE(direct.oscillator);
  CHECK(direct.weight_numerator == 300);
  CHECK(direct.weight_denominator == 100);
  REQUIRE(direct.filters.size() == 1);
  CHECK(direct.filters[0] == design::FilterSpecification{.type = design::FilterType::bandpass,
                                                         .prototype = design::Prototype::butterworth,
                                                         .order = 1,
                                                         .frequency = {53},
                                                         .quality = 10});
  machine::PositionControlStage const& indirect = axis.position_control->stages[1];
  CHECK(indirect.index == 2);
  REQUIRE(indirect.oscillator);
  CHECK(*indirect.oscillator == design::OscillatorSpecification{.frequency = {11}, .damping = 0.8});
  CHECK(axis.drive_scaling.controller == machine::PositionController::drive);
  CHECK(axis.drive_scaling.v_reso_num == 100);
  CHECK(axis.drive_scaling.v_reso_denom == 36);
  CHECK(axis.drive_scaling.multi_gain_z == 2000);
}

TEST_CASE("Improved Position Control in the newer spelling") {
  std::string const stage = "lr_param.improved_position_control.stage[1].";
  Checked const checked(
      "lr_param.improved_position_control.enable 1\n"
      "lr_param.improved_position_control.v_add_max_fact 500\n" +
      stage + "mode SET_POINT\n" + stage + "filter[0].type ALLPASS\n" + stage + "filter[0].order 2\n" +
      stage + "filter[0].fg_f0 40\n" + stage + "filter[1].type BANDPASS\n" + stage +
      "filter[1].prototype BESSEL\n" + stage + "filter[1].order 1\n" + stage + "filter[1].fg_f0 53\n" +
      stage + "filter[1].q_factor 4\n" + stage + "osc_damping 0.3\n");
  REQUIRE(checked.result.machine);
  auto const& control = checked.result.machine->axes[0].position_control;
  REQUIRE(control);
  REQUIRE(control->stages.size() == 1);
  REQUIRE(control->stages[0].filters.size() == 2);
  CHECK(control->stages[0].filters[0] == design::FilterSpecification{.type = design::FilterType::allpass,
                                                                     .prototype = design::Prototype::bessel,
                                                                     .order = 2,
                                                                     .frequency = {40}});
  CHECK(control->stages[0].filters[1].prototype == design::Prototype::bessel);
  CHECK(control->stages[0].filters[1].quality == 4);
  REQUIRE(control->stages[0].oscillator);
  CHECK(control->stages[0].oscillator->frequency.value == 53);
  CHECK(control->stages[0].oscillator->damping == 0.3);
}

TEST_CASE("the prototype of a stage's band-pass: P-AXIS-00848, CRIT_DAMPING where no list says one") {
  auto const prototype = [](std::string const& line) {
    std::string const stage = "lr_param.improved_position_control.stage[0].";
    Checked const checked(
        "lr_param.improved_position_control.enable 1\n"
        "lr_param.improved_position_control.v_add_max_fact 500\n" +
        stage + "mode DIRECT\n" + stage + "filter[0].order 2\n" + stage + "filter[0].fg_f0 53\n" + stage +
        "filter[0].q_factor 4\n" + line);
    REQUIRE(checked.result.machine);
    return checked.result.machine->axes[0].position_control->stages[0].filters[0].prototype;
  };
  std::string const name = "lr_param.improved_position_control.stage[0].filter[0].prototype ";
  CHECK(prototype("") == design::Prototype::critical_damping);
  CHECK(prototype(name + "CRIT_DAMPING\n") == design::Prototype::critical_damping);
  CHECK(prototype(name + "BUTTERWORTH\n") == design::Prototype::butterworth);
  CHECK(prototype(name + "BESSEL\n") == design::Prototype::bessel);
}

TEST_CASE("where the position is controlled") {
  using machine::PositionController;
  auto const controller = [](std::string const& lines) {
    Checked const checked(lines);
    REQUIRE(checked.result.machine);
    return checked.result.machine->axes[0].drive_scaling.controller;
  };
  CHECK(controller("") == PositionController::cnc);
  CHECK(controller("kenngr.antr_typ 8\n") == PositionController::drive);
  CHECK(controller("kenngr.antr_typ 5\n") == PositionController::cnc);
  CHECK(controller("kenngr.antr_typ 8\nantr.operation_mode CNC_POSITION_CONTROL\n") ==
        PositionController::cnc);
  CHECK(controller("antr.operation_mode DSC_POSITION_CONTROL\n") == PositionController::drive);
  CHECK(controller("antr.operation_mode OPEN_POSITION_LOOP_MODE\n") == PositionController::unknown);
}

TEST_CASE("gantries and channels of the typed machine") {
  std::string const machine = R"({"cycle_time_us": 1000, "axes": [{"name": "X", "list": "x.lis"},
      {"name": "X2", "list": "x2.lis"}, {"name": "S", "list": "s.lis"}],
      "gantries": [{"master": "X", "slaves": ["X2"]}]})";
  Checked const checked({{"m.json", machine},
                         {"x.lis", "kopf.achs_nr 1\n"},
                         {"x2.lis", "kopf.achs_nr 2\n"},
                         {"s.lis", "kopf.achs_nr 3\nkenngr.achs_typ 4\n"}},
                        "m.json");
  REQUIRE(checked.result.machine);
  machine::Machine const& built = *checked.result.machine;
  CHECK(built.axes[1].gantry_master == std::size_t{0});
  CHECK_FALSE(built.axes[0].gantry_master.has_value());
  REQUIRE(built.groups.size() == 1);
  CHECK(built.groups[0].axes == std::vector<std::size_t>{0, 1});
}
