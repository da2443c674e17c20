// What is behind an axisc_workspace, and its files and settings as they are during one call.
#pragma once

#include "axisc/axisc.h"
#include "axisc/interface/provided_files.hpp"
#include "axisc/workspace/workspace.hpp"
#include "editor/session.hpp"

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>

struct axisc_workspace {
  axisc::Language language = axisc::Language::english;
  axisc::validator::CheckOptions options;
  axisc_files from{};  ///< read null: the disk
  axisc::EditedBytes unsaved;
  std::unique_ptr<axisc::editor::Session> session;
  std::string error;
  std::string input;       ///< what the call is about
  bool is_usable = false;  ///< opened without a mistake
  std::atomic<bool> is_in_call = false;
  std::atomic<bool> is_cancelled = false;
};

namespace axisc::interface {

enum class Wanted : std::uint8_t { findings, machine };

/// Files and settings as they are during one call.
struct Now {
  ProvidedFiles files;
  Workspace workspace;

  explicit Now(axisc_workspace& object, Wanted wanted = Wanted::machine);

  /// A file or a folder, whether or not it can be read.
  [[nodiscard]] bool has(std::string const& path);
};

}  // namespace axisc::interface
