// Recordings as TwinCAT Scope keeps them: .svdx, with its samples uncompressed in blocks of version
// 01.00.00.40.
//
// The layout is not documented by the vendor. What is checked here was found on files: blocks without gaps,
// every byte of a block accounted for, and at each level the extremes of the samples below. A file that
// breaks one of these rules is refused, because then something else in it may mean something else, too.
#pragma once

#include "analysis/recordings/bad_recording.hpp"
#include "analysis/recordings/recording.hpp"

#include <string_view>
#include <variant>

namespace axisc::recordings {

/// Channels with the samples that the scope shows: from the last one at or before the earliest begin of a
/// block to its end. Times are ms since that begin, values are raw. Whole numbers beyond 2^53 lose their last
/// digits.
[[nodiscard]] std::variant<Recording, BadRecording> read_svdx_recording(std::string_view file);

}  // namespace axisc::recordings
