#include "axisc/workspace/workspace.hpp"

#include "axisc/files/disk_files.hpp"
#include "axisc/workspace/judged_inputs.hpp"

namespace axisc {

Workspace::Workspace(Overrides overrides)
    : own_disk_(std::make_unique<DiskFiles>(true)),
      disk_(*own_disk_),
      overrides_(std::move(overrides)),
      settings_(overrides_.schema_files) {}

Workspace::Workspace(configuration::Files& disk, Overrides overrides)
    : disk_(disk), overrides_(std::move(overrides)), settings_(overrides_.schema_files) {}

Workspace::Workspace(configuration::Files& disk, OptionsOf options)
    : disk_(disk), ready_options_(std::move(options)) {}

validator::CheckOptions Workspace::options_of(std::string const& path) {
  if (ready_options_) return ready_options_(path);
  auto options = overrides_.options;
  if (auto const found = found_.find(path); found != found_.end()) {
    options.from_folder = true;
    options.is_beside_start_up_list = found->second.is_beside_start_up_list;
  }
  options.catalogue = settings_.catalogue(path);
  auto const* const settings = settings_.find(path);
  return settings == nullptr ? options : with_settings(std::move(options), *settings, path);
}

Belonging Workspace::machine_of(std::string const& path) {
  return axisc::machine_of(files_, path);
}

void Workspace::judge_in_machines(Inputs& inputs) {
  axisc::judge_in_machines(inputs, files_);
  shown_ = inputs.shown;
}

std::vector<Belonging> Workspace::belonging_of(Inputs const& inputs) {
  return axisc::belonging_of(inputs, files_);
}

std::vector<std::string> const* Workspace::shown_of(std::string const& machine) const {
  auto const found = shown_.find(machine);
  return found == shown_.end() ? nullptr : &found->second;
}

}  // namespace axisc
