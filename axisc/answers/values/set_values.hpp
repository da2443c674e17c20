// Writes values into the list of an axis.
#pragma once

#include "axisc/answers/suggestion/chain_edits.hpp"
#include "axisc/checking/path_machine.hpp"

#include <string>
#include <vector>

namespace axisc {

struct SetQuestion {
  MachineRequest machine;
  std::vector<std::string> words;  ///< an axis, then `parameter=value`: see chosen_values.hpp
};

struct NewValues {
  ListEdits edits;
  std::vector<Message> notes;  ///< other axes that read the list
};

/// A value is written as the list has it, `48000`, or with a unit that is converted, `48Hz`, `10ms`, `1.5mm`.
/// A line that sets the parameter gets the new value; otherwise a line follows the last one of its family.
/// Every other byte stays. None if the list would then have errors that it has not now: `errors` takes them.
/// Failure for words that name nothing, for a value that cannot be converted, and for a list that cannot be
/// edited or that the input does not name.
[[nodiscard]] std::optional<NewValues> set_values(Workspace& workspace, SetQuestion const& question,
                                                  ErrorSink const& errors);

}  // namespace axisc
