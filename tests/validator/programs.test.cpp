// NC programs and filter_sets of a machine: which channel runs them, and which parameter sets they ask for.
#include "support/catch.hpp"
#include "support/checked.hpp"
#include "validator/loading/loading.hpp"

namespace programs_test {

namespace {

using namespace axisc;
using tests::Checked;
using tests::Lines;
using Indices = std::vector<std::size_t>;

constexpr char const* moving_average = "filter_fir.type 1\nfilter_fir.order 20\n";

/// Axes X and Y; `more` are keys of the machine file.
std::map<std::string, std::string> machine_text(std::string const& more,
                                                std::map<std::string, std::string> programs = {}) {
  programs["m.json"] = R"({"cycle_time_us": 1000, "axes": [{"name": "X", "list": "x.lis"},
      {"name": "Y", "list": "y.lis"}])" +
                       more + "}";
  programs["x.lis"] = moving_average;
  programs["y.lis"] = moving_average;
  return programs;
}

/// The parameter sets of one group of a machine without errors, as text.
Lines sets_of(Checked const& checked, std::size_t group = 0) {
  REQUIRE(checked.result.machine);
  REQUIRE(checked.result.machine->groups.size() > group);
  Lines sets;
  for (auto const& parameters : checked.result.machine->groups[group].filter_sets) {
    sets.push_back(machine::to_text(parameters));
  }
  return sets;
}

validator::LoadedMachine loaded(std::map<std::string, std::string> contents) {
  tests::MapFiles files(std::move(contents));
  SourceSet sources;
  return std::get<validator::LoadedMachine>(validator::load(files, "m.json", {}, sources));
}

}  // namespace

TEST_CASE("distinct parameter sets in the order of their first use") {
  Checked const checked(
      machine_text(R"(, "programs": ["a.nc", "b.nc"],
                                     "filter_sets": ["#FILTER ON [ORDER=60]", "#FILTER ON [ORDER=30]"])",
                   {{"a.nc",
                     "#FILTER ON [SHARE=80 ORDER=40]\n#FILTER ON\n#FILTER OFF [ORDER=5]\n"
                     "#FILTER ON [ORDER=30]\n#FILTER ON [AX_DEV=0.1 ACC_FACT=1]\n"},
                    {"b.nc",
                     "#FILTER ON [ORDER_TIME=30000]\n#FILTER ON [ORDER=40 SHARE=80.0 AX_DEV=1]\n"
                     "#FILTER ON [FCUT=50]\n#FILTER ON [QUALITY=0.5 ORDER=0]\n"}}),
      "m.json");
  CHECK(sets_of(checked) ==
        Lines{"ORDER=40 SHARE=80", "ORDER=30", "FCUT=50", "ORDER=0 QUALITY=0.5", "ORDER=60"});
  CHECK(checked.result.not_compiled.empty());
}

TEST_CASE("without ON a command builds on those before it in its program") {
  auto const sets = [](std::string const& program, std::string const& more = "") {
    Checked const checked(machine_text(R"(, "programs": ["a.nc", "b.nc"])" + more,
                                       {{"a.nc", program}, {"b.nc", "#FILTER [FCUT=50]\n"}}),
                          "m.json");
    return sets_of(checked);
  };
  CHECK(sets("#FILTER ON [ORDER=60]\n#FILTER [SHARE=50]\n#FILTER [AX_DEV=0.1]\n#FILTER [ORDER=20]\n") ==
        Lines{"ORDER=60", "ORDER=60 SHARE=50", "ORDER=20 SHARE=50", "FCUT=50"});
  CHECK(sets("#FILTER ON [ORDER=60]\n#FILTER OFF\n#FILTER [SHARE=50]\n") ==
        Lines{"ORDER=60", "ORDER=60 SHARE=50", "FCUT=50"});
  CHECK(sets("#FILTER ON [ORDER=60]\n#FILTER ON [SHARE=50]\n") == Lines{"ORDER=60", "SHARE=50", "FCUT=50"});
  // What a variable gives is unknown until the next ON.
  CHECK(sets("#FILTER ON [ORDER=P1]\n#FILTER [SHARE=50]\n#FILTER ON [SHARE=40]\n#FILTER [ORDER=5]\n") ==
        Lines{"SHARE=40", "ORDER=5 SHARE=40", "FCUT=50"});
  CHECK(sets("#FILTER OFF [ORDER=P1]\n#FILTER [SHARE=50]\n") == Lines{"SHARE=50", "FCUT=50"});
  CHECK(
      sets("#FILTER ON [ORDER=4]\n", R"(, "filter_sets": ["#FILTER ON [ORDER=60]", "#FILTER [SHARE=50]"])") ==
      Lines{"ORDER=4", "FCUT=50", "ORDER=60", "SHARE=50"});
}

TEST_CASE("each channel has the sets of its own programs and of those of all") {
  Checked const checked(
      machine_text(R"(, "groups": [{"axes": ["X"], "programs": ["x.nc"]}, {"axes": ["Y"]}],
                   "programs": ["all.nc"], "filter_sets": ["#FILTER ON [ORDER=3]"])",
                   {{"x.nc", "#FILTER ON [ORDER=1]\n"}, {"all.nc", "#FILTER ON [ORDER=2]\n"}}),
      "m.json");
  CHECK(sets_of(checked, 0) == Lines{"ORDER=1", "ORDER=2", "ORDER=3"});
  CHECK(sets_of(checked, 1) == Lines{"ORDER=2", "ORDER=3"});
}

