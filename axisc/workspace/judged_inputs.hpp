// A list is judged in its machine, however it was named.
#pragma once

#include "axisc/workspace/inputs.hpp"
#include "axisc/workspace/machine_search.hpp"

#include <vector>

namespace axisc {

/// The machine of each input, in their order. For a list in a folder that is an input, only machines in the
/// folders above it count: those within are inputs. Cost: looks into the lists and machine files of the
/// folders once.
[[nodiscard]] std::vector<Belonging> belonging_of(Inputs const& inputs, configuration::Files& files);

/// Replaces lists and programs by the machines that read them; of such a machine only findings about these
/// files are shown (Inputs::shown), unless it is an input itself.
void judge_in_machines(Inputs& inputs, configuration::Files& files);

}  // namespace axisc
