// Commands that answer a question have the same formats, and the same answer in each of them.
#include "cli/program.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

#include <algorithm>
#include <sstream>

#include <nlohmann/json.hpp>

namespace answers_test {

using namespace axisc::test;
using nlohmann::json;

namespace {

struct Asked {
  std::string folder;
  std::vector<std::string> words;
  int status = 0;
  std::string csv;  ///< how it begins
};

std::vector<Asked> const all = {
    {"mill",
     {"contour", "machine.json", "--feed", "1250.5,4000", "--tolerance", "0.01"},
     0,
     "group,feed_mm_per"},
    {"motion/square", {"simulate", "machine.json", "--program", "square.nc"}, 0, "time_s,block,"},
    {"motion/rack",
     {"simulate", "machine.json", "--plant", "plant.json", "--move", "X:50"},
     0,
     "time_s,setpoint"},
    {"resonance",
     {"suggest", "machine.json", "--axis", "X", "--measured", "torque-velocity.csv"},
     0,
     "number,axis,"},
    {"motion/rack",
     {"suggest", "machine.json", "--axis", "X", "--resonance", "11Hz", "--plant", "plant.json"},
     0,
     "number,axis,"},
    {"mill", {"get", "machine.json", "X", "--all"}, 0, "parameter,p_axis,"},
    {"recording", {"compare", "x.lis", "scope.csv", "--cycle-time", "1ms"}, 1, "readings,"},
};

Outcome answered(Asked const& asked, std::string const& format, std::string const& language = "en") {
  auto const samples = std::string(AXISC_SOURCE_DIR) + "/samples/";
  auto words = asked.words;
  words.insert(words.end(), {"--format", format, "--lang", language});
  // Without teeth, whose simulation takes ten times as long and has the same answers.
  static TemporaryFolder const folder;
  auto plant = json::parse(file_contents(samples + "motion/rack/plant.json"));
  plant["plants"][0]["transmission_error_um"] = 0;
  folder.write("plant.json", plant.dump());
  std::replace(words.begin(), words.end(), std::string("plant.json"), folder / "plant.json");
  auto outcome = run_axisc(words, in_folder(samples + asked.folder));
  INFO(words.front() << " " << format << ": " << outcome.err);
  CHECK(outcome.status == asked.status);
  CHECK_FALSE(outcome.out.empty());
  return outcome;
}

/// In columns of a terminal.
std::size_t width_of(std::string const& line) {
  return static_cast<std::size_t>(std::count_if(line.begin(), line.end(), [](char const byte) {
    return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
  }));
}

}  // namespace

TEST_CASE("answers have every format, and text fits a terminal") {
  for (auto const& asked : all) {
    INFO(asked.words.front());
    for (std::string const language : {"en", "de"}) {
      std::istringstream lines(answered(asked, "text", language).out);
      for (std::string line; std::getline(lines, line);) {
        INFO(line);
        CHECK(width_of(line) <= 80);
      }
      auto const page = answered(asked, "html", language).out;
      CHECK(page.starts_with("<!doctype html>\n<html lang=\"" + language + "\">"));
      CHECK(page.ends_with("</html>\n"));
    }
    CHECK(answered(asked, "csv").out.starts_with(asked.csv));
    auto const markdown = answered(asked, "markdown").out;
    CHECK(markdown.starts_with("# "));
    // What stays as it is, such as lines of a list, is in a fence or a table.
    CHECK(markdown.find("\n\n\n") == std::string::npos);
  }
}

TEST_CASE("programs read the same in every language") {
  for (auto const& asked : all) {
    auto english = json::parse(answered(asked, "json").out);
    auto german = json::parse(answered(asked, "json", "de").out);
    CHECK(english["version"].is_number_integer());
    // What a reading means is said to people.
    for (auto* const answer : {&english, &german}) {
      if (answer->contains("next")) (*answer)["next"].erase("meaning");
      if (!answer->contains("fitting")) continue;
      for (auto& one : (*answer)["fitting"]) one.erase("meaning");
    }
    CHECK(english == german);
  }
}

}  // namespace answers_test
