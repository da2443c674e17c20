// Reads and merges the lists of an input: the data that the rules check.
#pragma once

#include "configuration/channel_dynamics.hpp"
#include "configuration/machine_file.hpp"
#include "grammar/nc_program.hpp"
#include "validator/loading/program_reading.hpp"
#include "validator/loading/start_up.hpp"
#include "validator/options.hpp"
#include "validator/values/effective_values.hpp"
#include "validator/values/merge_lists.hpp"

#include <deque>
#include <optional>
#include <string>
#include <vector>

namespace axisc::validator {

struct NamedList {
  std::string name;  ///< as the machine file names it; the file's own name for a single list
  LoadedList list;
};

struct LoadedAxis {
  std::string name;
  machine::AxisType type = machine::AxisType::translatory;
  std::size_t list = 0;                             ///< index into LoadedMachine::lists
  std::optional<configuration::LocatedText> drive;  ///< from the machine file; overrides kenngr.antr_typ
  machine::PositionController position_control =
      machine::PositionController::unknown;  ///< from the machine file; overrides antr.operation_mode
  double drive_delay_us = 0;                 ///< from the machine file; 0: not stated
  MergedValues merged;
};

/// An NC program, alone or named by a machine file.
struct LoadedProgram {
  std::string name;  ///< as the machine file names it; the file's own name for a single program
  std::string path;
  ContentMark mark;   ///< of the bytes that were checked
  SourceId source{};  ///< an excerpt, unless the options ask for all of it: the lines that `tree` points into
  grammar::NcProgram tree;
  bool gives_order = false;  ///< one of its #FILTER commands gives an order
};

/// A channel: its axes and the NC programs that run in it.
struct LoadedGroup {
  std::string name;
  std::vector<std::size_t> axes;  ///< indices into LoadedMachine::axes
  std::vector<std::size_t>
      programs;  ///< indices into LoadedMachine::programs: its own and those of every group
  machine::ChannelDynamics dynamics = {};
  std::vector<configuration::UncomputedValue> uncomputed = {};
  std::optional<SourceId> channel_list = {};           ///< none: the control's defaults count
  std::vector<configuration::CoupledPair> pairs = {};  ///< of the channel list
  std::optional<Place> slope_place = {};               ///< of the value of P-CHAN-00071
  bool look_ahead_said = false;  ///< by the start-up list or the machine file, outside of channel lists
};

/// A gantry, from the lists and the machine file together.
struct LoadedGantry {
  std::size_t master = 0;
  std::vector<std::size_t> slaves;
};

/// The role that the machine file gives an axis in a gantry.
struct GantryClaim {
  std::size_t axis = 0;
  std::optional<std::size_t> master;  ///< none: the axis is a master itself
  Place place;                        ///< position of the axis name in the machine file
};

struct LoadedMachine {
  std::string name;
  std::string path;  ///< the input
  std::optional<design::CycleTime> cycle_time;
  std::deque<NamedList> lists;  ///< of axes, each file once, in the order of reading; addresses stay valid
  /// Lists of the other kinds, checked line by line: the input itself, or what a start-up list names.
  std::deque<NamedList> other_lists;
  bool is_beside_start_up_list =
      false;  ///< the input is a list that a start-up list in its folder does not name
  std::optional<SourceId> list_of_unknown_kind;  ///< the input, if its kind is unknown
  std::optional<std::size_t> default_list;
  std::optional<SourceId> default_channel_list;  ///< of all channels
  bool knows_all_axes = true;                    ///< no list of an axis is missing
  bool complete = true;  ///< every file that the input names was read and is of its kind
  std::vector<LoadedAxis> axes;
  std::vector<LoadedProgram> programs;  ///< each file once
  std::vector<configuration::LocatedText>
      filter_sets;                  ///< from the machine file: commands in addition to those of the programs
  std::vector<LoadedGroup> groups;  ///< if the machine file has none: one of all axes except spindles
  std::vector<LoadedGantry> gantries;      ///< of gantries_of(), once everything is loaded
  std::vector<GantryClaim> gantry_claims;  ///< in the order of the machine file
  std::optional<SourceId> machine_file;    ///< none for a single list
  std::optional<StartUp> start_up;         ///< the machine is that of a start-up list or of a project
  bool inch = false;                       ///< lengths in programs are inches
  configuration::MachineFileReport report;
  design::Readings readings;          ///< how the control computes its filters
  machine::MotionReadings motion;     ///< how it plans a path
  std::optional<BuildVersion> build;  ///< of the control, where the options name it
  std::deque<Finding> findings;       ///< AX4020: code, place and sentences; the engine adds the rest
  std::vector<std::string> files;

  [[nodiscard]] LoadedList const* list_of_defaults() const {
    return default_list ? &lists[*default_list].list : nullptr;
  }
};

/// The axis' own list gives it a logical number, kopf.achs_nr, perhaps in a line that cannot be used.
[[nodiscard]] bool has_own_number(LoadedAxis const& axis);

/// The axis with this logical number.
[[nodiscard]] std::optional<std::size_t> axis_numbered(LoadedMachine const& machine, std::uint32_t number);

/// Merges the lists of a machine again if a line without effect was taken for a parameter that it may have
/// meant: rules are silent about that parameter, but the control uses it. True if there was such a line.
bool forget_guesses(LoadedMachine& machine);

/// True if a #FILTER command of an NC program or of `filter_sets` gives the FIR filter of the axis an order.
[[nodiscard]] bool program_gives_order(LoadedMachine const& machine, std::size_t axis);

/// Reads the input and every file that it names. An error only if the input itself cannot be read. The
/// machine refers to `sources`, which must outlive it.
[[nodiscard]] std::variant<LoadedMachine, configuration::FileError> load(configuration::Files& files,
                                                                         std::string const& path,
                                                                         CheckOptions const& options,
                                                                         SourceSet& sources);

}  // namespace axisc::validator
