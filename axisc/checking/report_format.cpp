#include "axisc/checking/report_format.hpp"

namespace axisc {

std::string texts_of(std::vector<Finding> const& findings, SourceSet const& sources,
                     WriteOptions const& options) {
  std::string text;
  for (auto const& finding : findings) text += write_text(finding, sources, options) + "\n";
  return text;
}

}  // namespace axisc
