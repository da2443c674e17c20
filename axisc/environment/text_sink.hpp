// Where the library's text goes: it prints nothing itself.
#pragma once

#include <functional>
#include <string_view>

namespace axisc {

/// Receives text piece by piece.
using TextSink = std::function<void(std::string_view)>;

}  // namespace axisc
