#include "axisc/workspace/machine_inputs.hpp"

#include "axisc/workspace/inputs.hpp"
#include "axisc/workspace/machine_outline.hpp"
#include "system/file.hpp"
#include "system/path.hpp"

namespace axisc {

std::vector<std::string> machine_inputs(std::string const& name) {
  if (name == "-" || system::kind_of(name) != system::FileKind::folder) {
    return {system::name_of(system::path_of(name))};
  }
  auto inputs = expand_inputs(
      {name}, [](std::string const&) { return true; }, NamedFiles::literal);
  if (!inputs.failures.empty()) throw Failure(inputs.failures.front());
  std::erase_if(inputs.paths, [](std::string const& path) { return !outline_of(path).is_machine; });
  return inputs.paths;
}

}  // namespace axisc
