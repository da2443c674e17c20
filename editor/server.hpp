// The language server: a function from one message to messages. It opens no file and waits for nothing.
#pragma once

#include "configuration/files.hpp"
#include "editor/client_settings.hpp"
#include "editor/reading/open_machines.hpp"

#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace axisc::editor {

/// What the server needs from its surroundings.
struct Surroundings {
  configuration::Files& disk;
  OptionsOf options;
  Language language = Language::english;
  /// Applies the settings of the client to `options`, returns the new language. Null if settings are ignored.
  std::function<Language(ClientSettings const&)> configure = nullptr;
};

/// A message that the client shows to the user.
[[nodiscard]] std::string error_message(std::string_view sentence);

/// Life cycle, synchronisation, settings, diagnostics. Capabilities answer requests about open documents.
class Server {
 public:
  explicit Server(Surroundings surroundings)
      : configure_(std::move(surroundings.configure)),
        machines_(surroundings.disk, std::move(surroundings.options), surroundings.language) {}
  Server(Server const&) = delete;
  Server& operator=(Server const&) = delete;

  /// The answers to one message, without frames. Does not throw for bad messages.
  [[nodiscard]] std::vector<std::string> receive(std::string_view message);
  /// The answers to messages that arrived together: requests that a later message cancels are refused.
  [[nodiscard]] std::vector<std::string> receive(std::span<std::string const> messages);
  /// Diagnostics of all documents affected by changes since the last call: changes that arrive together are
  /// checked once.
  [[nodiscard]] std::vector<std::string> publish();
  [[nodiscard]] bool has_ended() const { return phase_ == Phase::ended; }
  /// The client asked for the shutdown before it ended the server.
  [[nodiscard]] bool ended_properly() const { return was_shut_down_; }

 private:
  enum class Phase : std::uint8_t { before_initialize, running, shut_down, ended };
  using Handler = Json (Server::*)(Json const& params);
  /// Null for methods of capabilities, and unknown ones.
  static Handler find(std::string_view method);

  [[nodiscard]] std::vector<std::string> take(Json const& message);
  /// The client's response to the request with this id.
  void take_answer(Json const& id, Json const& result);

  Json initialize(Json const& params);
  Json shut_down(Json const& params);
  Json exit(Json const& params);
  Json ignore(Json const& params);
  Json open(Json const& params);
  Json change(Json const& params);
  Json close(Json const& params);
  Json check_all(Json const& params);
  Json begin_conversation(Json const& params);
  Json configure(Json const& params);

  void apply(ClientSettings const& settings);
  void ask_for_settings();
  void ask_for_notifications();

  std::function<Language(ClientSettings const&)> configure_;
  OpenMachines machines_;
  Phase phase_ = Phase::before_initialize;
  bool was_shut_down_ = false;
  bool gives_settings_ = false;      ///< the client answers workspace/configuration
  bool registers_settings_ = false;  ///< the client can notify about changed settings
  bool watches_files_ = false;       ///< the client can notify about changed files
  ClientSettings settings_;
  std::vector<std::string> pending_;  ///< requests to the client, sent before the next answer
  std::set<std::string> changed_;     ///< URIs of open documents to check
  std::set<std::string> closed_;
  std::map<std::string, std::string> published_;  ///< the last diagnostics, by URI
};

}  // namespace axisc::editor
