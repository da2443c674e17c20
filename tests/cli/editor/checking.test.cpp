// The language server shows what lint says.
#include "cli/editor/conversation.hpp"
#include "cli/program.hpp"
#include "cli/temporary_folder.hpp"
#include "support/catch.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>

using namespace axisc::test;

namespace {

namespace fs = std::filesystem;

/// The machine that the sample's folder says it belongs to.
std::string machine_of(fs::path const& list) {
  auto const name = list.filename().string();
  if (name == "achsmds1_alt.lis" || name == "notizen.lis") return list.string();
  for (auto const* const machine : {"machine.json", "hochlauf.lis", "hochlauf.xml"}) {
    if (fs::exists(list.parent_path() / machine)) return (list.parent_path() / machine).string();
    auto const beside = list.parent_path().parent_path() / "listen" / machine;
    if (list.extension() == ".nc" && fs::exists(beside)) return beside.string();
  }
  return list.string();
}

Json const& linted(std::string const& input) {
  static std::map<std::string, Json> known;
  auto& found = known[input];
  if (found.is_null()) {
    found = Json::parse(run_axisc({"lint", input, "--format", "json", "--lang", "en"}).out)["diagnostics"];
  }
  return found;
}

std::vector<Json> expected_in(std::string const& path) {
  std::vector<Json> expected;
  for (auto const& finding : linted(machine_of(path))) {
    if (fs::path(finding["file"].get<std::string>()).lexically_normal() == path) expected.push_back(finding);
  }
  return expected;
}

std::vector<std::string> sample_files() {
  std::vector<std::string> files;
  for (auto const& entry : fs::recursive_directory_iterator(source_path("samples"))) {
    auto const extension = entry.path().extension();
    bool const is_text = extension == ".lis" || extension == ".nc" || extension == ".xml" ||
                         entry.path().filename() == "machine.json";
    if (entry.is_regular_file() && is_text) files.push_back(entry.path().string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// The number of findings.
std::size_t compare(Json const& shown, std::vector<Json> const& expected) {
  REQUIRE(shown.size() == expected.size());
  for (std::size_t i = 0; i < shown.size(); ++i) {
    CHECK(shown[i]["code"] == expected[i]["code"]);
    CHECK(shown[i]["severity"] == (expected[i]["severity"] == "error"     ? 1
                                   : expected[i]["severity"] == "warning" ? 2
                                                                          : 3));
    CHECK(shown[i]["message"].get<std::string>().starts_with(expected[i]["message"].get<std::string>()));
    CHECK(shown[i].value("relatedInformation", Json::array()).size() == expected[i]["related"].size());
    CHECK(shown[i].contains("data") == !expected[i]["fix"].is_null());
    if (expected[i]["line"].is_null()) continue;
    CHECK(shown[i]["range"]["start"]["line"] == expected[i]["line"].get<int>() - 1);
    CHECK(shown[i]["range"]["start"]["character"] == expected[i]["column"].get<int>() - 1);
    CHECK(shown[i]["range"]["end"]["character"] == expected[i]["end_column"].get<int>() - 1);
  }
  return shown.size();
}

Json shown_in(std::vector<Json> const& notifications, std::string const& path) {
  Json shown;
  for (auto const& message : notifications) {
    if (message["params"].value("uri", "") == "file://" + path) shown = message["params"]["diagnostics"];
  }
  return shown;
}

}  // namespace

TEST_CASE("each sample alone shows what lint says of it in its machine") {
  std::size_t findings = 0;
  auto const files = sample_files();
  REQUIRE(files.size() > 80);
  for (auto const& path : files) {
    INFO(path);
    findings += compare(Conversation().open(path).ask("textDocument/diagnostic", path).results()[0]["items"],
                        expected_in(path));
  }
  CHECK(findings > 20);
}

TEST_CASE("a file has one verdict, whether it is named, in a commit, or an editor's text") {
  auto const files = sample_files();
  auto const found = [](std::vector<std::string> words, std::string const& input = {}) {
    words.insert(words.begin(), "lint");
    words.insert(words.end(), {"--format", "json", "--lang", "en"});
    Surroundings surroundings;
    surroundings.input = input;
    return Json::parse(run_axisc(words, surroundings).out)["diagnostics"];
  };
  // The assumed cycle time is said once in a run.
  auto const of_file = [](Json const& all, std::string const& path) {
    auto own = Json::array();
    for (auto const& finding : all) {
      if (finding["code"] == "AX9006") continue;
      if (fs::path(finding["file"].get<std::string>()).lexically_normal() == path) own.push_back(finding);
    }
    return own;
  };
  std::vector<std::string> commit{"--hook"};
  commit.insert(commit.end(), files.begin(), files.end());
  auto const committed = found(commit);
  TemporaryFolder const folder;
  std::string names;
  for (auto const& path : files) names += path + "\n";
  folder.write("changed.txt", names);
  auto const listed = found({"@" + folder.path() + "/changed.txt"});
  for (auto const& path : files) {
    INFO(path);
    Json const expected = expected_in(path);
    if (machine_of(path) != path) CHECK(found({path}) == expected);
    CHECK(of_file(committed, path) == of_file(expected, path));
    CHECK(of_file(listed, path) == of_file(expected, path));
    std::ifstream in(path, std::ios::binary);
    std::string const bytes((std::istreambuf_iterator<char>(in)), {});
    if (machine_of(path) != path) CHECK(found({"-", "--stdin-filename", path}, bytes) == expected);
  }
}

TEST_CASE("all samples together show what lint says of each") {
  Conversation conversation;
  auto const files = sample_files();
  for (auto const& path : files) conversation.open(path);
  (void)conversation.results();
  std::size_t findings = 0;
  for (auto const& path : files) {
    INFO(path);
    auto const shown = shown_in(conversation.notifications(), path);
    REQUIRE(shown.is_array());
    findings += compare(shown, expected_in(path));
  }
  CHECK(findings > 20);
}

TEST_CASE("an unsaved default list changes what other open lists of its machine show") {
  TemporaryFolder const folder;
  folder.write(
      "machine.json",
      R"({"cycle_time_us": 1000, "default_list": "all.lis", "axes": [{"name": "X", "list": "lists/x.lis"}]})");
  folder.write("all.lis", "filter[0].type LOWPASS\n");
  folder.write("lists/x.lis", "filter[0].enable 1\nfilter[0].order 1\nfilter[0].time_constant 5000\n");
  auto const list = folder.path() + "/lists/x.lis";
  // The same file, written otherwise.
  auto const defaults = folder.path() + "/lists/.././all.lis";
  auto const codes = [&](Json const& items) {
    std::string all;
    for (auto const& item : items) all += item["code"].get<std::string>() + " ";
    return all;
  };
  Conversation conversation;
  auto const results = conversation.open(defaults)
                           .open(list)
                           .ask("textDocument/diagnostic", list)
                           .change(defaults, "filter[0].type PT1\n")
                           .ask("textDocument/diagnostic", list)
                           .results();
  CHECK(codes(results[0]["items"]).find("AX3009") != std::string::npos);
  CHECK(codes(results[1]["items"]).find("AX3009") == std::string::npos);
  // Told without being asked.
  CHECK(shown_in(conversation.notifications(), list) == results[1]["items"]);
}

TEST_CASE("a machine file that is being written counts") {
  TemporaryFolder const folder;
  folder.write("x.lis",
               "filter[0].enable 1\nfilter[0].order 1\nfilter[0].type PT1\nfilter[0].time_constant 1500\n");
  auto const list = folder.path() + "/x.lis";
  auto const machine = folder.path() + "/machine.json";
  auto const results =
      Conversation()
          .open(list)
          .open(machine, "{}")
          .ask("textDocument/diagnostic", list)
          .change(machine, R"({"cycle_time_us": 4000, "axes": [{"name": "X", "list": "x.lis"}]})")
          .ask("textDocument/diagnostic", list)
          .results();
  CHECK(results[0]["items"].dump().find("AX3004") == std::string::npos);
  CHECK(results[1]["items"].dump().find("AX3004") != std::string::npos);
}

TEST_CASE("team settings apply") {
  TemporaryFolder const folder;
  folder.write("axisc.json", R"({"disable": ["AX2001"]})");
  auto const list = folder.path() + "/x.lis";
  auto const results =
      Conversation().open(list, "kopx.achs_nr 1\n").ask("textDocument/diagnostic", list).results();
  CHECK(results[0]["items"].dump().find("AX2001") == std::string::npos);
}

TEST_CASE("a mistake in the team settings is told once") {
  TemporaryFolder const folder;
  folder.write("axisc.json", R"({"disable": 5})");
  auto const list = folder.path() + "/x.lis";
  Conversation conversation;
  (void)conversation.open(list, "kopx.achs_nr 1\n")
      .ask("textDocument/diagnostic", list)
      .ask("textDocument/hover", list, {{"position", {{"line", 0}, {"character", 1}}}})
      .results();
  auto const& sent = conversation.notifications();
  CHECK(std::count_if(sent.begin(), sent.end(), [](Json const& message) {
          return message["method"] == "window/showMessage" && message["params"]["type"] == 1 &&
                 message["params"]["message"].get<std::string>().find("axisc.json") != std::string::npos;
        }) == 1);
}

TEST_CASE("ignored text is marked as unnecessary") {
  auto const results = Conversation()
                           .open("/x.lis", "kopf.achs_nr 1\nEnde\nkopf.achs_nr 2\n")
                           .ask("textDocument/diagnostic", "/x.lis")
                           .results();
  bool found = false;
  for (auto const& diagnostic : results[0]["items"]) {
    if (diagnostic["code"] != "AX1008") continue;
    found = true;
    CHECK(diagnostic["tags"] == Json::array({1}));
  }
  CHECK(found);
}

TEST_CASE("a closed document shows nothing") {
  Conversation conversation;
  (void)conversation.open("/x.lis", "kopx.achs_nr 1\n")
      .notify("textDocument/didClose", {{"textDocument", {{"uri", "file:///x.lis"}}}})
      .results();
  CHECK(shown_in(conversation.notifications(), "/x.lis").empty());
}
