// Code actions.
#include "support/catch.hpp"
#include "support/conversation.hpp"

#include <algorithm>

namespace actions_test {

using namespace axisc::test;

namespace {

Json const whole = {{"start", {{"line", 0}, {"character", 0}}}, {"end", {{"line", 9999}, {"character", 0}}}};

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

Json actions(std::string const& path, std::string const& text, Json const& only, Json const& range = whole) {
  return Conversation("utf-8")
      .open(path, text)
      .ask("textDocument/codeAction", path,
           {{"range", range}, {"context", {{"diagnostics", Json::array()}, {"only", only}}}})
      .results()[0];
}

Json asked(std::string const& method, std::string const& path, std::string const& text,
           Json const& params = Json::object()) {
  return Conversation().open(path, text).ask(method, path, params).results()[0];
}

}  // namespace

TEST_CASE("a finding's fix is a code action that keeps the columns of comments") {
  std::string const text = "filter[0].fg_f0     17,5    ( Hz\nfilter[0].enable   1\n";
  auto const offered = actions("/x.lis", text, {"quickfix"});
  auto const fix = std::find_if(offered.begin(), offered.end(), [](Json const& action) {
    return action["diagnostics"][0]["code"] == "AX1005";
  });
  REQUIRE(fix != offered.end());
  CHECK((*fix)["kind"] == "quickfix");
  CHECK((*fix)["isPreferred"].is_boolean());
  CHECK(edited(text, (*fix)["edit"]["changes"]["file:///x.lis"]) ==
        "filter[0].fg_f0     17.5    ( Hz\nfilter[0].enable   1\n");
  Json const second = {{"start", {{"line", 1}, {"character", 0}}}, {"end", {{"line", 1}, {"character", 3}}}};
  CHECK(actions("/x.lis", text, {"quickfix"}, second).dump().find("AX1005") == std::string::npos);
}

TEST_CASE("a finding can be allowed on its line, and then it is gone") {
  auto const allowed = [](std::string const& text) {
    auto const actions = Conversation()
                             .open("/x.lis", text)
                             .ask("textDocument/codeAction", "/x.lis",
                                  {{"range", whole}, {"context", {{"diagnostics", Json::array()}}}})
                             .results()[0];
    auto const action = std::find_if(actions.begin(), actions.end(), [](Json const& each) {
      return each["title"] == "Allow AX2001 on this line";
    });
    REQUIRE(action != actions.end());
    auto const edit = (*action)["edit"]["changes"]["file:///x.lis"][0];
    auto const line = edit["range"]["start"]["line"].get<std::size_t>();
    std::size_t begin = 0;
    for (std::size_t i = 0; i < line; ++i) begin = text.find('\n', begin) + 1;
    auto changed = text;
    changed.insert(begin + edit["range"]["start"]["character"].get<std::size_t>(), edit["newText"]);
    return changed;
  };
  CHECK(allowed("unknown.name 1\n") == "unknown.name 1  ( axisc: allow AX2001\n");
  CHECK(allowed("unknown.name 1 ( old\n") == "unknown.name 1 ( old axisc: allow AX2001\n");
  CHECK(allowed("unknown.name 1 ( axisc: allow AX1005\n") == "unknown.name 1 ( axisc: allow AX1005,AX2001\n");
  for (auto const* const text :
       {"unknown.name 1\n", "unknown.name 1 ( old\n", "unknown.name 1 ( axisc: allow AX1005\n"}) {
    Conversation conversation;
    conversation.open("/x.lis", allowed(text));
    (void)conversation.results();
    for (auto const& message : conversation.notifications()) {
      for (auto const& finding : message["params"].value("diagnostics", Json::array())) {
        CHECK(finding["code"] != "AX2001");
      }
    }
  }
}

TEST_CASE("a finding's page and a number's word are actions") {
  auto const actions = [](std::string const& text) {
    Json const range = {{"start", {{"line", 0}, {"character", 3}}}, {"end", {{"line", 0}, {"character", 3}}}};
    return Conversation()
        .open("/x.lis", text)
        .ask("textDocument/codeAction", "/x.lis",
             {{"range", range}, {"context", {{"diagnostics", Json::array()}}}})
        .results()[0];
  };
  auto const explain = actions("unknown.name 1\n");
  REQUIRE(!explain.empty());
  CHECK(explain.back()["command"]["arguments"] == Json({"file:///x.lis", "AX2001"}));
  auto const words = actions("filter[0].prototype 2\n");
  auto const word = std::find_if(words.begin(), words.end(),
                                 [](Json const& each) { return each["kind"] == "refactor.rewrite"; });
  REQUIRE(word != words.end());
  CHECK((*word)["edit"]["changes"]["file:///x.lis"][0]["newText"] == "  ( BUTTERWORTH");
  auto const page = asked("workspace/executeCommand", "/x.lis", "",
                          {{"command", "axisc.explain"}, {"arguments", {"file:///x.lis", "AX2001"}}});
  CHECK(page["title"] == "AX2001");
  auto const html = page["html"].get<std::string>();
  CHECK(html.find("<h1>") != std::string::npos);
  CHECK(html.find("AX2001") != std::string::npos);
  // As a page, not as the source of one.
  CHECK(html.find("**") == std::string::npos);
}

TEST_CASE("a value with its unit is converted to the unit of the list") {
  auto const converted = [](std::string const& text) {
    Json const at = {{"line", 0}, {"character", 0}};
    auto const actions =
        asked("textDocument/codeAction", "/x.lis", text,
              {{"range", {{"start", at}, {"end", at}}}, {"context", {{"only", {"refactor.rewrite"}}}}});
    if (actions.empty()) return std::string();
    auto const edit = actions[0]["edit"]["changes"]["file:///x.lis"][0];
    auto const begin = edit["range"]["start"]["character"].get<std::size_t>();
    return text.substr(0, begin) + edit["newText"].get<std::string>() + text.substr(begin);
  };
  CHECK(converted("filter[0].time_constant 20 ms\n") == "filter[0].time_constant 20000 ( 20 ms\n");
  CHECK(converted("filter[0].time_constant 20ms\n") == "filter[0].time_constant 20000 ( 20ms\n");
  CHECK(converted("filter[0].time_constant 0,5 ms ( so\n") == "filter[0].time_constant 500 ( 0,5 ms ( so\n");
  CHECK(converted("filter[0].fg_f0 42.5Hz\n") == "filter[0].fg_f0 42.5 ( 42.5Hz\n");
  CHECK(converted("filter[0].fg_f0 0.1 kHz\n") == "filter[0].fg_f0 100 ( 0.1 kHz\n");
  CHECK(converted("filter[0].time_constant 20 MSEC; so\n") ==
        "filter[0].time_constant 20000 ( 20 MSEC; so\n");
  CHECK(converted("getriebe[0].dynamik.vb_max 500 mm/s\n") ==
        "getriebe[0].dynamik.vb_max 500000 ( 500 mm/s\n");
  // In the list's unit, of another quantity, not whole, no unit, no number.
  for (auto const* const text :
       {"filter[0].fg_f0 42.5 Hz\n", "filter[0].time_constant 20 Hz\n", "filter[0].time_constant 0.0001 ms\n",
        "filter[0].fg_f0 42.5\n", "filter[0].fg_f0 42.5 Hallo\n", "filter[0].type 20 ms\n",
        "unknown 20 ms\n"}) {
    INFO(text);
    CHECK(converted(text).empty());
  }
}

}  // namespace actions_test
