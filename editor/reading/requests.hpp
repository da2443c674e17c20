// What requests have in common.
#pragma once

#include "diagnostics/message.hpp"
#include "editor/reading/text_positions.hpp"

#include <stdexcept>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace axisc::editor {

using Json = nlohmann::json;

/// Why a request has no answer, in the user's language.
class RequestRefused : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A position that a client names. A Json exception where it is none: also negative and broken numbers.
[[nodiscard]] TextPosition position_in(Json const& json);

/// On one line. Bytes that are not UTF-8 are replaced.
[[nodiscard]] std::string dump(Json const& message);

[[nodiscard]] std::string say(SentenceRef sentence, Language language, std::vector<Argument> arguments = {});

}  // namespace axisc::editor
