#include "validator/engine/rule.hpp"

#include "validator/rules/helpers.hpp"

namespace axisc::validator::says {

constexpr Sentence headline{"nothing in this list tells what kind of list it is: it is not checked",
                            "nichts in dieser Liste zeigt, von welcher Art sie ist: sie wird nicht geprüft"};
constexpr Sentence help{
    "`--kind axis`, or \"kind\" in axisc.json, checks it as an axis list, \"exclude\" there leaves it out; "
    "other kinds: "
    "{kinds}",
    "`--kind axis` oder \"kind\" in axisc.json prüft sie als Achsliste, \"exclude\" dort lässt sie aus; "
    "andere Arten: "
    "{kinds}"};

}  // namespace axisc::validator::says

namespace axisc::validator::checks {
namespace {

std::string other_kinds() {
  std::string words;
  for (schema::ListKindRow const& row : schema::list_kind_rows) {
    if (row.kind == schema::ListKind::axis) continue;
    words.append(words.empty() ? "" : ", ").append(row.word);
  }
  return words;
}

void unknown_kind(MachineContext const& context, Report& report) {
  if (!context.machine.list_of_unknown_kind) return;
  SourceId const source = *context.machine.list_of_unknown_kind;
  std::uint32_t const begin = context.sources[source].text_begin();
  Finding& finding =
      report.add(Place{.source = source, .span = {.begin = begin, .end = begin}}, message(says::headline));
  finding.help.push_back(message(says::help, {{"kinds", other_kinds()}}));
}

}  // namespace

extern constinit Rule const ax7001{
    .code = Code{7001},
    .name = "unknown-kind",
    .severity = Severity::warning,
    .check = unknown_kind,
};

}  // namespace axisc::validator::checks
