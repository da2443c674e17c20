// Why a file that a machine names cannot be read.
#pragma once

#include "configuration/files.hpp"
#include "diagnostics/message.hpp"

namespace axisc::validator {

/// A sentence about the file `{file}`.
[[nodiscard]] SentenceRef sentence_of(configuration::FileError error);

}  // namespace axisc::validator
