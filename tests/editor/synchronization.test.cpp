// OpenDocuments that are opened, changed and closed, and files that change under them.
#include "editor/server.hpp"
#include "support/catch.hpp"
#include "support/conversation.hpp"
#include "support/temporary_folder.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <variant>
#include <vector>

namespace synchronization_test {

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

Json shown_in(std::vector<Json> const& notifications, std::string const& path) {
  Json shown;
  for (auto const& message : notifications) {
    if (message["params"].value("uri", "") == "file://" + path) shown = message["params"]["diagnostics"];
  }
  return shown;
}

}  // namespace

TEST_CASE("edits reach the text at the positions of each encoding") {
  // ü: two bytes, one UTF-16 unit; 😀: four bytes, two units.
  std::string const text = "# \xC3\xBC\xF0\x9F\x98\x80 kopx.achs_nr 1\r\nkopx.achs_nr 1\n";
  auto const shown = [&](std::string const& encoding, int line, int character) {
    Json const at = {{"line", line}, {"character", character}};
    auto const before = Json{{"line", line}, {"character", character - 1}};
    auto const results =
        Conversation(encoding)
            .open("/x.lis", text)
            .notify("textDocument/didChange",
                    {{"textDocument", {{"uri", "file:///x.lis"}, {"version", 2}}},
                     {"contentChanges",
                      Json::array({{{"range", {{"start", before}, {"end", at}}}, {"text", "kopy\nkopz "}}})}})
            .ask("textDocument/diagnostic", "/x.lis")
            .results();
    return results[0]["items"].dump();
  };
  CHECK(shown("utf-32", 0, 5).find("kopz") != std::string::npos);
  CHECK(shown("utf-16", 0, 6).find("kopz") != std::string::npos);
  CHECK(shown("utf-8", 0, 9).find("kopz") != std::string::npos);
  CHECK(shown("", 1, 4).find("kopz") != std::string::npos);
  // After the end of a line, and after the last one.
  CHECK(shown("utf-16", 1, 4000).find("kopz") != std::string::npos);
  CHECK(shown("utf-16", 2000000000, 4000).find("kopz") != std::string::npos);
}

TEST_CASE("an edit at no position changes nothing") {
  for (auto const* const number : {"-1", "1.5", "1e300", "\"0\"", "null"}) {
    INFO(number);
    auto const at = Json::parse(std::string(R"({"line":0,"character":)") + number + "}");
    auto const results =
        Conversation()
            .open("/x.lis", "kopf.achs_nr 1\n")
            .notify(
                "textDocument/didChange",
                {{"textDocument", {{"uri", "file:///x.lis"}, {"version", 2}}},
                 {"contentChanges", Json::array({{{"range", {{"start", at}, {"end", at}}}, {"text", "x"}}})}})
            .ask("textDocument/diagnostic", "/x.lis")
            .results();
    CHECK(results[0]["items"].dump().find("AX2001") == std::string::npos);
  }
}

TEST_CASE("a document without text is not open") {
  auto const results =
      Conversation()
          .notify("textDocument/didOpen", {{"textDocument", {{"uri", "file:///x.lis"}, {"version", 1}}}})
          .change("/x.lis", "kopx.achs_nr 1\n")
          .ask("textDocument/diagnostic", "/x.lis")
          .results();
  CHECK(results[0]["error"]["code"] == -32602);
}

TEST_CASE("a carriage return alone ends a line of the protocol") {
  auto const results = Conversation("utf-16")
                           .open("/x.lis", "kopf.achs_nr 1\rkopf.achs_nr 2\nkopx.achs_nr 1\n")
                           .ask("textDocument/diagnostic", "/x.lis")
                           .results();
  int seen = 0;
  for (auto const& diagnostic : results[0]["items"]) {
    if (diagnostic["code"] == "AX1001") {
      ++seen;
      CHECK(diagnostic["range"]["start"] == Json({{"line", 0}, {"character", 14}}));
      CHECK(diagnostic["range"]["end"] == Json({{"line", 1}, {"character", 0}}));
    }
    if (diagnostic["code"] == "AX2001") {
      ++seen;
      CHECK(diagnostic["range"]["start"] == Json({{"line", 2}, {"character", 0}}));
    }
  }
  CHECK(seen == 2);
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

TEST_CASE("a closed document shows nothing") {
  Conversation conversation;
  (void)conversation.open("/x.lis", "kopx.achs_nr 1\n")
      .notify("textDocument/didClose", {{"textDocument", {{"uri", "file:///x.lis"}}}})
      .results();
  CHECK(shown_in(conversation.notifications(), "/x.lis").empty());
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

}  // namespace synchronization_test
