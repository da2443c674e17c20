// The language server: a function from one message to messages. It opens no file and waits for nothing.
#pragma once

#include "configuration/files.hpp"
#include "diagnostics/message.hpp"
#include "editor/buffers.hpp"
#include "editor/machine_context.hpp"
#include "editor/text_positions.hpp"
#include "validator/options.hpp"

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace axisc::editor {

/// What the server needs from its surroundings.
struct Surroundings {
  configuration::Files& disk;
  OptionsOf options;
  /// A parameter's page as Markdown, as `explain` prints it.
  std::function<std::string(schema::Catalogue const&, schema::Parameter const&)> explain;
  Language language = Language::english;
};

enum class Phase : std::uint8_t { before_initialize, running, shut_down, ended };

/// What the check of a machine found.
struct Checked {
  SourceSet sources;
  std::vector<Finding> findings;
};

/// A message that the client shows to the user.
[[nodiscard]] std::string error_message(std::string_view sentence);

class Places;

class Server {
 public:
  explicit Server(Surroundings surroundings) : surroundings_(std::move(surroundings)) {}

  /// The answers to one message, without frames. Never throws for a bad message.
  [[nodiscard]] std::vector<std::string> receive(std::string_view message);
  /// Diagnostics of the documents that changes since the last call affect: several changes that arrived together are
  /// checked once.
  [[nodiscard]] std::vector<std::string> publish();
  [[nodiscard]] bool has_ended() const { return phase_ == Phase::ended; }
  /// The client asked for the shutdown before it ended the server.
  [[nodiscard]] bool ended_properly() const { return was_shut_down_; }

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
  Json pull(Json const& params);
  Json format(Json const& params);
  Json code_actions(Json const& params);
  Json hover(Json const& params);
  Json complete(Json const& params);
  Json define(Json const& params);
  Json links(Json const& params);
  Json symbols(Json const& params);

  /// The document that a request names; std::out_of_range where it is not open.
  [[nodiscard]] Document& document(Json const& params);
  [[nodiscard]] std::string const& machine_of(Document const& document);
  [[nodiscard]] Checked check(Buffers& files, std::string const& machine) const;
  [[nodiscard]] Json diagnostics(Checked const& checked, Buffers const& files,
                                 Document const& document) const;
  [[nodiscard]] Json diagnostic(Finding const& finding, Places const& places) const;
  /// Edits of the document.
  [[nodiscard]] Json fix_all(Document const& document);

  Surroundings surroundings_;
  Phase phase_ = Phase::before_initialize;
  bool was_shut_down_ = false;
  PositionEncoding encoding_ = PositionEncoding::utf16;
  bool markdown_ = true;  ///< the client shows Markdown in hovers
  Documents documents_;
  std::map<std::string, std::string> machines_;  ///< of open documents, by URI; emptied where they may change
  std::set<std::string> changed_;                ///< URIs of open documents whose machines are to be checked
  std::set<std::string> closed_;
  std::map<std::string, std::string> published_;  ///< the last diagnostics, by URI
};

}  // namespace axisc::editor
