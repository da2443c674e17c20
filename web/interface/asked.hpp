// JSON objects whose values are texts: options and questions.
#pragma once

#include "axisc/environment/failure.hpp"

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace axisc::web {

/// A Failure names what is wrong with the object, and what would be right.
class Asked {
 public:
  explicit Asked(std::string const& json);

  [[nodiscard]] std::optional<std::string> find(std::string const& key) const;
  [[nodiscard]] std::string text(std::string const& key) const { return find(key).value_or(""); }

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

  /// `keys`: all that there may be, with blanks between them.
  void refuse_others(std::string_view keys) const;

 private:
  [[nodiscard]] static Failure unknown_word(std::string const& key, std::string const& word,
                                            std::string const& known);

  std::map<std::string, std::string> values_;
};

}  // namespace axisc::web
