// A machine as the open documents and the disk have it at one moment: read once, checked once, however many requests ask.
#pragma once

#include "axisc/workspace/buffers.hpp"
#include "axisc/workspace/machine_search.hpp"
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
  /// `path` is the machine's input. What the arguments refer to outlives the reading; no document that it depends on
  /// changes meanwhile, and none is opened or closed.
  MachineReading(Buffers files, std::string path, OptionsOf const& options);
  MachineReading(MachineReading const&) = delete;
  MachineReading& operator=(MachineReading const&) = delete;

  [[nodiscard]] Buffers const& files() const { return files_; }
  [[nodiscard]] SourceSet const& sources() const { return sources_; }
  /// Null where the input cannot be read.
  [[nodiscard]] validator::LoadedMachine const* machine() const { return machine_ ? &*machine_ : nullptr; }
  /// In output order. What concerns no file is in the machine's.
  [[nodiscard]] std::vector<Finding> const& findings();
  [[nodiscard]] OpenList const& list(Document const& document);
  /// What was read depends on the text of the document.
  [[nodiscard]] bool depends_on(Document const& document) const {
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
  std::map<Document const*, std::unique_ptr<OpenList const>> lists_;
};

}  // namespace axisc::editor
