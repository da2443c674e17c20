#include "tests/fmu/imported.hpp"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <sstream>

namespace axisc::test {

namespace {

std::string const sources = AXISC_SOURCE_DIR "/tests/fmu/";

char digit(image::FmiVersion version) {
  return version == image::FmiVersion::three ? '3' : '2';
}

/// The importer for a version.
std::string importer(image::FmiVersion version) {
  static TemporaryFolder const folder;
  auto program = folder / (std::string("importer") + digit(version));
  if (!std::filesystem::exists(program)) {
    REQUIRE(shell("cc -std=c11 -Wall -Wextra -Werror -DFMI=" + std::string(1, digit(version)) + " " +
                  sources + "importer.c -ldl -o " + program));
  }
  return program;
}

std::string override_of(image::FmiVersion version) {
  return std::string(" -DFMI") + digit(version) + "_OVERRIDE_FUNCTION_PREFIX";
}

/// What does not depend on the machine.
std::string common_object(std::string const& folder, std::string const& source, image::FmiVersion version) {
  static TemporaryFolder const objects;
  auto object = objects / (source + ".o");
  if (!std::filesystem::exists(object)) {
    REQUIRE(shell(std::string(strict_c) + override_of(version) + " -fPIC -fvisibility=hidden -c " + folder +
                  "/sources/" + source + " -o " + object));
  }
  return object;
}

std::string type_letter(std::string_view type) {
  if (type == "Float64" || type == "Real") return "f";
  return type == "Boolean" ? "b" : "e";
}

}  // namespace

bool shell(std::string const& line) {
  return std::system(line.c_str()) == 0;
}

bool is_installed(std::string const& program) {
  return shell("command -v " + program + " >/dev/null 2>&1");
}

UnpackedFmu::UnpackedFmu(std::string place, image::FmiVersion fmi)
    : folder(std::move(place)), version(fmi), description(), variables() {
  REQUIRE(description.load_file((folder + "/modelDescription.xml").c_str()));
  for (auto const variable : description.document_element().child("ModelVariables")) {
    auto const type = version == image::FmiVersion::three ? variable.name() : variable.first_child().name();
    variables[variable.attribute("name").value()] =
        type_letter(type) + variable.attribute("valueReference").value();
  }
}

void UnpackedFmu::compile() const {
  auto const interface = std::string("fmi") + digit(version) + ".c";
  REQUIRE(shell("cd " + folder + "/sources && " + std::string(strict_c) +
                " -fPIC -fvisibility=hidden -shared fmu_core.c machine.c " +
                common_object(folder, "axisrt_c.c", version) + " " +
                common_object(folder, interface, version) + " -o ../library.so"));
}

std::string UnpackedFmu::variable(std::string const& name) const {
  auto const found = variables.find(name);
  return found == variables.end() ? "" : found->second;
}

std::vector<std::string> UnpackedFmu::outputs() const {
  std::vector<std::string> names;
  for (auto const variable : description.document_element().child("ModelVariables")) {
    if (variable.attribute("causality").value() == std::string_view("output")) {
      names.emplace_back(variable.attribute("name").value());
    }
  }
  return names;
}

std::vector<std::string> UnpackedFmu::run(std::string const& scenario,
                                          std::vector<std::string> const& outputs,
                                          std::string const& token) const {
  auto const root = description.document_element();
  auto const own =
      root.attribute(version == image::FmiVersion::three ? "instantiationToken" : "guid").value();
  std::ofstream(folder + "/scenario") << scenario;
  std::string line = importer(version) + " " + folder + "/library.so " + (token.empty() ? own : token) + " " +
                     root.child("DefaultExperiment").attribute("stepSize").value();
  for (auto const& name : outputs) line += " " + variable(name);
  int const status = std::system((line + " <" + folder + "/scenario >" + folder + "/printed").c_str());
  std::vector<std::string> lines;
  std::ifstream printed(folder + "/printed");
  for (std::string each; std::getline(printed, each);) lines.push_back(each);
  if (status != 0) lines.emplace_back("failed");
  return lines;
}

std::string hexadecimal(double value) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%a", value);
  return text.data();
}

std::vector<double> numbers_of(std::string const& line) {
  std::vector<double> numbers;
  std::istringstream words(line);
  for (std::string word; words >> word;) numbers.push_back(std::strtod(word.c_str(), nullptr));
  return numbers;
}

}  // namespace axisc::test
