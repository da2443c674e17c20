#include "axisc/exporting/fmu_libraries.hpp"

#include "axisc/asked/quantities.hpp"
#include "axisc/environment/failure.hpp"
#include "axisc/exporting/temporary_folder.hpp"
#include "system/file.hpp"
#include "system/path.hpp"
#include "system/program.hpp"

#include <optional>
#include <utility>
#include <variant>

namespace axisc::says {

constexpr Sentence not_a_platform{
    "--binaries takes linux64, win64 or linux64,win64; or none or auto alone; not \"{value}\"",
    "--binaries nimmt linux64, win64 oder linux64,win64; oder none oder auto allein; nicht „{value}“"};
constexpr Sentence no_compiler{"{system}: no library, because {compiler} cannot be run",
                               "{system}: keine Bibliothek, weil {compiler} nicht ausgeführt werden kann"};
constexpr Sentence other_target{"{system}: no library, because {compiler} compiles for {target}",
                                "{system}: keine Bibliothek, weil {compiler} für {target} kompiliert"};
constexpr Sentence compiler_failed{"{system}: no library, because {compiler} reports: {errors}",
                                   "{system}: keine Bibliothek, weil {compiler} meldet: {errors}"};

}  // namespace axisc::says

namespace axisc {

namespace {

constexpr char const* linux_compiler = "cc";
constexpr char const* windows_compiler = "x86_64-w64-mingw32-gcc-posix";

bool is_windows(image::FmuPlatform const& platform) {
  return platform.key == image::win64.key;
}

std::vector<std::string> command(image::Fmu const& fmu, image::FmiVersion version,
                                 image::FmuPlatform const& platform, TemporaryFolder const& folder,
                                 std::string const& library) {
  // Small, since FMUs are sent and kept.
  std::vector<std::string> words{is_windows(platform) ? windows_compiler : linux_compiler,
                                 "-std=c99",
                                 "-Os",
                                 "-fno-asynchronous-unwind-tables",
                                 "-fno-ident",
                                 "-ffunction-sections",
                                 "-fdata-sections",
                                 "-ffp-contract=off",
                                 "-fvisibility=hidden",
                                 "-shared",
                                 "-s",
                                 "-nostartfiles",  // nothing is constructed when it is loaded
                                 "-Wl,--gc-sections"};
  if (is_windows(platform)) {
    // No entry point. And by itself the linker derives the address from the name of the file.
    words.insert(words.end(), {"-static-libgcc", "-Wl,-e,0", "-Wl,--no-insert-timestamp",
                               "-Wl,--disable-auto-image-base"});
  } else {
    words.insert(words.end(), {"-fPIC", "-Wl,-z,noseparate-code", "-Wl,--build-id=none"});
  }
  words.emplace_back(version == image::FmiVersion::three ? "-DFMI3_OVERRIDE_FUNCTION_PREFIX"
                                                         : "-DFMI2_OVERRIDE_FUNCTION_PREFIX");
  for (auto const& file : fmu.files) {
    if (file.name.ends_with(".c")) words.push_back(folder / file.name);
  }
  words.insert(words.end(), {"-o", library});
  return words;
}

std::string first_line(std::string const& text) {
  return text.substr(0, text.find_first_of("\r\n"));
}

/// "x86_64-linux-gnu"; nothing where the compiler cannot be run.
std::optional<std::string> target_of(std::string const& compiler) {
  auto const run = system::run_program({compiler, "-dumpmachine"});
  auto const* const outcome = std::get_if<system::ProgramOutcome>(&run);
  return outcome == nullptr ? std::nullopt : std::optional(first_line(outcome->output));
}

bool is_for(image::FmuPlatform const& platform, std::string const& target) {
  return target.starts_with("x86_64") &&
         target.find(is_windows(platform) ? "mingw" : "linux") != std::string::npos;
}

/// The library, or why there is none.
std::variant<std::string, Message> library_of(image::Fmu const& fmu, image::FmiVersion version,
                                              image::FmuPlatform const& platform,
                                              TemporaryFolder const& folder) {
  auto const library = folder / (std::string(platform.key) + std::string(platform.suffix));
  auto const words = command(fmu, version, platform, folder, library);
  std::vector<Argument> arguments{{"system", std::string(platform.key)}, {"compiler", words.front()}};
  auto const target = target_of(words.front());
  if (!target) return Message{says::no_compiler, std::move(arguments)};
  if (!is_for(platform, *target)) {
    arguments.push_back({"target", *target});
    return Message{says::other_target, std::move(arguments)};
  }
  auto const run = system::run_program(words);
  auto const* const outcome = std::get_if<system::ProgramOutcome>(&run);
  if (outcome == nullptr) return Message{says::no_compiler, std::move(arguments)};
  auto bytes = outcome->status == 0 ? system::bytes_of(library) : std::nullopt;
  if (bytes) return *std::move(bytes);
  arguments.push_back({"errors", first_line(outcome->errors)});
  return Message{says::compiler_failed, std::move(arguments)};
}

}  // namespace

std::vector<image::FmuPlatform> library_platforms(std::string_view word) {
  if (word == "none") return {};
  if (word == "auto") return {image::linux64, image::win64};
  std::vector<image::FmuPlatform> platforms;
  auto names = split_list(word, ',');
  if (names.empty()) names.emplace_back(word);
  for (auto const& platform : {image::linux64, image::win64}) {
    if (std::erase(names, platform.key) > 0) platforms.push_back(platform);
  }
  if (!names.empty()) throw Failure({says::not_a_platform, {{"value", names.front()}}});
  return platforms;
}

FmuLibraries fmu_libraries(image::Fmu const& fmu, image::FmiVersion version,
                           std::vector<image::FmuPlatform> const& platforms) {
  FmuLibraries libraries;
  if (platforms.empty()) return libraries;
  TemporaryFolder const folder;
  for (auto const& file : fmu.files) {
    if (file.name.starts_with("sources/")) folder.write(file.name, file.content);
  }
  for (auto const& platform : platforms) {
    auto made = library_of(fmu, version, platform, folder);
    if (auto* const bytes = std::get_if<std::string>(&made)) {
      libraries.files.push_back(
          {.name = image::library_name(fmu, version, platform), .content = std::move(*bytes)});
    } else {
      libraries.missing.push_back(std::get<Message>(std::move(made)));
    }
  }
  return libraries;
}

}  // namespace axisc
