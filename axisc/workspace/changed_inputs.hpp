// The inputs of `axisc lint --changed-since REF`.
#pragma once

#include "axisc/files/changed_files.hpp"
#include "axisc/settings/settings.hpp"
#include "axisc/workspace/inputs.hpp"

namespace axisc {

/// Leaves the inputs that differ: that are changed themselves, or of which a list, a program or the settings
/// are changed or gone. Rather too many machines than one too few. Failure for an input outside of the
/// repository, whose changes git does not tell. Cost: reads each start-up list and machine file once more.
void keep_changed(Inputs& inputs, ChangedFiles const& changed, SettingsFinder& settings);

}  // namespace axisc
