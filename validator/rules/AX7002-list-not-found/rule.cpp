#include "validator/engine/rule.hpp"

#include "validator/loading/unreadable_file.hpp"
#include "validator/rules/filter_words.hpp"

namespace axisc::validator::says {

constexpr Sentence headline{"the list \"{file}\" is not found", "die Liste „{file}“ ist nicht zu finden"};
constexpr Sentence searched{
    "searched from the folder of the start-up list and from each folder above it, then beside the start-up "
    "list",
    "gesucht ab dem Ordner der Hochlaufliste und ab jedem Ordner darüber, dann neben der Hochlaufliste"};
constexpr Sentence taken{R"("{path}" beside the start-up list was taken instead of "{file}")",
                         "statt „{file}“ wurde „{path}“ neben der Hochlaufliste genommen"};

}  // namespace axisc::validator::says

namespace axisc::validator::checks {
namespace {

void list_not_found(MachineContext const& context, Report& report) {
  if (!context.machine.start_up) return;
  for (ListSearch const& search : context.machine.start_up->searches) {
    if (search.error) {
      report.add(search.named.place, {sentence_of(*search.error), {{"file", search.named.text}}});
    } else if (!search.found) {
      report.add(search.named.place, {says::headline, {{"file", search.named.text}}})
          .notes.push_back({says::searched, {}});
    } else if (search.found->beside) {
      report
          .add(search.named.place, {says::taken, {{"path", search.found->path}, {"file", search.named.text}}})
          .severity = Severity::note;
    }
  }
}

}  // namespace

extern constinit Rule const ax7002{
    .code = Code{7002},
    .name = "list-not-found",
    .check = list_not_found,
};

}  // namespace axisc::validator::checks
