// Lists as they are: the manuals' own examples, and a long one in the manner of those found on machines.
#include "cli/program.hpp"
#include "schema/catalogue.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

#include <algorithm>
#include <filesystem>
#include <string>

#include <nlohmann/json.hpp>

namespace samples_test {

using namespace axisc;
using namespace axisc::test;

namespace {

/// A line for each parameter with a documented default: aligned by blanks and tabs, comments behind an open
/// `(` with the number and umlauts in windows-1252, bit masks in hexadecimal, references to numbers that
/// stand elsewhere in the list, mostly further down.
std::string list_as_on_machines() {
  std::string list = "#*****************************************\n# Achsliste f\xFCr die X-Achse\n\t\t\n\n";
  std::size_t line = 4;
  auto const add = [&](std::string const& text) {
    list += text + "\n";
    ++line;
  };
  add("kopf.achs_nr                       1          ( Achsnummer");
  add("kopf.log_achs_name                 X_Achse    ( Name der Achse : P-AXIS-00297");
  add("kenngr.achs_mode                   0x000001   ( Betriebsart (linear) : P-AXIS-00015");
  add("getriebe[0].vb_eilgang             P-AXIS-00212.0   (Eilgang: P-AXIS-00209");
  constexpr std::size_t most_entries = 3;
  for (std::size_t entry = 0; entry < most_entries; ++entry) {
    for (schema::Parameter const& parameter : schema::parameters()) {
      bool const plain = parameter.has_default && !parameter.default_text.empty() &&
                         parameter.default_text.substr(0, 6) != "P-AXIS" && parameter.p_axis != 0;
      bool const taken = parameter.name.substr(0, 5) == "kopf." || parameter.name == "kenngr.achs_mode" ||
                         parameter.name == "getriebe[].vb_eilgang";
      if (!plain || taken || line >= 999 || entry >= parameter.slots) continue;
      auto const slot = static_cast<schema::Slot>(static_cast<std::size_t>(parameter.first_slot) + entry);
      std::string name = schema::slot_name(parameter, slot);
      name.resize(std::max<std::size_t>(name.size() + 1, 40), ' ');
      if (line % 7 == 0) name += '\t';
      std::string const comment = line % 5 == 0 ? "( f\xFCr Pr\xFC"
                                                  "fung : "
                                                : "(Vorgabe [1\xB5m] : ";
      add(name + std::string(parameter.default_text) + "   " + comment +
          schema::p_axis_text(parameter.p_axis));
      if (line % 40 == 0) add("\t");
    }
  }
  add("Ende");
  return list;
}

}  // namespace

TEST_CASE("the manuals' own examples give no error") {
  std::string const folder = std::string(AXISC_SOURCE_DIR) + "/samples/manual";
  std::size_t files = 0;
  for (auto const& entry : std::filesystem::recursive_directory_iterator(folder)) {
    files += entry.is_regular_file() ? 1U : 0U;
  }
  CHECK(files >= 22);
  // Shorter cycles make their time delays longer than the control allows.
  for (std::string const cycle_time : {"1ms", "2ms"}) {
    auto const outcome = run_axisc({"lint", folder, "--cycle-time", cycle_time, "--format", "json"});
    auto const json = nlohmann::json::parse(outcome.out);
    INFO(outcome.out);
    CHECK(outcome.status == 0);
    CHECK(json["summary"]["errors"] == 0);
  }
}

TEST_CASE("a list of a thousand lines as found on machines gives no finding") {
  TemporaryFolder const folder;
  auto const list = list_as_on_machines();
  CHECK(lines_of(list) >= 1000);
  folder.write("x.lis", list);
  auto const outcome = run_axisc({"lint", "x.lis", "--cycle-time", "1ms"}, in_folder(folder.path()));
  CHECK(outcome.status == 0);
  CHECK(outcome.out == "1 file: no findings\n");
}

TEST_CASE("commands inside comments of a program are none") {
  TemporaryFolder const folder;
  folder.write(
      "part.nc",
      "%MAIN\nN10 (#FILTER ON [ORDER=999]) G01 X1\n; #FILTER ON [ORDR=1]\n#COMMENT BEGIN\n"
      "#FILTER ON [ORDER=999]\n#VIB GUARD ON [MODE=9]\n#COMMENT END\nN20 G00 X0 (offen #FILTER\nM30\n");
  auto const outcome =
      run_axisc({"lint", "part.nc", "--pedantic", "--cycle-time", "1ms"}, in_folder(folder.path()));
  CHECK(outcome.status == 0);
  CHECK(outcome.out == "1 file: no findings\n");
}

TEST_CASE("every sample differs from itself in nothing") {
  std::size_t compared = 0;
  for (auto const& entry :
       std::filesystem::recursive_directory_iterator(std::string(AXISC_SOURCE_DIR) + "/samples")) {
    std::string const path = entry.path().string();
    // What a machine file names is compared with it.
    bool const is_input = path.ends_with("machine.json") || path.find("manual/") != std::string::npos;
    bool const is_text = path.ends_with(".lis") || path.ends_with(".json");
    // The tutorial begins with a list that has mistakes.
    bool const is_left_out =
        path.find("synchronous/") != std::string::npos || path.find("tutorial/") != std::string::npos;
    if (!is_input || !is_text || is_left_out) continue;
    INFO(path);
    auto const outcome = run_axisc({"diff", path, path, "--exit-code", "--format", "json"});
    CHECK(outcome.status == 0);
    CHECK_THAT(outcome.out, Catch::Matchers::Contains(R"("equal": true)"));
    ++compared;
  }
  CHECK(compared > 20);
}

}  // namespace samples_test
