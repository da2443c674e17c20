// The checked machine, from which the image is made. No strings to interpret, no number without unit,
// optional where a feature is off. A Machine exists only when no error was found.
#pragma once

#include "configuration/machine/drive_path.hpp"
#include "configuration/machine/filter_command.hpp"
#include "configuration/machine/path_dynamics.hpp"
#include "design/filter_specification.hpp"
#include "design/kernels/kernel_design.hpp"
#include "design/oscillator.hpp"
#include "design/units.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace axisc::machine {

/// Values are the numbers of P-AXIS-00018.
enum class AxisType : std::uint8_t { translatory = 1, rotary = 2, spindle = 4 };

/// Where one value of a list came from; the image's source map.
struct SourcedValue {
  std::string name;        ///< `filter[0].order`
  std::string text;        ///< the value as written
  std::uint32_t list = 0;  ///< index into Machine::lists
  std::uint32_t line = 0;
};

struct ConfiguredFilter {
  std::uint32_t index = 0;  ///< i of filter[i]
  design::FilterSpecification specification;
};

/// The kernel of an axis with the lists' values: filter_fir of type 1 to 4, the HSC filter in filter[0], or
/// Vibration Guard. Present also where it is switched off: a command may switch it on and change it.
struct ConfiguredKernel {
  KernelFamily family = KernelFamily::fir;
  std::uint32_t index = 0;  ///< i of filter[i] for HSC
  /// With the order that order_time or time_constant gives, where order does not; 0: no order results.
  design::KernelSpecification specification;
  bool on_at_start = false;  ///< filter_fir.enable, vib_guard.active; never for HSC
};

/// Values are the numbers of P-AXIS-00753.
enum class StageMode : std::uint8_t { direct = 1, indirect = 2, set_point = 3 };

/// An active stage of Improved Position Control.
struct PositionControlStage {
  std::uint32_t index = 0;  ///< i of stage[i]
  StageMode mode = StageMode::direct;
  std::optional<design::OscillatorSpecification> oscillator;  ///< INDIRECT and SET_POINT
  std::vector<design::FilterSpecification> filters;           ///< in series; NO_FILTER is left out
  double weight_numerator = 1;
  double weight_denominator = 1;  ///< the weight is min(numerator / denominator, 7.0)
};

/// lr_param.improved_position_control of an axis where it is enabled and a stage is active.
struct PositionControl {
  std::vector<PositionControlStage> stages;
  double limit_factor = 0;  ///< P-AXIS-00757 in 0.1 % of P-AXIS-00212
};

/// Where the axis' position is controlled.
enum class PositionController : std::uint8_t { unknown = 0, drive = 1, cnc = 2 };

/// From velocities to drive increments.
struct DriveScaling {
  PositionController controller = PositionController::unknown;
  double v_reso_num = 1;        ///< P-AXIS-00206
  double v_reso_denom = 1;      ///< P-AXIS-00205
  std::uint32_t time_base = 0;  ///< P-AXIS-00207: 0 per minute, 1 per second, 2 per sampling interval
  double multi_gain_z = 1;      ///< P-AXIS-00129
  double multi_gain_n = 1;      ///< P-AXIS-00128
};

/// A parameter that a list sets to something that no plan of a path takes into account.
struct UncomputedParameter {
  std::string number;  ///< "P-AXIS-00561"
  std::string name;    ///< as the list writes it
  std::string file;    ///< the list, as findings name it
  std::uint32_t line = 0;
  std::string line_text;
};

struct AxisConfiguration {
  std::string name;
  std::uint32_t number = 1;  ///< kopf.achs_nr
  AxisType type = AxisType::translatory;
  std::vector<ConfiguredFilter> filters;  ///< active filter[i], in order of i
  std::vector<ConfiguredFilter>
      interface_filters;  ///< active lr_param.add_interface.filter[i], and only if the interface is on
  std::optional<ConfiguredKernel> kernel;
  /// What #VIB GUARD starts from, its values as the lists have them, or by default; none if they are out of
  /// range.
  std::optional<design::KernelSpecification> listed_guard = {};
  std::optional<PositionControl> position_control;
  DriveScaling drive_scaling;
  /// Index into Machine::axes of the gantry's master, for a slave: its additive velocity is the master's.
  std::optional<std::size_t> gantry_master;
  DrivePath drive_path = {};        ///< at the start of programs
  DrivePath fed_forward_path = {};  ///< after G135
  double position_window = 0.4;     ///< P-AXIS-00351, in position units (0.1 µm or 1e-4°)
  double velocity_limit = 0;        ///< P-AXIS-00212, µm/s or 1e-3 °/s
  double acceleration_limit = 0;    ///< P-AXIS-00008, mm/s² or °/s²
  double transition_weight = 0;     ///< P-AXIS-00013, in 0.1 %
  AxisDynamics dynamics = {};       ///< gear 0
  std::vector<UncomputedParameter> uncomputed = {};
  std::vector<SourcedValue> values;  ///< everything its lists set, in the order of the lines
};

/// Takes the next bytes of a source.
using ContentReceiver = std::function<void(std::string_view)>;

/// The bytes of an NC program, which are not kept in memory.
struct StoredContent {
  std::uint64_t size = 0;
  /// Reads them again, from the Files that the check had; throws SourceChanged if they have changed since the
  /// check.
  std::function<void(ContentReceiver const&)> read;
};

/// A list, or an NC program, as it is recorded in the image.
struct MachineList {
  std::string name;     ///< as the machine file names it; never an absolute path
  std::string content;  ///< of a list
  bool is_default_list = false;
  bool is_program = false;  ///< an NC program: its commands decide which kernels there are
  std::optional<StoredContent> stored = std::nullopt;  ///< of a program, instead of `content`
};

/// An NC channel: the axes that #FILTER and #VIB GUARD act on.
struct MachineGroup {
  std::string name;
  std::vector<std::size_t> axes;  ///< indices into Machine::axes, in the order of the machine file
  /// The distinct parameter sets that are in force after the commands of the group's programs and of
  /// filter_sets, in the order of their first use, in canonical form; without `#FILTER ON` alone, OFF and
  /// [HSC], which need none. `#VIB GUARD` has one even without parameters: it gives every axis a guard.
  std::vector<FilterParameters> filter_sets;
  std::vector<std::string> programs = {};  ///< paths of the NC programs that it runs
  ChannelDynamics dynamics = {};
  std::vector<UncomputedParameter> uncomputed = {};  ///< of the channel list
};

struct Machine {
  std::string name;
  design::CycleTime cycle_time;
  std::vector<AxisConfiguration> axes;
  std::vector<MachineGroup> groups;
  std::vector<MachineList> lists;
  bool inch = false;           ///< lengths in NC programs are inches
  MotionReadings motion = {};  ///< how the control plans a path where its manuals leave it open
};

}  // namespace axisc::machine
