// How a content security policy names the script that it lets run.
#pragma once

#include <string>
#include <string_view>

namespace axisc {

/// "sha256-" and the digest in Base64, of the script as UTF-8 with line feeds.
[[nodiscard]] std::string script_digest(std::string_view script);

}  // namespace axisc
