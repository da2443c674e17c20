// What `axisc lsp` does with messages, however they reach it.
#pragma once

#include "axisc/files/disk_files.hpp"
#include "axisc/settings/settings.hpp"
#include "editor/server.hpp"

#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace axisc::editor {

/// A server with the settings that apply to each list. They are read again for every check, because they may have changed;
/// the user is told once about each mistake in them.
class Session {
 public:
  Session(validator::CheckOptions asked, Language language);
  Session(Session const&) = delete;
  Session& operator=(Session const&) = delete;
  ~Session() = default;

  /// The answers to messages that arrived together, without frames.
  [[nodiscard]] std::vector<std::string> take(std::span<std::string const> messages);
  /// Diagnostics of what has changed since the last call.
  [[nodiscard]] std::vector<std::string> publish();
  [[nodiscard]] bool has_ended() const { return server_.has_ended(); }
  [[nodiscard]] bool ended_properly() const { return server_.ended_properly(); }

 private:
  [[nodiscard]] validator::CheckOptions options_of(std::string const& path);
  [[nodiscard]] Language configure(ClientSettings const& settings);
  [[nodiscard]] std::vector<std::string> with_failure(std::vector<std::string> messages);

  validator::CheckOptions started_;  ///< of the command line
  validator::CheckOptions asked_;    ///< with the client's settings, which override them
  Language own_language_;
  Language language_;
  DiskFiles disk_;
  std::optional<SettingsFinder> settings_;  ///< the options of a check refer to them
  std::string failure_;                     ///< of the settings
  std::set<std::string> told_;
  std::vector<std::string> mistakes_;  ///< of the client's settings
  OptionsOf options_;
  Server server_;
};

}  // namespace axisc::editor
