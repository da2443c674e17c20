#include "axisc/workspace/inputs.hpp"

#include "axisc/environment/codes.hpp"
#include "axisc/files/disk_files.hpp"
#include "axisc/files/path_identity.hpp"
#include "axisc/settings/glob.hpp"
#include "axisc/workspace/machine_inputs.hpp"
#include "axisc/workspace/machine_outline.hpp"
#include "axisc/workspace/response_file.hpp"
#include "configuration/project_file.hpp"
#include "configuration/xml/xml_names.hpp"
#include "diagnostics/ascii.hpp"
#include "diagnostics/joined.hpp"
#include "system/folder.hpp"
#include "system/path.hpp"
#include "system/process.hpp"

#include <algorithm>
#include <unordered_set>
#include <utility>
#include <variant>

namespace axisc::says {

constexpr Sentence folder{"cannot read the folder {folder}: {reason}",
                          "der Ordner {folder} ist nicht lesbar: {reason}"};
constexpr Sentence folder_no_permission{
    "cannot read the folder {folder}: permission denied; check its access rights",
    "der Ordner {folder} ist nicht lesbar: keine Berechtigung; die Zugriffsrechte prüfen"};
constexpr Sentence no_machine{
    "the folder {folder} holds no machine: no start-up list and no machine file",
    "der Ordner {folder} enthält keine Maschine: keine Hochlaufliste und keine Maschinendatei"};
constexpr Sentence several_machines{
    "the folder {folder} holds several machines; name one of them: {machines}",
    "der Ordner {folder} enthält mehrere Maschinen; eine davon angeben: {machines}"};
constexpr Sentence folder_empty{
    "the folder {folder} holds no list (*.lis), no machine file (*.json with the key \"axes\") and no NC "
    "program (*.nc)",
    "der Ordner {folder} enthält keine Liste (*.lis), keine Maschinendatei (*.json mit dem Schlüssel "
    "\"axes\") und kein NC-Programm (*.nc)"};
constexpr Sentence not_a_file{
    "{file} is not read: it is a pipe or a device, and lists in a folder are regular files",
    "{file} wird nicht gelesen: eine Pipe oder ein Gerät, und Listen in einem Ordner sind gewöhnliche "
    "Dateien"};
constexpr Sentence folder_link{
    "{file} is not searched: it is a link to a folder elsewhere; name that folder as well",
    "{file} wird nicht durchsucht: ein Link auf einen Ordner an anderer Stelle; diesen Ordner ebenfalls "
    "angeben"};
constexpr Sentence unclear{
    "{file} is not checked: it is cut off or not text, and may have been a machine file; name it to check it",
    "{file} wird nicht geprüft: abgeschnitten oder kein Text, vielleicht eine Maschinendatei; die Datei "
    "angeben, um sie zu prüfen"};
constexpr Sentence listed{
    "cannot read {file}, named in {place}: there is no such file; check the name and the folder",
    "{file}, genannt in {place}, ist nicht lesbar: die Datei gibt es nicht; Name und Ordner prüfen"};

}  // namespace axisc::says

namespace axisc {

namespace {

struct Found {
  std::string path;
  bool is_link = false;
  bool is_replaced = false;  ///< a start-up list of which a machine file names lists
  bool is_in_folder = false;
  MachineOutline outline = {};
};

/// Paths are compared by component: a folder comes before names that merely begin with its name.
bool is_before(std::string const& left, std::string const& right) {
  auto const rank = [](char character) {
    return character == '/' ? 0U : static_cast<unsigned char>(character) + 1U;
  };
  return std::lexicographical_compare(left.begin(), left.end(), right.begin(), right.end(),
                                      [rank](char a, char b) { return rank(a) < rank(b); });
}

bool has_input_name(std::string const& name) {
  return ascii::has_extension(name, ".lis") || ascii::has_extension(name, ".json") ||
         ascii::has_extension(name, ".nc") || configuration::is_project_name(name) ||
         configuration::is_xml_name(name);
}

/// Files that are recognisably neither list nor machine: other JSON and XML files, and projects without a
/// CNC.
bool is_something_else(Found const& file) {
  bool const says_itself = ascii::has_extension(file.path, ".json") ||
                           configuration::is_xml_name(file.path) || configuration::is_project_name(file.path);
  return says_itself && !file.outline.is_machine && !file.outline.is_xml_list;
}

class Expansion {
 public:
  using Wanted = std::function<bool(std::string const& path)>;

  Expansion(Wanted const& wanted, NamedFiles named_files) : wanted_(wanted), named_files_(named_files) {}

