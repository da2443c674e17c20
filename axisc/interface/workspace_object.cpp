#include "axisc/interface/workspace_object.hpp"

#include "system/file.hpp"

#include <variant>

namespace axisc::interface {

namespace {

Overrides overrides_of(axisc_workspace const& object, Wanted wanted) {
  Overrides overrides{.options = object.options};
  overrides.options.machine = wanted == Wanted::machine;
  return overrides;
}

}  // namespace

Now::Now(axisc_workspace& object, Wanted wanted)
    : files(object.from, object.is_cancelled), workspace(files, overrides_of(object, wanted)) {
  workspace.put_all(object.unsaved);
}

bool Now::has(std::string const& path) {
  auto const read = workspace.files().read(path);
  auto const* const error = std::get_if<configuration::FileError>(&read);
  return error == nullptr || *error != configuration::FileError::not_found ||
         system::kind_of(path) == system::FileKind::folder;
}

}  // namespace axisc::interface
