#include "axisc/answers/explain/explain_answer.hpp"

#include "axisc/answers/explain/explain_index.hpp"
#include "axisc/answers/explain/explain_parts.hpp"
#include "axisc/answers/explain/explain_subject.hpp"
#include "axisc/answers/explain/search_entries.hpp"
#include "diagnostics/finding.hpp"

#include <cstddef>
#include <utility>
#include <vector>

namespace axisc::says {

constexpr Sentence rules{"Rules", "Regeln"};
constexpr Sentence origin{
    "Every code that axisc reports, as printed by `axisc explain --all`: first by what is seen at the "
    "machine, by parameter, by message of the control and by code, then the page of each.",
    "Alle Codes, die axisc meldet, wie `axisc explain --all --lang de` sie ausgibt: zuerst nach dem, was an "
    "der Maschine zu sehen ist, nach Parameter, nach Meldung der Steuerung und nach Code, dann die Seite zu "
    "jedem."};
constexpr Sentence hits{"Found for \"{word}\"", "Gefunden zu „{word}“"};
constexpr Sentence near_hits{R"(No entry has all words of "{word}"; these have some of them)",
                             "Kein Eintrag hat alle Wörter von „{word}“; diese haben einige davon"};
constexpr Sentence more{"More with \"{word}\" in the name:", "Weitere mit „{word}“ im Namen:"};
constexpr Sentence read_as{R"("{word}" was read as "{meant}".)", "„{word}“ wurde als „{meant}“ gelesen."};

}  // namespace axisc::says

namespace axisc {

using namespace presentation;

namespace {

/// A part that people see alone gives the document its title.
Words take_title(Section& part) {
  auto title = *part.title;
  part.title.reset();
  return title;
}

Document document_of(Section section) {
  Document document{.version = 3, .title = take_title(section), .blocks = {}};
  document.blocks.emplace_back(std::move(section));
  return document;
}

/// What programs read of any answer: arrays, of which some are empty.
struct Arrays {
  Sections topics{.key = "topics", .items = {}};
  Sections rules{.key = "rules", .items = {}};
  Sections messages{.key = "messages", .items = {}};
  Sections parameters{.key = "parameters", .items = {}};

  void add_to(std::vector<Block>& blocks) && {
    for (auto* const sections : {&topics, &rules, &messages, &parameters}) {
      blocks.emplace_back(std::move(*sections));
    }
  }
};

void for_programs(Section& section) {
  section.audience = Audience::programs;
  section.id.clear();
}

/// All that can be looked up, for programs.
Table every_subject(schema::Catalogue const& of_axes) {
  std::vector<Subject> subjects;
  auto const all = search_entries(catalogues_of(of_axes));
  for (auto const& entry : all.entries) subjects.push_back(entry.subject);
  auto table = subjects_table("hits", subjects);
  table.audience = Audience::programs;
  return table;
}

Document every_code(schema::Catalogue const& of_axes) {
  Arrays arrays;
  for (auto const& rule : validator::rules()) arrays.rules.items.push_back(rule_section(rule));
  for (auto const& parameter : of_axes.parameters()) {
    arrays.parameters.items.push_back(parameter_section(of_axes, parameter));
    for_programs(arrays.parameters.items.back());
  }
  Document answer{
      .version = 3, .title = says::rules, .blocks = {Paragraph{says::origin}}, .csv_table = "rules"};
  for (auto& way : rule_index(of_axes)) answer.blocks.push_back(std::move(way));
  std::move(arrays).add_to(answer.blocks);
  answer.blocks.emplace_back(every_subject(of_axes));
  return answer;
}

/// Others whose names contain the words.
void add_more(Document& answer, ExplainSubject const& subject, ExplainQuestion const& question) {
  if (subject.hits.empty()) return;
  auto table = subjects_table({}, subjects_of(subject.hits));
  table.audience = Audience::people;
  table.most_shown = 10;
  answer.blocks.emplace_back(Paragraph{Words(says::more, {{"word", question.word}})});
  answer.blocks.emplace_back(std::move(table));
}

Document page_of(ExplainSubject const& subject, ExplainQuestion const& question,
                 std::span<schema::Catalogue const> catalogues) {
  Document answer{.version = 3, .title = as_given(question.word), .blocks = {}};
  if (!subject.read_as.empty()) {
    answer.blocks.emplace_back(
        Paragraph{Words(says::read_as, {{"word", question.word}, {"meant", subject.read_as}})});
  }
  if (subject.motion_word != nullptr) {
    auto word = word_answer(*subject.motion_word);
    word.blocks.insert(word.blocks.begin(), answer.blocks.begin(), answer.blocks.end());
    return word;
  }
  Arrays arrays;
  if (subject.topic != nullptr) arrays.topics.items.push_back(topic_section(*subject.topic, catalogues));
  for (auto const* const rule : subject.rules) arrays.rules.items.push_back(rule_section(*rule));
  if (subject.number) {
    arrays.messages.items.push_back(message_section(*subject.number, subject.message, subject.foretelling));
  }
  for (auto const* const parameter : subject.parameters) {
    arrays.parameters.items.push_back(parameter_section(question.of_axes, *parameter));
  }
  std::vector<Section*> parts;
  for (auto* const sections : {&arrays.topics, &arrays.rules, &arrays.messages, &arrays.parameters}) {
    for (auto& item : sections->items) parts.push_back(&item);
    if (!sections->items.empty() && answer.csv_table.empty()) answer.csv_table = sections->key;
  }
  if (parts.size() == 1) answer.title = take_title(*parts.front());
  // Only the list of all codes has links.
  for (auto* const part : parts) part->id.clear();
  for (auto const* const rule : subject.foretelling) {
    arrays.rules.items.push_back(rule_section(*rule));
    for_programs(arrays.rules.items.back());
  }
  std::move(arrays).add_to(answer.blocks);
  add_more(answer, subject, question);
  return answer;
}

struct Collector {
  Arrays& arrays;
  ExplainQuestion const& question;

