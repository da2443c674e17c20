// The settings of the editor: `axisc.cycleTime` and its neighbours, told or asked for.
#include "support/catch.hpp"
#include "support/conversation.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace client_settings_test {

using namespace axisc::test;

namespace {

/// Begins with settings, and with the abilities of the client that concern its workspace.
Conversation hello(Json const& settings = nullptr, Json const& workspace = Json::object()) {
  return Conversation("", {{"workspace", workspace}}, settings);
}

Json settings_answer(Json const& section) {
  return {{"id", "axisc.settings"}, {"result", Json::array({section})}};
}

Conversation opened(Conversation conversation) {
  return conversation.open(source_path("samples/manual/axis-pt1.lis"));
}

Conversation changed(Conversation conversation, Json const& settings) {
  return conversation.notify("workspace/didChangeConfiguration", {{"settings", settings}});
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
  CHECK(codes(opened(hello()).all()) == Texts{"AX9006"});
  CHECK(codes(opened(hello(cycle("1ms"))).all()).empty());
  CHECK(codes(opened(hello({{"axisc", cycle(" 100ms ")}})).all()) == Texts{"AX3004"});
}

TEST_CASE("a change of settings is checked at once, and empty ones give way to the command line") {
  CHECK(codes(changed(opened(hello()), {{"axisc", cycle("1ms")}}).all()).empty());
  axisc::CheckingOptions options;
  options.cycle_time = "100ms";
  CHECK(codes(changed(opened(hello(cycle("1ms"))), {{"axisc", cycle("")}})
                  .all(axisc::Language::english, options)) == Texts{"AX3004"});
  // Those of other programs, and none.
  for (auto const& other : {Json({{"other", cycle("")}}), Json(nullptr), Json(7)}) {
    CHECK(codes(changed(opened(hello(cycle("1ms"))), other).all()).empty());
  }
}

TEST_CASE("clients that answer questions about settings are asked for them") {
  auto const able =
      hello(nullptr, {{"configuration", true}, {"didChangeConfiguration", {{"dynamicRegistration", true}}}});
  auto const begun = opened(Conversation(able).notify("initialized", Json::object()));
  auto const first = Conversation(begun).say(settings_answer(cycle("1ms"))).all();
  CHECK(asked(first) == Texts{"client/registerCapability", "workspace/configuration"});
  CHECK(codes(first).empty());
  auto const again = changed(Conversation(begun).say(settings_answer(cycle("1ms"))), nullptr)
                         .say(settings_answer(cycle("100ms")))
                         .all();
  CHECK(asked(again) ==
        Texts{"client/registerCapability", "workspace/configuration", "workspace/configuration"});
  CHECK(codes(again) == Texts{"AX3004"});
  CHECK(codes(Conversation(begun).say(settings_answer(nullptr)).all()) == Texts{"AX9006"});
  CHECK(asked(hello().notify("initialized", Json::object()).all()).empty());
}

TEST_CASE("clients that watch files are asked for all that a machine consists of") {
  auto able = hello(nullptr, {{"didChangeWatchedFiles", {{"dynamicRegistration", true}}}});
  Texts patterns;
  for (auto const& each : able.notify("initialized", Json::object()).all()) {
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
    for (auto const& each : opened(hello(settings)).all()) {
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
  auto const page = [](std::string const& setting, axisc::Language own) {
    auto const results = hello({{"language", setting}})
                             .open("/x.lis", "filter[0].order 4\nx\n")
                             .ask_at("textDocument/hover", "/x.lis", 0, 3)
                             .results(own);
    return results[0]["contents"]["value"].get<std::string>();
  };
  CHECK(page("de", axisc::Language::english).find("Ordnung") != std::string::npos);
  CHECK(page("en", axisc::Language::german).find("Ordnung") == std::string::npos);
  CHECK(page("auto", axisc::Language::german).find("Ordnung") != std::string::npos);
  CHECK(page("", axisc::Language::german).find("Ordnung") != std::string::npos);
}

TEST_CASE("a mistake in a setting is told by its name, and the others count") {
  auto const told =
      opened(hello({{"cycleTime", "soon"}, {"kind", "list"}, {"build", "V9"}, {"language", "fr"}})).all();
  auto const texts = shown(told);
  REQUIRE(texts.size() == 4);
  CHECK(texts[0].starts_with("axisc.cycleTime: \"soon\""));
  CHECK(texts[1].starts_with("axisc.build: \"V9\""));
  CHECK(texts[2].starts_with("axisc.kind: "));
  CHECK(texts[3].starts_with("axisc.language: \"fr\""));
  CHECK(codes(opened(hello({{"build", "V9"}, {"cycleTime", "1ms"}})).all()).empty());
  CHECK(codes(opened(hello({{"kind", "channel"}, {"cycleTime", 5}})).all()) != Texts{"AX9006"});
}

}  // namespace client_settings_test
