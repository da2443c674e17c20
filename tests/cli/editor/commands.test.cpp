// The language server shows what the commands print.
#include "cli/program.hpp"
#include "support/catch.hpp"
#include "support/conversation.hpp"
#include "support/file_contents.hpp"
#include "support/temporary_folder.hpp"

#include <algorithm>
#include <filesystem>
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

/// The text after edits; they do not overlap.
std::string edited(std::string text, Json edits) {
  auto const offset = [&text](Json const& at) {
    std::size_t begin = 0;
    for (int line = 0; line < at["line"].get<int>(); ++line) begin = text.find('\n', begin) + 1;
    return begin + at["character"].get<std::size_t>();
  };
  std::reverse(edits.begin(), edits.end());
  for (auto const& edit : edits) {
    auto const begin = offset(edit["range"]["start"]);
    text.replace(begin, offset(edit["range"]["end"]) - begin, edit["newText"].get<std::string>());
  }
  return text;
}

Json const whole = {{"start", {{"line", 0}, {"character", 0}}}, {"end", {{"line", 9999}, {"character", 0}}}};

Json actions(std::string const& path, std::string const& text, Json const& only) {
  return Conversation("utf-8")
      .open(path, text)
      .ask("textDocument/codeAction", path,
           {{"range", whole}, {"context", {{"diagnostics", Json::array()}, {"only", only}}}})
      .results()[0];
}

Json hover(std::string const& path, std::string const& text, int line, int character) {
  return Conversation().open(path, text).ask_at("textDocument/hover", path, line, character).results()[0];
}

std::string hover_text(std::string const& path, std::string const& text, int line, int character) {
  auto const shown = hover(path, text, line, character);
  return shown.is_null() ? "" : shown["contents"]["value"].get<std::string>();
}

bool contains(std::string const& text, std::string const& piece) {
  INFO(text);
  CHECK(text.find(piece) != std::string::npos);
  return text.find(piece) != std::string::npos;
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
    if (machine_of(path) != path) {
      CHECK(found({"-", "--stdin-filename", path}, file_contents(path)) == expected);
    }
  }
}

