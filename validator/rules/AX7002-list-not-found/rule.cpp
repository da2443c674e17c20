#include "validator/engine/rule.hpp"

#include "validator/loading/unreadable_file.hpp"
#include "validator/rules/filter_words.hpp"
#include "validator/sentences.hpp"

#include <algorithm>

namespace axisc::validator::checks::ax7002::says {

constexpr Sentence no_list{"the list \"{file}\" is not found", "die Liste „{file}“ ist nicht zu finden"};
constexpr Sentence no_program{"the program \"{file}\" is not found",
                              "das Programm „{file}“ ist nicht zu finden"};
constexpr Sentence streamed{
    "the lines of \"{file}\" come through the control's streaming interface, so they are not checked",
    "die Zeilen von „{file}“ kommen über die Streaming-Schnittstelle der Steuerung und werden nicht geprüft"};
constexpr Sentence searched{"searched from the folder of the start-up list and from each folder above it",
                            "gesucht ab dem Ordner der Hochlaufliste und ab jedem Ordner darüber"};
constexpr Sentence searched_from_project{
    "searched from the folder of the project and from each folder above it",
    "gesucht ab dem Ordner des Projekts und ab jedem Ordner darüber"};
constexpr Sentence help_list{"correct the name, or add the list to the folder",
                             "den Namen berichtigen oder die Liste in den Ordner legen"};
constexpr Sentence help_program{
    "correct the name, or add the program: its #FILTER commands count",
    "den Namen berichtigen oder das Programm dazulegen: seine #FILTER-Befehle zählen"};
constexpr Sentence help_unreadable{
    "put a text file in its place, in UTF-8 or windows-1252, that may be read",
    "eine lesbare Textdatei an ihre Stelle setzen, in UTF-8 oder windows-1252"};
constexpr Sentence taken{R"("{path}" was taken for "{file}", whose folder does not exist)",
                         "statt „{file}“, dessen Ordner es nicht gibt, wurde „{path}“ genommen"};
constexpr Sentence taken_of_two{R"("{path}" was taken for "{file}", but "{other}" may be meant)",
                                "für „{file}“ wurde „{path}“ genommen, gemeint sein kann aber „{other}“"};
constexpr Sentence help_two{
    "give the folder the name that the start-up list uses, or remove one of the files",
    "dem Ordner den Namen geben, den die Hochlaufliste nennt, oder eine der Dateien entfernen"};
constexpr Sentence help_unnamed{"name the list, or lower the number",
                                "die Liste nennen oder die Anzahl verringern"};
constexpr Sentence reaction_unnamed{"it looks for a list without a name and aborts start-up",
                                    "sie sucht eine Liste ohne Namen und bricht den Hochlauf ab"};

}  // namespace axisc::validator::checks::ax7002::says

namespace axisc::validator::checks::ax7002 {
namespace {

class Searches {
 public:
  Searches(StartUp const& start_up, Report& report) : start_up_(start_up), report_(report) {}

  void check() const {
    for (ListSearch const& search : start_up_.searches) {
      if (!search.found) {
        tell_missing(search);
      } else if (search.found->other) {
        Finding& finding = report_.add(
            search.named.place,
            {says::taken_of_two,
             {{"path", search.found->path}, {"file", search.named.text}, {"other", *search.found->other}}});
        finding.severity = Severity::warning;
        finding.help.push_back({says::help_two, {}});
      } else if (search.found->moved) {
        report_
            .add(search.named.place,
                 {says::taken, {{"path", search.found->path}, {"file", search.named.text}}})
            .severity = Severity::note;
      }
    }
  }

 private:
  void tell_unnamed(ListSearch const& search) const {
    Finding& finding =
        report_.add(search.named.place, {validator::says::unnamed_list, {{"parameter", search.named.text}}});
    finding.help.push_back({says::help_unnamed, {}});
    // What becomes of a channel without a list is not documented.
    if (search.wanted != configuration::ListKind::channel) react(finding, {says::reaction_unnamed, {}});
  }

  void tell_missing(ListSearch const& search) const {
    if (search.sought == Sought::unnamed_list) {
      tell_unnamed(search);
      return;
    }
    if (search.sought == Sought::streamed_program) {
      report_.add(search.named.place, {says::streamed, {{"file", search.named.text}}}).severity =
          Severity::note;
      return;
    }
    bool const is_list = search.sought == Sought::list;
    SentenceRef const not_found = is_list ? says::no_list : says::no_program;
    Finding& finding = report_.add(search.named.place, {search.error ? sentence_of(*search.error) : not_found,
                                                        {{"file", search.named.text}}});
    if (search.error) {
      finding.help.push_back({says::help_unreadable, {}});
    } else {
      finding.notes.push_back({start_up_.is_project ? says::searched_from_project : says::searched, {}});
      finding.help.push_back({is_list ? says::help_list : says::help_program, {}});
    }
    if (is_default_list(start_up_, search)) finding.notes.push_back({validator::says::control_defaults, {}});
  }

  StartUp const& start_up_;
  Report& report_;
};

void list_not_found(MachineContext const& context, Report& report) {
  if (!context.machine.start_up) return;
  Searches(*context.machine.start_up, report).check();
}

}  // namespace

extern constinit Rule const rule{
    .check = list_not_found,
};

}  // namespace axisc::validator::checks::ax7002
