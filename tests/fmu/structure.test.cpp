// What no XSD checks of an FMU: references, names, starts, units, types, files. And the XSDs, where they are.
#include "axisrt_c.h"
#include "image/fmu/compact_source.hpp"
#include "image/fmu/fmu.hpp"
#include "image/fmu/names.hpp"
#include "image/fmu/runtime_size.hpp"
#include "image/fmu/zip_archive.hpp"
#include "runtime/c99/random_image.hpp"
#include "runtime/test_runtime.hpp"
#include "tests/fmu/imported.hpp"

#include <cstdlib>
#include <set>
#include <span>

using namespace axisc;
using namespace axisc::test;
using image::FmiVersion;

namespace {

struct Loaded {
  explicit Loaded(ImageRecord const& record) : bytes(write_image(record)) {
    auto read = image::read_image(span());
    REQUIRE(std::holds_alternative<image::ImageContents>(read));
    contents = std::get<image::ImageContents>(std::move(read));
  }
  [[nodiscard]] std::span<std::byte const> span() const {
    return std::as_bytes(std::span(bytes.data(), bytes.size()));
  }
  [[nodiscard]] image::Fmu fmu(image::FmuOptions const& options) const {
    auto made = image::fmu_of(span(), contents, options);
    REQUIRE(std::holds_alternative<image::Fmu>(made));
    return std::get<image::Fmu>(std::move(made));
  }

  AlignedMemory bytes;
  image::ImageContents contents;
};

/// Names as people choose them: an identifier, blanks, quotes, umlauts.
ImageRecord named(std::uint32_t seed) {
  static constexpr std::array names = {"X",       "Achse 1", "O'Neill\"s\\", "Drehtisch Süd", "2nd",
                                       "a<b & c", "",        "X.Y"};
  auto record = random_image(seed);
  record.strip = seed % 5 == 4;
  for (std::size_t i = 0; i < record.axes.size(); ++i) {
    record.axes[i].name = names[i % names.size()] + (i < names.size() ? "" : std::to_string(i));
  }
  for (std::size_t i = 0; i < record.groups.size(); ++i) {
    record.groups[i].name = i == 0 ? "Kanal \xC3\x84" : "CH" + std::to_string(i);
  }
  return record;
}

std::string content(image::Fmu const& fmu, std::string_view name) {
  for (auto const& file : fmu.files) {
    if (file.name == name) return file.content;
  }
  return "";
}

using Strings = std::set<std::string>;

/// What is an enumeration's, by the name of the type.
std::map<std::string, std::vector<int>> enumerations(pugi::xml_node root, FmiVersion version) {
  std::map<std::string, std::vector<int>> types;
  for (auto const type : root.child("TypeDefinitions")) {
    auto const items = version == FmiVersion::three ? type : type.child("Enumeration");
    Strings names;
    for (auto const item : items.children("Item")) {
      CHECK(names.insert(item.attribute("name").value()).second);
      types[type.attribute("name").value()].push_back(item.attribute("value").as_int());
    }
  }
  return types;
}

void check_description(image::Fmu const& fmu, image::FmuOptions const& options) {
  auto const version = options.version;
  pugi::xml_document document;
  REQUIRE(document.load_string(content(fmu, "modelDescription.xml").c_str()));
  auto const root = document.document_element();
  CHECK(root.attribute("generationTool").value() == std::string_view("axisc"));
  CHECK_FALSE(root.attribute("generationDateAndTime"));
  CHECK(std::string_view(root.attribute(version == FmiVersion::three ? "instantiationToken" : "guid").value())
            .size() == 32);
  CHECK(root.child("CoSimulation").attribute("modelIdentifier").value() == fmu.identifier);
  auto const types = enumerations(root, version);
  CHECK(types.empty() == options.plain_integers);
  for (auto const& [name, values] : types) {
    CHECK(values.front() == 0);
    CHECK(std::set<int>(values.begin(), values.end()).size() == values.size());
  }
  Strings units, names, used_units, used_types, outputs, listed, initial;
  for (auto const unit : root.child("UnitDefinitions")) units.insert(unit.attribute("name").value());
  std::set<unsigned> references;
  int index = 0;
  for (auto const variable : root.child("ModelVariables")) {
    auto const typed = version == FmiVersion::three ? variable : variable.first_child();
    std::string const causality = variable.attribute("causality").value();
    std::string const name = variable.attribute("name").value();
    INFO(name);
    index += 1;
    CHECK(names.insert(name).second);
    CHECK(types.find(name) == types.end());
    auto const reference = variable.attribute("valueReference").as_uint(~0U);
    CHECK(references.insert(reference).second);
    if (auto const unit = typed.attribute("unit")) used_units.insert(unit.value());
    auto const type = typed.attribute("declaredType");
    if (type) used_types.insert(type.value());
    CHECK((std::string_view(typed.name()) == "Enumeration") == !type.empty());
    if (causality == "independent") continue;
    CHECK(variable.attribute("variability").value() == std::string_view("discrete"));
    CHECK((causality == "input") == !typed.attribute("start").empty());
    CHECK((causality == "output") ==
          (variable.attribute("initial").value() == std::string_view("calculated")));
    if (causality == "output") {
      outputs.insert(std::to_string(version == FmiVersion::three ? static_cast<int>(reference) : index));
    }
  }
  CHECK(used_units == units);
  Strings type_names;
  for (auto const& type : types) type_names.insert(type.first);
  CHECK(used_types == type_names);
  auto const structure = root.child("ModelStructure");
  if (version == FmiVersion::three) {
    for (auto const output : structure.children("Output"))
      listed.insert(output.attribute("valueReference").value());
    for (auto const each : structure.children("InitialUnknown")) {
      initial.insert(each.attribute("valueReference").value());
    }
  } else {
    for (auto const output : structure.child("Outputs")) listed.insert(output.attribute("index").value());
    for (auto const each : structure.child("InitialUnknowns"))
      initial.insert(each.attribute("index").value());
  }
  CHECK(listed == outputs);
  CHECK(initial == outputs);
}

/// Every source is listed, and every listed one is there.
void check_sources(image::Fmu const& fmu, FmiVersion version) {
  pugi::xml_document document;
  Strings listed, there;
  if (version == FmiVersion::three) {
    REQUIRE(document.load_string(content(fmu, "sources/buildDescription.xml").c_str()));
    auto const build = document.document_element().child("BuildConfiguration");
    CHECK(build.attribute("modelIdentifier").value() == fmu.identifier);
    for (auto const source : build.child("SourceFileSet").children("SourceFile")) {
      listed.insert(source.attribute("name").value());
    }
  } else {
    REQUIRE(document.load_string(content(fmu, "modelDescription.xml").c_str()));
    for (auto const file : document.document_element().child("CoSimulation").child("SourceFiles")) {
      listed.insert(file.attribute("name").value());
    }
  }
  for (auto const& file : fmu.files) {
    if (file.name.starts_with("sources/") && file.name.ends_with(".c")) there.insert(file.name.substr(8));
  }
  CHECK(listed == there);
}

/// The folder with the standard's schemas: a variable of the environment, or beside the project.
std::string schemas() {
  char const* const named_folder = std::getenv("AXISC_FMI_SCHEMAS");
  return named_folder != nullptr ? named_folder : AXISC_SOURCE_DIR "/../shared/fmi";
}

}  // namespace

