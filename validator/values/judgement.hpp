// Judges one assignment while a list is read.
#pragma once

#include "validator/values/reading.hpp"

#include <forward_list>
#include <string>

namespace axisc::validator {

/// Fills the value part of `reading`, whose name is already looked up; `text` is the value as written. Texts that are
/// not UTF-8 are stored in `transcoded`.
void judge(SourceText const& source, grammar::Assignment const& assignment, Reading& reading,
           std::forward_list<std::string>& transcoded);

}  // namespace axisc::validator
