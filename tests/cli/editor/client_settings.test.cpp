// The settings of the editor: `axisc.cycleTime` and its neighbours, told or asked for.
#include "cli/editor/conversation.hpp"
#include "cli/program.hpp"
#include "support/catch.hpp"

#include <algorithm>
#include <string>
#include <vector>

using namespace axisc::test;

namespace {

std::string message(std::string const& method, Json const& params) {
  return framed(Json{{"jsonrpc", "2.0"}, {"method", method}, {"params", params}}.dump());
}

std::string hello(Json const& options = nullptr, Json const& workspace = Json::object()) {
  return framed(
      Json{{"jsonrpc", "2.0"},
           {"id", 1},
           {"method", "initialize"},
           {"params", {{"initializationOptions", options}, {"capabilities", {{"workspace", workspace}}}}}}
          .dump());
}

std::string settings_answer(Json const& section) {
  return framed(
      Json{{"jsonrpc", "2.0"}, {"id", "axisc.settings"}, {"result", Json::array({section})}}.dump());
}

std::string opened() {
  auto const path = source_path("samples/manual/axis-pt1.lis");
  return message(
      "textDocument/didOpen",
      {{"textDocument",
        {{"uri", "file://" + path}, {"languageId", "axis-list"}, {"version", 1}, {"text", text_of(path)}}}});
}

std::vector<Json> talk(std::string const& input, std::vector<std::string> const& options = {}) {
  Surroundings surroundings;
  surroundings.input = input + framed(R"({"jsonrpc":"2.0","id":99,"method":"shutdown"})") +
                       framed(R"({"jsonrpc":"2.0","method":"exit"})");
  std::vector<std::string> words = {"lsp"};
  words.insert(words.end(), options.begin(), options.end());
  auto const outcome = run_axisc(words, surroundings);
  CHECK(outcome.status == 0);
  return unframed(outcome.out);
}

using Texts = std::vector<std::string>;

Texts codes(std::vector<Json> const& messages) {
  Texts found;
  for (auto const& each : messages) {
    if (each.value("method", "") != "textDocument/publishDiagnostics") continue;
    found.clear();
    for (auto const& finding : each["params"]["diagnostics"]) found.push_back(finding["code"]);
  }
  return found;
}

Texts shown(std::vector<Json> const& messages) {
  Texts found;
  for (auto const& each : messages) {
    if (each.value("method", "") == "window/showMessage") found.push_back(each["params"]["message"]);
  }
  return found;
}

/// What the client is asked.
Texts asked(std::vector<Json> const& messages) {
  Texts found;
  for (auto const& each : messages) {
    if (each.contains("id") && each.contains("method")) found.push_back(each["method"]);
  }
  return found;
}

Json cycle(std::string const& time) {
  return {{"cycleTime", time}};
}

}  // namespace

TEST_CASE("settings come with the greeting, as a section or alone") {
  CHECK(codes(talk(hello() + opened())) == Texts{"AX9006"});
  CHECK(codes(talk(hello(cycle("1ms")) + opened())).empty());
  CHECK(codes(talk(hello({{"axisc", cycle(" 100ms ")}}) + opened())) == Texts{"AX3004"});
}

TEST_CASE("a change of settings is checked at once, and empty ones give way to the command line") {
  auto const change = [](Json const& settings) {
    return message("workspace/didChangeConfiguration", {{"settings", settings}});
  };
  CHECK(codes(talk(hello() + opened() + change({{"axisc", cycle("1ms")}}))).empty());
  CHECK(codes(talk(hello(cycle("1ms")) + opened() + change({{"axisc", cycle("")}}),
                   {"--cycle-time", "100ms"})) == Texts{"AX3004"});
  // Those of other programs, and none.
  for (auto const& other : {Json({{"other", cycle("")}}), Json(nullptr), Json(7)}) {
    CHECK(codes(talk(hello(cycle("1ms")) + opened() + change(other))).empty());
  }
}

