// What the check would say to edited lists that it does not say to the present ones.
#pragma once

#include "axisc/workspace/workspace.hpp"
#include "diagnostics/fingerprint.hpp"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace axisc {

class NewFindings {
 public:
  /// Checks the machine as it is. Both outlive this.
  NewFindings(std::string const& path, Workspace& workspace);

  /// Codes, each once.
  [[nodiscard]] std::vector<std::string> of(EditedBytes const& edited) const;

 private:
  using Counts = std::map<Identity, std::size_t>;
  [[nodiscard]] Counts count(EditedBytes const& edited) const;

  std::string const& path_;
  Workspace& workspace_;
  Counts before_;
};

}  // namespace axisc
