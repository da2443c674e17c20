// A configuration of TwinCAT Scope that records objects of a control: .tcscopex.
//
// Its elements are those of the project in a genuine .svdx of Scope 3.4; whether another version takes it
// could not be tried.
#pragma once

#include "analysis/recordings/objects.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace axisc::recordings {

struct TemplateSignal {
  Object object = Object::position_unfiltered;  ///< with an index
  std::uint32_t channel = 1;                    ///< of the control, from 1
  std::uint32_t axis = 1;                       ///< index in the channel, or number of the axis
};

/// A chart.
struct TemplateAxis {
  std::string name;
  std::vector<TemplateSignal> signals;
};

struct TemplateOptions {
  std::string net_id;        ///< "1.2.3.4.1.1"
  double cycle_ms = 1;       ///< of the control
  double seconds = 60;       ///< to record
  std::string comment = {};  ///< what to do with it
};

/// UTF-8 with byte order mark, lines end in CRLF. The same input gives the same bytes: identifiers are
/// hashes.
[[nodiscard]] std::string scope_template(std::vector<TemplateAxis> const& axes,
                                         TemplateOptions const& options);

}  // namespace axisc::recordings
