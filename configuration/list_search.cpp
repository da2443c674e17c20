#include "configuration/list_search.hpp"

#include "diagnostics/ascii.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace axisc::configuration {
namespace {

constexpr std::string_view kernel_folder = "CncKernelRootDir";
/// The lists of a machine are not kept further up.
constexpr std::size_t most_folders = 16;

using Parts = std::vector<std::string>;

/// Without `.` and empty parts.
Parts parts_of(std::string_view named) {
  Parts parts;
  while (!named.empty()) {
    std::size_t const end = std::min(named.find_first_of("/\\"), named.size());
    std::string_view const part = named.substr(0, end);
    if (!part.empty() && part != ".") parts.emplace_back(part);
    named.remove_prefix(std::min(end + 1, named.size()));
  }
  if (parts.size() > 1 && ascii::equal_ignoring_case(parts.front(), kernel_folder)) {
    parts.erase(parts.begin());
  }
  return parts;
}

/// With a separator at its end; empty for the working folder.
std::string folder_of(std::string const& path) {
  std::size_t const separator = path.find_last_of("/\\");
  return separator == std::string::npos ? std::string() : path.substr(0, separator + 1);
}

/// The folder above; none above the root.
std::optional<std::string> folder_above(std::string const& folder) {
  if (folder == "/" || (folder.size() == 3 && folder[1] == ':')) return std::nullopt;
  if (folder.empty() || folder == "./") return "../";
  if (folder == "../" || folder.ends_with("/../")) return folder + "../";
  return folder_of(folder.substr(0, folder.size() - 1));
}

std::string path_of_parts(std::string const& folder, Parts const& parts) {
  std::string path = folder;
  for (std::string const& part : parts) path += (&part == &parts.front() ? "" : "/") + part;
  return path;
}

struct Looked {
  std::optional<std::string> file;  ///< with its names as the folders write them
  bool has_folder = false;          ///< the file's folder is there, whether the file is or not
};

Looked look(Files& files, std::string const& folder, Parts const& parts) {
  std::string exact = path_of_parts(folder, parts);
  if (files.is_file(exact)) return {.file = std::move(exact), .has_folder = true};
  Looked looked;
  std::string path = folder;
  for (std::string const& part : parts) {
    bool const is_last = &part == &parts.back();
    std::vector<std::string> const names = files.names_in(path);
    looked.has_folder = is_last && !names.empty();
    auto const name = std::find_if(names.begin(), names.end(), [&](std::string const& each) {
      return ascii::equal_ignoring_case(each, part);
    });
    if (name == names.end() && part != "..") return looked;
    path += (name == names.end() ? part : *name) + (is_last ? "" : "/");
  }
  if (files.is_file(path)) looked.file = std::move(path);
  return looked;
}

class Search {
 public:
  Search(Files& files, std::string const& start_up, Parts parts)
      : files_(files), parts_(std::move(parts)), without_first_(parts_.begin() + 1, parts_.end()) {
    std::optional<std::string> folder = folder_of(start_up);
    for (std::size_t i = 0; folder && i < most_folders; ++i) {
      folders_.push_back(*folder);
      folder = folder_above(*folder);
    }
  }

  std::optional<FoundList> find() {
    if (auto found = as_named()) return found;
    // A file that is not in its folder is missing, even if another folder has one of its name.
    if (without_first_.empty() || has_folder_) return std::nullopt;
    if (auto found = in_renamed_folder()) return found;
    return has_folder_ ? std::nullopt : below_start_up_list();
  }

 private:
  [[nodiscard]] std::string const& own_folder() const { return folders_.front(); }

  Looked look_in(std::string const& folder, Parts const& parts) {
    Looked looked = look(files_, folder, parts);
    has_folder_ = has_folder_ || (parts.size() > 1 && looked.has_folder);
    return looked;
  }

  std::optional<FoundList> as_named() {
    for (std::size_t i = 0; i < folders_.size(); ++i) {
      auto const file = look_in(folders_[i], parts_).file;
      if (!file) continue;
      FoundList found{.path = short_name(*file)};
      if (i > 0 && !without_first_.empty() && !encloses_start_up_list(*file, i)) {
        found.other = other_than(found.path, 0, i);
      }
      return found;
    }
    return std::nullopt;
  }

  /// The first folder of the path may have been renamed in a copy: the start-up list lies in the copy.
  std::optional<FoundList> in_renamed_folder() {
    if (without_first_.front() == "..") return std::nullopt;
    for (std::size_t i = 0; i < folders_.size(); ++i) {
      auto file = look_in(folders_[i], without_first_).file;
      if (!file) continue;
      FoundList found{.path = short_name(*std::move(file)), .moved = true};
      found.other = other_than(found.path, i + 1, folders_.size());
      return found;
    }
    return std::nullopt;
  }

  std::optional<FoundList> below_start_up_list() {
    Parts rest = without_first_;
    while (rest.size() > 1 && !has_folder_) {
      rest.erase(rest.begin());
      if (rest.front() == "..") continue;
      if (auto file = look_in(own_folder(), rest).file) {
        return FoundList{.path = *std::move(file), .moved = true};
      }
    }
    return std::nullopt;
  }

  /// `x.lis` rather than `../listen/x.lis`.
  [[nodiscard]] std::string short_name(std::string path) {
    auto beside = look(files_, own_folder(), {parts_.back()}).file;
    return beside && files_.is_same(*beside, path) ? *std::move(beside) : std::move(path);
  }

  /// True where the start-up list lies in the first folder that `file`, found from the folder number `from`
  /// on, names: that is the folder itself and not a renamed copy.
  [[nodiscard]] bool encloses_start_up_list(std::string const& file, std::size_t from) {
    std::string const first = file.substr(0, file.find('/', folders_[from].size()));
    std::string const& towards = folders_[from - 1];
    return files_.is_same(towards.empty() ? "." : towards.substr(0, towards.size() - 1), first);
  }

  /// A file that lies where `path` would if the first folder of its name were one of these.
  [[nodiscard]] std::optional<std::string> other_than(std::string const& path, std::size_t begin,
                                                      std::size_t end) {
    if (without_first_.front() == "..") return std::nullopt;
    for (std::size_t i = begin; i < end; ++i) {
      auto other = look(files_, folders_[i], without_first_).file;
      if (other && !files_.is_same(*other, path)) return other;
    }
    return std::nullopt;
  }

  Files& files_;
  Parts parts_;
  Parts without_first_;
  std::vector<std::string> folders_;  ///< that of the start-up list, then those above it
  bool has_folder_ = false;           ///< one of them has the folder that the name asks for
};

}  // namespace

std::optional<FoundList> find_list(Files& files, std::string const& start_up, std::string_view named) {
  Parts parts = parts_of(named);
  if (parts.empty()) return std::nullopt;
  return Search(files, start_up, std::move(parts)).find();
}

}  // namespace axisc::configuration
