#include "axisc/files/path_identity.hpp"

#include "system/path.hpp"

namespace axisc {

namespace {

namespace fs = std::filesystem;

constexpr int most_links = 40;

std::string resolved(fs::path const& path) {
  std::error_code error;
  auto const found = fs::weakly_canonical(fs::absolute(path, error), error);
  auto name = system::name_of(error ? path.lexically_normal() : found);
  // "a/missing/.." becomes "a/".
  while (name.size() > 1 && name.ends_with('/')) name.pop_back();
  return name;
}

}  // namespace

std::string PathIdentities::of(std::string const& path) {
  std::error_code error;
  return of(path, fs::is_symlink(fs::symlink_status(system::path_of(path), error)));
}

std::string PathIdentities::of(std::string const& name, bool is_link) {
  if (name == "-") return "-";
  auto const path = system::path_of(name);
  auto const file = path.filename();
  if (file.empty() || file == "." || file == ".." || is_link) return resolved(path);
  auto const [folder, is_new] = folders_.try_emplace(system::name_of(path.parent_path()));
  if (is_new) folder->second = resolved(path.has_parent_path() ? path.parent_path() : ".");
  return system::name_of(system::path_of(folder->second) / file);
}

std::string behind_links(std::string const& path) {
  fs::path target = system::path_of(path);
  std::error_code error;
  for (int links = 0; links < most_links && fs::is_symlink(fs::symlink_status(target, error)); ++links) {
    auto const next = fs::read_symlink(target, error);
    if (error) break;
    target = next.is_absolute() ? next : target.parent_path() / next;
  }
  return system::name_of(target);
}

}  // namespace axisc
