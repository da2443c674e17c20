// A controller's folder: its start-up list is the machine.
#include "cli/program.hpp"
#include "diagnostics/finding.hpp"
#include "support/golden.hpp"
#include "support/temporary_folder.hpp"
#include "validator/engine/rule.hpp"

#include <filesystem>

#include <nlohmann/json.hpp>

namespace controller_test {

using namespace axisc::test;
namespace fs = std::filesystem;

namespace {

constexpr char const* sample = AXISC_SOURCE_DIR "/samples/controller";

Surroundings copy_of_sample(TemporaryFolder const& folder) {
  fs::copy(sample, folder.path(), fs::copy_options::recursive);
  return in_folder(folder.path());
}

/// A machine of one axis.
void write_machine(TemporaryFolder const& folder, std::string const& name, std::string const& list) {
  folder.write(name, "zahl_mds 1\nachs_mds[0] " + list + "\nEnde\n");
  folder.write(list, "kopf.achs_nr 1\nEnde\n");
}

}  // namespace

TEST_CASE("a program that the default list of all channels names is checked once") {
  TemporaryFolder const folder;
  folder.write("hochlauf.lis",
               "kanal_anzahl 1\nsda_mds[0] sda1.lis\ndefault_sda_mds sda.lis\nzahl_mds 1\n"
               "achs_mds[0] x.lis\nrtconf_lis rt.lis\n");
  folder.write("rt.lis", "cycle_time 2000\n");
  folder.write("sda1.lis", "gruppe[0].achse[0].bezeichnung X\ngruppe[0].achse[0].log_achs_nr 1\n");
  folder.write("sda.lis", "start_init_prog_file init.nc\n");
  folder.write("x.lis", "kopf.achs_nr 1\nkopf.log_achs_name X\nfilter_fir.type 1\nfilter_fir.order 10\n");
  folder.write("init.nc", "#FILTR ON\n");
  CHECK_THAT(run_axisc({"lint", "."}, in_folder(folder.path())).out,
             Catch::Matchers::Contains("6 files: 1 error\n"));
}

TEST_CASE("a stock folder is checked as the machine that it is, in silence") {
  TemporaryFolder const folder;
  auto const there = copy_of_sample(folder);
  for (std::vector<std::string> const& words : {std::vector<std::string>{"lint", ".", "--pedantic"},
                                                {"lint", "listen", "--pedantic"},
                                                {"lint", "listen/hochlauf.lis", "--pedantic"},
                                                {"lint", ".", "--fix=all"}}) {
    auto const outcome = run_axisc(words, there);
    CHECK(outcome.status == 0);
    CHECK(outcome.out == "18 files: no findings\n");
  }
}

TEST_CASE("the machine as it was understood, as text and as a machine file") {
  TemporaryFolder const folder;
  auto const there = copy_of_sample(folder);
  for (std::string const language : {"en", "de"}) {
    auto const outcome = run_axisc({"machine", "listen", "--lang", language}, there);
    CHECK(outcome.status == 0);
    check_golden("tests/cli/data/golden/machine." + language, outcome.out);
  }
  check_golden("tests/cli/data/golden/machine.json",
               run_axisc({"machine", ".", "--format", "json"}, there).out);
}

TEST_CASE("folder, start-up list and the machine file made of it compile to one image") {
  TemporaryFolder const folder;
  copy_of_sample(folder);
  auto const there = in_folder(folder / "listen");
  folder.write("listen/m.json", run_axisc({"machine", "hochlauf.lis", "--format", "json"}, there).out);
  for (std::string const input : {"m.json", "hochlauf.lis"}) {
    auto const outcome = run_axisc({"compile", input, "-o", input + ".axim", "--quiet"}, there);
    INFO(outcome.err);
    CHECK(outcome.status == 0);
  }
  auto const image = folder.read("listen/hochlauf.lis.axim");
  CHECK(image.size() > 1000);
  CHECK(folder.read("listen/m.json.axim") == image);
  fs::remove(folder / "listen/m.json");
  CHECK(run_axisc({"compile", "..", "-o", "folder.axim", "--quiet"}, there).status == 0);
  CHECK(folder.read("listen/folder.axim") == image);
}

TEST_CASE("the machine file made of a start-up list keeps the default channel list and the look-ahead") {
  TemporaryFolder const folder;
  auto const there = in_folder(folder.path());
  folder.write("hochlauf.lis",
               "kanal_anzahl 2\nsda_mds[0] sda1.lis\nsda_mds[1] sda2.lis\ndefault_sda_mds all.lis\n"
               "zahl_mds 2\nachs_mds[0] x.lis\nachs_mds[1] y.lis\nrtconf_lis rt.lis\n"
               "configuration.channel[0].interpolator.function FCT_LOOK_AHEAD_CUSTOM\n"
               "configuration.channel[0].interpolator.number_blocks_lah 44\n");
  folder.write("rt.lis", "cycle_time 1000\n");
  for (std::string const number : {"1", "2"}) {
    folder.write("sda" + number + ".lis", "gruppe[0].achs_anzahl 1\ngruppe[0].achse[0].bezeichnung A" +
                                              number + "\ngruppe[0].achse[0].log_achs_nr " + number + "\n");
  }
  folder.write("all.lis", "prog_start.slope.profile 1\n");
  folder.write("x.lis", "kopf.achs_nr 1\n");
  folder.write("y.lis", "kopf.achs_nr 2\n");
  auto const written = run_axisc({"machine", "hochlauf.lis", "--format", "json"}, there).out;
  folder.write("m.json", written);
  auto const machine = nlohmann::json::parse(written);
  CHECK(machine["default_channel_list"] == "all.lis");
  CHECK(machine["groups"][0]["look_ahead_blocks"] == 44);
  CHECK_FALSE(machine["groups"][1].contains("look_ahead_blocks"));
  // The channels' parameters are compared, too.
  auto const difference = run_axisc({"diff", "hochlauf.lis", "m.json", "--format", "json"}, there);
  INFO(difference.out << difference.err);
  CHECK(nlohmann::json::parse(difference.out).at("channels").empty());
  // Written again it is the same, with paths from the working folder.
  CHECK(run_axisc({"machine", "m.json", "--format", "json"}, there).out == written);
  CHECK_THAT(run_axisc({"machine", "m.json", "--lang", "de"}, there).out,
             Catch::Matchers::Contains("Standardliste der Kanäle") && Catch::Matchers::Contains("all.lis"));
  folder.write("bad.json", R"({"cycle_time_us": 1000, "axes": [{"name": "X", "list": "x.lis"}],
    "default_channel_list": "x.lis", "groups": [{"axes": ["X"], "look_ahead_blocks": 5}]})");
  auto const bad = run_axisc({"lint", "bad.json"}, there).out;
  CHECK_THAT(bad, Catch::Matchers::Contains("look_ahead_blocks") && Catch::Matchers::Contains("x.lis") &&
                      Catch::Matchers::Contains("AX4020"));
}