  void operator()(validator::Rule const* rule) const { add(arrays.rules, rule_section(*rule)); }
  void operator()(schema::Parameter const* parameter) const {
    add(arrays.parameters, parameter_section(question.of_axes, *parameter));
  }
  // Their rows say what there is to know.
  void operator()(schema::MotionWord const* /*word*/) const {}
  void operator()(schema::Topic const* /*topic*/) const {}
  void operator()(schema::ControlMessage const* message) const {
    add(arrays.messages, message_section(message->numbers.front(), message, {}));
  }

  static void add(Sections& sections, Section section) {
    for_programs(section);
    sections.items.push_back(std::move(section));
  }
};

/// Everything that may be meant, best first.
Document list_of(ExplainSubject const& subject, ExplainQuestion const& question) {
  constexpr std::size_t most_shown = 40;
  auto const subjects = subjects_of(subject.hits);
  Arrays arrays;
  for (auto const& found : subjects) std::visit(Collector{arrays, question}, found);
  bool const has_others = arrays.parameters.items.size() != subjects.size();
  auto table = subjects_table("hits", subjects);
  table.most_shown = most_shown;
  bool const is_near = subject.hits.front().likeness == Likeness::some_words;
  Document answer{.version = 3,
                  .title = Words(is_near ? says::near_hits : says::hits, {{"word", question.word}}),
                  .blocks = {std::move(table)},
                  .csv_table = has_others ? "hits" : "parameters"};
  std::move(arrays).add_to(answer.blocks);
  return answer;
}

}  // namespace

std::vector<schema::Catalogue> catalogues_of(schema::Catalogue const& of_axes) {
  std::vector<schema::Catalogue> catalogues{of_axes};
  for (auto const& row : schema::list_kind_rows) {
    if (row.kind != schema::ListKind::axis) catalogues.push_back(schema::Catalogue::of(row.kind));
  }
  return catalogues;
}

Document rule_answer(validator::Rule const& rule) {
  return document_of(rule_section(rule));
}

Document parameter_answer(schema::Catalogue const& catalogue, schema::Parameter const& parameter) {
  return document_of(parameter_section(catalogue, parameter));
}

Document explain_answer(ExplainQuestion const& question) {
  if (question.all) return every_code(question.of_axes);
  auto const catalogues = catalogues_of(question.of_axes);
  auto const subject = explain_subject(catalogues, question.word);
  return subject.is_found() ? page_of(subject, question, catalogues) : list_of(subject, question);
}

}  // namespace axisc
