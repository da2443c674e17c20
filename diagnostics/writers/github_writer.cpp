#include "diagnostics/location.hpp"
#include "diagnostics/terminal.hpp"
#include "diagnostics/utf8.hpp"
#include "diagnostics/writers/report_writer.hpp"

#include <string>
#include <string_view>
#include <utility>

namespace axisc {
namespace {

/// A command ends with its line; percent signs introduce what was escaped. Properties are separated by commas
/// and begin after a colon, so both are escaped there too. Other characters are printable.
std::string command_text(std::string_view text, bool is_property) {
  std::string result;
  while (!text.empty()) {
    DecodedCharacter const character = decode_utf8(text);
    text.remove_prefix(character.size);
    switch (character.value) {
      case U'%': result += "%25"; break;
      case U'\r': result += "%0D"; break;
      case U'\n': result += "%0A"; break;
      case U':': result += is_property ? "%3A" : ":"; break;
      case U',': result += is_property ? "%2C" : ","; break;
      default: append_printable(result, character.value);
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

class GithubReport final : public ReportWriter {
 public:
  GithubReport(Language language, ReportContext context)
      : language_(language), context_(std::move(context)) {}

  void add(std::string& out, Finding const& finding, SourceSet const& sources,
           std::string_view /*fingerprint*/) override {
    ((out += "::") += command_of(finding.severity)) += ' ';
    if (std::string_view const file = file_of(finding, sources); !file.empty()) {
      out += "file=" + command_text(shown_path(context_.paths, file), true);
      if (finding.place) out += numbers(locate(*finding.place, sources));
      out += ',';
    }
    out += "title=" + command_text(code_text(finding.code) + ' ' + std::string(finding.name), true);
    out += "::" + command_text(whole_message(finding, language_, Values::printable), false) + '\n';
  }

 private:
  Language language_;
  ReportContext context_;
};

}  // namespace

std::unique_ptr<ReportWriter> github_report(WriteOptions const& options, ReportContext context) {
  return std::make_unique<GithubReport>(options.language, std::move(context));
}

}  // namespace axisc
