// Whole machines, and axes of one machine, compared.
#include "cli/program.hpp"
#include "support/golden.hpp"
#include "support/temporary_folder.hpp"

#include <filesystem>

#include <nlohmann/json.hpp>

namespace diff_machines_test {

using namespace axisc::test;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

namespace {

constexpr char const* sample = AXISC_SOURCE_DIR "/samples/controller";

void replace(TemporaryFolder const& folder, std::string const& file, std::string_view was,
             std::string_view is) {
  auto text = folder.read(file);
  auto const at = text.find(was);
  INFO(file << ": " << was);
  REQUIRE(at != std::string::npos);
  text.replace(at, was.size(), is);
  folder.write(file, text);
}

/// The sample as `old`, and as `new` with changes of every kind.
Surroundings old_and_new(TemporaryFolder const& folder) {
  for (std::string const side : {"old", "new"}) {
    fs::copy(sample, folder / side, fs::copy_options::recursive);
    for (auto const& entry : fs::recursive_directory_iterator(folder / side)) {
      fs::permissions(entry.path(), fs::perms::owner_write, fs::perm_options::add);
    }
  }
  for (std::string const number : {"1", "2", "3", "4"}) {
    replace(folder, "new/listen/achsmds" + number + ".lis", "filter_fir.order                       10",
            "filter_fir.order                       14");
  }
  replace(folder, "new/listen/default_mds.lis", "500000", "400000");
  replace(folder, "new/listen/achsmds5.lis", "Ende", "kenngr.antr_typ 2\nfilter_fir.share 100\nEnde");
  replace(folder, "new/listen/sda_mds1.lis", "bezeichnung         Z", "bezeichnung         W");
  folder.write("new/prog/init.nc", folder.read("new/prog/init.nc") + "G0 X1\n");
  return in_folder(folder.path());
}

nlohmann::json as_json(Surroundings const& there, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "diff");
  arguments.insert(arguments.end(), {"--format", "json"});
  auto const outcome = run_axisc(arguments, there);
  INFO(outcome.err);
  REQUIRE_FALSE(outcome.out.empty());
  return nlohmann::json::parse(outcome.out);
}

/// A machine of axes in one channel; each axis is {number, name, more lines}.
struct Axis {
  std::string number, name, lines;
};
void write_machine(TemporaryFolder const& folder, std::string const& path, std::vector<Axis> const& axes,
                   std::string const& channel = {}) {
  std::string start_up = "zahl_mds " + std::to_string(axes.size()) + "\nkanal_anzahl 1\nsda_mds[0] sda.lis\n";
  std::string list = channel + "gruppe[0].bezeichnung main\n";
  for (std::size_t i = 0; i < axes.size(); ++i) {
    auto const index = std::to_string(i);
    start_up += "achs_mds[" + index + "] a" + axes[i].number + ".lis\n";
    list += "gruppe[0].achse[" + index + "].bezeichnung " + axes[i].name + "\n";
    list += "gruppe[0].achse[" + index + "].log_achs_nr " + axes[i].number + "\n";
    folder.write(path + "/a" + axes[i].number + ".lis", "kopf.achs_nr " + axes[i].number +
                                                            "\nkopf.log_achs_name " + axes[i].name + "\n" +
                                                            axes[i].lines + "Ende\n");
  }
  folder.write(path + "/hochlauf.lis", start_up + "rtconf_lis rt.lis\nEnde\n");
  folder.write(path + "/sda.lis", list + "Ende\n");
  folder.write(path + "/rt.lis", "cycle_time 1000\nEnde\n");
}

}  // namespace

TEST_CASE("two folders in every format and language") {
  TemporaryFolder const folder;
  auto const there = old_and_new(folder);
  for (std::string const language : {"en", "de"}) {
    for (std::string const form : {"text", "markdown", "json", "csv"}) {
      auto const outcome = run_axisc({"diff", "old", "new", "--lang", language, "--format", form}, there);
      CHECK(outcome.status == 0);
      CHECK(outcome.err.empty());
      check_golden("tests/cli/data/golden/diff/folders." + language + "." + form, outcome.out);
    }
  }
  CHECK(run_axisc({"diff", "old", "new", "--exit-code", "--quiet"}, there).status == 2);
  CHECK(run_axisc({"diff", "old", "new", "--exit-code"}, there).status == 1);
  CHECK(run_axisc({"diff", "old", "old/listen/hochlauf.lis", "--exit-code"}, there).out ==
        "old and old/listen/hochlauf.lis mean the same\n");
}