  void add(NamedInput const& input) {
    auto kind =
        input.path == "-" ? system::FileKind::regular : system::kind_of(input.path, system::Link::refused);
    bool const is_link = kind == system::FileKind::link;
    if (is_link) kind = system::kind_of(input.path);
    if (!kind && !system::shell_expands_patterns() && add_matching(input.path)) return;
    if (kind == system::FileKind::folder) {
      add_folder(input.path);
    } else if (!kind && !input.place.empty()) {
      failures_.push_back(
          Failure({says::listed, {{"file", input.path}, {"place", input.place}}}, cannot_read));
    } else {
      Found file{.path = input.path, .is_link = is_link, .outline = outline_of(input.path)};
      bool const is_chosen = named_files_ != NamedFiles::of_hook || wanted_(input.path);
      if (is_chosen && !is_passed_over(file)) found_.push_back(std::move(file));
    }
  }

  [[nodiscard]] Inputs result() && {
    Inputs result;
    result.failures = std::move(failures_);
    result.notes = std::move(notes_);
    PathIdentities identities;
    Known lists;
    Known programs;
    auto const identities_of = [&](Found const& input, std::vector<std::string> const& names) {
      std::vector<std::string> known;
      for (auto const& name : names) {
        result.sources.push_back(
            system::name_of(system::path_of(input.path).parent_path() / system::path_of(name)));
        known.push_back(identities.of(result.sources.back()));
      }
      return known;
    };
    Known of_machine_files;
    for (bool const machine_files : {true, false}) {
      for (auto& input : found_) {
        if (ascii::has_extension(input.path, ".json") != machine_files) continue;
        auto const named = identities_of(input, input.outline.lists);
        if (machine_files) of_machine_files.insert(named.begin(), named.end());
        input.is_replaced = !machine_files && std::any_of(named.begin(), named.end(), [&](auto const& list) {
          return of_machine_files.contains(list);
        });
        lists.insert(named.begin(), named.end());
        for (auto& program : identities_of(input, input.outline.programs)) {
          programs.insert(std::move(program));
        }
      }
    }
    // A single input has no duplicate, so its links need not be resolved.
    bool const is_alone = found_.size() == 1;
    Known taken;
    for (auto& input : found_) {
      result.sources.push_back(input.path);
      if (!is_alone && !is_wanted(input, identities.of(input.path, input.is_link), lists, programs, taken)) {
        continue;
      }
      if (input.is_in_folder) {
        result.found[input.path] = {.is_beside_start_up_list = is_beside_start_up_list(input)};
      }
      result.paths.push_back(input.path);
    }
    return result;
  }

 private:
  using Known = std::unordered_set<std::string>;

  /// Files that a machine file names are checked through it; a machine file itself is always checked.
  [[nodiscard]] static bool is_wanted(Found const& input, std::string const& identity, Known const& lists,
                                      Known const& programs, Known& taken) {
    if (!taken.insert(identity).second) return false;
    if (ascii::has_extension(input.path, ".json")) return true;
    if (input.outline.is_machine) return !input.is_replaced;
    return !(ascii::has_extension(input.path, ".nc") ? programs : lists).contains(identity);
  }

  /// In its folder or in one above.
  [[nodiscard]] bool is_beside_start_up_list(Found const& input) const {
    bool const is_list = !input.outline.is_machine && !ascii::has_extension(input.path, ".nc");
    return is_list && std::any_of(found_.begin(), found_.end(), [&input](Found const& other) {
             if (!other.outline.is_machine || other.is_replaced ||
                 ascii::has_extension(other.path, ".json")) {
               return false;
             }
             auto const folder = system::name_of(system::path_of(other.path).parent_path());
             return folder.empty() || input.path.starts_with(folder + "/");
           });
  }

  void add_folder(std::string const& folder) {
    std::vector<Found> entries;
    auto const start = system::name_of(system::path_of(folder).lexically_normal());
    auto const failures = failures_.size();
    collect(start, folder, entries);
    std::sort(entries.begin(), entries.end(),
              [](Found const& left, Found const& right) { return is_before(left.path, right.path); });
    auto const before = found_.size();
    for (auto& entry : entries) {
      if (!wanted_(entry.path)) continue;
      entry.is_in_folder = true;
      entry.outline = outline_of(entry.path);
      if (is_something_else(entry)) {
        if (entry.outline.is_unclear) note(says::unclear, entry.path);
        continue;
      }
      found_.push_back(std::move(entry));
    }
    bool const all_excluded = std::none_of(entries.begin(), entries.end(), [this](Found const& entry) {
      return entry.path.empty() || wanted_(entry.path);
    });
    bool const is_empty = entries.empty() || !all_excluded;
    if (found_.size() == before && failures_.size() == failures && is_empty) {
      failures_.push_back(Failure({says::folder_empty, {{"folder", folder}}}, cannot_read));
    }
  }

