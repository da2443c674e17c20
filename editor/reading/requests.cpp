#include "editor/reading/requests.hpp"

#include <utility>

#include <nlohmann/json.hpp>

namespace axisc::editor {

TextPosition position_in(Json const& json) {
  auto const count = [&json](char const* key) {
    return static_cast<std::size_t>(json.at(key).get_ref<Json::number_unsigned_t const&>());
  };
  return {.line = count("line"), .character = count("character")};
}

std::string dump(Json const& message) {
  return message.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string say(SentenceRef sentence, Language language, std::vector<Argument> arguments) {
  return render({sentence, std::move(arguments)}, language);
}

}  // namespace axisc::editor
