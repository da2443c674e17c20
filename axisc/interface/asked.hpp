// JSON objects whose values are texts, or arrays of them: options and questions.
#pragma once

#include "axisc/environment/failure.hpp"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace axisc::interface {

/// Words for what is off unless it is asked for.
inline constexpr std::array no_or_yes = {std::pair(std::string_view("no"), false),
                                         std::pair(std::string_view("yes"), true)};

/// Of the caller's program, not of files: AXISC_BAD_ARGUMENT.
class BadArgument : public Failure {
 public:
  using Failure::Failure;
};

/// A BadArgument names what is wrong with the object, and what would be right.
class Asked {
 public:
  /// Null: an object without keys. `keys`: all that there may be, with blanks between them; for a question,
  /// refuse_others() tells them.
  explicit Asked(char const* json) : Asked(json, {}) {}
  Asked(char const* json, std::optional<std::string_view> keys);

  /// BadArgument where there are several.
  [[nodiscard]] std::optional<std::string> find(std::string const& key) const;
  [[nodiscard]] std::string text(std::string const& key) const { return find(key).value_or(""); }
  /// All that the key has.
  [[nodiscard]] std::vector<std::string> texts(std::string const& key) const;

  /// The value of the row with the key's word; the first row's where there is no such key.
  template <typename Rows>
  [[nodiscard]] auto word(std::string const& key, Rows const& rows) const {
    auto const wanted = find(key);
    std::string known;
    for (auto const& [word, value] : rows) {
      if (!wanted || *wanted == word) return value;
      known.append(known.empty() ? "" : ", ").append(word);
    }
    throw unknown_word(key, *wanted, known);
  }

  void refuse_others(std::string_view keys) const;

  [[nodiscard]] static BadArgument unknown_word(std::string const& key, std::string const& word,
                                                std::string const& known);

 private:
  std::map<std::string, std::vector<std::string>> values_;
};

/// A JSON array of texts.
[[nodiscard]] std::vector<std::string> asked_texts(char const* json);

}  // namespace axisc::interface
