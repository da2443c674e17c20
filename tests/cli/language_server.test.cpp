// Conversations with the built language server.
#include "cli/program.hpp"
#include "diagnostics/source_text.hpp"
#include "support/catch.hpp"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

using namespace axisc::test;

namespace {

using Json = nlohmann::json;

std::string frame(std::string const& text) {
  return "Content-Length: " + std::to_string(text.size()) + "\r\n\r\n" + text;
}

std::string request(int id, std::string const& method, Json const& params) {
  return frame(Json{{"jsonrpc", "2.0"}, {"id", id}, {"method", method}, {"params", params}}.dump());
}

std::string notification(std::string const& method, Json const& params) {
  return frame(Json{{"jsonrpc", "2.0"}, {"method", method}, {"params", params}}.dump());
}

std::string const hello =
    request(1, "initialize", {{"capabilities", {{"general", {{"positionEncodings", {"utf-32"}}}}}}});
std::string const farewell = request(99, "shutdown", nullptr) + notification("exit", nullptr);

std::vector<Json> messages(std::string_view out) {
  std::vector<Json> found;
  while (!out.empty()) {
    auto const end = out.find("\r\n\r\n");
    REQUIRE(end != std::string_view::npos);
    auto const size = std::stoul(std::string(out.substr(16, end - 16)));
    found.push_back(Json::parse(out.substr(end + 4, size)));
    out.remove_prefix(end + 4 + size);
  }
  return found;
}

Surroundings fed(std::string input) {
  Surroundings surroundings;
  surroundings.input = std::move(input);
  return surroundings;
}

std::string open(std::string const& path, std::string const& text) {
  return notification(
      "textDocument/didOpen",
      {{"textDocument",
        {{"uri", "file://" + path}, {"languageId", "axis-list"}, {"version", 1}, {"text", text}}}});
}

}  // namespace

TEST_CASE("the language server shows what lint says of every sample list") {
  std::vector<std::pair<std::string, std::string>> lists;
  for (auto const& entry :
       std::filesystem::recursive_directory_iterator(std::string(AXISC_SOURCE_DIR) + "/samples")) {
    auto const path = entry.path().string();
    if (!entry.is_regular_file() || !path.ends_with(".lis")) continue;
    std::ifstream file(path, std::ios::binary);
    std::string const text((std::istreambuf_iterator<char>(file)), {});
    // A client sends UTF-8, without a mark.
    axisc::SourceText const source(path, text);
    auto const size = static_cast<std::uint32_t>(text.size());
    lists.emplace_back(path, source.utf8({source.text_begin(), size}));
  }
  REQUIRE(lists.size() > 20);
  // One at a time: an open document would take the place of a file that another names.
  std::size_t findings = 0;
  for (auto const& [path, text] : lists) {
    INFO(path);
    auto const served =
        run_axisc({"lsp", "--lang", "en"},
                  fed(hello + open(path, text) +
                      request(2, "textDocument/diagnostic", {{"textDocument", {{"uri", "file://" + path}}}}) +
                      farewell));
    CHECK(served.status == 0);
    auto const linted = run_axisc({"lint", path, "--format", "json", "--lang", "en"});
    auto const expected = Json::parse(linted.out)["diagnostics"];
    Json shown;
    for (auto const& message : messages(served.out)) {
      if (message.value("id", 0) == 2) shown = message["result"]["items"];
    }
    REQUIRE(shown.size() == expected.size());
    for (std::size_t i = 0; i < shown.size(); ++i) {
      CHECK(shown[i]["code"] == expected[i]["code"]);
      CHECK(shown[i]["message"].get<std::string>().starts_with(expected[i]["message"].get<std::string>()));
      CHECK(shown[i]["relatedInformation"].size() >= expected[i]["related"].size());
      CHECK(shown[i].contains("data") == !expected[i]["fix"].is_null());
      if (expected[i]["line"].is_null() || expected[i]["file"] != path) continue;
      CHECK(shown[i]["range"]["start"]["line"] == expected[i]["line"].get<int>() - 1);
      CHECK(shown[i]["range"]["start"]["character"] == expected[i]["column"].get<int>() - 1);
      CHECK(shown[i]["range"]["end"]["character"] == expected[i]["end_column"].get<int>() - 1);
      ++findings;
    }
  }
  CHECK(findings > 20);
}

TEST_CASE("the language server answers what is no request of it and ends") {
  auto const outcome = run_axisc(
      {"lsp"},
      fed(request(5, "textDocument/diagnostic", nullptr) + frame("{no json") + frame("[]") + hello +
          request(2, "textDocument/unknown", nullptr) + request(3, "textDocument/formatting", nullptr) +
          notification("$/cancelRequest", {{"id", 3}}) + notification("unknown", nullptr) + farewell));
  CHECK(outcome.status == 0);
  auto const all = messages(outcome.out);
  REQUIRE(all.size() == 7);
  CHECK(all[0]["error"]["code"] == -32002);
  CHECK(all[1]["error"]["code"] == -32700);
  CHECK(all[2]["error"]["code"] == -32600);
  CHECK(all[3]["result"]["capabilities"]["positionEncoding"] == "utf-32");
  CHECK(all[4]["error"]["code"] == -32601);
  CHECK(all[5]["error"]["code"] == -32602);
  CHECK(all[6]["result"].is_null());
  CHECK(run_axisc({"lsp"}, fed("Content-Length: many\r\n\r\n{}")).status == 2);
  CHECK(run_axisc({"lsp"}, fed(hello)).status == 1);
}

TEST_CASE("the language server checks the edited text") {
  Json const document = {{"uri", "file:///x.lis"}, {"version", 2}};
  Json const end = {{"line", 0}, {"character", 4}};
  Json const start = {{"line", 0}, {"character", 3}};
  auto const edit = notification(
      "textDocument/didChange",
      {{"textDocument", document},
       {"contentChanges", Json::array({{{"range", {{"start", start}, {"end", end}}}, {"text", "f"}}})}});
  auto const ask = [&](int id) {
    return request(id, "textDocument/diagnostic", {{"textDocument", document}});
  };
  auto const outcome = run_axisc(
      {"lsp"}, fed(hello + open("/x.lis", "kopx.achs_nr   1\n") + ask(2) + edit + ask(3) + farewell));
  CHECK(outcome.status == 0);
  auto const all = messages(outcome.out);
  REQUIRE(all.size() == 4);
  CHECK(all[1]["result"].dump().find("kopx") != std::string::npos);
  CHECK(all[2]["result"]["kind"] == "full");
  CHECK(all[2]["result"].dump().find("kopx") == std::string::npos);
}
