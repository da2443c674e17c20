#include "axisc/files/recorded_columns.hpp"

#include "axisc/environment/codes.hpp"
#include "axisc/environment/failure.hpp"
#include "axisc/files/recorded_signals.hpp"

#include <utility>

namespace axisc::says {

constexpr Sentence which_columns{
    "{file} has the columns {known}; name the setpoint before the filters with --in and behind them with "
    "--out",
    "{file} hat die Spalten {known}; den Sollwert vor den Filtern mit --in und den dahinter mit --out "
    "nennen"};

}  // namespace axisc::says

namespace axisc {

RecordedColumns read_recorded_columns(std::string const& name, recordings::ByteSource source,
                                      WantedColumns const& wanted, design::CycleTime cycle_time) {
  auto const choose = [&wanted](ColumnNames const& columns) {
    auto const values = columns.values();
    if ((!wanted.input || !wanted.output) && values.size() != 2) {
      throw Failure({says::which_columns, {{"file", columns.file}, {"known", columns.known()}}},
                    csv_malformed);
    }
    return std::vector{wanted.input ? columns.index_of(*wanted.input) : values[0],
                       wanted.output ? columns.index_of(*wanted.output) : values[1]};
  };
  auto recorded = read_recorded_signals(name, std::move(source), choose, cycle_time);
  return {.input_name = recorded.names[0],
          .output_name = recorded.names[1],
          .recording = {.input = std::move(recorded.signals[0]),
                        .output = std::move(recorded.signals[1]),
                        .gaps = std::move(recorded.gaps)},
          .repeated = recorded.repeated};
}

}  // namespace axisc
