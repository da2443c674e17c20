// What a machine file says beyond its lists: groups, gantries, drives.
#include "validator/loading/loading.hpp"

#include "support/catch.hpp"
#include "support/map_files.hpp"
#include "validator/views/gantry.hpp"

#include <deque>

namespace {

using namespace axisc;
using Indices = std::vector<std::size_t>;

validator::LoadedMachine loaded(std::map<std::string, std::string> contents, std::string const& path,
                                validator::CheckOptions const& options = {}) {
  tests::MapFiles files(std::move(contents));
  // A machine looks into its sources.
  static std::deque<SourceSet> sources;
  auto machine =
      std::get<validator::LoadedMachine>(validator::load(files, path, options, sources.emplace_back()));
  machine.gantries = validator::gantries_of(machine);
  return machine;
}

/// Four axes X, Y, X2 and a spindle S; `more` are keys of the machine file.
validator::LoadedMachine machine_text(std::string const& more, std::string const& x = "kopf.achs_nr 1\n",
                                      std::string const& x2 = "kopf.achs_nr 3\n") {
  std::string const text = R"({"axes": [{"name": "X", "list": "x.lis", "drive": "sercos",
      "position_control": "cnc"}, {"name": "Y", "list": "y.lis", "position_control": "drive"},
      {"name": "X2", "list": "x2.lis"}, {"name": "S", "list": "s.lis", "type": "S"}])" +
                           more + "}";
  return loaded({{"m.json", text},
                 {"x.lis", x},
                 {"y.lis", "kopf.achs_nr 2\n"},
                 {"x2.lis", x2},
                 {"s.lis", "kopf.achs_nr 4\n"}},
                "m.json");
}

}  // namespace

TEST_CASE("without groups all axes but spindles form one") {
  validator::LoadedMachine const three = machine_text("");
  REQUIRE(three.groups.size() == 1);
  CHECK(three.groups[0].axes == Indices{0, 1, 2});
  REQUIRE(loaded({{"x.lis", ""}}, "x.lis").groups.size() == 1);
  CHECK(loaded({{"x.lis", ""}}, "x.lis").groups[0].axes == Indices{0});
  CHECK(loaded({{"s.lis", "kenngr.achs_typ 4\n"}}, "s.lis").groups.empty());
}

TEST_CASE("texts of every encoding outlive the reading") {
  std::string const latin = "kopf.log_achs_name Gr\xF6\xDF";
  std::string const machine_file =
      R"({"default_list": "d.lis", "axes": [{"name": "X", "list": "x.lis"}, {"name": "Y", "list": "y.lis"},
          {"name": "Z", "list": "z.lis"}]})";
  validator::LoadedMachine first = loaded({{"m.json", machine_file},
                                           {"d.lis", latin + "D\n"},
                                           {"x.lis", latin + "X\nkopf.achs_nr 1\n"},
                                           {"y.lis", "kopf.log_achs_name Größ\nkopf.achs_nr 2\n"},
                                           {"z.lis", "kopf.achs_nr 3\n"}},
                                          "m.json");
  validator::LoadedMachine const machine = std::move(first);
  std::vector<std::string> names;
  for (validator::LoadedAxis const& axis : machine.axes) {
    names.emplace_back(axis.merged.values.at("kopf.log_achs_name").value.text);
  }
  CHECK(names == std::vector<std::string>{"GrößX", "Größ", "GrößD"});
}

TEST_CASE("groups name their axes") {
  validator::LoadedMachine const two =
      machine_text(R"(, "groups": [{"name": "mill", "axes": ["Y", "X", "Y"]}, {"axes": ["S"]}])");
  REQUIRE(two.groups.size() == 2);
  CHECK(two.groups[0].name == "mill");
  CHECK(two.groups[0].axes == Indices{0, 1});
  CHECK(two.groups[1].name.empty());
  CHECK(two.groups[1].axes == Indices{3});
}

TEST_CASE("what the machine file says about drives") {
  validator::LoadedMachine const mill = machine_text(R"(, "inch": true)");
  REQUIRE(mill.axes[0].drive);
  CHECK(mill.axes[0].drive->text == "SERCOS");
  CHECK(mill.axes[0].position_control == machine::PositionController::cnc);
  CHECK(mill.axes[1].position_control == machine::PositionController::drive);
  CHECK(mill.axes[2].position_control == machine::PositionController::unknown);
  CHECK(mill.axes[3].type == machine::AxisType::spindle);
  CHECK(mill.inch);
  CHECK(mill.machine_file);
}

TEST_CASE("a gantry of the lists, of the machine file, and of both") {
  std::string const master = "kopf.achs_nr 1\nkenngr.achs_mode 0x10001\n";
  std::string const slave = "kopf.achs_nr 3\nkenngr.achs_mode 0x20001\nkenngr.gantry_ax_nr 1\n";
  std::string const key = R"(, "gantries": [{"master": "X", "slaves": ["X2"]}])";
  for (auto const& one :
       {machine_text("", master, slave), machine_text(key), machine_text(key, master, slave),
        machine_text(key, master, "kopf.achs_nr 3\nkenngr.achs_mode 0x20001\n"),
        machine_text(key, "kopf.achs_nr 1\nkenngr.achs_mode 1\n", "kopf.achs_nr 3\n")}) {
    REQUIRE(one.gantries.size() == 1);
    CHECK(one.gantries[0].master == 0);
    CHECK(one.gantries[0].slaves == Indices{2});
  }
}

TEST_CASE("the lists are the truth about gantries") {
  std::string const of_y = R"(, "gantries": [{"master": "Y", "slaves": ["X2"]}])";
  validator::LoadedMachine const differing =
      machine_text(of_y, "kopf.achs_nr 1\nkenngr.achs_mode 0x10001\n",
                   "kopf.achs_nr 3\nkenngr.achs_mode 0x20001\nkenngr.gantry_ax_nr 1\n");
  REQUIRE(differing.gantries.size() == 1);
  CHECK(differing.gantries[0].master == 0);
  CHECK(machine_text(of_y, "", "kopf.achs_nr 3\nkenngr.achs_mode 0x4\n").gantries.empty());
  CHECK(machine_text("", "", "kenngr.achs_mode 0x20001\nkenngr.gantry_ax_nr 9\n").gantries.empty());
}
