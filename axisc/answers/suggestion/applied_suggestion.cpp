#include "axisc/answers/suggestion/applied_suggestion.hpp"

#include "axisc/answers/suggestion/suggest_answer.hpp"
#include "axisc/asked/quantities.hpp"
#include "axisc/environment/failure.hpp"
#include "axisc/files/output_file.hpp"
#include "axisc/workspace/changeable_files.hpp"
#include "diagnostics/joined.hpp"
#include "diagnostics/writers/unified_diff.hpp"

namespace axisc::says {

constexpr Sentence bad_apply{"--apply needs a number from 1 to 5, not \"{value}\"",
                             "--apply braucht eine Zahl von 1 bis 5, nicht \"{value}\""};
constexpr Sentence apply_needs_plant{"--apply 4 is Improved Position Control: it needs --plant",
                                     "--apply 4 ist die optimierte Lageregelung: dafür --plant angeben"};
constexpr Sentence step_has_no_ramps{
    "--apply 5 proposes ramp times, which have no effect with STEP; add --slope TRAPEZ or SIN2",
    "--apply 5 schlägt Rampenzeiten vor, die mit STEP nicht wirken; dafür --slope TRAPEZ oder SIN2 angeben"};
constexpr Sentence written{"written: {file}", "geschrieben: {file}"};
constexpr Sentence nothing_written{"nothing to write: the lists have this setting already",
                                   "nichts zu schreiben: die Listen haben diese Einstellung schon"};
constexpr Sentence nothing_to_apply{"there is no suggestion {number} to write",
                                    "es gibt keinen Vorschlag {number}, der geschrieben werden könnte"};
constexpr Sentence not_editable{"{file} cannot be edited: write the lines into it by hand",
                                "{file} kann nicht bearbeitet werden: die Zeilen von Hand eintragen"};
constexpr Sentence not_named{
    "{file} lies outside what the command line names: write the lines into it by hand",
    "{file} liegt außerhalb dessen, was die Befehlszeile nennt: die Zeilen von Hand eintragen"};
constexpr Sentence has_findings{
    "suggestion {number} is not written: the lists would have findings ({codes})",
    "Vorschlag {number} wird nicht geschrieben: die Listen hätten Befunde ({codes})"};

}  // namespace axisc::says

namespace axisc {

namespace {

struct Found {
  ChosenSuggestion chosen;
  std::vector<std::string> const& findings;
};

Found found_in(Suggested const& suggested, std::size_t number) {
  auto const* const damping = suggested.damping ? suggested.damping->damping() : nullptr;
  if (number == damping_number && damping != nullptr) {
    return {{{.title = damping_name(*damping), .blocks = {}}, suggested.damping->edits},
            suggested.damping->findings};
  }
  auto const* const ramps = suggested.ramps ? &*suggested.ramps : nullptr;
  if (number == ramps_number && ramps == nullptr) {
    throw Failure({says::step_has_no_ramps});
  }
  if (number == ramps_number && ramps->quickest() != nullptr) {
    return {{{.title = ramps_name(*ramps), .blocks = {}}, ramps->edits}, ramps->findings};
  }
  auto const* const suggestion = suggested.suggestion();
  if (number >= damping_number || suggestion == nullptr) {
    throw Failure({says::nothing_to_apply, {{"number", std::to_string(number)}}});
  }
  auto const index = suggestion->proposed.at(number - 1);
  auto const& alternative = suggestion->alternatives.at(index);
  return {{chosen_answer(*suggestion, index), alternative.edits}, alternative.findings};
}

}  // namespace

std::size_t suggestion_number(std::string const& word, bool has_plant) {
  auto const number = parse_count(word);
  if (!number || *number < 1 || *number > ramps_number) {
    throw Failure({says::bad_apply, {{"value", word}}});
  }
  if (*number == damping_number && !has_plant) {
    throw Failure({says::apply_needs_plant});
  }
  return *number;
}

ChosenSuggestion chosen_suggestion(Suggested const& suggested, std::size_t number, std::string const& named) {
  auto found = found_in(suggested, number);
  auto const& edits = found.chosen.edits;
  if (edits.refused) throw Failure({says::not_editable, {{"file", *edits.refused}}});
  if (!found.findings.empty()) {
    throw Failure(
        {says::has_findings, {{"number", std::to_string(number)}, {"codes", joined(found.findings)}}});
  }
  ChangeableFiles const changeable({named});
  for (auto const& [path, bytes] : edits.edited) {
    if (!changeable.contains(path)) {
      throw Failure({says::not_named, {{"file", path}}});
    }
  }
  return std::move(found.chosen);
}

std::vector<Message> notes_of(ListEdits const& edits) {
  if (!edits.edited.empty()) return {};
  return {{says::nothing_written}};
}

std::vector<Message> write_lists(ListEdits const& edits) {
  std::vector<std::string> done;
  try {
    for (auto const& [path, bytes] : edits.edited) {
      replace_content(path, edits.original.at(path), bytes);
      done.push_back(path);
    }
  } catch (Failure const&) {
    for (auto const& path : done) replace_content(path, edits.edited.at(path), edits.original.at(path));
    throw;
  }
  auto notes = notes_of(edits);
  for (auto const& path : done) notes.push_back({says::written, {{"file", path}}});
  return notes;
}

std::string patch_of(ListEdits const& edits) {
  std::string patch;
  for (auto const& [path, bytes] : edits.edited) patch += unified_diff(path, edits.original.at(path), bytes);
  return patch;
}

}  // namespace axisc
