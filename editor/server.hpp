// The language server: a function from one message to messages. It opens no file and waits for nothing.
#pragma once

#include "configuration/files.hpp"
#include "diagnostics/message.hpp"
#include "editor/text_positions.hpp"
#include "validator/options.hpp"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace axisc::editor {

/// What the server needs from its surroundings.
struct Surroundings {
  configuration::Files& disk;
  /// The options with which `lint` checks a file.
  std::function<validator::CheckOptions(std::string const& path)> options;
  Language language = Language::english;
};

struct Document {
  std::string path;
  std::string text;  ///< UTF-8
  std::optional<std::int64_t> version;
};

enum class Phase : std::uint8_t { before_initialize, running, shut_down, ended };

class Server {
 public:
  explicit Server(Surroundings surroundings) : surroundings_(std::move(surroundings)) {}

  /// The answers to one message, without frames. Never throws for a bad message.
  [[nodiscard]] std::vector<std::string> receive(std::string_view message);
  /// Diagnostics of the documents that changed since the last call: several changes that arrived together are checked
  /// once.
  [[nodiscard]] std::vector<std::string> publish();
  [[nodiscard]] bool has_ended() const { return phase_ == Phase::ended; }
  /// The client asked for the shutdown before it ended the server.
  [[nodiscard]] bool ended_properly() const { return was_shut_down_; }
  /// The text of an open document; none for others.
  [[nodiscard]] std::optional<std::string> text(std::string const& uri) const;

 private:
  using Json = nlohmann::json;
  struct Method;
  static Method const* find(std::string_view name);

  Json initialize(Json const& params);
  Json shut_down(Json const& params);
  Json exit(Json const& params);
  Json ignore(Json const& params);
  Json open(Json const& params);
  Json change(Json const& params);
  Json close(Json const& params);
  Json check_all(Json const& params);
  Json format(Json const& params);
  Json pull(Json const& params);

  [[nodiscard]] Document& document(Json const& params);
  [[nodiscard]] Json diagnostics(Document const& document);

  Surroundings surroundings_;
  Phase phase_ = Phase::before_initialize;
  bool was_shut_down_ = false;
  PositionEncoding encoding_ = PositionEncoding::utf16;
  std::map<std::string, Document> documents_;  ///< by URI
  std::map<std::string, bool> changed_;        ///< by URI: false for one that was closed
};

}  // namespace axisc::editor
