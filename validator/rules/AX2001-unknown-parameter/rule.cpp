#include "validator/engine/rule.hpp"

#include "validator/rules/helpers.hpp"
#include "validator/rules/sentences.hpp"
#include "validator/sentences.hpp"
#include "validator/values/lost_assignment.hpp"

namespace axisc::validator::checks::ax2001::says {

constexpr Sentence headline{"unknown parameter `{name}`", "unbekannter Parameter `{name}`"};
constexpr Sentence former_name{"`{name}` is a former name of `{suggestion}`",
                               "`{name}` ist ein früherer Name von `{suggestion}`"};
constexpr Sentence reaction{"it ignores the line", "sie übergeht die Zeile"};
constexpr Sentence help{
    "correct the name; a parameter of a newer build can be described in a schema file (`--schema`)",
    "den Namen berichtigen; einen Parameter eines neueren Stands kann eine Schemadatei beschreiben "
    "(`--schema`)"};

}  // namespace axisc::validator::checks::ax2001::says

namespace axisc::validator::checks::ax2001 {
namespace {

/// A number of another kind of list: then the name is not misspelt, the line is in the wrong list.
bool is_numbered_elsewhere(Line const& line) {
  auto const kind = configuration::kind_numbered_in(line.context.source.slice(line.assignment().trailer));
  return kind && *kind != line.context.list.kind;
}

void describe(Finding& finding, Line const& line) {
  finding.message = message_of(says::headline, Argument{"name", finding.parameter});
  set_reaction(finding, says::reaction);
  auto const& suggestions = line.context.list.line_values.suggestions(line.number);
  if (suggestions.names.empty() || is_numbered_elsewhere(line)) {
    if (line.context.list.kind == configuration::ListKind::axis) {
      finding.help.push_back(message(says::help));
    }
    return;
  }
  std::string const& best = suggestions.names.front();
  if (suggestions.is_former_name) {
    finding.notes.push_back(
        message_of(says::former_name, Argument{"name", finding.parameter}, Argument{"suggestion", best}));
  }
  finding.help.reserve(suggestions.names.size());
  for (std::string const& suggestion : suggestions.names) {
    finding.help.push_back(
        message_of(validator::says::parameter_did_you_mean, Argument{"suggestion", suggestion}));
  }
  if (!suggestions.is_certain) return;
  finding.fix = replace_by(line.place(line.assignment().name), best,
                           message_of(validator::says::parameter_fix, Argument{"replacement", best}));
}

/// An image would lack the setting that the line was meant for.
bool concerns_image(Line const& line) {
  std::string_view const name = line.context.source.slice(line.assignment().name);
  auto const& suggestions = line.context.list.line_values.suggestions(line.number);
  if (is_compiled_family(name)) return true;
  if (is_numbered_elsewhere(line)) return false;
  return is_close_to_compiled_family(name) ||
         (suggestions.is_close && is_compiled_family(suggestions.names.front()));
}

/// By a slip of the pen. Real lists have names that the documents of their kind do not know.
bool is_explained(Line const& line) {
  auto const& suggestions = line.context.list.line_values.suggestions(line.number);
  return !is_numbered_elsewhere(line) && !suggestions.names.empty() &&
         (suggestions.is_close || suggestions.is_certain || suggestions.is_former_name);
}

void unknown_parameter(ListContext const& context, Report& report) {
  for_each_doubtful(context, [&](Line const& line) {
    if (line.line_value().row_known()) return;
    Reported& reported = report_line<describe>(report, line, line.assignment().name);
    if (context.list.kind != configuration::ListKind::axis) {
      if (!is_explained(line)) reported.severity = Severity::note;
    } else if (concerns_image(line)) {
      reported.severity = Severity::error;
    }
  });
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::warning,
    .control = "1001119",
    .check = unknown_parameter,
};

}  // namespace axisc::validator::checks::ax2001
