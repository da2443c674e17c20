// An FMU in a folder, compiled as an importer compiles it, and executed by tests/fmu/importer.c.
#pragma once

#include "image/fmu/model.hpp"
#include "support/temporary_folder.hpp"

#include <map>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace axisc::test {

/// How compilers are called: with every warning that counts as an error.
inline constexpr std::string_view strict_c =
    "cc -std=c99 -pedantic -Wall -Wextra -Werror -ffp-contract=off -O1";

/// Runs a line of the shell; whether it succeeded. What it prints is captured on failure.
[[nodiscard]] bool shell(std::string const& line);
/// A program of this name is on PATH.
[[nodiscard]] bool is_installed(std::string const& program);

/// Unpacked FMU: files below `folder`.
class UnpackedFmu {
 public:
  /// `folder` has modelDescription.xml.
  UnpackedFmu(std::string folder, image::FmiVersion version);

  /// Compiles its listed sources; those that are the same for every machine only once in a test program.
  void compile() const;
  /// "f17", as the importer takes it; empty for an unknown name.
  [[nodiscard]] std::string variable(std::string const& name) const;
  [[nodiscard]] std::vector<std::string> outputs() const;
  /// Lines that the importer prints. `token`: another one than that of the image.
  [[nodiscard]] std::vector<std::string> run(std::string const& scenario,
                                             std::vector<std::string> const& outputs,
                                             std::string const& token = "") const;

  std::string folder;
  image::FmiVersion version;
  pugi::xml_document description;
  std::map<std::string, std::string> variables;
};

/// A number as the importer reads and prints it, every bit of it.
[[nodiscard]] std::string hexadecimal(double value);
/// The numbers of a line.
[[nodiscard]] std::vector<double> numbers_of(std::string const& line);

}  // namespace axisc::test
