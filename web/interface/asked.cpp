#include "web/interface/asked.hpp"

#include <nlohmann/json.hpp>

namespace axisc::says {

constexpr Sentence unknown_word{R"("{key}" cannot be "{word}": {known})",
                                R"("{key}" kann nicht "{word}" sein: {known})"};
constexpr Sentence unknown_key{R"(there is no "{key}" here: {known})",
                               R"("{key}" gibt es hier nicht: {known})"};
constexpr Sentence no_texts{"options and questions are JSON objects whose values are texts",
                            "Optionen und Fragen sind JSON-Objekte, deren Werte Texte sind"};

}  // namespace axisc::says

namespace axisc::web {

Asked::Asked(std::string const& json) {
  auto const values = nlohmann::json::parse(json, nullptr, false);
  auto const refuse = [] { return Failure({says::no_texts}); };
  if (!values.is_object()) throw refuse();
  for (auto const& [key, value] : values.items()) {
    if (value.is_null()) continue;
    if (!value.is_string()) throw refuse();
    values_.emplace(key, value.get<std::string>());
  }
}

std::optional<std::string> Asked::find(std::string const& key) const {
  auto const found = values_.find(key);
  return found == values_.end() ? std::nullopt : std::optional(found->second);
}

void Asked::refuse_others(std::string_view keys) const {
  auto const words = " " + std::string(keys) + " ";
  for (auto const& [key, value] : values_) {
    if (words.find(" " + key + " ") != std::string::npos) continue;
    throw Failure({says::unknown_key, {{"key", key}, {"known", std::string(keys)}}});
  }
}

Failure Asked::unknown_word(std::string const& key, std::string const& word, std::string const& known) {
  return Failure({says::unknown_word, {{"key", key}, {"word", word}, {"known", known}}});
}

}  // namespace axisc::web
