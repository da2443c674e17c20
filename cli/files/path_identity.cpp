#include "cli/files/path_identity.hpp"

namespace axisc::cli {

namespace {

namespace fs = std::filesystem;

constexpr int most_links = 40;

std::string resolved(fs::path const& path) {
  std::error_code error;
  auto const found = fs::weakly_canonical(fs::absolute(path, error), error);
  auto name = error ? path.lexically_normal().string() : found.string();
  // "a/missing/.." becomes "a/".
  while (name.size() > 1 && name.ends_with('/')) name.pop_back();
  return name;
}

}  // namespace

std::string PathIdentities::of(fs::path const& path) {
  std::error_code error;
  return of(path, fs::is_symlink(fs::symlink_status(path, error)));
}

std::string PathIdentities::of(fs::path const& path, bool is_link) {
  if (path == "-") return "-";
  auto const name = path.filename();
  if (name.empty() || name == "." || name == ".." || is_link) return resolved(path);
  auto const [folder, is_new] = folders_.try_emplace(path.parent_path().string());
  if (is_new) folder->second = resolved(path.has_parent_path() ? path.parent_path() : ".");
  return (fs::path(folder->second) / name).string();
}

std::string behind_links(std::string const& path) {
  fs::path target = path;
  std::error_code error;
  for (int links = 0; links < most_links && fs::is_symlink(fs::symlink_status(target, error)); ++links) {
    auto const next = fs::read_symlink(target, error);
    if (error) break;
    target = next.is_absolute() ? next : target.parent_path() / next;
  }
  return target.string();
}

}  // namespace axisc::cli
