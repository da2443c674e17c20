// A conversation with the built language server, written beforehand.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

namespace axisc::test {

using Json = nlohmann::json;

[[nodiscard]] std::string framed(std::string const& text);
[[nodiscard]] std::vector<Json> unframed(std::string_view out);

/// A file of the repository as a client sends it: UTF-8, without a mark.
[[nodiscard]] std::string text_of(std::string const& path);
[[nodiscard]] std::string source_path(std::string const& path);

class Conversation {
 public:
  /// Begins with initialize, which offers `encoding`; empty for none.
  explicit Conversation(std::string const& encoding = "utf-32", Json capabilities = Json::object());

  Conversation& open(std::string const& path, std::string const& text);
  Conversation& open(std::string const& path) { return open(path, text_of(path)); }
  Conversation& notify(std::string const& method, Json const& params);
  Conversation& change(std::string const& path, std::string const& text);
  /// Asks about a document.
  Conversation& ask(std::string const& method, std::string const& path, Json params = Json::object());
  Conversation& ask_at(std::string const& method, std::string const& path, int line, int character);

  /// Says farewell, runs the server and returns the results of what was asked, in order; an error as it is.
  [[nodiscard]] std::vector<Json> results(std::string const& language = "en");
  /// Messages that the server sent by itself, after results().
  [[nodiscard]] std::vector<Json> const& notifications() const { return notifications_; }

 private:
  std::string input_;
  int last_id_ = 1;
  std::vector<Json> notifications_;
};

}  // namespace axisc::test