TEST_CASE(
    "the machine file made of a start-up list keeps couplings, through the channel lists that it names") {
  TemporaryFolder const folder;
  copy_of_sample(folder);
  auto const there = in_folder(folder / "listen");
  auto list = folder.read("listen/sda_mds1.lis");
  list.insert(list.find("Ende"),
              "synchro_data.koppel_gruppe[0].paar[0].log_achs_nr_slave 5\n"
              "synchro_data.koppel_gruppe[0].paar[0].log_achs_nr_master 1\n");
  folder.write("listen/sda_mds1.lis", list);
  auto const written = run_axisc({"machine", "hochlauf.lis", "--format", "json"}, there).out;
  folder.write("listen/m.json", written);
  auto const of_folder = run_axisc({"lint", "hochlauf.lis"}, there).out;
  auto const of_machine = run_axisc({"lint", "m.json"}, there).out;
  CHECK_THAT(of_folder, Catch::Matchers::Contains("AX4022"));
  CHECK(of_machine.substr(0, of_machine.find("\n\n")) == of_folder.substr(0, of_folder.find("\n\n")));
  auto const difference =
      nlohmann::json::parse(run_axisc({"diff", "hochlauf.lis", "m.json", "--format", "json"}, there).out);
  for (std::string const side : {"before", "after"}) {
    CHECK(difference.at("channels").at(0).at(side).at("couplings") == nlohmann::json{"U = X"});
  }
}

