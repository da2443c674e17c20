// Language and colours as the environment sets them.
#pragma once

#include "diagnostics/message.hpp"
#include "system/process.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace axisc::cli {

enum class ColorChoice : std::uint8_t { automatic, always, never };

/// `--lang` among the arguments, else the first of LC_ALL, LC_MESSAGES and LANG that is set, else English.
/// Read before the other options, so that messages about them are already in that language.
[[nodiscard]] Language choose_language(std::span<std::string const> arguments);

/// Automatic: only on a terminal, without NO_COLOR, and not on a dumb one.
[[nodiscard]] bool use_color(ColorChoice choice, system::Stream stream);

}  // namespace axisc::cli
