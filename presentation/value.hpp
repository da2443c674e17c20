// Values of an answer, and sentences about them. Neither knows its language: it is chosen when they are
// written.
#pragma once

#include "diagnostics/message.hpp"
#include "diagnostics/wording.hpp"
#include "presentation/quantity.hpp"

#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace axisc::presentation {

struct NamedValue;

/// A sentence with values in its placeholders.
struct Words {
  SentenceRef sentence;
  std::vector<NamedValue> values;

  // Not explicit: most labels are a sentence without values.
  Words(Sentence const& only);
  Words(SentenceRef only);
  Words(SentenceRef with, std::vector<NamedValue> filled);
  Words(Message const& message);
  // In the source, where the values' type is complete.
  Words(Words const& other);
  Words(Words&& other) noexcept;
  Words& operator=(Words const& other);
  Words& operator=(Words&& other) noexcept;
  ~Words();
};

/// There is no value: null for programs; for people the reason, or "-", or an empty cell.
struct Nothing {
  std::optional<Words> reason = {};
};

/// A member of a closed set: a symbol for programs, words for people.
struct Symbol {
  std::string_view symbol;
  Words words;
};

using Names = std::vector<std::string>;
using NameLists = std::vector<Names>;

/// In JSON an array; people see the first of many.
struct Numbers {
  std::vector<double> values;
  Unit unit = Unit::none;
  Digits digits = {};
};

/// A text that leads to the section of that id.
struct Link {
  std::string text;
  std::string id;
};

/// The content of a field or a cell. Texts are foreign, names and the like: people see their printable form.
class Value {
 public:
  using Form = std::variant<Nothing, bool, std::int64_t, Quantity, std::string, Symbol, Words, Names, Numbers,
                            NameLists, Wording, Link>;

  Value() = default;
  Value(Nothing nothing) : form_(std::move(nothing)) {}
  // Not explicit: rows of tables are written as lists of values.
  Value(Quantity quantity) : form_(quantity) {}
  Value(std::string text) : form_(std::move(text)) {}
  Value(char const* text) : form_(std::string(text)) {}
  Value(std::string_view text) : form_(std::string(text)) {}
  Value(Symbol symbol) : form_(std::move(symbol)) {}
  Value(Words words) : form_(std::move(words)) {}
  Value(Names names) : form_(std::move(names)) {}
  Value(Numbers numbers) : form_(std::move(numbers)) {}
  Value(Wording wording) : form_(std::move(wording)) {}
  Value(Link link) : form_(std::move(link)) {}
  Value(NameLists lists) : form_(std::move(lists)) {}
  Value(double number) : form_(Quantity{.value = number}) {}
  /// Nothing without a reason where there is none.
  template <class Known>
  Value(std::optional<Known> const& known) {
    if (known) *this = Value(*known);
  }
  template <std::integral Number>
  Value(Number number) {
    if constexpr (std::same_as<Number, bool>) {
      form_ = number;
    } else {
      form_ = static_cast<std::int64_t>(number);
    }
  }

  [[nodiscard]] Form const& form() const { return form_; }
  /// Right-aligned in its column, for people.
  [[nodiscard]] bool is_number() const {
    return std::holds_alternative<Quantity>(form_) || std::holds_alternative<std::int64_t>(form_);
  }
  [[nodiscard]] bool is_nothing() const { return std::holds_alternative<Nothing>(form_); }
  /// Nothing, and no reason to show, or a text or list without anything in it.
  [[nodiscard]] bool is_blank() const;

 private:
  Form form_;
};

/// The quantity, or nothing.
[[nodiscard]] Value quantity_or(Nothing nothing, std::optional<double> value, Unit unit = Unit::none,
                                Digits digits = {});

/// The value of a placeholder.
struct NamedValue {
  std::string_view name;
  Value value;
};

/// A text that is the same in both languages, where a sentence is wanted.
[[nodiscard]] Words as_given(Value text);

enum class Units : std::uint8_t {
  shown,
  in_heading,  ///< the heading of the column has it
};

/// What a format does to texts that are not the program's own: names, values of lists.
using ForeignText = std::string (*)(std::string_view printable);

/// For people: one line, printable.
[[nodiscard]] std::string text_of(Value const& value, Language language, Units units = Units::shown,
                                  ForeignText foreign = nullptr);
[[nodiscard]] std::string text_of(Words const& words, Language language, ForeignText foreign = nullptr);
[[nodiscard]] Wording wording_of(Words const& words);

}  // namespace axisc::presentation
