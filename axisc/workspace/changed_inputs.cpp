#include "axisc/workspace/changed_inputs.hpp"

#include "axisc/files/path_identity.hpp"
#include "axisc/workspace/machine_outline.hpp"
#include "diagnostics/ascii.hpp"
#include "system/path.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace axisc::says {

constexpr Sentence outside{
    "{file} is not in the repository {root}, so its changes are unknown; leave it out, or run axisc in its "
    "own repository",
    "{file} liegt nicht im Repository {root}, ihre Änderungen sind also unbekannt; sie weglassen oder axisc "
    "in ihrem eigenen Repository aufrufen"};

}  // namespace axisc::says

namespace axisc {

namespace {

std::string_view last_part(std::string_view path) {
  auto const separator = path.find_last_of("/\\");
  return separator == std::string_view::npos ? path : path.substr(separator + 1);
}

/// "a/b" of "a/b/x.lis"; empty of "x.lis".
std::string_view parent_of(std::string_view path) {
  return path.substr(0, std::min(path.rfind('/'), path.size() - last_part(path).size()));
}

bool is_below(std::string_view path, std::string_view folder) {
  return folder.empty() || (path.starts_with(folder) && path.substr(folder.size()).starts_with('/'));
}

class Changes {
 public:
  Changes(ChangedFiles const& changed, SettingsFinder& settings) : changed_(changed), settings_(settings) {}

  [[nodiscard]] bool concern(std::string const& input) {
    auto const own = place_of(input);
    if (!own) {
      throw Failure({says::outside, {{"file", input}, {"root", changed_.root}}});
    }
    return is_changed(input) || settings_changed(input, *own) || parts_changed(input, *own);
  }

 private:
  /// A path from the root of the repository; none outside.
  [[nodiscard]] std::optional<std::string> from_root(std::string const& whole) const {
    std::string_view root = changed_.root;
    if (root.ends_with('/')) root.remove_suffix(1);
    if (!whole.starts_with(root) || whole.substr(root.size(), 1) != "/") return std::nullopt;
    return whole.substr(root.size() + 1);
  }
  /// Where the file or the link of that name lies.
  [[nodiscard]] std::optional<std::string> place_of(std::string const& name) {
    return from_root(identities_.of(name, false));
  }

  /// The path or one of its folders: a changed submodule is known as a whole.
  [[nodiscard]] bool has(std::optional<std::string> const& path) const {
    if (!path) return false;
    for (std::string_view part = *path; !part.empty(); part = parent_of(part)) {
      if (changed_.paths.contains(std::string(part))) return true;
    }
    return false;
  }
  /// A link is changed where it, or what it leads to, is.
  [[nodiscard]] bool is_changed(std::string const& name) {
    return has(place_of(name)) || has(from_root(identities_.of(name)));
  }

  [[nodiscard]] bool settings_changed(std::string const& input, std::string const& own) {
    std::vector<std::string> files;
    add_settings_files(settings_, input, files);
    auto const is_gone = [&own](std::string const& gone) {
      return last_part(gone) == settings_file_name && is_below(own, parent_of(gone));
    };
    return std::any_of(files.begin(), files.end(), [this](auto const& file) { return is_changed(file); }) ||
           std::any_of(changed_.gone.begin(), changed_.gone.end(), is_gone);
  }

  [[nodiscard]] bool parts_changed(std::string const& input, std::string const& own) {
    auto const outline = outline_of(input);
    if (!outline.is_machine) return false;
    auto const folder = system::path_of(input).parent_path();
    auto const is_changed_part = [&](std::string const& part) {
      return is_changed(system::name_of(folder / system::path_of(part)));
    };
    if (std::any_of(outline.lists.begin(), outline.lists.end(), is_changed_part) ||
        std::any_of(outline.programs.begin(), outline.programs.end(), is_changed_part)) {
      return true;
    }
    // A machine file names places. A control looks for the lists of a start-up list in several.
    if (ascii::has_extension(input, ".json")) return false;
    return std::any_of(changed_.gone.begin(), changed_.gone.end(), [&](std::string const& gone) {
      return is_below(gone, parent_of(own)) ||
             std::any_of(outline.written.begin(), outline.written.end(), [&gone](std::string const& written) {
               return ascii::equal_ignoring_case(last_part(written), last_part(gone));
             });
    });
  }

  ChangedFiles const& changed_;
  SettingsFinder& settings_;
  PathIdentities identities_;
};

}  // namespace

void keep_changed(Inputs& inputs, ChangedFiles const& changed, SettingsFinder& settings) {
  Changes changes(changed, settings);
  std::erase_if(inputs.paths, [&changes](std::string const& path) { return !changes.concern(path); });
}

}  // namespace axisc
