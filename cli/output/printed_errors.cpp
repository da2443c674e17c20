#include "cli/output/printed_errors.hpp"

#include "axisc/checking/report_format.hpp"
#include "axisc/environment/failure.hpp"
#include "cli/terminal/printed_width.hpp"

namespace axisc::cli {

ErrorSink printed_errors(Invocation const& invocation, bool color) {
  return {.language = invocation.language,
          .take = [&err = invocation.streams.err, write = WriteOptions{.language = invocation.language,
                                                                       .color = color,
                                                                       .width = printed_width()}](
                      std::vector<Finding> const& errors, SourceSet const& sources) {
            err.write(texts_of(errors, sources, write));
          }};
}

TakeProblem printed_problems(Invocation const& invocation, bool color) {
  return [errors = printed_errors(invocation, color)](Finding const& problem, SourceSet const& sources) {
    errors.take({problem}, sources);
  };
}

std::function<void(Message const&)> printed_remarks(Invocation const& invocation) {
  return [&invocation](Message const& remark) {
    invocation.streams.err.write(warning_line(remark, invocation.language));
  };
}

std::function<void(Message const&)> printed_notes(Invocation const& invocation) {
  return [&invocation](Message const& note) {
    invocation.streams.err.write("axisc: " + render(note, invocation.language) + "\n");
  };
}

}  // namespace axisc::cli
