// `axisc lsp` without its input and output: messages in, messages out.
#pragma once

#include "axisc/files/disk_files.hpp"
#include "axisc/workspace/workspace.hpp"
#include "editor/server.hpp"

#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace axisc::editor {

/// A server with the settings that apply to each list. They are read again for every check, because they may
/// change. Each mistake in them is reported once.
class Session {
 public:
  Session(validator::CheckOptions asked, Language language);
  Session(Session const&) = delete;
  Session& operator=(Session const&) = delete;
  ~Session() = default;

  /// The answers to messages that arrived together, without frames.
  [[nodiscard]] std::vector<std::string> take(std::span<std::string const> messages);
  /// Diagnostics of everything that changed since the last call.
  [[nodiscard]] std::vector<std::string> publish();
  [[nodiscard]] bool has_ended() const { return server_.has_ended(); }
  [[nodiscard]] bool ended_properly() const { return server_.ended_properly(); }

 private:
  [[nodiscard]] validator::CheckOptions options_of(std::string const& path);
  [[nodiscard]] Language configure(ClientSettings const& settings);
  [[nodiscard]] std::vector<std::string> with_failure(std::vector<std::string> messages);

  validator::CheckOptions started_;  ///< from the command line
  validator::CheckOptions asked_;    ///< with the settings of the client, which come first
  Language own_language_;
  Language language_;
  DiskFiles disk_;
  std::optional<Workspace> workspace_;  ///< whose settings the options of a check refer to
  std::string failure_;                 ///< mistake in the settings
  std::set<std::string> told_;
  std::vector<std::string> mistakes_;  ///< in the settings of the client
  OptionsOf options_;
  Server server_;
};

}  // namespace axisc::editor
