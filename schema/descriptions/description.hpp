// Descriptions of parameters in words. The texts are in axis-descriptions.json; the generator turns them into
// constant tables at build time.
#pragma once

#include "diagnostics/page.hpp"
#include "schema/catalogue.hpp"

#include <string_view>
#include <vector>

namespace axisc::schema {

struct ValueMeaning {
  std::string_view value;  ///< a number, a bit ("0x10000") or a word, as lists write it
  Page meaning;
};

struct Description {
  Page what;    ///< a phrase
  Page detail;  ///< sentences; may be empty
  std::vector<ValueMeaning> values;
  bool inferred = false;  ///< `what` is only inferred from the family of its name
  /// The control reads the parameter at start-up only: it keeps the old value when lists are loaded again.
  /// Documented for some parameters; false does not promise that a change takes effect at once.
  bool restart = false;
};

/// For a parameter of a schema file that of the built-in one of its name; otherwise empty, as for parameters
/// of other kinds of lists.
[[nodiscard]] Description description_of(Parameter const& parameter);

}  // namespace axisc::schema
