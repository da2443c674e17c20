// Code actions and formatting of the language server.
#include "cli/editor/conversation.hpp"
#include "cli/program.hpp"
#include "cli/temporary_folder.hpp"
#include "support/catch.hpp"

#include <algorithm>

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

TEST_CASE("only lists are aligned") {
  for (auto const* const path : {"/machine.json", "/x.nc", "/x.xml"}) {
    INFO(path);
    CHECK(Conversation()
              .open(path, "a 1\nabc   2\n")
              .ask("textDocument/formatting", path)
              .results()[0]
              .empty());
  }
}
