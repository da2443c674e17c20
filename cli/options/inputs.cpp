#include "cli/options/inputs.hpp"

#include "cli/codes.hpp"
#include "cli/files/disk_files.hpp"
#include "cli/options/machine_outline.hpp"
#include "cli/options/response_file.hpp"

#include <algorithm>
#include <filesystem>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <variant>

namespace axisc::cli::says {

constexpr Sentence folder{"cannot read the folder {folder}: {reason}; check its access rights",
                          "der Ordner {folder} ist nicht lesbar: {reason}; die Zugriffsrechte prüfen"};
constexpr Sentence folder_empty{
    "the folder {folder} holds no list (*.lis), no machine file (*.json with the key \"axes\") and no NC "
    "program (*.nc)",
    "der Ordner {folder} enthält keine Liste (*.lis), keine Maschinendatei (*.json mit dem Schlüssel "
    "\"axes\") und kein NC-Programm (*.nc)"};
constexpr Sentence listed{
    "cannot read {file}, named in {place}: there is no such file; check the name and the folder",
    "{file}, genannt in {place}, ist nicht lesbar: die Datei gibt es nicht; Name und Ordner prüfen"};

}  // namespace axisc::cli::says

namespace axisc::cli {

namespace {

namespace fs = std::filesystem;

struct Found {
  std::string path;
  bool is_link = false;
  std::vector<std::string> named;  ///< the lists and programs of a machine file, as it writes them
};

/// A path with all links resolved. A folder is resolved once: resolving every file would cost more than reading it.
class Identities {
 public:
  [[nodiscard]] std::string of(fs::path const& path) {
    std::error_code error;
    return of(path, fs::is_symlink(fs::symlink_status(path, error)));
  }

  [[nodiscard]] std::string of(fs::path const& path, bool is_link) {
    if (path == "-") return "-";
    auto const name = path.filename();
    if (name.empty() || name == "." || name == ".." || is_link) return canonical(path);
    auto const [folder, is_new] = folders_.try_emplace(path.parent_path().string());
    if (is_new) folder->second = canonical(path.has_parent_path() ? path.parent_path() : ".");
    return folder->second + "/" + name.string();
  }

 private:
  [[nodiscard]] static std::string canonical(fs::path const& path) {
    std::error_code error;
    auto const found = fs::weakly_canonical(fs::absolute(path, error), error);
    auto name = error ? path.lexically_normal().string() : found.string();
    // "a/missing/.." becomes "a/".
    while (name.ends_with('/')) name.pop_back();
    return name;
  }

  std::unordered_map<std::string, std::string> folders_;
};

/// The lists that a machine file names; none for a list, and for JSON that is not a machine file. An unreadable file
/// counts as a machine file, so that the check reports it.
MachineOutline outline_of(std::string const& path) {
  if (!has_extension(path, ".json")) return {};
  DiskFiles files;
  auto const bytes = files.read(path);
  auto const* const text = std::get_if<std::string>(&bytes);
  return text == nullptr ? MachineOutline{.is_machine = true, .named = {}} : read_machine_outline(*text);
}

/// Paths are compared by component: a folder comes before names that merely begin with its name.
bool is_before(std::string const& left, std::string const& right) {
  auto const rank = [](char character) {
    return character == '/' ? 0U : static_cast<unsigned char>(character) + 1U;
  };
  return std::lexicographical_compare(left.begin(), left.end(), right.begin(), right.end(),
                                      [rank](char a, char b) { return rank(a) < rank(b); });
}

bool may_be_input(fs::directory_entry const& entry) {
  auto const& name = entry.path().native();
  if (!has_extension(name, ".lis") && !has_extension(name, ".json") && !has_extension(name, ".nc")) {
    return false;
  }
  std::error_code error;
  // A dangling link is reported when it is read.
  return entry.is_regular_file(error) || !entry.exists(error);
}

class Expansion {
 public:
  void add(NamedInput const& input) {
    std::error_code error;
    auto type = input.path == "-" ? fs::file_type::regular : fs::symlink_status(input.path, error).type();
    bool const is_link = type == fs::file_type::symlink;
    if (is_link) type = fs::status(input.path, error).type();
    if (type == fs::file_type::directory) {
      add_folder(input.path);
    } else if (type == fs::file_type::not_found && !input.place.empty()) {
      failures_.push_back(
          Failure({.sentence = says::listed, .arguments = {{"file", input.path}, {"place", input.place}}},
                  cannot_read));
    } else {
      found_.push_back({.path = input.path, .is_link = is_link, .named = outline_of(input.path).named});
    }
  }

  [[nodiscard]] Inputs result() && {
    Inputs result{.paths = {}, .failures = std::move(failures_), .first = {}};
    if (found_.size() == 1 && found_.front().named.empty()) {
      // A single input has no duplicate, so its links need not be resolved.
      result.paths.push_back(std::move(found_.front().path));
      return result;
    }
    Identities identities;
    std::unordered_set<std::string> through_machine;
    for (auto const& input : found_) {
      auto const folder = fs::path(input.path).parent_path();
      for (auto const& file : input.named) through_machine.insert(identities.of(folder / file));
    }
    std::unordered_set<std::string> taken;
    for (auto& input : found_) {
      auto const [identity, is_new] = taken.insert(identities.of(input.path, input.is_link));
      if (is_new && !through_machine.contains(*identity)) result.paths.push_back(std::move(input.path));
    }
    return result;
  }

 private:
  void add_folder(std::string const& folder) {
    std::vector<Found> entries;
    std::error_code error;
    auto const start = fs::path(folder).lexically_normal();
    for (fs::recursive_directory_iterator entry(start, error), end; !error && entry != end;
         entry.increment(error)) {
      if (!may_be_input(*entry)) continue;
      auto const& path = entry->path().native();
      std::error_code unknown;
      entries.push_back(
          {.path = start == "." ? path.substr(2) : path, .is_link = entry->is_symlink(unknown), .named = {}});
    }
    if (error) {
      failures_.push_back(
          Failure({.sentence = says::folder, .arguments = {{"folder", folder}, {"reason", error.message()}}},
                  cannot_read));
      return;
    }
    std::sort(entries.begin(), entries.end(),
              [](Found const& left, Found const& right) { return is_before(left.path, right.path); });
    auto const before = found_.size();
    for (auto& entry : entries) {
      auto outline = outline_of(entry.path);
      if (has_extension(entry.path, ".json") && !outline.is_machine) continue;
      entry.named = std::move(outline.named);
      found_.push_back(std::move(entry));
    }
    if (found_.size() == before) {
      failures_.push_back(
          Failure({.sentence = says::folder_empty, .arguments = {{"folder", folder}}}, cannot_read));
    }
  }

  std::vector<Found> found_;
  std::vector<Failure> failures_;
};

}  // namespace

Inputs expand_inputs(std::vector<std::string> const& words) {
  auto const named = read_response_files(words);
  Expansion expansion;
  for (auto const& input : named) expansion.add(input);
  auto inputs = std::move(expansion).result();
  if (!named.empty()) inputs.first = named.front().path;
  return inputs;
}

}  // namespace axisc::cli
