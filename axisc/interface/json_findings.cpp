#include "axisc/interface/json_findings.hpp"

#include "axisc/checking/report_context.hpp"

#include <string_view>

namespace axisc::interface {

JsonFindings::JsonFindings(Now& now, axisc_workspace& object, std::string const& first)
    : object_(object),
      identity_paths_(now.workspace.settings()),
      stream_({.report_format = {.format = FindingFormat::json,
                                 .write = {.language = object.language},
                                 .context = report_context(first)},
               .baseline = {},
               .identity_paths = &identity_paths_},
              [this](std::string_view piece) { text_ += piece; }) {}

void JsonFindings::fail(Failure const& failure) {
  has_failed_ = true;
  object_.error += failure.line(object_.language);
  stream_.fail(failure);
}

void JsonFindings::add(CheckedInput const& checked) {
  if (checked.failure) fail(*checked.failure);
  stream_.add(checked);
}

std::string const& JsonFindings::text() {
  stream_.finish({}, [](Code) { return true; });
  return text_;
}

}  // namespace axisc::interface
