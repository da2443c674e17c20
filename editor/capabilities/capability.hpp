// A capability of the server: a function of the open machines that answers one request of the protocol.
#pragma once

#include "editor/reading/requests.hpp"

namespace axisc::editor {

class OpenMachines;

/// From the parameters of a request to its result. Throws an exception of Json or std::out_of_range for
/// invalid parameters, RequestRefused if the request cannot be met.
using Capability = Json (*)(OpenMachines& machines, Json const& params);

}  // namespace axisc::editor
