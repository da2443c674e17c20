// One assignment on its way to a reading, for who reads a list.
#pragma once

#include "validator/values/reading.hpp"

#include <forward_list>
#include <string>

namespace axisc::validator {

/// Fills what `reading` says of the value; its name is looked up already, `text` is the value as it stands. Texts that are not
/// UTF-8 as they stand are kept in `transcoded`.
void judge(SourceText const& source, grammar::Assignment const& assignment, Reading& reading,
           std::forward_list<std::string>& transcoded);

}  // namespace axisc::validator
