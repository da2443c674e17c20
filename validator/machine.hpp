// The checked machine: what the image is made from. No strings to interpret, no number without unit, optional
// where a feature is off. A Machine exists only when no error was found.
#pragma once

#include "design/filter_specification.hpp"
#include "design/units.hpp"
#include "validator/effective_values.hpp"
#include "validator/filter_view.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace axisc::validator {

/// Values are the numbers of P-AXIS-00018.
enum class AxisType : std::uint8_t { translatory = 1, rotary = 2, spindle = 4 };

/// What the lists say: P-AXIS-00018.
[[nodiscard]] AxisType axis_type_of(EffectiveValues const& values);

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

struct AxisConfiguration {
  std::string name;
  std::uint32_t number = 1;  ///< kopf.achs_nr
  AxisType type = AxisType::translatory;
  std::vector<ConfiguredFilter> filters;  ///< active filter[i], in order of i
  std::vector<ConfiguredFilter>
      interface_filters;         ///< active lr_param.add_interface.filter[i], and only if the interface is on
  double position_window = 0.4;  ///< P-AXIS-00351, in position units (0.1 µm or 1e-4°)
  double velocity_limit = 0;     ///< P-AXIS-00212, µm/s or 1e-3 °/s
  double acceleration_limit = 0;     ///< P-AXIS-00008, mm/s² or °/s²
  std::vector<SourcedValue> values;  ///< everything its lists set, in the order of the lines
};

/// A list as the image remembers it.
struct MachineList {
  std::string name;  ///< as the machine file names it; never an absolute path
  std::string content;
  bool is_default_list = false;
};

struct Machine {
  std::string name;
  design::CycleTime cycle_time;
  std::vector<AxisConfiguration> axes;
  std::vector<MachineList> lists;
};

}  // namespace axisc::validator