TEST_CASE("who answers questions about settings is asked for them") {
  auto const able =
      hello(nullptr, {{"configuration", true}, {"didChangeConfiguration", {{"dynamicRegistration", true}}}});
  auto const begun = able + message("initialized", Json::object());
  auto const first = talk(begun + opened() + settings_answer(cycle("1ms")));
  CHECK(asked(first) == Texts{"client/registerCapability", "workspace/configuration"});
  CHECK(codes(first).empty());
  auto const changed = talk(begun + opened() + settings_answer(cycle("1ms")) +
                            message("workspace/didChangeConfiguration", {{"settings", nullptr}}) +
                            settings_answer(cycle("100ms")));
  CHECK(asked(changed) ==
        Texts{"client/registerCapability", "workspace/configuration", "workspace/configuration"});
  CHECK(codes(changed) == Texts{"AX3004"});
  CHECK(codes(talk(begun + opened() + settings_answer(nullptr))) == Texts{"AX9006"});
  CHECK(asked(talk(hello() + message("initialized", Json::object()))).empty());
}

TEST_CASE("who watches files is asked for all that a machine is made of") {
  auto const able = hello(nullptr, {{"didChangeWatchedFiles", {{"dynamicRegistration", true}}}});
  Texts patterns;
  for (auto const& each : talk(able + message("initialized", Json::object()))) {
    if (each.value("method", "") != "client/registerCapability") continue;
    for (auto const& registration : each["params"]["registrations"]) {
      CHECK(registration["method"] == "workspace/didChangeWatchedFiles");
      for (auto const& watcher : registration["registerOptions"]["watchers"]) {
        patterns.push_back(watcher["globPattern"]);
      }
    }
  }
  std::sort(patterns.begin(), patterns.end());
  CHECK(patterns == Texts{"**/*.LIS", "**/*.NC", "**/*.json", "**/*.lis", "**/*.nc", "**/*.tsproj",
                          "**/*.xml", "**/*.xti"});
}

TEST_CASE("codes lead to the pages that a setting names") {
  auto const pages = [](Json const& settings) {
    Texts found;
    for (auto const& each : talk(hello(settings) + opened())) {
      if (each.value("method", "") != "textDocument/publishDiagnostics") continue;
      for (auto const& finding : each["params"]["diagnostics"]) {
        found.push_back(finding.contains("codeDescription") ? finding["codeDescription"]["href"] : "none");
      }
    }
    return found;
  };
  CHECK(pages({{"findingPage", "https://rules.example/all#{code}"}}) ==
        Texts{"https://rules.example/all#AX9006"});
  CHECK(pages({{"findingPage", "https://rules.example"}}) == Texts{"https://rules.example"});
  CHECK(pages({{"findingPage", ""}}) == Texts{"none"});
}

TEST_CASE("a setting decides the language from then on") {
  auto const at = framed(
      Json{{"jsonrpc", "2.0"},
           {"id", 2},
           {"method", "textDocument/hover"},
           {"params",
            {{"textDocument", {{"uri", "file:///x.lis"}}}, {"position", {{"line", 0}, {"character", 3}}}}}}
          .dump());
  auto const page = [&](std::string const& language, std::vector<std::string> const& options) {
    auto const open = message(
        "textDocument/didOpen",
        {{"textDocument", {{"uri", "file:///x.lis"}, {"version", 1}, {"text", "filter[0].order 4\nx\n"}}}});
    for (auto const& each : talk(hello({{"language", language}}) + open + at, options)) {
      if (each.value("id", Json()) == 2) return each["result"]["contents"]["value"].get<std::string>();
    }
    return std::string();
  };
  CHECK(page("de", {}).find("Ordnung") != std::string::npos);
  CHECK(page("en", {"--lang", "de"}).find("Ordnung") == std::string::npos);
  CHECK(page("auto", {"--lang", "de"}).find("Ordnung") != std::string::npos);
  CHECK(page("", {"--lang", "de"}).find("Ordnung") != std::string::npos);
}

TEST_CASE("a mistake in a setting is told by its name, and the others count") {
  auto const told =
      talk(hello({{"cycleTime", "soon"}, {"kind", "list"}, {"build", "V9"}, {"language", "fr"}}) + opened());
  auto const texts = shown(told);
  REQUIRE(texts.size() == 4);
  CHECK(texts[0].starts_with("axisc.cycleTime: \"soon\""));
  CHECK(texts[1].starts_with("axisc.build: \"V9\""));
  CHECK(texts[2].starts_with("axisc.kind: "));
  CHECK(texts[3].starts_with("axisc.language: \"fr\""));
  CHECK(codes(talk(hello({{"build", "V9"}, {"cycleTime", "1ms"}}) + opened())).empty());
  CHECK(codes(talk(hello({{"kind", "channel"}, {"cycleTime", 5}}) + opened())) != Texts{"AX9006"});
}
