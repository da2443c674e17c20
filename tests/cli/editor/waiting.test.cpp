// Messages that arrived together, and files that go away.
#include "cli/editor/conversation.hpp"
#include "editor/server.hpp"
#include "support/catch.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <variant>
#include <vector>

using namespace axisc::test;

namespace {

class VanishingFiles final : public axisc::configuration::Files {
 public:
  std::variant<std::string, axisc::configuration::FileError> read(std::string const& path) override {
    auto const found = files.find(path);
    if (found == files.end()) return axisc::configuration::FileError::not_found;
    return found->second;
  }
  std::vector<std::string> names_in(std::string const& /*folder*/) override {
    std::vector<std::string> names;
    for (auto const& [path, text] : files) names.push_back(path.substr(path.rfind('/') + 1));
    return names;
  }
  std::map<std::string, std::string> files;
};

std::string request(int id, std::string const& method, Json const& params) {
  return Json{{"jsonrpc", "2.0"}, {"id", id}, {"method", method}, {"params", params}}.dump();
}

std::string note(std::string const& method, Json const& params) {
  return Json{{"jsonrpc", "2.0"}, {"method", method}, {"params", params}}.dump();
}

Json const document = {{"uri", "file:///m/x.lis"}};
Json const position = {{"line", 0}, {"character", 2}};
Json const range = {{"start", position}, {"end", position}};

}  // namespace

TEST_CASE("a request that is cancelled while it waits is refused") {
  Conversation conversation;
  conversation.open("/x.lis", "kopf.achs_nr 1\n")
      .ask_at("textDocument/hover", "/x.lis", 0, 2)
      .ask_at("textDocument/hover", "/x.lis", 0, 2)
      .notify("$/cancelRequest", {{"id", 2}})
      .notify("$/cancelRequest", {{"id", 99}})
      .notify("$/cancelRequest", {{"id", "2"}})
      .notify("$/cancelRequest", nullptr)
      .ask_at("textDocument/hover", "/x.lis", 0, 2);
  auto const results = conversation.results();
  CHECK(results[0]["error"]["code"] == -32800);
  CHECK(results[1].contains("contents"));
  CHECK(results[2].contains("contents"));
}

TEST_CASE("of several changes that wait only the last is checked") {
  Conversation conversation;
  conversation.open("/x.lis", "kopf.achs_nr 1\n");
  for (int i = 0; i < 20; ++i) {
    conversation.change("/x.lis", std::string(static_cast<std::size_t>(i), '\n') + "kopx.achs_nr 1\n");
  }
  (void)conversation.results();
  auto const& told = conversation.notifications();
  CHECK(std::count_if(told.begin(), told.end(), [](Json const& message) {
          return message["method"] == "textDocument/publishDiagnostics";
        }) == 1);
  auto const last = std::find_if(told.begin(), told.end(), [](Json const& message) {
    return message["method"] == "textDocument/publishDiagnostics";
  });
  REQUIRE(last != told.end());
  auto const& found = (*last)["params"]["diagnostics"];
  CHECK(std::any_of(found.begin(), found.end(), [](Json const& finding) {
    return finding["code"] == "AX2001" && finding["range"]["start"]["line"] == 19;
  }));
}

TEST_CASE("files that are deleted under the server leave it answering") {
  VanishingFiles disk;
  disk.files = {
      {"/m/machine.json",
       R"({"cycle_time_us": 1000, "default_list": "all.lis", "axes": [{"name": "X", "list": "x.lis"}]})"},
      {"/m/all.lis", "filter[0].fg_f0 42\n"},
      {"/m/x.lis", "filter[0].fg_f0 17\n"}};
  axisc::editor::Server server(
      {.disk = disk, .options = [](std::string const&) { return axisc::validator::CheckOptions{}; }});
  (void)server.receive(request(1, "initialize", {{"capabilities", Json::object()}}));
  (void)server.receive(
      note("textDocument/didOpen",
           {{"textDocument", {{"uri", document["uri"]}, {"version", 1}, {"text", disk.files["/m/x.lis"]}}}}));
  (void)server.publish();
  auto const ask = [&](std::string const& method, Json params) {
    params["textDocument"] = document;
    auto const answers = server.receive(request(2, method, params));
    REQUIRE(answers.size() == 1);
    return Json::parse(answers[0]);
  };
  auto const items = ask("textDocument/prepareTypeHierarchy", {{"position", position}})["result"];
  REQUIRE(items.size() == 1);
  CHECK(ask("typeHierarchy/supertypes", {{"item", items[0]}})["result"].size() == 2);
  disk.files.clear();
  SECTION("before it is told") {}
  SECTION("after it is told") {
    (void)server.receive(note("workspace/didChangeWatchedFiles", {{"changes", Json::array()}}));
    CHECK(server.publish().size() == 1);
    // Alone, the list has nothing but the default above it.
    CHECK(ask("typeHierarchy/supertypes", {{"item", items[0]}})["result"].size() == 1);
  }
  for (auto const* const method :
       {"textDocument/hover", "textDocument/completion", "textDocument/definition", "textDocument/references",
        "textDocument/prepareTypeHierarchy", "textDocument/formatting", "textDocument/codeLens",
        "textDocument/documentSymbol", "textDocument/documentLink", "textDocument/semanticTokens/full",
        "textDocument/foldingRange", "textDocument/diagnostic"}) {
    INFO(method);
    CHECK(ask(method, {{"position", position}}).contains("result"));
  }
  CHECK(ask("textDocument/inlayHint", {{"range", range}}).contains("result"));
  CHECK(ask("textDocument/codeAction", {{"range", range}, {"context", Json::object()}}).contains("result"));
  CHECK(ask("typeHierarchy/subtypes", {{"item", items[0]}}).contains("result"));
}
