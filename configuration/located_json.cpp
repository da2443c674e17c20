#include "configuration/located_json.hpp"

#include "diagnostics/ascii.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

namespace axisc::configuration::says {

constexpr Sentence trailing_comma{"JSON has no comma after the last entry",
                                  "in JSON steht nach dem letzten Eintrag kein Komma"};
constexpr Sentence comment{"JSON has no comments", "JSON hat keine Kommentare"};
constexpr Sentence single_quotes{"JSON has texts in double quotes",
                                 "in JSON stehen Texte in doppelten Anführungszeichen"};
constexpr Sentence missing_comma{"a comma is missing before this", "davor fehlt ein Komma"};
constexpr Sentence bare_word{
    "texts and keys are in double quotes; the only bare words are true, false and null",
    "Texte und Schlüssel stehen in doppelten Anführungszeichen; ohne stehen nur true, false und null"};
constexpr Sentence too_deep{"JSON is read up to {most} nested brackets",
                            "JSON wird bis zu {most} ineinandergeschachtelten Klammern gelesen"};

}  // namespace axisc::configuration::says

namespace axisc::configuration {
namespace {

using Json = nlohmann::json;

/// Walks over the tokens of a text that the parser has already accepted, one token per event.
class TokenCursor {
 public:
  TokenCursor(std::string_view bytes, std::uint32_t begin) : bytes_(bytes), next_(begin) {}

  Span next() {
    std::size_t const begin = begin_of_next();
    std::size_t const end = end_of_token(begin);
    next_ = end;
    return span(begin, end);
  }

  /// Where and why the parser stopped, `stop` bytes into the text at the latest.
  [[nodiscard]] JsonError failure(std::size_t stop) const {
    Span const token = failing_token(stop);
    if (token.empty()) return {.span = token};
    char const first = bytes_[token.begin];
    std::size_t const before = bytes_.find_last_not_of(" \t\r\n", token.begin == 0 ? 0 : token.begin - 1);
    char const previous = token.begin == 0 || before == std::string_view::npos ? '{' : bytes_[before];
    auto const because = [&](SentenceRef reason) {
      return JsonError{.span = token, .reason = Message{reason}};
    };
    bool const closes = first == '}' || first == ']';
    if (closes && previous == ',') return because(says::trailing_comma);
    if (first == '/' || first == '#') return because(says::comment);
    if (first == '\'') return because(says::single_quotes);
    if (!closes && std::string_view("{[,:").find(previous) == std::string_view::npos) {
      return because(says::missing_comma);
    }
    if (ascii::is_letter(first)) return because(says::bare_word);
    return {.span = token};
  }

 private:
  /// The token at which the parser stopped, `stop` bytes into the text at the latest.
  [[nodiscard]] Span failing_token(std::size_t stop) const {
    std::size_t const begin = std::min({begin_of_next(), stop, bytes_.size()});
    std::size_t const end = std::min(end_of_token(begin), bytes_.find_first_of("\r\n", begin));
    return span(begin, std::min(end, bytes_.size()));
  }

  static Span span(std::size_t begin, std::size_t end) {
    return {.begin = static_cast<std::uint32_t>(begin), .end = static_cast<std::uint32_t>(end)};
  }

  [[nodiscard]] std::size_t begin_of_next() const {
    return std::min(bytes_.find_first_not_of(" \t\r\n,:", next_), bytes_.size());
  }

  [[nodiscard]] std::size_t end_of_token(std::size_t begin) const {
    if (begin >= bytes_.size()) return bytes_.size();
    char const first = bytes_[begin];
    if (first == '"') {
      std::size_t i = begin + 1;
      while (i < bytes_.size() && bytes_[i] != '"') i += bytes_[i] == '\\' ? 2U : 1U;
      return std::min(i + 1, bytes_.size());
    }
    if (std::string_view("{}[],:").find(first) != std::string_view::npos) return begin + 1;
    return std::min(bytes_.find_first_of(" \t\r\n,:{}[]\"", begin), bytes_.size());
  }

  std::string_view bytes_;
  std::size_t next_;
};

/// nlohmann's event interface, which prescribes these names.
class TreeBuilder {
 public:
  TreeBuilder(std::string_view bytes, std::uint32_t begin) : cursor_(bytes, begin), begin_(begin) {}

  bool null() { return add(JsonKind::null) != nullptr; }
  bool boolean(bool value) {
    add(JsonKind::boolean)->flag = value;
    return true;
  }
  bool number_integer(Json::number_integer_t value) { return number(static_cast<double>(value)); }
  bool number_unsigned(Json::number_unsigned_t value) { return number(static_cast<double>(value)); }
  bool number_float(Json::number_float_t value, Json::string_t const& /*text*/) { return number(value); }
  bool string(Json::string_t const& value) {
    add(JsonKind::string)->string = value;
    return true;
  }
  static bool binary(Json::binary_t const& /*value*/) { return false; }
  bool start_object(std::size_t /*elements*/) { return open(JsonKind::object); }
  bool key(Json::string_t const& value) {
    key_ = value;
    key_span_ = cursor_.next();
    return true;
  }
  bool end_object() { return close(); }
  bool start_array(std::size_t /*elements*/) { return open(JsonKind::array); }
  bool end_array() { return close(); }
  bool parse_error(std::size_t position, std::string const& /*token*/, Json::exception const& /*reason*/) {
    error_ = cursor_.failure(begin_ + (position == 0 ? 0 : position - 1));
    return false;
  }

  std::variant<JsonDocument, JsonError> result() {
    if (error_) return *error_;
    return std::move(document_);
  }

 private:
  JsonValue* add(JsonKind kind) {
    std::size_t const index = document_.values.size();
    JsonValue& value = document_.values.emplace_back();
    value.kind = kind;
    value.span = cursor_.next();
    if (!open_.empty()) {
      JsonValue& parent = document_.values[open_.back()];
      if (parent.kind == JsonKind::array) {
        parent.items.push_back(index);
      } else {
        parent.members.push_back({.key = key_, .key_span = key_span_, .value = index});
      }
    }
    return &document_.values[index];
  }

  bool number(double value) {
    add(JsonKind::number)->number = value;
    return true;
  }

  bool open(JsonKind kind) {
    JsonValue const* const value = add(kind);
    if (open_.size() >= deepest_json) {
      error_ = JsonError{.span = value->span,
                         .reason = Message{says::too_deep, {{"most", std::to_string(deepest_json)}}}};
      return false;
    }
    open_.push_back(document_.values.size() - 1);
    return true;
  }

  bool close() {
    cursor_.next();
    open_.pop_back();
    return true;
  }

  TokenCursor cursor_;
  std::size_t begin_;
  JsonDocument document_;
  std::vector<std::size_t> open_;
  std::string key_;
  Span key_span_;
  std::optional<JsonError> error_;
};

}  // namespace

JsonMember const* JsonValue::find(std::string_view key) const {
  auto const found =
      std::find_if(members.begin(), members.end(), [key](JsonMember const& each) { return each.key == key; });
  return found == members.end() ? nullptr : &*found;
}

std::variant<JsonDocument, JsonError> parse_json(std::string_view bytes, std::uint32_t text_begin) {
  TreeBuilder builder(bytes, text_begin);
  std::string_view const text = bytes.substr(text_begin);
  if (text.empty()) return JsonError{};
  Json::sax_parse(text.begin(), text.end(), &builder);
  return builder.result();
}

}  // namespace axisc::configuration