TEST_CASE("two axes of one machine in both languages") {
  TemporaryFolder const folder;
  auto const there = old_and_new(folder);
  for (std::string const language : {"en", "de"}) {
    for (std::string const form : {"text", "markdown", "json", "csv"}) {
      auto const outcome = run_axisc(
          {"diff", "old", "--axis", "X", "--axis", "U", "--lang", language, "--format", form}, there);
      CHECK(outcome.status == 0);
      check_golden("tests/cli/data/golden/diff/axes." + language + "." + form, outcome.out);
    }
  }
}

TEST_CASE("an axis is named as programs call it, by its number, or by its list") {
  TemporaryFolder const folder;
  auto const there = old_and_new(folder);
  auto const expected = run_axisc({"diff", "old", "--axis", "X", "--axis", "U"}, there).out;
  for (std::vector<std::string> const& names : {std::vector<std::string>{"1", "5"},
                                                {"achsmds1.lis", "achsmds5"},
                                                {"x", "u"},
                                                {"X", "achsmds5.lis"}}) {
    INFO(names[0] << ' ' << names[1]);
    CHECK(run_axisc({"diff", "old", "--axis", names[0], "--axis", names[1]}, there).out == expected);
  }
  auto const unknown = run_axisc({"diff", "old", "--axis", "Q", "--axis", "X"}, there);
  CHECK(unknown.status == 2);
  CHECK(unknown.err ==
        "axisc: error: old has no axis \"Q\"; the axes are X (1, achsmds1.lis), Y (2, achsmds2.lis), "
        "Z (3, achsmds3.lis), X2 (4, achsmds4.lis), U (5, achsmds5.lis), S (6, achsmds6.lis)\n");
}

TEST_CASE("a name that two channels use is ambiguous") {
  TemporaryFolder const folder;
  auto const there = old_and_new(folder);
  replace(folder, "old/listen/sda_mds2.lis", "bezeichnung         U", "bezeichnung         X");
  auto const outcome = run_axisc({"diff", "old", "--axis", "X", "--axis", "Y"}, there);
  CHECK(outcome.status == 2);
  CHECK_THAT(outcome.err, Contains("X (1, achsmds1.lis), X_2 (5, achsmds5.lis)"));
  CHECK(run_axisc({"diff", "old", "--axis", "1", "--axis", "Y"}, there).status == 0);
}

TEST_CASE("one input without two axes has nothing to be compared with") {
  TemporaryFolder const folder;
  auto const there = old_and_new(folder);
  for (std::vector<std::string> const& words :
       {std::vector<std::string>{"diff", "old"}, {"diff", "old", "--axis", "X"}}) {
    auto const outcome = run_axisc(words, there);
    CHECK(outcome.status == 2);
    CHECK_THAT(outcome.err, Contains("--axis X --axis Y"));
  }
  CHECK(run_axisc({"diff", "old", "new", "old"}, there).status == 2);
  CHECK(run_axisc({"diff", "old", "--axis", "X", "--axis", "Y", "--axis", "Z"}, there).status == 2);
}

TEST_CASE("axes are paired by their numbers, and what is on one side only is named") {
  TemporaryFolder const folder;
  auto const there = in_folder(folder.path());
  write_machine(folder, "a", {{"1", "X", ""}, {"2", "Y", "filter_fir.share 90\n"}, {"3", "Z", ""}});
  write_machine(folder, "b", {{"2", "Q", "filter_fir.share 80\n"}, {"1", "X", ""}, {"4", "C", ""}});
  auto const json = as_json(there, {"a", "b"});
  CHECK(json["axes_removed"] == nlohmann::json{"Z"});
  CHECK(json["axes_added"] == nlohmann::json{"C"});
  auto const& axis = json["axes"][0];
  CHECK(axis["name_before"] == "Y");
  CHECK(axis["name"] == "Q");
  CHECK(axis["parameters"][0]["name"] == "filter_fir.share");
  REQUIRE(json["channels"].size() == 1);
  CHECK(json["channels"][0]["before"]["axes"] == nlohmann::json{"X", "Y", "Z"});
  CHECK(json["channels"][0]["after"]["axes"] == nlohmann::json{"Q", "X", "C"});
}

