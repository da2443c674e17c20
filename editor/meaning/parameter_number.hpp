// Parameter numbers in references and comments: P-AXIS-00140, P-CHAN-00035.
#pragma once

#include "schema/list_kind.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace axisc::editor {

struct ParameterNumber {
  schema::ListKind kind{};
  std::uint16_t number = 0;
  std::size_t begin = 0;  ///< in bytes
  std::size_t end = 0;
};

/// The number around a byte of the text, or right before it.
[[nodiscard]] std::optional<ParameterNumber> parameter_number_at(std::string_view text, std::size_t offset);

}  // namespace axisc::editor
