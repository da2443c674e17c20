// What the server can do for open documents: one function for each request of the protocol.
#pragma once

#include "editor/reading/requests.hpp"

namespace axisc::editor {

class OpenMachines;

/// From the parameters of a request to its result. An exception of Json or std::out_of_range for parameters that mean
/// nothing, RequestRefused for what cannot be done.
using Capability = Json (*)(OpenMachines& machines, Json const& params);

}  // namespace axisc::editor