TEST_CASE("an axis without a number is paired by its name") {
  TemporaryFolder const folder;
  auto const there = in_folder(folder.path());
  folder.write("x.lis", "filter_fir.share 90\nEnde\n");
  folder.write("x2.lis", "filter_fir.share 80\nEnde\n");
  folder.write("y.lis", "Ende\n");
  folder.write("a.json", R"({"axes": [{"name": "X", "list": "x.lis"}, {"name": "Y", "list": "y.lis"}]})");
  folder.write("b.json", R"({"axes": [{"name": "Y", "list": "y.lis"}, {"name": "X", "list": "x2.lis"}]})");
  auto const json = as_json(there, {"a.json", "b.json"});
  REQUIRE(json["axes"].size() == 1);
  CHECK(json["axes"][0]["name"] == "X");
  CHECK(json["axes"][0]["parameters"][0]["before"] == "90");
}

TEST_CASE("channels: spindles, couplings and the content of programs that run by themselves") {
  TemporaryFolder const folder;
  auto const there = in_folder(folder.path());
  std::vector<Axis> const axes = {{"1", "X", ""}, {"2", "Y", ""}};
  write_machine(folder, "a", axes, "path[0].dir prog\nstart_init_prog_file init.nc\n");
  write_machine(folder, "b", axes, "path[0].dir prog\nstart_init_prog_file init.nc\n");
  folder.write("a/prog/init.nc", "G0 X0\n");
  folder.write("b/prog/init.nc", "G0 X1\n");
  CHECK_THAT(run_axisc({"diff", "a", "b"}, there).out, Contains("prog/init.nc (other content)"));
  folder.write("b/prog/init.nc", "G0 X0\n");
  CHECK(run_axisc({"diff", "a", "b", "--exit-code"}, there).status == 0);
  write_machine(folder, "b", axes,
                "path[0].dir prog\nstart_init_prog_file init.nc\nspdl_anzahl 1\nspindel[0].bezeichnung S\n"
                "spindel[0].log_achs_nr 2\nsynchro_data.koppel_gruppe[0].paar[0].log_achs_nr_slave 2\n"
                "synchro_data.koppel_gruppe[0].paar[0].log_achs_nr_master 1\n");
  auto const channel = as_json(there, {"a", "b"})["channels"][0];
  CHECK(channel["before"]["spindles"].empty());
  CHECK(channel["after"]["spindles"] == nlohmann::json{"Y"});
  CHECK(channel["after"]["couplings"] == nlohmann::json{"Y = X"});
}

TEST_CASE("values are equal where the control reads the same") {
  TemporaryFolder const folder;
  auto const there = in_folder(folder.path());
  struct Pair {
    std::string a, b;
    bool equal;
  };
  for (Pair const& pair : {
           Pair{"filter_fir.order 20", "filter_fir.order 0x14", true},
           {"filter_fir.order 20", "filter_fir.order 20.0", true},  // an error, but the same number
           {"filter_fir.order 20", "filter_fir.order 21", false},
           {"filter_fir.order 20", "filter_fir.order +20", true},
           {"filter[0].guete 0.5", "filter[0].guete 5e-1", true},
           {"filter[0].guete 0.1", "filter[0].guete 0.10000000000000000555", true},
           {"filter[0].guete 0.1", "filter[0].guete 0.1000000001", false},
           {"kopf.log_achs_name X", "kopf.log_achs_name \"X\"", true},
           {"kopf.log_achs_name X", "kopf.log_achs_name x", false},
           {"filter[0].type LOWPASS", "filter[0].type 1", true},
           {"filter[0].enable 1", "filter[0].enable TRUE", true},
           {"filter_fir.order 0", "kopf.achs_nr 1", true},  // each the default of the other
       }) {
    folder.write("a.lis", pair.a + "\nEnde\n");
    folder.write("b.lis", pair.b + "\nEnde\n");
    INFO(pair.a << " | " << pair.b);
    auto const json = as_json(there, {"a.lis", "b.lis"});
    CHECK(json["equal"] == pair.equal);
  }
}

