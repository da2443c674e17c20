#include "cli/checking/identity_paths.hpp"

#include "cli/files/repository.hpp"
#include "diagnostics/repository_path.hpp"

#include <filesystem>

namespace axisc::cli {

namespace {

namespace fs = std::filesystem;

std::string current_folder() {
  std::error_code error;
  return fs::current_path(error).generic_string();
}

}  // namespace

IdentityPaths::IdentityPaths(SettingsFinder& settings, FileNames names)
    : settings_(settings), names_(names), working_folder_(current_folder()), root_(root_of(".")) {}

std::string const& IdentityPaths::of(std::string const& file) {
  auto const [known, is_new] = paths_.try_emplace(file);
  if (is_new) known->second = names_ == FileNames::as_given ? path_of(file) : file;
  return known->second;
}

bool IdentityPaths::is_gone(std::string const& path) {
  auto const [known, is_new] = gone_.try_emplace(path);
  std::error_code error;
  if (is_new) known->second = !fs::exists(fs::path(root_) / path, error);
  return known->second;
}

std::string IdentityPaths::path_of(std::string const& file) {
  auto const slash = file.rfind('/');
  auto const folder = slash == std::string::npos ? "." : file.substr(0, slash + 1);
  auto const [root, is_new] = roots_.try_emplace(folder);
  if (is_new) root->second = root_of(file);
  return path_in_repository({.root = root->second, .folder = working_folder_}, file).value_or(file);
}

std::string IdentityPaths::root_of(std::string const& file) {
  auto const whole = (fs::path(working_folder_) / file).lexically_normal();
  if (auto const repository = repository_of(whole.parent_path())) return repository->generic_string();
  auto const* const settings = settings_.find(file);
  bool const is_below = settings != nullptr &&
                        path_in_repository({.root = settings->folder, .folder = {}}, whole.generic_string());
  return is_below ? settings->folder : working_folder_;
}

}  // namespace axisc::cli
