#include "cli/editor/conversation.hpp"

#include "cli/program.hpp"
#include "diagnostics/source_text.hpp"
#include "support/catch.hpp"

#include <cstdint>
#include <fstream>
#include <iterator>
#include <utility>

namespace axisc::test {

std::string framed(std::string const& text) {
  return "Content-Length: " + std::to_string(text.size()) + "\r\n\r\n" + text;
}

std::vector<Json> unframed(std::string_view out) {
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

std::string source_path(std::string const& path) {
  return std::string(AXISC_SOURCE_DIR) + "/" + path;
}

std::string text_of(std::string const& path) {
  std::ifstream file(path, std::ios::binary);
  std::string const text((std::istreambuf_iterator<char>(file)), {});
  SourceText const source(path, text);
  return source.utf8({source.text_begin(), static_cast<std::uint32_t>(text.size())});
}

Conversation::Conversation(std::string const& encoding, Json capabilities) {
  if (!encoding.empty()) capabilities["general"]["positionEncodings"] = {encoding};
  input_ = framed(Json{{"jsonrpc", "2.0"},
                       {"id", 1},
                       {"method", "initialize"},
                       {"params", {{"capabilities", std::move(capabilities)}}}}
                      .dump());
}

Conversation& Conversation::notify(std::string const& method, Json const& params) {
  input_ += framed(Json{{"jsonrpc", "2.0"}, {"method", method}, {"params", params}}.dump());
  return *this;
}

Conversation& Conversation::open(std::string const& path, std::string const& text) {
  return notify("textDocument/didOpen",
                {{"textDocument",
                  {{"uri", "file://" + path}, {"languageId", "axis-list"}, {"version", 1}, {"text", text}}}});
}

Conversation& Conversation::change(std::string const& path, std::string const& text) {
  return notify("textDocument/didChange", {{"textDocument", {{"uri", "file://" + path}, {"version", 2}}},
                                           {"contentChanges", Json::array({{{"text", text}}})}});
}

Conversation& Conversation::ask(std::string const& method, std::string const& path, Json params) {
  params["textDocument"]["uri"] = "file://" + path;
  input_ += framed(
      Json{{"jsonrpc", "2.0"}, {"id", ++last_id_}, {"method", method}, {"params", std::move(params)}}.dump());
  return *this;
}

Conversation& Conversation::ask_at(std::string const& method, std::string const& path, int line,
                                   int character) {
  return ask(method, path, {{"position", {{"line", line}, {"character", character}}}});
}

std::vector<Json> Conversation::results(std::string const& language) {
  input_ += framed(R"({"jsonrpc": "2.0", "id": "bye", "method": "shutdown", "params": null})") +
            framed(R"({"jsonrpc": "2.0", "method": "exit", "params": null})");
  Surroundings surroundings;
  surroundings.input = input_;
  auto const outcome = run_axisc({"lsp", "--lang", language}, surroundings);
  CHECK(outcome.status == 0);
  CHECK(outcome.err.empty());
  std::vector<Json> results;
  for (auto& message : unframed(outcome.out)) {
    if (!message.contains("id")) {
      notifications_.push_back(std::move(message));
    } else if (message["id"].is_number() && message["id"] != 1) {
      results.push_back(message.contains("error") ? message : message["result"]);
    }
  }
  REQUIRE(results.size() == static_cast<std::size_t>(last_id_ - 1));
  return results;
}

}  // namespace axisc::test
