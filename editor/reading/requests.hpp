// Helpers for requests: reading positions, refusing, writing JSON and sentences.
#pragma once

#include "diagnostics/message.hpp"
#include "editor/reading/text_positions.hpp"

#include <stdexcept>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace axisc::editor {

using Json = nlohmann::json;

/// The reason why a request fails, in the user's language.
class RequestRefused : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Throws an exception of Json if it is not a position: negative and fractional numbers are not.
[[nodiscard]] TextPosition position_in(Json const& json);

/// In one line; invalid UTF-8 is replaced.
[[nodiscard]] std::string dump(Json const& message);

[[nodiscard]] std::string say(SentenceRef sentence, Language language, std::vector<Argument> arguments = {});

}  // namespace axisc::editor
