// Text in XML and HTML.
#pragma once

#include <string>
#include <string_view>

namespace axisc {

/// For text between tags and in attributes in double quotes; the text must be printable, see terminal.hpp.
[[nodiscard]] std::string escaped(std::string_view text);

}  // namespace axisc