TEST_CASE("a variable asks for no set, a silenced mistake is not left out without a word") {
  Checked const variable(machine_text(R"(, "programs": ["a.nc"])", {{"a.nc", "#FILTER ON [ORDER=P1]\n"}}),
                         "m.json");
  CHECK(sets_of(variable).empty());
  CHECK(variable.result.not_compiled.empty());

  Checked const silenced(
      machine_text(R"(, "programs": ["a.nc"])", {{"a.nc",
                                                  "#FILTER ON [ORDER=201] (axisc: allow AX5002)\n"
                                                  "#FILTER ON [ORDER_TIME=10] (axisc: allow AX5002)\n"}}),
      "m.json");
  CHECK(sets_of(silenced) == Lines{"ORDER=0"});
  REQUIRE(silenced.result.not_compiled.size() == 1);
  Finding left_out;
  left_out.place = silenced.result.not_compiled[0].place;
  CHECK(silenced.place_text(left_out) == "a.nc:1:1 ");
}

TEST_CASE("a group has so many parameter sets and no more") {
  std::string program;
  for (int share = 1; share <= 10; ++share) {
    for (int order = 1; order <= 100; ++order) {
      program += "#FILTER ON [ORDER=" + std::to_string(order) + " SHARE=" + std::to_string(share) + "]\n";
    }
  }
  Checked const full(machine_text(R"(, "programs": ["a.nc"])", {{"a.nc", program}}), "m.json");
  CHECK(sets_of(full).size() == 1000);
  CHECK(full.result.not_compiled.empty());

  Checked const more(machine_text(R"(, "programs": ["a.nc"], "filter_sets": ["#FILTER ON [ORDER=1 SHARE=1]",
                                  "#FILTER ON [ORDER=7]", "#FILTER ON [ORDER=8]"])",
                                  {{"a.nc", program}}),
                     "m.json");
  CHECK(sets_of(more).size() == 1000);
  REQUIRE(more.result.not_compiled.size() == 1);
  CHECK(render(more.result.not_compiled[0].feature, Language::english) ==
        "more than 1000 different filter commands in one group");
}

TEST_CASE("every file that was read is named, programs once") {
  Checked const checked(machine_text(R"(, "programs": ["a.nc", "a.nc"],
                                     "groups": [{"axes": ["X"], "programs": ["b.nc", "./a.nc"]}])",
                                     {{"./a.nc", ""}, {"b.nc", ""}}),
                        "m.json");
  CHECK(checked.found().empty());
  CHECK(checked.result.files == Lines{"m.json", "x.lis", "y.lis", "b.nc", "./a.nc"});
}

TEST_CASE("an NC program alone is checked for what it says by itself") {
  Checked const checked({{"part.nc", "N10 #FILTER ON [ORDER=201]\nN20 #FILTER ON\n"}}, "part.nc");
  CHECK(checked.found() == Lines{"1:23 AX5002"});
  CHECK_FALSE(checked.result.machine);
  CHECK(checked.result.files == Lines{"part.nc"});
  CHECK_FALSE(Checked({{"part.nc", ""}}, "part.nc").result.machine);
  CHECK(Checked(std::map<std::string, std::string>{}, "part.nc").result.unreadable ==
        configuration::FileError::not_found);
}

TEST_CASE("the assumed cycle time is named where a keyword needs it") {
  auto const found = [](std::string const& program) {
    return Checked({{"part.nc", program}}, "part.nc", {}).found();
  };
  CHECK(found("#FILTER ON [ORDER=20]\n").empty());
  CHECK(found("#VIB GUARD ON [FREQ=40]\n").empty());
  CHECK(found("#FILTER ON [ORDER_TIME=20000]\n") == Lines{"- AX9006"});
  CHECK(found("#FILTER ON [FCUT=600]\n") == Lines{"- AX9006", "1:18 AX5002"});
}

TEST_CASE("whether a program gives the order of an axis") {
  auto const one =
      loaded(machine_text(R"(, "groups": [{"axes": ["X"], "programs": ["a.nc"]}, {"axes": ["Y"]}])",
                          {{"a.nc", "#FILTER ON [ORDER=20]\n"}}));
  CHECK(validator::program_gives_order(one, 0));
  CHECK_FALSE(validator::program_gives_order(one, 1));
  CHECK_FALSE(validator::program_gives_order(loaded(machine_text("")), 0));
  CHECK(validator::program_gives_order(loaded(machine_text(R"(, "filter_sets": ["#FILTER ON [ORDER=20]"])")),
                                       1));
  CHECK_FALSE(validator::program_gives_order(loaded(machine_text(R"(, "filter_sets": ["ORDER=20"])")), 0));
}

TEST_CASE("commands of filter_sets must be known to the control's build too") {
  auto const findings = [](std::string const& sets, char const* build) {
    validator::CheckOptions options;
    options.build = validator::parse_build_version(build);
    options.disabled.push_back(Code{9006});
    std::map<std::string, std::string> contents = {
        {"x.lis", "kopf.log_achs_name X\n"},
        {"m.json", R"({"axes": [{"name": "X", "list": "x.lis"}], "filter_sets": [)" + sets + "]}"}};
    return Checked(std::move(contents), "m.json", options).found();
  };
  std::string const sets = R"("#FILTER ON [ORDER=20]", "#FILTER ON [QUALITY=0.5 ORDER=3]")";
  CHECK(findings(sets, "V3.1.3075.04").empty());
  // Where the text begins in the machine file.
  CHECK(findings(sets, "V3.1.3075.03") == Lines{"1:98 AX2016"});
  CHECK(findings(sets, "V3.1.3075.01") == Lines{"1:61 AX2016", "1:86 AX2016"});
}

}  // namespace programs_test
