// `compare --emit template`: a scope's configuration for the signals that a comparison needs.
#pragma once

#include "configuration/machine/machine.hpp"
#include "diagnostics/message.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace axisc {

/// What the recording is for.
enum class RecordingPurpose : std::uint8_t {
  compare,   ///< the command position before and after the filters
  circle,    ///< the command position before the filters and of the position controller, the actual position
  identify,  ///< command and actual position, and the velocity for the drive
};

struct TemplateQuestion {
  std::string machine;                ///< as the user names it
  std::optional<std::string> net_id;  ///< AMS NetId of the control
  std::optional<std::string> axes;    ///< "X,Y"; none: all of the channels
  RecordingPurpose purpose = RecordingPurpose::compare;
};

struct RecordingTemplate {
  std::string text;
  std::vector<Message> notes;  ///< what to do with it
};

/// Failure without a NetId, or with one that is not six numbers up to 255; for an axis that is in no channel.
[[nodiscard]] RecordingTemplate recording_template(TemplateQuestion const& question,
                                                   machine::Machine const& machine, Language language);

}  // namespace axisc
