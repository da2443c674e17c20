#include "cli/options/recorded_numbers.hpp"

#include "axisc/environment/failure.hpp"

namespace axisc::cli::says {

constexpr Sentence option_recorded_unit{
    "unit of the columns' numbers; mm for rotary axes means degrees, incr increments of the measuring system "
    "(default: that of the recorded object or of the header; else whole numbers 0.1um, others mm)",
    "Einheit der Zahlen in den Spalten; mm bei rotatorischen Achsen heißt Grad, incr Inkremente des "
    "Messsystems (Standardwert: die des aufgezeichneten Objekts oder des Kopfs; sonst ganze Zahlen 0.1um, "
    "andere mm)"};
constexpr Sentence option_scaled{
    "the numbers of columns with a scale are scaled, as the scope shows them",
    "die Zahlen von Spalten mit einer Skalierung sind skaliert, wie das Scope sie zeigt"};
constexpr Sentence option_raw{"they are raw, as the control has them",
                              "sie sind roh, wie die Steuerung sie hat"};
constexpr Sentence scaled_and_raw{"name either --scaled or --raw", "entweder --scaled oder --raw angeben"};

}  // namespace axisc::cli::says

namespace axisc::cli {

void declare_recorded_numbers(CommandLine& command_line, RecordedNumbers& numbers) {
  command_line.choice("--unit", recorded_units, numbers.unit, says::option_recorded_unit);
  command_line.flag("--scaled", numbers.scaled, says::option_scaled);
  command_line.flag("--raw", numbers.raw, says::option_raw);
}

PositionUnits RecordedNumbers::units() const {
  if (scaled && raw) throw Failure({says::scaled_and_raw});
  auto const numbers = scaled ? ScaledNumbers::shown : raw ? ScaledNumbers::raw : ScaledNumbers::recognised;
  return {.unit = unit, .numbers = numbers};
}

}  // namespace axisc::cli
