// The role of an axis in a gantry. Its lists set it in kenngr.achs_mode and kenngr.gantry_ax_nr; the machine
// file adds what they leave open. A mode that is the documented default leaves it open.
#pragma once

#include "validator/loading/loading.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace axisc::validator {

/// The gantry settings in the lists of an axis. References stay valid while the EffectiveValues live.
struct GantryView {
  EffectiveValue const& mode;           ///< P-AXIS-00015
  EffectiveValue const& master_number;  ///< P-AXIS-00070

  explicit GantryView(EffectiveValues const& values);

  [[nodiscard]] bool open() const;  ///< neither master nor slave nor something else
  [[nodiscard]] bool is_master() const;
  [[nodiscard]] bool is_slave() const;
  /// Logical number of the named master; none for 0 and if it cannot be used.
  [[nodiscard]] std::optional<std::uint32_t> named_master() const;
};

/// The entry of the machine file about the axis as a slave, or as a master; null if there is none.
[[nodiscard]] GantryClaim const* slave_claim(LoadedMachine const& machine, std::size_t axis);
[[nodiscard]] GantryClaim const* master_claim(LoadedMachine const& machine, std::size_t axis);

/// The master of an axis that lists and machine file together make a slave; none for every other axis.
[[nodiscard]] std::optional<std::size_t> master_of(LoadedMachine const& machine, std::size_t axis);

/// Every gantry, in ascending order of masters.
[[nodiscard]] std::vector<LoadedGantry> gantries_of(LoadedMachine const& machine);

}  // namespace axisc::validator
