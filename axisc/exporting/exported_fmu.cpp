#include "axisc/exporting/exported_fmu.hpp"

#include "axisc/environment/version.hpp"
#include "image/fmu/zip_archive.hpp"
#include "system/path.hpp"

#include <utility>
#include <variant>

namespace axisc::says {

constexpr Sentence equal_names{
    "two axes or two channels are called {name}; variables of an FMU need different names",
    "zwei Achsen oder zwei Kanäle heißen {name}; Variable einer FMU brauchen verschiedene Namen"};

}  // namespace axisc::says

namespace axisc {

ExportedFmu exported_fmu(ImageFile const& image, image::FmuOptions options,
                         std::vector<image::FmuPlatform> const& platforms) {
  options.tool = "axisc " + std::string(program_version());
  auto made = image::fmu_of(image.bytes.bytes(), image.contents, options);
  if (auto const* const equal = std::get_if<image::EqualNames>(&made)) {
    throw Failure({says::equal_names, {{"name", equal->name}}});
  }
  auto& fmu = std::get<image::Fmu>(made);
  auto libraries = fmu_libraries(fmu, options.version, platforms);
  ExportedFmu exported{.archive = {}, .libraries = {}, .missing = std::move(libraries.missing)};
  for (auto& library : libraries.files) {
    exported.libraries.push_back(library.name);
    fmu.files.push_back(std::move(library));
  }
  exported.archive = image::zip_archive(std::move(fmu.files));
  return exported;
}

std::string model_name(std::string const& path) {
  return system::name_of(system::path_of(path).stem());
}

}  // namespace axisc