TEST_CASE("descriptions of FMUs keep the rules that no schema checks") {
  for (std::uint32_t seed = 0; seed < 40; ++seed) {
    Loaded const image(named(seed));
    for (auto const version : {FmiVersion::two, FmiVersion::three}) {
      image::FmuOptions const options{
          .version = version, .name = "m", .complete = false, .plain_integers = seed % 4 == 3};
      INFO("seed " << seed << ", FMI " << static_cast<int>(version));
      auto const fmu = image.fmu(options);
      check_description(fmu, options);
      check_sources(fmu, version);
    }
  }
}

TEST_CASE("descriptions of FMUs are valid by the standard's schemas") {
  if (!std::filesystem::is_directory(schemas()) || !is_installed("xmllint")) {
    WARN("the schemas of the FMI (AXISC_FMI_SCHEMAS) or xmllint are not there");
    return;
  }
  TemporaryFolder const folder;
  std::string two, three, builds;
  for (std::uint32_t seed = 0; seed < 40; ++seed) {
    Loaded const image(named(seed));
    for (auto const version : {FmiVersion::two, FmiVersion::three}) {
      auto const fmu = image.fmu({.version = version, .name = "m", .plain_integers = seed % 4 == 3});
      auto& files = version == FmiVersion::two ? two : three;
      auto const name = std::to_string(seed) + "-" + std::to_string(static_cast<int>(version)) + ".xml";
      files += " " + folder.write(name, content(fmu, "modelDescription.xml"));
      auto const build = content(fmu, "sources/buildDescription.xml");
      if (!build.empty()) builds += " " + folder.write("build-" + name, build);
    }
  }
  CHECK(shell("xmllint --noout --schema " + schemas() + "/fmi2ModelDescription.xsd" + two + " 2>/dev/null"));
  CHECK(
      shell("xmllint --noout --schema " + schemas() + "/fmi3ModelDescription.xsd" + three + " 2>/dev/null"));
  CHECK(
      shell("xmllint --noout --schema " + schemas() + "/fmi3BuildDescription.xsd" + builds + " 2>/dev/null"));
}

