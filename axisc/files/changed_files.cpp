#include "axisc/files/changed_files.hpp"

#include "axisc/environment/failure.hpp"
#include "axisc/files/repository.hpp"
#include "system/path.hpp"
#include "system/program.hpp"

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <utility>
#include <variant>

namespace axisc::says {

constexpr Sentence no_revision{
    "--changed-since needs a revision of git, such as origin/main or HEAD~1, not \"{revision}\"",
    "--changed-since braucht eine Revision von git, etwa origin/main oder HEAD~1, nicht \"{revision}\""};
constexpr Sentence no_repository{
    "--changed-since needs a git repository: none of the folders from {folder} upwards holds .git",
    "--changed-since braucht ein Git-Repository: in keinem Ordner von {folder} aufwärts liegt .git"};
constexpr Sentence no_git{
    "--changed-since needs the program git, which cannot be started ({reason}); install it, or add its "
    "folder to PATH",
    "--changed-since braucht das Programm git, das sich nicht starten lässt ({reason}); es installieren oder "
    "seinen Ordner in PATH aufnehmen"};
constexpr Sentence git_refuses{
    "git cannot compare with \"{revision}\": {reason}; `git fetch` gets revisions that are missing, in a "
    "shallow clone with --unshallow",
    "git kann nicht mit \"{revision}\" vergleichen: {reason}; `git fetch` holt fehlende Revisionen, in einem "
    "flachen Klon mit --unshallow"};

}  // namespace axisc::says

namespace axisc {

namespace {

/// The text before the next NUL, which is taken away.
std::string_view next_part(std::string_view& rest) {
  auto const end = std::min(rest.find('\0'), rest.size());
  auto const part = rest.substr(0, end);
  rest.remove_prefix(std::min(end + 1, rest.size()));
  return part;
}

/// Its first line, without "fatal: ".
std::string reason_of(system::ProgramOutcome const& outcome) {
  constexpr std::string_view prefix = "fatal: ";
  std::string_view line = outcome.errors;
  line = line.substr(0, line.find('\n'));
  if (line.starts_with(prefix)) line.remove_prefix(prefix.size());
  return line.empty() ? "status " + std::to_string(outcome.status) : std::string(line);
}

class Git {
 public:
  Git(std::string root, std::string revision) : root_(std::move(root)), revision_(std::move(revision)) {}

  /// The output of git. Optional locks are left to commands that change something.
  [[nodiscard]] std::string operator()(std::vector<std::string> const& words) const {
    std::vector<std::string> arguments{"git", "--no-optional-locks", "-C", root_};
    arguments.insert(arguments.end(), words.begin(), words.end());
    auto result = system::run_program(arguments);
    if (auto const* const error = std::get_if<system::Error>(&result)) {
      throw Failure({says::no_git, {{"reason", system::text_of(*error)}}});
    }
    auto& outcome = std::get<system::ProgramOutcome>(result);
    if (outcome.status == 0) return std::move(outcome.output);
    throw Failure({says::git_refuses, {{"revision", revision_}, {"reason", reason_of(outcome)}}});
  }

 private:
  std::string root_;
  std::string revision_;
};

}  // namespace

ChangedFiles changed_since(std::string const& revision) {
  // Git would take a revision that begins with a dash for an option.
  if (revision.empty() || revision.starts_with('-')) {
    throw Failure({says::no_revision, {{"revision", revision}}});
  }
  std::error_code error;
  auto const folder = std::filesystem::current_path(error);
  auto const root = repository_of(folder);
  if (!root) {
    throw Failure({says::no_repository, {{"folder", system::name_of(folder)}}});
  }
  ChangedFiles changed{.root = system::name_of(*root), .paths = {}, .gone = {}};
  Git const git(changed.root, revision);
  auto const differing =
      git({"diff", "--name-status", "--no-renames", "--no-ext-diff", "-z", revision, "--"});
  for (std::string_view rest = differing; !rest.empty();) {
    auto const status = next_part(rest);
    std::string name(next_part(rest));
    if (status == "D") changed.gone.push_back(name);
    changed.paths.insert(std::move(name));
  }
  auto const unknown = git({"ls-files", "--others", "--exclude-standard", "-z"});
  for (std::string_view rest = unknown; !rest.empty();) {
    auto path = next_part(rest);
    // A repository inside this one.
    if (path.ends_with('/')) path.remove_suffix(1);
    changed.paths.emplace(path);
  }
  return changed;
}

}  // namespace axisc
