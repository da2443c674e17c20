// From the numbers of a recording to positions.
#pragma once

#include "analysis/recordings/scaling.hpp"
#include "axisc/answers/execution/recorded_units.hpp"
#include "axisc/files/recorded_choice.hpp"
#include "diagnostics/wording.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace axisc {

/// `--raw`, `--scaled`: of columns that a scope scales.
enum class ScaledNumbers : std::uint8_t { recognised, raw, shown };

struct PositionUnits {
  RecordedUnit unit = RecordedUnit::recognised;       ///< of all columns
  ScaledNumbers numbers = ScaledNumbers::recognised;  ///< of columns with a scale
};

/// A position is factor (number) + offset, in `thousandths`.
struct ColumnScale {
  double factor = 1, offset = 0;
  bool is_whole = false;    ///< then rounded: it is a whole number that the scale made another one
  double thousandths = 1;   ///< µm or 0.001°
  bool is_guessed = false;  ///< `thousandths`, from whether all numbers are whole
  recordings::Scaling scaling = recordings::Scaling::none;  ///< of the numbers in the file

  [[nodiscard]] bool changes() const { return factor != 1 || offset != 0; }
};

/// In this order: `units.unit`; the unit of the object, for raw numbers; the unit that the header names, for
/// shown ones. For other columns what the header names, or whole numbers in 0.1 µm and others in mm. Failure
/// (AX9005) where the numbers may be raw or shown, or their unit is not known. `signal` are the numbers.
[[nodiscard]] ColumnScale column_scale(RecordingFile const& file, ChosenColumn const& column,
                                       PositionUnits const& units, image::ImageAxis const& axis,
                                       recordings::Signal const& signal,
                                       std::vector<std::size_t> const& gaps);

/// To the numbers as the scope shows them, in the unit that the header names: of a column that is not a
/// position. Failure (AX9005) where they may be raw or shown.
[[nodiscard]] ColumnScale shown_scale(RecordingFile const& file, ChosenColumn const& column,
                                      ScaledNumbers numbers);

/// In units of `thousandths`.
[[nodiscard]] recordings::Signal positions(recordings::Signal signal, ColumnScale const& scale,
                                           double thousandths);

/// What an answer says of a column.
struct MappedColumn {
  std::string name;
  std::size_t number = 0;  ///< of the column in the file, from 1
  FoundBy by = FoundBy::order;
  double sample_time_ms = 0;  ///< 0: not known, a sample a cycle
  Wording unit;               ///< of its numbers; empty where it does not matter
  recordings::Scaling scaling = recordings::Scaling::none;
};
[[nodiscard]] MappedColumn mapped_column(RecordingFile const& file, ChosenColumn const& column,
                                         ColumnScale const& scale, bool is_rotary);
/// Of a signal whose unit does not matter.
[[nodiscard]] MappedColumn mapped_column(RecordingFile const& file, ChosenColumn const& column);

/// The input is a machine, not a list by itself, of which nobody knows where its control has it.
[[nodiscard]] bool names_machine(std::string_view input);

}  // namespace axisc