  [[nodiscard]] bool is_passed_over(Found const& file) {
    if (named_files_ != NamedFiles::of_hook || !is_something_else(file)) return false;
    if (file.outline.is_unclear) note(says::unclear, file.path);
    return true;
  }

  /// A folder that cannot be read is reported as `shown`; the others are read nevertheless. Links to folders
  /// are not followed.
  void collect(std::string const& start, std::string const& shown, std::vector<Found>& entries) {
    std::vector<std::pair<std::string, std::string>> folders{{start == "." ? "" : start, shown}};
    while (!folders.empty()) {
      auto const [folder, name] = std::move(folders.back());
      folders.pop_back();
      auto const found = system::entries_of(folder);
      if (auto const* const error = std::get_if<system::Error>(&found)) {
        fail(name, *error);
        continue;
      }
      for (auto const& entry : std::get<std::vector<system::FolderEntry>>(found)) {
        auto const path = system::name_in(folder, entry.name);
        bool const is_link = entry.kind == system::FileKind::link;
        // A dangling link is reported when it is read.
        auto const kind = is_link ? system::kind_of(path).value_or(system::FileKind::regular) : entry.kind;
        if (kind == system::FileKind::folder) {
          if (!is_link) {
            folders.emplace_back(path, path);
          } else if (leads_out_of(start, path) && wanted_(path + "/x.lis")) {  // settings exclude `old/**`
            note(says::folder_link, path);
          }
        } else if (has_input_name(path)) {
          if (kind == system::FileKind::regular) {
            entries.push_back({.path = path, .is_link = is_link});
          } else if (wanted_(path)) {
            note(says::not_a_file, path);
          }
        }
      }
    }
  }

  /// A link's target within the folder is found by itself.
  static bool leads_out_of(std::string const& folder, std::string const& link) {
    auto const inside = system::real_name(folder);
    auto const target = system::real_name(link);
    return !inside || !target || (*target != *inside && !target->starts_with(*inside + "/"));
  }

  void note(SentenceRef sentence, std::string const& path) { notes_.push_back({sentence, {{"file", path}}}); }

  /// False where the last part of the name is not a pattern, or nothing matches it.
  bool add_matching(std::string const& pattern) {
    auto const whole = system::path_of(pattern);
    auto const last = system::name_of(whole.filename());
    if (last.find_first_of("*?") == std::string::npos) return false;
    auto const folder = system::name_of(whole.parent_path());
    auto const found = system::entries_of(folder);
    auto const* const entries = std::get_if<std::vector<system::FolderEntry>>(&found);
    if (entries == nullptr) return false;
    bool is_found = false;
    for (auto const& entry : *entries) {
      if (!matches_glob(last, entry.name)) continue;
      add({.path = system::name_in(folder, entry.name)});
      is_found = true;
    }
    return is_found;
  }

  void fail(std::string const& folder, system::Error const& error) {
    bool const is_denied = error.refusal == system::Refusal::no_permission;
    failures_.push_back(Failure({is_denied ? says::folder_no_permission : says::folder,
                                 {{"folder", folder}, {"reason", system::text_of(error)}}},
                                cannot_read));
  }

  Wanted const& wanted_;
  NamedFiles named_files_;
  std::vector<Found> found_;
  std::vector<Failure> failures_;
  std::vector<Message> notes_;
};

}  // namespace

Inputs expand_inputs(std::vector<std::string> const& words, Expansion::Wanted const& wanted,
                     NamedFiles named_files) {
  std::vector<NamedInput> named;
  bool const may_name_others = named_files == NamedFiles::usual;
  if (may_name_others) {
    named = read_response_files(words);
  } else {
    for (auto const& word : words) named.push_back({.path = word});
  }
  // Messages use `/` between folders on every system, also for names written with `\`.
  for (auto& input : named) input.path = system::name_of(system::path_of(input.path));
  Expansion expansion(wanted, named_files);
  for (auto const& input : named) expansion.add(input);
  auto inputs = std::move(expansion).result();
  if (!named.empty()) inputs.first = named.front().path;
  for (auto const& input : named) inputs.named.push_back(input.path);
  for (auto const& word : words) {
    if (may_name_others && word.starts_with('@')) inputs.sources.push_back(word.substr(1));
  }
  return inputs;
}

std::string machine_input(std::string const& name) {
  auto machines = machine_inputs(name);
  if (machines.size() == 1) return std::move(machines.front());
  if (machines.empty()) {
    throw Failure({says::no_machine, {{"folder", name}}}, cannot_read);
  }
  throw Failure({says::several_machines, {{"folder", name}, {"machines", joined(machines)}}});
}

}  // namespace axisc