TEST_CASE("three states: set, default, and neither") {
  TemporaryFolder const folder;
  auto const there = in_folder(folder.path());
  folder.write("a.lis", "filter_fir.share 90\nantr.sercos.mdt[0].ident_nr 5\nfilter_fir.order 0\nEnde\n");
  folder.write("b.lis", "kopf.log_achs_name Q\nEnde\n");
  auto const all = as_json(there, {"a.lis", "b.lis", "--all"});
  std::map<std::string, nlohmann::json> changes;
  for (auto const& change : all["axes"][0]["parameters"]) changes[change["name"]] = change;
  CHECK(changes.at("filter_fir.share")["state_before"] == "set");
  CHECK(changes.at("filter_fir.share")["state_after"] == "default");
  CHECK(changes.at("filter_fir.share")["equal"] == false);
  CHECK(changes.at("filter_fir.order")["equal"] == true);
  CHECK(changes.at("kopf.log_achs_name")["state_before"] != "set");
  auto const some = as_json(there, {"a.lis", "b.lis"});
  CHECK(some["set_to_default"] == 1);
  for (auto const& change : some["axes"][0]["parameters"]) CHECK(change["equal"] == false);
}

TEST_CASE("the default list counts, and what it changes for several axes is said once") {
  TemporaryFolder const folder;
  auto const there = old_and_new(folder);
  auto const text = run_axisc({"diff", "old", "new"}, there).out;
  auto const first = text.find("P-AXIS-00212");
  REQUIRE(first != std::string::npos);
  CHECK(text.find("P-AXIS-00212", first + 1) == std::string::npos);
  CHECK_THAT(text, Contains("axes X, Y, W, X2, U\n"));
}

TEST_CASE("what needs a restart of the control") {
  TemporaryFolder const folder;
  auto const there = old_and_new(folder);
  auto const json = as_json(there, {"old", "new"});
  CHECK(json["restart"] == true);
  // Two axes of a machine are no change of one.
  CHECK(as_json(there, {"new", "--axis", "X", "--axis", "U"})["restart"] == false);
  CHECK_THAT(run_axisc({"diff", "old", "new"}, there).out,
             Contains("after a restart of the control: kenngr.antr_typ (U)\n"));
}

TEST_CASE("what every axis has for itself is left out between two axes") {
  TemporaryFolder const folder;
  auto const there = in_folder(folder.path());
  write_machine(folder, "a",
                {{"1", "X", "antr.sercos.antr_adr 4\nantr.canopen.address 1\n"},
                 {"2", "Y", "antr.sercos.antr_adr 5\nantr.canopen.address 2\n"}});
  auto const json = as_json(there, {"a", "--axis", "X", "--axis", "Y"});
  CHECK(json["equal"] == true);
  CHECK(json["left_out"] ==
        nlohmann::json{"antr.canopen.address", "antr.sercos.antr_adr", "kopf.achs_nr", "kopf.log_achs_name"});
  CHECK(as_json(there, {"a", "--axis", "X", "--axis", "Y", "--all"})["axes"][0]["parameters"].size() == 4);
}

TEST_CASE("an image and the folder that it was made of mean the same") {
  TemporaryFolder const folder;
  auto const there = old_and_new(folder);
  REQUIRE(run_axisc({"compile", "old", "-o", "old.axim", "--quiet"}, there).status == 0);
  for (std::vector<std::string> const& pair :
       {std::vector<std::string>{"old", "old.axim"}, {"old.axim", "old"}, {"old.axim", "old.axim"}}) {
    auto const outcome = run_axisc({"diff", pair[0], pair[1], "--exit-code"}, there);
    INFO(outcome.out);
    CHECK(outcome.status == 0);
  }
  auto const changed = as_json(there, {"old.axim", "new"});
  CHECK(changed["axes"].size() == 5);
  CHECK(changed["axes"][0]["parameters"][0]["place_before"] == "achsmds1.lis:9");
}

