// Applies the fixes of findings, in memory, until none is left.
#pragma once

#include "axisc/checking/baseline.hpp"
#include "axisc/checking/identity_paths.hpp"
#include "axisc/workspace/changeable_files.hpp"
#include "axisc/workspace/workspace.hpp"
#include "diagnostics/writers/writers.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace axisc {

enum class FixChoice : std::uint8_t { none, safe, all };

struct FixedInputs {
  EditedBytes edited;    ///< to be read instead of the files; standard input is here in any case
  EditedBytes original;  ///< the bytes before, of the same paths
  FixFacts facts;
  std::vector<Failure> failures = {};  ///< inputs that cannot be read
};

/// A fix that leads to another finding, or does not end its own, is taken back. Findings in the baseline, and
/// files that are not in `changeable`, are not fixed.
/// Applying fixes to the result changes nothing. One input after another, because they may share files. Cost:
/// a check per round, and some more for each fix that is taken back, at most two hundred.
[[nodiscard]] FixedInputs fix_inputs(Workspace& workspace, std::vector<std::string> const& paths,
                                     FixChoice choice, Baseline const& baseline,
                                     IdentityPaths& identity_paths, ChangeableFiles const& changeable);

}  // namespace axisc
