// Findings as JSON, and the lines about what cannot be read.
#pragma once

#include "axisc/checking/identity_paths.hpp"
#include "axisc/checking/report_stream.hpp"
#include "axisc/interface/workspace_object.hpp"

#include <string>

namespace axisc::interface {

/// What cannot be read goes to the error of the workspace as well.
class JsonFindings {
 public:
  /// `first`: the input whose repository the paths count from.
  JsonFindings(Now& now, axisc_workspace& object, std::string const& first);

  void fail(Failure const& failure);
  void add(CheckedInput const& checked);
  [[nodiscard]] std::string const& text();
  [[nodiscard]] bool has_failed() const { return has_failed_; }
  [[nodiscard]] bool has_errors() const { return stream_.counts().errors > 0; }

 private:
  axisc_workspace& object_;
  IdentityPaths identity_paths_;
  std::string text_;
  bool has_failed_ = false;
  ReportStream stream_;
};

}  // namespace axisc::interface
