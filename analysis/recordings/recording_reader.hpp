// A recording, whichever form its file has.
#pragma once

#include "analysis/recordings/bad_recording.hpp"
#include "analysis/recordings/recording.hpp"
#include "analysis/recordings/text_lines.hpp"

#include <variant>

namespace axisc::recordings {

/// The bytes decide. A text is read piece by piece; of a binary file all bytes are held while it is read.
[[nodiscard]] std::variant<Recording, BadRecording> read_recording(ByteSource source);

}  // namespace axisc::recordings
