// What the filters of a machine do to a corner, a circle, a line and a path there and back.
#pragma once

#include "axisc/answers/contour/contour_groups.hpp"
#include "diagnostics/message.hpp"
#include "presentation/document.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace axisc {

struct ContourQuestion {
  std::string machine;                ///< its path, for messages
  std::optional<std::string> group;   ///< none: all
  std::optional<std::string> filter;  ///< a #FILTER command; none: FIR and HSC filters are on
  ContourRequest wanted;
  Language language = Language::english;  ///< of what a Failure quotes
};

/// `remark`, if any, takes what is noteworthy: a feed that an axis cannot reach. Failure for a group that is
/// not there, for one whose axes cannot follow a path, and for a command that is none.
[[nodiscard]] presentation::Document contour_answer(ContourQuestion const& question,
                                                    machine::Machine const& machine,
                                                    std::function<void(Message const&)> const& remark);

/// Up to which feeds the tolerance is kept.
[[nodiscard]] presentation::Words kept_feeds(ContourLimits const& limits);

/// The figures of one group, without a title.
[[nodiscard]] std::vector<presentation::Block> contour_blocks(GroupContour const& group,
                                                              ContourRequest const& wanted);

}  // namespace axisc
