// The language server: a function from one message to messages. It opens no file and waits for nothing.
#pragma once

#include "axisc/workspace/buffers.hpp"
#include "axisc/workspace/machine_search.hpp"
#include "configuration/files.hpp"
#include "diagnostics/message.hpp"
#include "editor/client_settings.hpp"
#include "editor/pages.hpp"
#include "editor/reading/machine_reading.hpp"
#include "editor/reading/text_positions.hpp"
#include "validator/options.hpp"

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace axisc::editor {

/// What the server needs from its surroundings.
struct Surroundings {
  configuration::Files& disk;
  OptionsOf options;
  Language language = Language::english;
  /// Takes the settings of the client into `options`; the language from then on. Null where none count.
  std::function<Language(ClientSettings const&)> configure = nullptr;
};

enum class LinesOf : std::uint8_t { list, machine };

enum class Phase : std::uint8_t { before_initialize, running, shut_down, ended };

/// A message that the client shows to the user.
[[nodiscard]] std::string error_message(std::string_view sentence);

/// The id of the request for the client's settings.
inline constexpr std::string_view settings_request = "axisc.settings";

class Places;

class Server {
 public:
  explicit Server(Surroundings surroundings)
      : surroundings_(std::move(surroundings)), search_(surroundings_.options) {}
  Server(Server const&) = delete;
  Server& operator=(Server const&) = delete;

  /// The answers to one message, without frames. Never throws for a bad message.
  [[nodiscard]] std::vector<std::string> receive(std::string_view message);
  /// The same for messages that arrived together: a request that a later one cancels is refused.
  [[nodiscard]] std::vector<std::string> receive(std::span<std::string const> messages);
  /// Diagnostics of the documents that changes since the last call affect: several changes that arrived together are
  /// checked once.
  [[nodiscard]] std::vector<std::string> publish();
  [[nodiscard]] bool has_ended() const { return phase_ == Phase::ended; }
  /// The client asked for the shutdown before it ended the server.
  [[nodiscard]] bool ended_properly() const { return was_shut_down_; }

 private:
  using Json = nlohmann::json;
  using Handler = Json (Server::*)(Json const& params);
  /// Of a method; null for unknown ones.
  static Handler find(std::string_view name);
  [[nodiscard]] std::vector<std::string> take(Json const& message);

  Json initialize(Json const& params);
  Json shut_down(Json const& params);
  Json exit(Json const& params);
  Json ignore(Json const& params);
  Json open(Json const& params);
  Json change(Json const& params);
  Json close(Json const& params);
  Json begin_conversation(Json const& params);
  Json configure(Json const& params);
  Json check_all(Json const& params);
  Json pull(Json const& params);
  Json format(Json const& params);
  Json format_range(Json const& params);
  Json code_actions(Json const& params);
  Json hover(Json const& params);
  Json complete(Json const& params);
  Json resolve_completion(Json const& params);
  Json define(Json const& params);
  Json refer(Json const& params);
  Json prepare_hierarchy(Json const& params);
  Json supertypes(Json const& params);
  Json subtypes(Json const& params);
  Json refuse_renaming(Json const& params);
  Json links(Json const& params);
  Json symbols(Json const& params);
  Json workspace_symbols(Json const& params);
  Json fold(Json const& params);
  Json hints(Json const& params);
  Json tokens(Json const& params);
  Json lenses(Json const& params);
  Json resolve_lens(Json const& params);
  Json execute(Json const& params);

  [[nodiscard]] static Json token_legend();
  /// What the server is able to do for this client.
  [[nodiscard]] Json capabilities(std::string const& encoding) const;
  /// The client's answer with its settings, or null.
  void take_settings(Json const& answer);
  void apply(ClientSettings const& settings);
  void ask_for_settings();
  void ask_for_notifications();
  /// The name of the axis that an open list makes.
  [[nodiscard]] std::optional<std::string> axis_of(Document const& document);
  /// The lines that set what stands at a position; of the whole machine, or those that decide it for the list.
  [[nodiscard]] Json lines_setting(Document const& asked, std::size_t offset, LinesOf of);

  [[nodiscard]] Buffers buffers();
  /// All machines are read again when they are wanted; who they looked for stays known.
  void forget_readings();
  /// The document that a request names; std::out_of_range where it is not open.
  [[nodiscard]] Document& document(Json const& params);
  [[nodiscard]] std::string const& machine_of(Document const& document);
  [[nodiscard]] MachineReading& reading_of(std::string const& machine);
  [[nodiscard]] MachineReading& reading_of(Document const& document) {
    return reading_of(machine_of(document));
  }
  [[nodiscard]] OpenList const& list_of(Document const& document) {
    return reading_of(document).list(document);
  }
  [[nodiscard]] Json diagnostics(MachineReading& reading, Document const& document) const;
  [[nodiscard]] Json diagnostic(Finding const& finding, Places const& places) const;
  /// Allowing a finding on its line, and its page.
  void add_finding_actions(Json& actions, Finding const& finding, Json const& shown,
                           Document const& document);
  void add_unit_action(Json& actions, Document const& document, std::size_t offset);
  void add_value_action(Json& actions, Document const& document, std::size_t offset);
  /// As `fmt` writes it.
  [[nodiscard]] std::string aligned(Document const& document) const;
  /// Edits of the document.
  [[nodiscard]] Json fix_all(Document const& document);

  Surroundings surroundings_;
  Phase phase_ = Phase::before_initialize;
  bool was_shut_down_ = false;
  PositionEncoding encoding_ = PositionEncoding::utf16;
  bool markdown_ = true;  ///< the client shows Markdown in hovers
  bool markdown_in_completion_ = false;
  bool documents_lazily_ = false;  ///< the client asks for the documentation of the completion that it shows
  bool gives_settings_ = false;    ///< the client answers workspace/configuration
  bool registers_settings_ = false;  ///< the client says when they change, if it is asked to
  bool watches_files_ = false;       ///< the client says when files change on the disk, if it is asked to
  bool takes_pushed_ = false;        ///< the client shows diagnostics that it is told
  ClientSettings settings_;
  std::vector<std::string> due_;  ///< requests to the client, sent with the next answer
  Documents documents_;
  std::shared_ptr<OpenPaths const> open_paths_;  ///< null where documents were opened or closed since
  MachineSearch search_;
  Readers readers_;  ///< machines of open documents that are not about to be checked anyway
  std::map<std::string, std::string> machines_;  ///< of open documents, by URI; emptied where they may change
  /// By the machine's input; one goes with a change of a document that it depends on, all with a document.
  std::map<std::string, std::unique_ptr<MachineReading>> readings_;
  std::set<std::string> changed_;  ///< URIs of open documents whose machines are to be checked
  std::set<std::string> closed_;
  std::map<std::string, std::string> published_;  ///< the last diagnostics, by URI
};

}  // namespace axisc::editor
