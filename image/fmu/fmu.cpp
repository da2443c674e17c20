#include "image/fmu/fmu.hpp"

#include "embedded.hpp"
#include "image/fmu/compact_source.hpp"
#include "image/fmu/descriptions.hpp"
#include "image/fmu/documentation.hpp"
#include "image/fmu/runtime_size.hpp"
#include "image/machine_sources.hpp"

#include <array>
#include <utility>

namespace axisc::image {

namespace {

/// What differs from one version of the FMI to the other.
struct Interface {
  std::string_view source, header;
  std::string_view (*source_text)();
  std::string_view (*header_text)();
  std::string_view prefix;
};
constexpr Interface interface_2{"fmi2.c", "fmi2.h", embedded::fmi2_c, embedded::fmi2_h,
                                "FMI2_FUNCTION_PREFIX"};
constexpr Interface interface_3{"fmi3.c", "fmi3.h", embedded::fmi3_c, embedded::fmi3_h,
                                "FMI3_FUNCTION_PREFIX"};

MachineHeader header_of(FmuModel const& model, ImageContents const& contents, std::string_view prefix) {
  return {.definitions = "\n#define machine_token \"" + model.token + "\"\n#ifndef " + std::string(prefix) +
                         "\n#define " + std::string(prefix) + " " + model.identifier + "_\n#endif\n",
          .numbers = ", machine_channel_count = " + std::to_string(contents.groups.size()) +
                     ", machine_runtime_size = " + std::to_string(runtime_size(contents))};
}

}  // namespace

std::variant<Fmu, EqualNames> fmu_of(std::span<std::byte const> image, ImageContents const& contents,
                                     FmuOptions const& options) {
  auto const bytes = exported_image(image, contents, options.complete);
  auto described = fmu_model(bytes, contents, options);
  if (auto const* const equal = std::get_if<EqualNames>(&described)) return *equal;
  auto const& model = std::get<FmuModel>(described);
  auto const& version = options.version == FmiVersion::three ? interface_3 : interface_2;
  std::array const sources{std::string_view("axisrt_c.c"), version.source, std::string_view("fmu_core.c"),
                           std::string_view("machine.c")};
  Fmu fmu{.identifier = model.identifier, .files = {}};
  auto const add = [&fmu](std::string_view folder, std::string_view name, std::string_view content) {
    fmu.files.push_back({.name = std::string(folder) + std::string(name), .content = std::string(content)});
  };
  add("", "modelDescription.xml", model_description(model, options, sources));
  std::array<std::pair<std::string_view, std::string_view>, 6> const texts{{
      {version.source, version.source_text()},
      {version.header, version.header_text()},
      {"fmu_core.c", embedded::fmu_core_c()},
      {"fmu_core.h", embedded::fmu_core_h()},
      {"axisrt_c.c", embedded::axisrt_c_source()},
      {"axisrt_c.h", embedded::axisrt_c_header()},
  }};
  for (auto const& [name, text] : texts) add("sources/", name, compact_source(text));
  add("sources/", "machine.c", machine_source(bytes));
  add("sources/", "machine.h", machine_header(contents, header_of(model, contents, version.prefix)));
  if (options.version == FmiVersion::three) {
    add("sources/", "buildDescription.xml", build_description(model, sources));
  }
  add("resources/", model.identifier + ".axim", {reinterpret_cast<char const*>(bytes.data()), bytes.size()});
  add("documentation/", "index.html", documentation(model, contents));
  add("documentation/licenses/", "license.txt", embedded::licence());
  add("extra/axisc/", "TE1420-axisc.xml", embedded::te1420_settings());
  return fmu;
}

std::string library_name(Fmu const& fmu, FmiVersion version, FmuPlatform const& platform) {
  return "binaries/" + std::string(platform.folder[version == FmiVersion::three ? 1 : 0]) + "/" +
         fmu.identifier + std::string(platform.suffix);
}

}  // namespace axisc::image