TEST_CASE("a list alone is compared at the cycle time of the machine") {
  TemporaryFolder const folder;
  auto const there = old_and_new(folder);
  auto const json = as_json(there, {"old/listen/achsmds1.lis", "old"});
  CHECK(json["cycle_time_us"]["before"] == 2000);
  CHECK(json["cycle_time_us"]["after"] == 2000);
  CHECK(json["axes_added"].size() == 5);
}

TEST_CASE("lists with errors are compared nevertheless, but not what they do to the axes") {
  TemporaryFolder const folder;
  auto const there = old_and_new(folder);
  replace(folder, "new/listen/achsmds2.lis", "Ende", "filter[0].guete 3,0\nEnde");
  auto const outcome = run_axisc({"diff", "old", "new"}, there);
  CHECK(outcome.status == 1);
  CHECK_THAT(outcome.err, Contains("AX1005"));
  CHECK_THAT(outcome.out, Contains("filter_fir.order  10 → 14"));
  CHECK_THAT(outcome.out, !Contains("settling"));
  CHECK_THAT(outcome.out, Contains("because a list has errors"));
}

TEST_CASE("a copy that leads back to the original is warned of") {
  TemporaryFolder const folder;
  auto const there = old_and_new(folder);
  fs::copy(folder / "old/listen", folder / "old/backup", fs::copy_options::recursive);
  auto const outcome = run_axisc({"diff", "old/backup", "old/listen"}, there);
  CHECK(outcome.status == 0);
  CHECK_THAT(outcome.out, Contains("both sides read old/listen/achsmds1.lis"));
  CHECK(run_axisc({"diff", "old/listen", "new/listen"}, there).err.empty());
  CHECK(run_axisc({"diff", "old/listen", "old/listen/hochlauf.lis"}, there).err.empty());
}

TEST_CASE("a stripped image is compared by the order of its axes, without parameters") {
  TemporaryFolder const folder;
  auto const there = old_and_new(folder);
  REQUIRE(run_axisc({"compile", "old", "-o", "old.axim", "--strip", "--quiet"}, there).status == 0);
  CHECK(as_json(there, {"old.axim", "old"})["equal"] == true);
  auto const json = as_json(there, {"old.axim", "new"});
  REQUIRE(json["axes"].size() == 4);
  CHECK(json["axes"][0]["parameters"].empty());
  CHECK(json["axes"][0]["after"]["delay_ms"] == 14);
}

TEST_CASE("what differs in one axis is told alike among many and alone") {
  TemporaryFolder const folder;
  auto const list = [](int order, std::string const& more) {
    return "filter_fir.enable 1\nfilter_fir.type 1\nfilter_fir.order " + std::to_string(order) + "\n" + more +
           "Ende\n";
  };
  std::string const slow =
      "filter[0].enable 1\nfilter[0].type LOWPASS\nfilter[0].order 2\nfilter[0].fg_f0 5\n";
  std::string const band =
      "filter[0].enable 1\nfilter[0].type BANDPASS\nfilter[0].order 2\nfilter[0].fg_f0 50\nfilter[0].guete "
      "2\n";
  std::vector<std::string> const before = {list(20, ""), list(11, slow), list(7, band), list(9, "")};
  std::vector<std::string> const after = {list(21, ""), list(12, slow), list(8, band), list(9, "")};
  auto const write = [&](std::string const& side, std::vector<std::string> const& lists, std::size_t first,
                         std::size_t end) {
    std::string axes;
    for (std::size_t i = first; i < end; ++i) {
      auto const name = std::to_string(i);
      folder.write(side + name + ".lis", lists[i]);
      axes += std::string(axes.empty() ? "" : ", ") + R"({"name": "A)" + name + R"(", "list": ")" + side +
              name + R"(.lis"})";
    }
    folder.write(side + ".json", R"({"machine": "m", "cycle_time_us": 1000, "axes": [)" + axes + "]}");
  };
  auto const there = in_folder(folder.path());
  write("old", before, 0, 4);
  write("new", after, 0, 4);
  auto const all = as_json(there, {"old.json", "new.json"})["axes"];
  REQUIRE(all.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    write("old", before, i, i + 1);
    write("new", after, i, i + 1);
    auto const alone = as_json(there, {"old.json", "new.json"})["axes"];
    REQUIRE(alone.size() == 1);
    CHECK(all[i] == alone[0]);
  }
}

}  // namespace diff_machines_test
