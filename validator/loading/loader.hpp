// Reads the files of an input, each once, into the machine that is being loaded.
#pragma once

#include "configuration/project_file.hpp"
#include "validator/loading/loading.hpp"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

namespace axisc::validator {

/// The last part of a path; what comes before its last point; `name` relative to the folder of `path`.
[[nodiscard]] std::string_view file_name(std::string_view path);
[[nodiscard]] std::string_view without_extension(std::string_view name);
[[nodiscard]] std::string beside(std::string const& path, std::string const& name);
[[nodiscard]] bool is_absolute(std::string_view path);
/// A key that is the same for all spellings of one path.
[[nodiscard]] std::string key_of(std::string const& path);

class Loader {
 public:
  /// All arguments must outlive the loader.
  Loader(configuration::Files& files, CheckOptions const& options, SourceSet& sources, LoadedMachine& machine)
      : files_(files), options_(options), sources_(sources), machine_(machine) {}

  /// The input, and everything that it names.
  std::optional<configuration::FileError> load(std::string const& path);

 private:
  std::optional<configuration::FileError> load_program();
  /// A list, a machine file, or a start-up list.
  std::optional<configuration::FileError> load_text();
  void load_single(SourceId source);
  /// A list of another kind that is judged by itself.
  void load_single_other(SourceId source, configuration::ListKind kind);
  void add_default_group();
  /// What the lists of a channel say about its motion; `number` is its index in the start-up list.
  /// `look_ahead` is what is said outside of channel lists.
  void read_dynamics(LoadedGroup& group, configuration::ListedLookAhead look_ahead);
  void add_other_list(SourceId source, configuration::ListKind kind, std::string name);

  // machine_file_loading.cpp
  void load_machine_file(SourceId source);
  /// None for an axis whose list could not be read.
  [[nodiscard]] std::optional<std::size_t> axis_named(configuration::LocatedText const& name) const;
  void add_group(configuration::MachineFileGroup const& named);
  void add_claims(configuration::MachineFileGantry const& gantry);
  /// The channel list of a group; none where it cannot be read or is of another kind.
  std::optional<SourceId> channel_list_named(configuration::LocatedText const& name);
  /// Index of the list, of the program; a file that is named several times is read once.
  std::optional<std::size_t> list_named(configuration::LocatedText const& name);
  std::optional<std::size_t> program_named(configuration::LocatedText const& name);
  void missing(configuration::LocatedText const& name, configuration::FileError error);
  void refuse(configuration::LocatedText const& name, SentenceRef text);
  /// A machine file that another one names.
  [[nodiscard]] bool is_machine_file(std::string const& path);

  // start_up_loading.cpp
  void load_start_up_list(SourceId source);
  void note_unnamed_lists(StartUp& start_up);
  void load_default_axis_list(StartUp& start_up);
  void load_channels(StartUp& start_up);
  void add_channel(StartUp& start_up, configuration::ListEntry const& entry);
  void add_channel(StartUp& start_up, std::uint32_t number, SourceId source);
  void load_program(StartUp& start_up, StartUpChannel const& channel,
                    configuration::ChannelProgram const& program);
  void load_compensations(StartUp& start_up);
  void name_axes(StartUp const& start_up);
  /// Index of the axis list; none where it is missing, cannot be read, or is of another kind.
  std::optional<std::size_t> axis_list_found(StartUp& start_up, configuration::LocatedText const& named);
  /// The source of a list of the kind `wanted`; none where it is missing, cannot be read, or is of another
  /// kind.
  std::optional<SourceId> source_found(StartUp& start_up, configuration::LocatedText const& named,
                                       std::optional<configuration::ListKind> wanted);
  std::optional<SourceId> source_of(StartUp& start_up, configuration::LocatedText const& named,
                                    std::optional<configuration::ListKind> wanted);
  /// Searches for a list; recorded, so that missing lists can be reported.
  ListSearch& search(StartUp& start_up, configuration::LocatedText const& named,
                     std::optional<configuration::ListKind> wanted);
  /// The path as seen from the folder of the start-up list.
  [[nodiscard]] std::string shown(std::string const& path) const;

  // project_loading.cpp
  void load_project(SourceId source);
  /// Index of the list; none where it is of another kind.
  std::optional<std::size_t> project_axis_list(StartUp& start_up, configuration::ProjectList const& named,
                                               SourceId source);
  void group_by_defaults(StartUp const& start_up, std::vector<configuration::ProjectList const*> const& axes);

  LoadedAxis& add_axis(std::size_t list, std::optional<machine::AxisType> type);
  /// Index of the list; a file is read once.
  std::variant<std::size_t, configuration::FileError> add_list(std::string const& path, std::string shown);
  std::size_t add_source(SourceId source, std::string shown);
  std::variant<std::size_t, configuration::FileError> add_program(std::string name, std::string const& path);
  std::variant<std::string, configuration::FileError> read_text(std::string const& path);
  /// The source of a file's text; for a list in XML, its values as lines. A mistake of the XML is noted, and
  /// then the list has no lines.
  SourceId add_text(std::string const& path, std::string bytes);

  configuration::Files& files_;
  CheckOptions const& options_;
  SourceSet& sources_;
  LoadedMachine& machine_;
  std::map<std::string, std::size_t> by_path_;
  std::map<std::string, std::size_t> programs_by_path_;
  std::map<std::string, SourceId> others_by_path_;  ///< lists of the other kinds
  std::vector<std::size_t> common_programs_;        ///< those that every group runs
  configuration::ChannelList default_channel_;      ///< what channels leave open
};

/// True where the channel runs the program.
[[nodiscard]] bool runs_in(LoadedGroup const& group, std::size_t program);

}  // namespace axisc::validator
