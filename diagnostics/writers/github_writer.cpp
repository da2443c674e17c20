#include "diagnostics/location.hpp"
#include "diagnostics/writers/writers.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace axisc {
namespace {

/// A command ends with its line; percent signs introduce what was escaped. Properties are separated by commas and begin
/// after a colon, so both are escaped there too.
std::string escaped(std::string_view text, bool is_property) {
  std::string result;
  for (char const character : text) {
    switch (character) {
      case '%':
        result += "%25";
        break;
      case '\r':
        result += "%0D";
        break;
      case '\n':
        result += "%0A";
        break;
      case ':':
        result += is_property ? "%3A" : ":";
        break;
      case ',':
        result += is_property ? "%2C" : ",";
        break;
      default:
        result += character;
    }
  }
  return result;
}

std::string_view command_of(Severity severity) {
  return severity == Severity::note ? "notice" : severity_name(severity);
}

std::string numbers(Location const& location) {
  std::string text =
      ",line=" + std::to_string(location.begin.line) + ",endLine=" + std::to_string(location.end.line);
  // Columns are allowed only for a place within one line.
  if (location.begin.line != location.end.line) return text;
  return text + ",col=" + std::to_string(location.begin.column) +
         ",endColumn=" + std::to_string(location.end.column);
}

}  // namespace

std::string write_github(Finding const& finding, SourceSet const& sources, ReportContext const& context,
                         WriteOptions const& options) {
  std::string line = "::" + std::string(command_of(finding.severity)) + " ";
  if (std::string_view const file = file_of(finding, sources); !file.empty()) {
    line += "file=" + escaped(shown_path(context.paths, file), true);
    if (finding.place) line += numbers(locate(*finding.place, sources));
    line += ',';
  }
  line += "title=" + escaped(code_text(finding.code) + ' ' + std::string(finding.name), true);
  return line + "::" + escaped(whole_message(finding, options.language), false) + '\n';
}

}  // namespace axisc
