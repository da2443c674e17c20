#include "diagnostics/location.hpp"

#include <string_view>

namespace axisc {

Location locate(Place const& place, SourceSet const& sources) {
  SourceText const& source = sources[place.source];
  return {.file = source.name(),
          .begin = source.position(place.span.begin),
          .end = source.position(place.span.end)};
}

std::string_view file_of(Finding const& finding, SourceSet const& sources) {
  return finding.place ? std::string_view(sources[finding.place->source].name())
                       : std::string_view(finding.file);
}

std::string_view severity_name(Severity severity) {
  switch (severity) {
    case Severity::error: return "error";
    case Severity::warning: return "warning";
    case Severity::note: break;
  }
  return "note";
}

}  // namespace axisc
