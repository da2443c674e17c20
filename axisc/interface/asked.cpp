#include "axisc/interface/asked.hpp"

#include <nlohmann/json.hpp>

namespace axisc::says {

constexpr Sentence unknown_word{R"("{key}" cannot be "{word}": {known})",
                                R"("{key}" kann nicht "{word}" sein: {known})"};
constexpr Sentence unknown_key{R"(there is no "{key}" here: {known})",
                               R"("{key}" gibt es hier nicht: {known})"};
constexpr Sentence no_texts{"options and questions are JSON objects whose values are texts",
                            "Optionen und Fragen sind JSON-Objekte, deren Werte Texte sind"};
constexpr Sentence no_messages{"messages are a JSON array of texts",
                               "Nachrichten sind ein JSON-Array von Texten"};

}  // namespace axisc::says

namespace axisc::interface {

Asked::Asked(char const* json, std::optional<std::string_view> keys) {
  if (json == nullptr) return;
  auto const values = nlohmann::json::parse(json, nullptr, false);
  if (!values.is_object()) throw BadArgument({says::no_texts});
  for (auto const& [key, value] : values.items()) {
    if (value.is_null()) continue;
    if (!value.is_string()) throw BadArgument({says::no_texts});
    values_.emplace(key, value.get<std::string>());
  }
  if (keys) refuse_others(*keys);
}

std::optional<std::string> Asked::find(std::string const& key) const {
  auto const found = values_.find(key);
  return found == values_.end() ? std::nullopt : std::optional(found->second);
}

void Asked::refuse_others(std::string_view keys) const {
  auto const words = " " + std::string(keys) + " ";
  for (auto const& [key, value] : values_) {
    bool const is_known =
        key.find(' ') == std::string::npos && words.find(" " + key + " ") != std::string::npos;
    if (is_known) continue;
    throw BadArgument({says::unknown_key, {{"key", key}, {"known", std::string(keys)}}});
  }
}

BadArgument Asked::unknown_word(std::string const& key, std::string const& word, std::string const& known) {
  return BadArgument({says::unknown_word, {{"key", key}, {"word", word}, {"known", known}}});
}

std::vector<std::string> asked_texts(char const* json) {
  auto const values = nlohmann::json::parse(json, nullptr, false);
  std::vector<std::string> texts;
  if (!values.is_array()) throw BadArgument({says::no_messages});
  for (auto const& value : values) {
    if (!value.is_string()) throw BadArgument({says::no_messages});
    texts.push_back(value.get<std::string>());
  }
  return texts;
}

}  // namespace axisc::interface
