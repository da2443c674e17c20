// The variables of a machine's FMU, whatever the FMI version.
#pragma once

#include "image/image_contents.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace axisc::image {

enum class FmiVersion : std::uint8_t { two = 2, three = 3 };
enum class FmuType : std::uint8_t { real, boolean, enumeration };
enum class FmuCausality : std::uint8_t { input, output };

struct FmuVariable {
  std::string name;             ///< quoted where it has to be
  std::uint32_t reference = 0;  ///< as runtime/fmu/fmu_core.h numbers them
  FmuCausality causality = FmuCausality::input;
  FmuType type = FmuType::real;
  std::string_view unit{};    ///< key of fmu_units; empty for a number without one
  std::string enumeration{};  ///< name of its type
  std::string description;
};

/// 1 unit = factor m, rad, m/s or rad/s; people see it in another unit.
struct FmuUnit {
  std::string_view name;
  char const* length;  ///< exponents of the SI: "1", or null
  char const* angle;
  char const* time;
  std::string_view factor;
  std::string_view shown, shown_factor;
};

struct FmuEnumeration {
  std::string name;
  std::vector<std::pair<std::string, std::uint32_t>> items;
};

/// A description that both versions of the FMI are written from.
struct FmuModel {
  std::string identifier;  ///< of C: file names and prefix of functions
  std::string token;       ///< first 16 bytes of the image's SHA-256, in hexadecimal
  std::string period;      ///< NC cycle time in seconds
  std::string description;
  bool is_structured = true;  ///< every name follows the structured naming convention
  std::vector<FmuVariable> variables;
  std::vector<FmuUnit> units;  ///< that variables have
  std::vector<FmuEnumeration> enumerations;
};

/// Two axes or two channels have this name, so that their variables could not be told apart.
struct EqualNames {
  std::string name;
};

struct FmuOptions {
  FmiVersion version = FmiVersion::three;
  std::string name{};           ///< of the model; usually the output's file name
  std::string tool{};           ///< "axisc 0.2.0"
  bool complete = false;        ///< the image keeps names, self-tests, lists and values
  bool plain_integers = false;  ///< instead of booleans and enumerations
};

/// `image`: the bytes that the FMU will contain.
[[nodiscard]] std::variant<FmuModel, EqualNames> fmu_model(std::span<std::byte const> image,
                                                           ImageContents const& contents,
                                                           FmuOptions const& options);

/// Numbers of the settings of a channel's filters: 0 as at start, 1 OFF, where it has guards 2 VIB GUARD OFF,
/// then its banks.
[[nodiscard]] FmuEnumeration filter_settings(std::string name, ImageGroup const& group);

}  // namespace axisc::image
