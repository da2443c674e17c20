#include "axisc/interface/asked.hpp"

#include <utility>

#include <nlohmann/json.hpp>

namespace axisc::says {

constexpr Sentence unknown_word{R"("{key}" cannot be "{word}": {known})",
                                R"("{key}" kann nicht "{word}" sein: {known})"};
constexpr Sentence unknown_key{R"(there is no "{key}" here: {known})",
                               R"("{key}" gibt es hier nicht: {known})"};
constexpr Sentence no_texts{
    "options and questions are JSON objects whose values are texts, or arrays of texts",
    "Optionen und Fragen sind JSON-Objekte, deren Werte Texte oder Arrays von Texten sind"};
constexpr Sentence one_text{R"("{key}" is one text, not several)", R"("{key}" ist ein Text, nicht mehrere)"};
constexpr Sentence no_messages{"messages are a JSON array of texts",
                               "Nachrichten sind ein JSON-Array von Texten"};

}  // namespace axisc::says

namespace axisc::interface {

namespace {

using Texts = std::vector<std::string>;

/// None where it is anything else.
std::optional<Texts> texts_in(nlohmann::json const& array) {
  Texts texts;
  if (!array.is_array()) return std::nullopt;
  for (auto const& value : array) {
    if (!value.is_string()) return std::nullopt;
    texts.push_back(value.get<std::string>());
  }
  return texts;
}

}  // namespace

Asked::Asked(char const* json, std::optional<std::string_view> keys) {
  if (json == nullptr) return;
  auto const values = nlohmann::json::parse(json, nullptr, false);
  if (!values.is_object()) throw BadArgument({says::no_texts});
  for (auto const& [key, value] : values.items()) {
    if (value.is_null()) continue;
    auto texts = value.is_string() ? Texts{value.get<std::string>()} : texts_in(value);
    if (!texts) throw BadArgument({says::no_texts});
    values_.emplace(key, std::move(*texts));
  }
  if (keys) refuse_others(*keys);
}

std::optional<std::string> Asked::find(std::string const& key) const {
  auto const all = texts(key);
  if (all.size() > 1) throw BadArgument({says::one_text, {{"key", key}}});
  return all.empty() ? std::nullopt : std::optional(all.front());
}

std::vector<std::string> Asked::texts(std::string const& key) const {
  auto const found = values_.find(key);
  return found == values_.end() ? Texts() : found->second;
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
  auto texts = texts_in(nlohmann::json::parse(json, nullptr, false));
  if (!texts) throw BadArgument({says::no_messages});
  return std::move(*texts);
}

}  // namespace axisc::interface
