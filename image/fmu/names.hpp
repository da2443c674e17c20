// Names in a modelDescription.xml.
#pragma once

#include <string>
#include <string_view>

namespace axisc::image {

/// An identifier of C as it is, any other name between single quotes, as the structured naming convention of
/// FMI 2.0 and 3.0 demands: "X", "'Achse 1'". Control characters become blanks.
[[nodiscard]] std::string quoted_name(std::string_view name);

/// The convention knows letters of ASCII only.
[[nodiscard]] bool is_ascii(std::string_view name);

/// A C identifier that resembles the name: letters, digits and `_`, no digit first; "model" for an empty
/// name.
[[nodiscard]] std::string identifier(std::string_view name);

}  // namespace axisc::image
