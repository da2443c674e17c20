#include "configuration/list_search.hpp"

#include "diagnostics/ascii.hpp"

#include <algorithm>
#include <vector>

namespace axisc::configuration {
namespace {

constexpr std::string_view kernel_folder = "CncKernelRootDir";
/// Further up nobody keeps the lists of a machine.
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

/// With a separator behind it; empty for the working folder.
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

/// The path of a file from `folder` on, with its names as the folders write them.
std::optional<std::string> file_in(Files& files, std::string const& folder, Parts const& parts) {
  std::string exact = folder;
  for (std::string const& part : parts) exact += (&part == &parts.front() ? "" : "/") + part;
  if (files.is_file(exact)) return exact;
  std::string path = folder;
  for (std::string const& part : parts) {
    std::vector<std::string> const names = files.names_in(path);
    auto const name = std::find_if(names.begin(), names.end(), [&](std::string const& each) {
      return ascii::equal_ignoring_case(each, part);
    });
    if (name == names.end() && part != "..") return std::nullopt;
    path += (name == names.end() ? part : *name) + (&part == &parts.back() ? "" : "/");
  }
  if (!files.is_file(path)) return std::nullopt;
  return path;
}

}  // namespace

std::optional<FoundList> find_list(Files& files, std::string const& start_up, std::string_view named) {
  Parts const parts = parts_of(named);
  if (parts.empty()) return std::nullopt;
  std::string const own_folder = folder_of(start_up);
  std::optional<std::string> const beside = file_in(files, own_folder, {parts.back()});
  std::optional<std::string> folder = own_folder;
  for (std::size_t i = 0; folder && i < most_folders; ++i) {
    if (auto const path = file_in(files, *folder, parts)) {
      // `x.lis` rather than `../listen/x.lis`.
      return FoundList{.path = beside && files.is_same(*beside, *path) ? *beside : *path};
    }
    folder = folder_above(*folder);
  }
  if (!beside) return std::nullopt;
  return FoundList{.path = *beside, .beside = parts.size() > 1};
}

}  // namespace axisc::configuration