TEST_CASE("text on standard input is judged in a machine above the working folder") {
  TemporaryFolder const folder;
  folder.write("machine.json", R"({"cycle_time_us": 1000, "axes": [{"name": "X", "list": "axes/x.lis"}]})");
  folder.write("axes/x.lis", "filter_fir.type 1\nfilter_fir.order 10\n");
  auto there = in_folder(folder / "axes");
  there.input = "filter_fir.type 1\nfilter_fir.order 300\n";
  for (std::string const name : {"x.lis", "./x.lis", "../axes/x.lis"}) {
    INFO(name);
    auto const outcome = run_axisc({"lint", "-", "--stdin-filename", name}, there);
    CHECK(outcome.status == 1);
    CHECK_THAT(outcome.out, Catch::Matchers::Contains("AX3001"));
  }
  there.input = std::string("\xFF\xFE", 2) + std::string("E\0n\0", 4);
  CHECK(run_axisc({"lint", "-", "--stdin-filename", "x.lis"}, there).status == 2);
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

TEST_CASE("fixing all in the editor equals lint --fix") {
  TemporaryFolder const folder;
  for (auto const* const sample : {"typing", "comments", "references", "units", "without-effect"}) {
    INFO(sample);
    auto const text = text_of(source_path(std::string("samples/mistakes/") + sample + ".lis"));
    auto const list = folder.path() + "/" + sample + ".lis";
    folder.write(std::string(sample) + ".lis", text);
    for (auto const& only : {Json({"source.fixAll.axisc"}), Json({"source.fixAll"}), Json({"source"})}) {
      auto const offered = actions(list, text, only);
      auto fixed = text;
      if (!offered.empty()) {
        CHECK(offered[0]["kind"] == "source.fixAll.axisc");
        fixed = edited(text, offered[0]["edit"]["changes"]["file://" + list]);
      }
      folder.write(std::string(sample) + ".lis", text);
      (void)run_axisc({"lint", list, "--fix"});
      CHECK(fixed == text_of(list));
    }
    folder.write(std::string(sample) + ".lis", text);
    CHECK(actions(list, text, {"refactor"}).empty());
  }
}

TEST_CASE("formatting in the editor equals fmt") {
  TemporaryFolder const folder;
  std::string const text = "# \xC3\xBC\r\nfilter[0].order 2 ( a\r\nkopf.achs_nr      1     ( b\r\n";
  folder.write("x.lis", text);
  auto const list = folder.path() + "/x.lis";
  auto const edits = Conversation("utf-8").open(list).ask("textDocument/formatting", list).results()[0];
  (void)run_axisc({"fmt", list});
  CHECK(edited(text, edits) == text_of(list));
  CHECK(text_of(list) != text);
}

TEST_CASE("hovering over a name shows the page that explain prints") {
  auto const page = run_axisc({"explain", "filter[0].order", "--lang", "en"}).out;
  auto const shown = hover("/x.lis", "# \xC3\xBC\nfilter[0].order  2\n", 1, 3);
  CHECK(shown["contents"]["kind"] == "markdown");
  contains(shown["contents"]["value"], page);
  CHECK(shown["range"]["start"] == Json({{"line", 1}, {"character", 0}}));
  CHECK(shown["range"]["end"] == Json({{"line", 1}, {"character", 15}}));
  CHECK(hover("/x.lis", "# comment\n", 0, 4).is_null());
  CHECK(hover("/x.lis", "kopx.unknown 1\n", 0, 4).is_null());
  CHECK(hover("/x.lis", "", 0, 0).is_null());
}

TEST_CASE("hovering over the number of a parameter shows its page anywhere") {
  auto const page = run_axisc({"explain", "P-AXIS-00140", "--lang", "en"}).out;
  contains(hover_text("/x.lis", "kopf.achs_nr 1 ( see P-AXIS-00140 : order\n", 0, 25), page);
  contains(hover_text("/x.lis", "# P-AXIS-00140\n", 0, 2), page);
  contains(hover_text("/x.nc", "N10 ( P-AXIS-00140\n", 0, 10), page);
  auto const channel = run_axisc({"explain", "P-CHAN-00035", "--lang", "en"}).out;
  contains(hover_text("/x.lis", "# P-CHAN-00035\n", 0, 14), channel);
  CHECK(hover("/x.lis", "# P-XXXX-00035 P-AXIS-99999999\n", 0, 5).is_null());
  CHECK(hover("/x.lis", "# P-XXXX-00035 P-AXIS-99999999\n", 0, 20).is_null());
}

TEST_CASE("hovering over each parameter says what it means in both languages") {
  for (auto const language : {axisc::Language::english, axisc::Language::german}) {
    std::string const word = language == axisc::Language::german ? "de" : "en";
    auto const all = Json::parse(run_axisc({"explain", "--all", "--format", "json", "--lang", word}).out);
    REQUIRE(all["parameters"].size() == 823);
    std::string text;
    for (auto const& parameter : all["parameters"]) {
      auto name = parameter["name"].get<std::string>();
      for (auto at = name.find("[]"); at != std::string::npos; at = name.find("[]")) name.insert(at + 1, "0");
      text += name + " 1\n";
    }
    Conversation conversation;
    conversation.open("/x.lis", text);
    for (int line = 0; line < 823; ++line) conversation.ask_at("textDocument/hover", "/x.lis", line, 1);
    auto const shown = conversation.results(language);
    for (std::size_t i = 0; i < shown.size(); ++i) {
      INFO(all["parameters"][i]["name"]);
      auto const meaning = all["parameters"][i]["meaning"].get<std::string>();
      REQUIRE(!meaning.empty());
      REQUIRE(shown[i].is_object());
      CHECK(shown[i]["contents"]["value"].get<std::string>().find(meaning) != std::string::npos);
    }
  }
}
