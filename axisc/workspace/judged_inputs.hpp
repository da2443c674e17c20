// A list is judged in its machine, however it was named.
#pragma once

#include "axisc/workspace/inputs.hpp"
#include "axisc/workspace/machine_search.hpp"

namespace axisc {

/// Puts the machines that read them in the place of lists and programs; of such a machine only what concerns these files is
/// shown (Inputs::shown), unless it is an input itself. Of a list in a folder that is an input, machines in the folders above
/// it count: those within are inputs. Cost: looks into the lists and machine files of the folders once.
void judge_in_machines(Inputs& inputs, configuration::Files& files, OptionsOf const& options);

}  // namespace axisc
