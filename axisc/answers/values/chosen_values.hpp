// The axis and the parameters that the user of `get` and `set` names.
#pragma once

#include "axisc/checking/path_machine.hpp"
#include "schema/catalogue.hpp"
#include "validator/loading/loading.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace axisc {

struct ChosenAxis {
  std::size_t axis = 0;            ///< into LoadedMachine::axes
  std::vector<std::string> words;  ///< that follow its name
};

/// The first word is the name of an axis; it may be missing where the input is the list of one axis, or a
/// machine of one axis. Failure for another name, with those that there are.
[[nodiscard]] ChosenAxis chosen_axis(validator::LoadedMachine const& machine, SourceSet const& sources,
                                     Belonging const& input, std::vector<std::string> words);

/// `filter[0].order`; of `filter[].order`, P-AXIS-00140 and what `axisc explain` finds ("Kv") those that a
/// list sets, else the first; of the beginning of names (`filter[0]`) those that a list sets. Failure where
/// nothing fits.
[[nodiscard]] std::vector<schema::Slot> chosen_slots(validator::EffectiveValues const& values,
                                                     std::string const& word);

/// One parameter by its whole name. Failure for anything else, with what may have been meant.
[[nodiscard]] schema::Slot chosen_slot(schema::Catalogue const& catalogue, std::string const& name);

}  // namespace axisc
