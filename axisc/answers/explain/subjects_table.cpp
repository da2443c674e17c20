#include "axisc/answers/explain/explain_parts.hpp"
#include "axisc/answers/labels.hpp"
#include "diagnostics/finding.hpp"
#include "schema/descriptions/description.hpp"
#include "validator/engine/rule_title.hpp"

#include <algorithm>

namespace axisc::says {

constexpr Sentence also{"also", "auch"};

}  // namespace axisc::says

namespace axisc {

using namespace presentation;

namespace {

std::string_view first_of(std::string_view page) {
  auto const text = page.substr(0, page.find('\n'));
  auto const end = text.find(". ");
  return text.substr(0, end == std::string_view::npos ? end : end + 1);
}

struct Described {
  std::string_view kind;
  std::string name;
  Wording also;
  Wording meaning;
};

std::string numbers_of(schema::ControlMessage const& message) {
  std::string text;
  for (auto const number : message.numbers) text += (text.empty() ? "" : "/") + std::to_string(number);
  return text;
}

struct Describer {
  Described operator()(validator::Rule const* rule) const {
    return {"rule", code_text(rule->code), std::string(rule->name), Wording(title(*rule))};
  }
  Described operator()(schema::Parameter const* parameter) const {
    return {"parameter", std::string(parameter->name),
            schema::number_text(parameter->kind, parameter->p_axis),
            Wording(schema::description_of(*parameter).what)};
  }
  Described operator()(schema::MotionWord const* word) const {
    return {"word", std::string(word->word), std::string(word->form),
            first_sentence({word->meaning.in(Language::english), word->meaning.in(Language::german)})};
  }
  Described operator()(schema::Topic const* topic) const {
    return {"topic", std::string(topic->name), Wording(topic->title), first_sentence(topic->page)};
  }
  Described operator()(schema::ControlMessage const* message) const {
    auto const reporter = schema::reporter_of(message->numbers.front());
    return {"message", numbers_of(*message), reporter ? wording_of(Words(*reporter)) : Wording(),
            Wording(message->meaning)};
  }
};

}  // namespace

Wording first_sentence(Page const& page) {
  return {std::string(first_of(page.english)), std::string(first_of(page.german))};
}

std::vector<Subject> subjects_of(std::span<Hit const> hits) {
  std::vector<Subject> subjects;
  for (auto const& hit : hits) subjects.push_back(hit.subject);
  return subjects;
}

Table subjects_table(std::string key, std::span<Subject const> subjects) {
  Table table{.key = std::move(key)};
  for (auto const& subject : subjects) {
    auto const [kind, name, also, meaning] = std::visit(Describer{}, subject);
    add_row(table, {data("kind", kind),
                    {"name", labels::name, name},
                    {"also", says::also, also.empty() ? Value() : Value(also)},
                    {"meaning", labels::meaning, meaning.empty() ? Value() : Value(meaning)}});
  }
  return table;
}

}  // namespace axisc
