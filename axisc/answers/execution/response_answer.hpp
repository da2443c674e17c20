// The frequency response of an image's chains as an answer.
#pragma once

#include "axisc/answers/execution/port_response.hpp"
#include "axisc/answers/execution/timed_commands.hpp"
#include "axisc/files/image_file.hpp"
#include "presentation/document.hpp"

#include <optional>
#include <string>
#include <vector>

namespace axisc {

struct ResponseQuestion {
  std::string image;                ///< its path, for messages
  std::optional<std::string> axis;  ///< none: all
  Port port = Port::setpoint;
  std::optional<std::vector<double>>
      frequencies;  ///< Hz; none: 200 logarithmic points and those of the filters
  std::uint32_t level = AXISRT_LEVEL_PORTABLE;
  std::vector<TimedCommand> commands;  ///< executed before the analysis
};

/// Failure where no axis has a filter at that port, and for what the runtime refuses.
[[nodiscard]] presentation::Document response_answer(ResponseQuestion const& question, ImageFile const& file);

}  // namespace axisc
