#include "diagnostics/writers/json_layout.hpp"

#include "diagnostics/writers/json_stream.hpp"

#include <algorithm>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

namespace axisc {

void append_indented(std::string& text, nlohmann::ordered_json const& value, std::string_view indent) {
  std::string const dumped =
      escape_invisible(value.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
  std::string_view rest = dumped;
  // Line breaks inside strings are escaped, so every one here is between tokens.
  while (true) {
    std::size_t const end = std::min(rest.find('\n'), rest.size() - 1) + 1;
    text.append(rest.substr(0, end));
    rest.remove_prefix(end);
    if (rest.empty()) return;
    text.append(indent);
  }
}

}  // namespace axisc
