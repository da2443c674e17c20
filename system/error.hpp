// Errors of the operating system.
#pragma once

#include <cstdint>
#include <string>
#include <variant>

namespace axisc::system {

/// Reasons that callers distinguish; every other error is `other` and has the system's own words.
enum class Refusal : std::uint8_t {
  not_found,
  exists,
  is_folder,
  no_permission,
  read_only,
  no_space,
  closed_pipe,
  not_open,
  link_loop,
  other,
};

struct Error {
  Refusal refusal = Refusal::other;
  int number = 0;  ///< the system's own
};

/// In the system's words: "No space left on device".
[[nodiscard]] std::string text_of(Error const& error);

template <typename Value>
using Result = std::variant<Value, Error>;

}  // namespace axisc::system
