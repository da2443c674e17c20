#include "axisc/checking/identity_paths.hpp"

#include "axisc/files/repository.hpp"
#include "diagnostics/repository_path.hpp"
#include "system/path.hpp"

#include <filesystem>

namespace axisc {

namespace {

namespace fs = std::filesystem;

std::string current_folder() {
  std::error_code error;
  return system::name_of(fs::current_path(error));
}

}  // namespace

IdentityPaths::IdentityPaths(SettingsFinder& settings)
    : settings_(settings), working_folder_(current_folder()), root_(root_of(".")) {}

std::string const& IdentityPaths::of(std::string const& file) {
  auto const [known, is_new] = paths_.try_emplace(file);
  if (is_new) known->second = path_of(file);
  return known->second;
}

bool IdentityPaths::is_gone(std::string const& path) {
  auto const [known, is_new] = gone_.try_emplace(path);
  std::error_code error;
  if (is_new) known->second = !fs::exists(system::path_of(root_) / system::path_of(path), error);
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
  auto const whole = (system::path_of(working_folder_) / system::path_of(file)).lexically_normal();
  if (auto const repository = repository_of(whole.parent_path())) return system::name_of(*repository);
  auto const* const settings = settings_.find(file);
  bool const is_below = settings != nullptr &&
                        path_in_repository({.root = settings->folder, .folder = {}}, system::name_of(whole));
  return is_below ? settings->folder : working_folder_;
}

}  // namespace axisc
