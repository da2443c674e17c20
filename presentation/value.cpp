#include "presentation/value.hpp"

#include "diagnostics/terminal.hpp"

#include <algorithm>

namespace axisc::presentation::says {

constexpr Sentence yes{"yes", "ja"};
constexpr Sentence no{"no", "nein"};
constexpr Sentence and_more{"{numbers} and {count} more", "{numbers} und {count} weitere"};

}  // namespace axisc::presentation::says

namespace axisc::presentation {

namespace {

constexpr std::size_t most_numbers = 6;

struct TextForm {
  Language language;
  Units units;
  ForeignText foreign;

  [[nodiscard]] std::string shown(std::string const& text) const {
    return foreign != nullptr ? foreign(printable(text)) : printable(text);
  }
  std::string operator()(Nothing const& nothing) const {
    return nothing.reason ? text_of(*nothing.reason, language, foreign) : "-";
  }
  std::string operator()(bool value) const {
    return std::string(SentenceRef(value ? says::yes : says::no).in(language));
  }
  std::string operator()(std::int64_t value) const { return std::to_string(value); }
  std::string operator()(Quantity const& quantity) const {
    return units == Units::shown ? quantity_text(quantity, language) : number_text(quantity, language);
  }
  std::string operator()(std::string const& text) const { return text.empty() ? "-" : shown(text); }
  std::string operator()(Symbol const& symbol) const { return text_of(symbol.words, language, foreign); }
  std::string operator()(Words const& words) const { return text_of(words, language, foreign); }
  std::string operator()(Names const& names) const {
    std::string text;
    for (auto const& name : names) (text += text.empty() ? "" : ", ") += shown(name);
    return text.empty() ? "-" : text;
  }
  std::string operator()(Numbers const& numbers) const {
    auto const& [values, unit, digits] = numbers;
    auto const count = std::min(values.size(), most_numbers);
    // A comma is the German decimal sign.
    std::string const separator = language == Language::german ? "; " : ", ";
    std::string text;
    for (std::size_t i = 0; i < count; ++i) {
      bool const is_last = i + 1 == count;
      text += (i == 0 ? std::string() : separator) +
              (*this)(Quantity{.value = values[i], .unit = is_last ? unit : Unit::none, .digits = digits});
    }
    if (count < values.size()) {
      return text_of(Words(says::and_more, {{"numbers", text}, {"count", values.size() - count}}), language);
    }
    return text.empty() ? "-" : text;
  }
  std::string operator()(NameLists const& lists) const {
    std::string text;
    for (auto const& names : lists) (text += text.empty() ? "" : "; ") += (*this)(names);
    return text.empty() ? "-" : text;
  }
  std::string operator()(Wording const& wording) const { return printable(wording.in(language)); }
  std::string operator()(Link const& link) const { return (*this)(link.text); }
};

}  // namespace

Words::Words(Sentence const& only) : sentence(only) {}
Words::Words(SentenceRef only) : sentence(only) {}
Words::Words(SentenceRef with, std::vector<NamedValue> filled) : sentence(with), values(std::move(filled)) {}
Words::Words(Message const& message) : sentence(message.sentence) {
  for (auto const& [name, value] : message.arguments) values.push_back({name, value});
}
Words::Words(Words const& other) = default;
Words::Words(Words&& other) noexcept = default;
Words& Words::operator=(Words const& other) = default;
Words& Words::operator=(Words&& other) noexcept = default;
Words::~Words() = default;

Words as_given(Value text) {
  return {axisc::says::as_given, {{"text", std::move(text)}}};
}

bool Value::is_blank() const {
  return std::visit(
      []<class Form>(Form const& form) {
        if constexpr (requires { form.empty(); }) return form.empty();
        if constexpr (requires { form.reason; }) return !form.reason;
        if constexpr (std::same_as<Form, Numbers>) return form.values.empty();
        return false;
      },
      form_);
}

Value quantity_or(Nothing nothing, std::optional<double> value, Unit unit, Digits digits) {
  if (!value) return nothing;
  return Quantity{.value = *value, .unit = unit, .digits = digits};
}

std::string text_of(Value const& value, Language language, Units units, ForeignText foreign) {
  return std::visit(TextForm{.language = language, .units = units, .foreign = foreign}, value.form());
}

namespace {

/// Whether the sentence has the value between backquotes, where a format that knows markup has none.
bool is_code(std::string_view sentence, std::string_view name) {
  auto const at = sentence.find("{" + std::string(name) + "}");
  auto const before = sentence.substr(0, at);
  return at != std::string_view::npos && std::count(before.begin(), before.end(), '`') % 2 == 1;
}

/// A backquote would end the code.
std::string in_code(std::string_view text) {
  std::string shown(text);
  std::replace(shown.begin(), shown.end(), '`', '\'');
  return shown;
}

}  // namespace

std::string text_of(Words const& words, Language language, ForeignText foreign) {
  Message message{words.sentence};
  for (auto const& [name, value] : words.values) {
    auto const* const wording = std::get_if<Wording>(&value.form());
    auto const how = foreign != nullptr && is_code(words.sentence.in(language), name) ? in_code : foreign;
    message.arguments.push_back(
        {name, wording != nullptr ? *wording : text_of(value, language, Units::shown, how)});
  }
  return render(message, language, Values::printable);
}

Wording wording_of(Words const& words) {
  return {text_of(words, Language::english), text_of(words, Language::german)};
}

}  // namespace axisc::presentation
