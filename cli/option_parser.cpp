#include "cli/option_parser.hpp"

#include <algorithm>
#include <cstddef>

namespace axisc::cli {

namespace {

/// "--name" or "-n", perhaps with more behind it; negative numbers are none.
bool is_option(std::string_view word) {
  if (word.size() < 2 || word.front() != '-') return false;
  bool const is_long = word.starts_with("--");
  if (is_long && word.size() == 2) return false;
  char const first = word[is_long ? 2 : 1];
  bool const is_digit = '0' <= first && first <= '9';
  return first != '-' && first != ' ' && first != '\n' && (is_long || !is_digit);
}

/// Calls `look` with each name until it gives true.
template <class Look>
bool any_name(OptionWords const& option, Look look) {
  for (std::string_view rest = option.names; !rest.empty();) {
    auto const comma = std::min(rest.find(','), rest.size());
    if (look(rest.substr(0, comma))) return true;
    rest.remove_prefix(std::min(comma + 1, rest.size()));
  }
  return false;
}

class Parser {
 public:
  Parser(std::span<std::string const> words, std::span<OptionWords> options)
      : words_(words), options_(options) {}

  std::vector<std::string> read() && {
    while (next_ < words_.size()) {
      auto const& word = words_[next_++];
      if (word == "--") {
        while (next_ < words_.size()) take_argument(words_[next_++]);
      } else if (!is_option(word)) {
        take_argument(word);
      } else if (word.starts_with("--")) {
        take_long(word);
      } else {
        take_short(word);
      }
    }
    return std::move(left_over_);
  }

 private:
  OptionWords* find(std::string_view name) {
    auto const found = std::find_if(options_.begin(), options_.end(), [name](OptionWords const& option) {
      return any_name(option, [name](std::string_view known) { return known == name; });
    });
    return found == options_.end() ? nullptr : &*found;
  }

  void take_argument(std::string const& word) {
    auto const taker = std::find_if(options_.begin(), options_.end(), [](OptionWords const& option) {
      return option.kind == OptionKind::arguments ||
             (option.kind == OptionKind::argument && option.given.empty());
    });
    (taker == options_.end() ? left_over_ : taker->given).push_back(word);
  }

  void take_long(std::string const& word) {
    auto const equals = std::min(word.find('='), word.size());
    auto* const option = find(std::string_view(word).substr(0, equals));
    if (option == nullptr) {
      left_over_.push_back(word);
      return;
    }
    auto const behind = std::string_view(word).substr(std::min(equals + 1, word.size()));
    if (option->kind == OptionKind::value) {
      take_value(*option, behind);
    } else if (option->kind == OptionKind::flag && !behind.empty()) {
      throw WrongValue{option};
    } else {
      option->given.emplace_back(behind);
    }
  }

  void take_short(std::string const& word) {
    std::string_view rest(word);
    for (rest.remove_prefix(1); !rest.empty();) {
      auto* const option = find(std::string{'-', rest.front()});
      if (option == nullptr) {
        left_over_.push_back("-" + std::string(rest));
        return;
      }
      rest.remove_prefix(1);
      if (option->kind == OptionKind::value) return take_value(*option, rest);
      option->given.emplace_back();
    }
  }

  /// `behind` the name in the same word, or the next word.
  void take_value(OptionWords& option, std::string_view behind) {
    if (!behind.empty()) {
      option.given.emplace_back(behind);
    } else if (next_ < words_.size()) {
      option.given.push_back(words_[next_++]);
    } else {
      throw WrongValue{&option};
    }
  }

  std::span<std::string const> words_;
  std::span<OptionWords> options_;
  std::size_t next_ = 0;
  std::vector<std::string> left_over_;
};

}  // namespace

std::string_view full_name(OptionWords const& option) {
  std::string_view name;
  any_name(option, [&name](std::string_view known) {
    name = known;
    return known.starts_with("--");
  });
  return name;
}

std::vector<std::string_view> names_of(OptionWords const& option) {
  std::vector<std::string_view> names;
  any_name(option, [&names](std::string_view name) {
    names.push_back(name);
    return false;
  });
  return names;
}

std::vector<std::string> take_apart(std::span<std::string const> words, std::span<OptionWords> options) {
  return Parser(words, options).read();
}

}  // namespace axisc::cli
