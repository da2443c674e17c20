// SHA-256 over the sources of an image: names and bytes of its lists, never their location.
#pragma once

#include "configuration/machine/machine.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace axisc::codegen {

using Sha256 = std::array<std::uint8_t, 32>;

[[nodiscard]] Sha256 sha256(std::string_view bytes);
/// The digest of one source's bytes.
[[nodiscard]] Sha256 sha256(machine::MachineList const& list);

/// The digest of each list's name, a zero byte, its size as little-endian u64, its bytes.
[[nodiscard]] Sha256 source_digest(std::span<machine::MachineList const> lists);

/// "0123abcd…".
[[nodiscard]] std::string hexadecimal(std::span<std::uint8_t const> bytes);

}  // namespace axisc::codegen
