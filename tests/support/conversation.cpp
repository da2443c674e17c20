#include "support/conversation.hpp"

#include "diagnostics/source_text.hpp"
#include "editor/session.hpp"
#include "support/catch.hpp"
#include "support/file_contents.hpp"

#include <cstdint>
#include <iterator>
#include <utility>

namespace axisc::test {

std::string source_path(std::string const& path) {
  return std::string(AXISC_SOURCE_DIR) + "/" + path;
}

std::string text_of(std::string const& path) {
  auto const text = file_contents(path);
  SourceText const source(path, text);
  return source.utf8({source.text_begin(), static_cast<std::uint32_t>(text.size())});
}

Conversation::Conversation(std::string const& encoding, Json capabilities, Json const& settings) {
  if (!encoding.empty()) capabilities["general"]["positionEncodings"] = {encoding};
  say({{"id", 1},
       {"method", "initialize"},
       {"params", {{"capabilities", std::move(capabilities)}, {"initializationOptions", settings}}}});
}

Conversation& Conversation::say(Json const& message) {
  auto whole = message;
  whole["jsonrpc"] = "2.0";
  messages_.push_back(whole.dump());
  return *this;
}

Conversation& Conversation::notify(std::string const& method, Json const& params) {
  return say({{"method", method}, {"params", params}});
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
  return say({{"id", ++last_id_}, {"method", method}, {"params", std::move(params)}});
}

Conversation& Conversation::ask_at(std::string const& method, std::string const& path, int line,
                                   int character) {
  return ask(method, path, {{"position", {{"line", line}, {"character", character}}}});
}

std::vector<Json> Conversation::all(Language language, CheckingOptions const& options) {
  messages_.push_back(shutdown_request);
  messages_.push_back(exit_notification);
  editor::Session session(check_options(options), language);
  std::vector<Json> answers;
  for (auto const& answer : session.take(messages_)) answers.push_back(Json::parse(answer));
  CHECK(session.has_ended());
  CHECK(session.ended_properly());
  return answers;
}

std::vector<Json> Conversation::results(Language language, CheckingOptions const& options) {
  std::vector<Json> results;
  for (auto& message : all(language, options)) {
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
