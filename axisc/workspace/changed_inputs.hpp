// The inputs of `axisc lint --changed-since REF`.
#pragma once

#include "axisc/files/changed_files.hpp"
#include "axisc/settings/settings.hpp"
#include "axisc/workspace/inputs.hpp"

namespace axisc {

/// Keeps the inputs that differ: those changed themselves, and those with a list, a program or settings that
/// are changed or gone. In doubt, a machine is kept. Failure for an input outside of the repository, whose
/// changes git does not show. Cost: reads each start-up list and machine file once more.
void keep_changed(Inputs& inputs, ChangedFiles const& changed, SettingsFinder& settings);

}  // namespace axisc
