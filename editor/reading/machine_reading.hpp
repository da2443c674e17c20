// A snapshot of a machine from open documents and the disk: read once and checked once for all requests.
#pragma once

#include "axisc/workspace/buffers.hpp"
#include "axisc/workspace/workspace.hpp"
#include "diagnostics/finding.hpp"
#include "editor/reading/open_list.hpp"
#include "validator/loading/loading.hpp"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace axisc::editor {

class MachineReading {
 public:
  /// `path` is the machine's input. `options` and the documents of `files` outlive this object. While it
  /// lives, no document that it depends on changes, and none is opened or closed.
  MachineReading(Buffers files, std::string path, OptionsOf const& options);
  MachineReading(MachineReading const&) = delete;
  MachineReading& operator=(MachineReading const&) = delete;

  [[nodiscard]] Buffers const& files() const { return files_; }
  [[nodiscard]] SourceSet const& sources() const { return sources_; }
  /// Null if the input cannot be read.
  [[nodiscard]] validator::LoadedMachine const* machine() const { return machine_ ? &*machine_ : nullptr; }
  /// In output order. Findings without a file belong to the machine's input.
  [[nodiscard]] std::vector<Finding> const& findings();
  [[nodiscard]] OpenList const& list(OpenDocument const& document);
  /// The text of the document was read.
  [[nodiscard]] bool depends_on(OpenDocument const& document) const {
    return files_.has_read(document) || lists_.contains(&document);
  }

 private:
  Buffers files_;
  std::string path_;
  OptionsOf const& options_;
  SourceSet sources_;
  schema::Catalogue catalogue_;  ///< of axis lists
  std::optional<validator::LoadedMachine> machine_;
  std::optional<std::vector<Finding>> findings_;
  std::map<OpenDocument const*, std::unique_ptr<OpenList const>> lists_;
};

}  // namespace axisc::editor
