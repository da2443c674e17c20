// A conversation with a language server in this process, as `axisc lsp` has it.
#pragma once

#include "axisc/checking/checking_options.hpp"
#include "diagnostics/sentence.hpp"

#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

namespace axisc::test {

using Json = nlohmann::json;

/// A file of the repository as a client sends it: UTF-8, without a mark.
[[nodiscard]] std::string text_of(std::string const& path);
[[nodiscard]] std::string source_path(std::string const& path);

inline std::string const shutdown_request = R"({"jsonrpc": "2.0", "id": "bye", "method": "shutdown"})";
inline std::string const exit_notification = R"({"jsonrpc": "2.0", "method": "exit"})";

class Conversation {
 public:
  /// Begins with initialize, which offers `encoding` (empty for none).
  explicit Conversation(std::string const& encoding = "utf-32", Json capabilities = Json::object(),
                        Json const& settings = nullptr);

  Conversation& open(std::string const& path, std::string const& text);
  Conversation& open(std::string const& path) { return open(path, text_of(path)); }
  Conversation& notify(std::string const& method, Json const& params);
  Conversation& change(std::string const& path, std::string const& text);
  /// Any message.
  Conversation& say(Json const& message);
  /// Asks about a document.
  Conversation& ask(std::string const& method, std::string const& path, Json params = Json::object());
  Conversation& ask_at(std::string const& method, std::string const& path, int line, int character);

  /// Ends the conversation; the results of all questions in order, errors as whole messages. `options` are
  /// those that the server is started with.
  [[nodiscard]] std::vector<Json> results(Language language = Language::english,
                                          CheckingOptions const& options = {});
  /// All messages of the server in order.
  [[nodiscard]] std::vector<Json> all(Language language = Language::english,
                                      CheckingOptions const& options = {});
  /// Messages without an id that the server sent, after results().
  [[nodiscard]] std::vector<Json> const& notifications() const { return notifications_; }

  [[nodiscard]] std::vector<std::string> const& messages() const { return messages_; }

 private:
  std::vector<std::string> messages_;
  int last_id_ = 1;
  std::vector<Json> notifications_;
};

}  // namespace axisc::test
