#include "presentation/value.hpp"

#include "diagnostics/message.hpp"
#include "diagnostics/terminal.hpp"

namespace axisc::presentation::says {

constexpr Sentence yes{"yes", "ja"};
constexpr Sentence no{"no", "nein"};

}  // namespace axisc::presentation::says

namespace axisc::presentation {

namespace {

struct TextForm {
  Language language;
  Units units;

  std::string operator()(Nothing const& nothing) const {
    return nothing.reason ? text_of(*nothing.reason, language) : "-";
  }
  std::string operator()(bool value) const {
    return std::string(SentenceRef(value ? says::yes : says::no).in(language));
  }
  std::string operator()(std::int64_t value) const { return std::to_string(value); }
  std::string operator()(Quantity const& quantity) const {
    return units == Units::shown ? quantity_text(quantity, language) : number_text(quantity, language);
  }
  std::string operator()(std::string const& text) const { return text.empty() ? "-" : printable(text); }
  std::string operator()(Symbol const& symbol) const { return text_of(symbol.words, language); }
  std::string operator()(Words const& words) const { return text_of(words, language); }
  std::string operator()(Names const& names) const {
    std::string text;
    for (auto const& name : names) (text += text.empty() ? "" : ", ") += printable(name);
    return text.empty() ? "-" : text;
  }
  std::string operator()(NameLists const& lists) const {
    std::string text;
    for (auto const& names : lists) (text += text.empty() ? "" : "; ") += (*this)(names);
    return text.empty() ? "-" : text;
  }
  std::string operator()(Wording const& wording) const { return (*this)(wording.in(language)); }
};

}  // namespace

Words::Words(Sentence const& only) : sentence(only) {}
Words::Words(SentenceRef only) : sentence(only) {}
Words::Words(SentenceRef with, std::vector<NamedValue> filled) : sentence(with), values(std::move(filled)) {}
Words::Words(Words const& other) = default;
Words::Words(Words&& other) noexcept = default;
Words& Words::operator=(Words const& other) = default;
Words& Words::operator=(Words&& other) noexcept = default;
Words::~Words() = default;

Value quantity_or(Nothing nothing, std::optional<double> value, Unit unit, Digits digits) {
  if (!value) return nothing;
  return Quantity{.value = *value, .unit = unit, .digits = digits};
}

std::string text_of(Value const& value, Language language, Units units) {
  return std::visit(TextForm{.language = language, .units = units}, value.form());
}

std::string text_of(Words const& words, Language language) {
  Message message{.sentence = words.sentence, .arguments = {}};
  for (auto const& [name, value] : words.values) {
    message.arguments.push_back({name, text_of(value, language)});
  }
  return render(message, language, Values::as_given);
}

Wording wording_of(Words const& words) {
  return {text_of(words, Language::english), text_of(words, Language::german)};
}

}  // namespace axisc::presentation
