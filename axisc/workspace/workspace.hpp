// What every question is asked of: files with unsaved text over them, the settings that apply to each, and
// the machine that a file belongs to.
#pragma once

#include "axisc/settings/settings.hpp"
#include "axisc/workspace/edited_files.hpp"
#include "axisc/workspace/inputs.hpp"
#include "axisc/workspace/machine_search.hpp"
#include "validator/options.hpp"

#include <functional>
#include <memory>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace axisc {

/// The options that `lint` checks an input with.
using OptionsOf = std::function<validator::CheckOptions(std::string const& path)>;

/// What counts for every file, before the settings: options of the command line, settings of an editor.
struct Overrides {
  validator::CheckOptions options = {};
  bool quiet = false;  ///< without notes
  std::vector<std::string> schema_files = {};
};

/// Asking may happen in several threads; changing it may not, and not while somebody asks. A Failure of the
/// settings ends the whole run.
class Workspace {
 public:
  /// Files of the disk; "-" is standard input.
  explicit Workspace(Overrides overrides = {});
  /// `disk` must outlive this object, and the machines of its answers: they read their NC programs again.
  explicit Workspace(configuration::Files& disk, Overrides overrides = {});
  /// With the options of a caller that has applied the settings itself.
  Workspace(configuration::Files& disk, OptionsOf options);
  Workspace(Workspace const&) = delete;
  Workspace& operator=(Workspace const&) = delete;

  [[nodiscard]] configuration::Files& files() { return files_; }
  [[nodiscard]] configuration::Files& disk() { return disk_; }
  [[nodiscard]] SettingsFinder& settings() { return settings_; }
  [[nodiscard]] Overrides const& overrides() const { return overrides_; }

  /// Unsaved text: it takes the place of the file, which need not exist.
  void put(std::string path, std::string bytes) {
    unsaved_.insert_or_assign(std::move(path), std::move(bytes));
  }
  void drop(std::string const& path) { unsaved_.erase(path); }
  void put_all(EditedBytes unsaved) { unsaved_ = std::move(unsaved); }
  [[nodiscard]] EditedBytes const& unsaved() const { return unsaved_; }

  /// The overrides with the settings that apply to the file. Cost: system calls once per folder.
  [[nodiscard]] validator::CheckOptions options_of(std::string const& path);
  /// The machine whose check covers the file.
  [[nodiscard]] Belonging machine_of(std::string const& path);
  /// An NC cycle time that only another input tells.
  void assume(design::CycleTime cycle_time) { overrides_.options.cycle_time = cycle_time; }

  /// Remembers which of the inputs were found in folders.
  void take(Inputs const& inputs) { found_ = inputs.found; }
  /// Replaces lists and programs by the machines that read them, of which only findings about these files are
  /// shown then: see judged_inputs.hpp.
  void judge_in_machines(Inputs& inputs);
  /// The machine of each input: see judged_inputs.hpp.
  [[nodiscard]] std::vector<Belonging> belonging_of(Inputs const& inputs);
  /// The files that are shown of a machine, by the names that it reads them by; null: all.
  [[nodiscard]] std::vector<std::string> const* shown_of(std::string const& machine) const;

 private:
  std::unique_ptr<configuration::Files> own_disk_;
  configuration::Files& disk_;
  Overrides overrides_;
  OptionsOf ready_options_;  ///< null: overrides and settings
  SettingsFinder settings_;
  EditedBytes unsaved_;
  EditedFiles files_{unsaved_, disk_};
  std::unordered_map<std::string, FoundInput> found_;                ///< see Inputs::found
  std::unordered_map<std::string, std::vector<std::string>> shown_;  ///< see Inputs::shown
};

}  // namespace axisc