TEST_CASE("names in FMUs are identifiers or quoted") {
  CHECK(image::quoted_name("X") == "X");
  CHECK(image::quoted_name("_x1") == "_x1");
  CHECK(image::quoted_name("1x") == "'1x'");
  CHECK(image::quoted_name("") == "''");
  CHECK(image::quoted_name("a.b") == "'a.b'");
  CHECK(image::quoted_name("it's \"\\\"\t") == "'it\\'s \\\"\\\\\\\" '");
  CHECK(image::quoted_name("Süd") == "'Süd'");
  CHECK(image::identifier("mill") == "mill");
  CHECK(image::identifier("5-axis mill") == "_5_axis_mill");
  CHECK(image::identifier("") == "model");
}

TEST_CASE("sources in FMUs have one comment each, and are to a compiler what they are in the project") {
  CHECK(image::compact_source("/* file */\nint a; /* why\n * so */\n/* part */\n\nint b;\n") ==
        "/* file */\nint a;\n\nint b;\n");
  CHECK(image::compact_source("a /* b */ c\n") == "a  c\n");
  std::string const literals = R"(char const* s = "/* no \" comment */", c = '"', d = '\''; int e;)";
  CHECK(image::compact_source(literals + " /* one */\n") == literals + "\n");
  if (!is_installed("cc")) return;
  Loaded const image(named(3));
  for (auto const version : {FmiVersion::two, FmiVersion::three}) {
    TemporaryFolder const folder;
    for (auto const& file : image.fmu({.version = version, .name = "m"}).files) {
      folder.write(file.name, file.content);
    }
    std::string const runtime = AXISC_SOURCE_DIR "/runtime/", sources = folder / "sources";
    std::string const interface = version == FmiVersion::two ? "fmu/fmi2.c" : "fmu/fmi3.c";
    for (std::string const& file :
         {std::string("c99/axisrt_c.c"), std::string("fmu/fmu_core.c"), interface}) {
      INFO(file);
      auto const name = file.substr(file.find('/') + 1);
      auto const preprocess = "cc -std=c99 -E -P -I " + runtime + "c99 -I " + sources + " ";
      REQUIRE(shell(preprocess + sources + "/" + name + " -o " + (folder / "of_fmu")));
      REQUIRE(shell(preprocess + runtime + file + " -o " + (folder / "of_project")));
      CHECK(folder.read("of_fmu") == folder.read("of_project"));
      auto const text = folder.read("sources/" + name);
      CHECK(text.find("/*", text.find("*/")) == std::string::npos);
    }
  }
}

TEST_CASE("equal names of axes are no FMU") {
  auto record = random_image(3);
  record.strip = false;
  for (auto& axis : record.axes) axis.name = "X";
  REQUIRE(record.axes.size() > 1);
  Loaded const image(record);
  auto const made = image::fmu_of(image.span(), image.contents, {});
  REQUIRE(std::holds_alternative<image::EqualNames>(made));
  CHECK(std::get<image::EqualNames>(made).name == "X");
}

TEST_CASE("a static block has room for the runtime of any machine") {
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    Loaded const image(random_image(seed));
    std::size_t needed = 0;
    REQUIRE(axisrt_c_memory_size(image.bytes.data(), image.bytes.size(), &needed) == AXISRT_C_OK);
    INFO("seed " << seed << ", " << needed << " bytes");
    CHECK(image::runtime_size(image.contents) >= needed);
    CHECK(image::runtime_size(image.contents) < 3 * needed + 20'000);
  }
}

TEST_CASE("zip archives are read by another program, and their bytes depend on the files alone") {
  std::vector<image::ExportedFile> files{{.name = "b/empty", .content = ""},
                                         {.name = "b/text", .content = std::string(100'000, 'x')},
                                         {.name = "a", .content = std::string("\0\xFF\x80", 3)}};
  auto const archive = image::zip_archive(files);
  std::swap(files[0], files[2]);
  CHECK(archive == image::zip_archive(files));
  CHECK(archive.size() < 1000);
  TemporaryFolder const folder;
  auto const path = folder.write("archive.zip", archive);
  REQUIRE(shell("cd " + folder.path() + " && " AXISC_CMAKE " -E tar xf " + path));
  for (auto const& file : files) CHECK(folder.read(file.name) == file.content);
}