TEST_CASE("a folder with several machines is asked for one, and lint checks each") {
  TemporaryFolder const folder;
  write_machine(folder, "a.lis", "x.lis");
  write_machine(folder, "b.lis", "y.lis");
  auto const there = in_folder(folder.path());
  for (std::string const command : {"machine", "contour"}) {
    auto const outcome = run_axisc({command, "."}, there);
    CHECK(outcome.status == 2);
    CHECK(outcome.err.find("several machines") != std::string::npos);
    CHECK(outcome.err.find("a.lis, b.lis") != std::string::npos);
  }
  CHECK(run_axisc({"lint", "."}, there).out.find("4 files") != std::string::npos);
  fs::remove(folder / "a.lis");
  fs::remove(folder / "b.lis");
  CHECK(run_axisc({"machine", "."}, there).err.find("holds no machine") != std::string::npos);
}

TEST_CASE("a machine file wins over the start-up list whose lists it names") {
  TemporaryFolder const folder;
  write_machine(folder, "hochlauf.lis", "x.lis");
  folder.write("machine.json", R"({"machine": "m", "axes": [{"name": "A", "list": "x.lis"}]})");
  auto const outcome = run_axisc({"machine", "."}, in_folder(folder.path()));
  CHECK(outcome.status == 0);
  CHECK(outcome.out.find("machine m\n") != std::string::npos);
}

TEST_CASE("a start-up list that names itself or is missing its lists is told so and never vanishes") {
  TemporaryFolder const folder;
  folder.write("hochlauf.lis", "zahl_mds 2\nachs_mds[0] hochlauf.lis\nachs_mds[1] gone.lis\nEnde\n");
  auto const outcome = run_axisc({"lint", "."}, in_folder(folder.path()));
  CHECK(outcome.status == 1);
  CHECK(outcome.out.find("AX7009") != std::string::npos);
  CHECK(outcome.out.find("AX7002") != std::string::npos);
}

TEST_CASE("fmt aligns the axis lists of a folder and leaves the others alone") {
  TemporaryFolder const folder;
  auto const there = copy_of_sample(folder);
  folder.write("listen/achsmds6.lis", "kopf.achs_nr   6\nkopf.log_achs_name S\nEnde\n");
  auto const before = folder.read("listen/sda_mds1.lis");
  CHECK(run_axisc({"fmt", "."}, there).status == 0);
  CHECK(folder.read("listen/achsmds6.lis") == "kopf.achs_nr        6\nkopf.log_achs_name  S\nEnde\n");
  CHECK(folder.read("listen/sda_mds1.lis") == before);
}

TEST_CASE("the folder with a mistake of each kind shows them all") {
  TemporaryFolder const folder;
  fs::copy(AXISC_SOURCE_DIR "/samples/mistakes/controller", folder.path(), fs::copy_options::recursive);
  auto const outcome = run_axisc({"lint", ".", "--pedantic"}, in_folder(folder.path()));
  CHECK(outcome.status == 1);
  check_golden("tests/cli/data/golden/controller-mistakes.txt", outcome.out);
  for (auto const& rule : axisc::validator::rules()) {
    if (static_cast<unsigned>(rule.code) / 1000 != 7) continue;
    CHECK_THAT(outcome.out, Catch::Matchers::Contains("[" + axisc::code_text(rule.code) + "]"));
  }
}

