#include "axisc/answers/axis_type.hpp"

namespace axisc::says {

constexpr Sentence translatory{"translatory", "translatorisch"};
constexpr Sentence rotary{"rotary", "rotatorisch"};
constexpr Sentence spindle{"spindle", "Spindel"};
constexpr Sentence unknown{"unknown", "unbekannt"};

}  // namespace axisc::says

namespace axisc {

presentation::Symbol axis_type_symbol(machine::AxisType type) {
  switch (type) {
    case machine::AxisType::translatory: return {.symbol = "T", .words = says::translatory};
    case machine::AxisType::rotary: return {.symbol = "R", .words = says::rotary};
    case machine::AxisType::spindle: return {.symbol = "S", .words = says::spindle};
  }
  return {.symbol = "?", .words = says::unknown};
}

}  // namespace axisc