TEST_CASE("settings choose the files of folders, and say what kind of list they are") {
  TemporaryFolder const folder;
  folder.write("a/x.lis", "kenngr.achs_typ 1,5\n");
  folder.write("old/y.lis", "kenngr.achs_typ 1,5\n");
  folder.write("tools/t.lis", "anzahl 5\n");
  auto const there = in_folder(folder.path());
  auto const out = [&](std::vector<std::string> const& words) { return run_axisc(words, there).out; };
  using Catch::Matchers::Contains;

  CHECK_THAT(out({"lint", "."}),
             Contains("a/x.lis:1") && Contains("old/y.lis:1") && Contains("warning[AX7001]"));
  folder.write("axisc.json", R"({"exclude": ["old/**"], "paths": [{"pattern": "tools/*", "kind": "tool"}]})");
  CHECK_THAT(out({"lint", "."}), Contains("a/x.lis:1") && !Contains("old/y.lis") && !Contains("AX7001"));
  CHECK_THAT(out({"lint", ".", "--pedantic"}), Contains("note[AX2001]: unknown parameter `anzahl`"));
  CHECK_THAT(out({"lint", "tools", "--kind", "axis"}),
             Contains("warning[AX2001]: unknown parameter `anzahl`"));
  // Who names a file means it.
  CHECK_THAT(out({"lint", "old/y.lis"}), Contains("old/y.lis:1"));
  folder.write("axisc.json", R"({"include": ["a/**"]})");
  CHECK_THAT(out({"lint", "."}), Contains("a/x.lis:1") && !Contains("old/y.lis") && Contains("1 file:"));
  CHECK_THAT(out({"lint", "--print-config", "a/x.lis"}), Contains("include        a/**"));
  folder.write("axisc.json", R"({"exclude": ["**"]})");
  auto const nothing = run_axisc({"lint", "."}, there);
  CHECK(nothing.status == 0);

  folder.write("axisc.json", R"({"paths": [{"pattern": "tools/*", "kind": "tools"}]})");
  auto const wrong = run_axisc({"lint", "."}, there);
  CHECK(wrong.status == 2);
  CHECK_THAT(wrong.err, Contains("axisc.json:1:") && Contains("zero_offset"));
  auto const unknown = run_axisc({"lint", "a/x.lis", "--kind", "tools"}, in_folder(folder / "a"));
  CHECK(unknown.status == 2);
}

TEST_CASE("compile shows the mistake for which the cycle time is not known") {
  TemporaryFolder const folder;
  auto const there = copy_of_sample(folder);
  folder.write("listen/rtconf.lis", "thread[0].function[0].name task_int\nthread[0].cycle 2ms\n");
  auto const outcome = run_axisc({"compile", ".", "-o", "x.axim"}, there);
  CHECK(outcome.status == 1);
  CHECK(outcome.err.find("listen/rtconf.lis:2:17") != std::string::npos);
}

TEST_CASE("a real-time list by itself is judged by its cycle time, too") {
  TemporaryFolder const folder;
  folder.write("rtconf.lis", "thread[0].function[0].name task_int\nthread[0].cycle 2\n");
  auto const outcome = run_axisc({"lint", "rtconf.lis", "--kind", "real_time"}, in_folder(folder.path()));
  CHECK(outcome.status == 1);
  CHECK(outcome.out.find("rtconf.lis:2:17") != std::string::npos);
  CHECK(outcome.out.find("AX4020") != std::string::npos);
  CHECK(run_axisc({"lint", "rtconf.lis"}, in_folder(folder.path())).status == 1);
}

TEST_CASE("fixes mend nothing but misspelt names in lists of other kinds") {
  TemporaryFolder const folder;
  auto const there = copy_of_sample(folder);
  std::string const tools = "wz[1].laenge   1,5\nwz[1].gultig TRUE\nwz[1].radius  5  # a\nwz[1].radius  6\n";
  folder.write("listen/werkz_d1.lis", tools);
  CHECK(run_axisc({"lint", ".", "--fix=all"}, there).status == 1);
  CHECK(folder.read("listen/werkz_d1.lis") ==
        "wz[1].laenge   1,5\nwz[1].gueltig TRUE\nwz[1].radius  5  # a\nwz[1].radius  6\n");
  CHECK(run_axisc({"fmt", "."}, there).status == 0);
  CHECK(folder.read("listen/werkz_d1.lis").substr(0, 18) == "wz[1].laenge   1,5");
}

TEST_CASE("a limit that another parameter of a list of another kind gives") {
  TemporaryFolder const folder;
  auto const there = in_folder(folder.path());
  folder.write("wz.lis", "wz[1].vb_max 100\nwz[1].vb_min 200\nwz[2].vb_min 200\nwz[3].vb_max 100\n");
  auto const outcome = run_axisc({"lint", "wz.lis"}, there);
  CHECK(outcome.status == 0);
  CHECK(outcome.out.find("warning[AX2015]: `wz[1].vb_min` must be ≤ `wz[1].vb_max`") != std::string::npos);
  CHECK(outcome.out.find("wz.lis:2:14") != std::string::npos);
  CHECK(outcome.out.find("1 file: 1 warning\n") != std::string::npos);
}

}  // namespace controller_test
