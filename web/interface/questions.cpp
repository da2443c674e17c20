#include "web/interface/questions.hpp"

#include "axisc/answers/contour/contour_answer.hpp"
#include "axisc/answers/explain/explain_answer.hpp"
#include "axisc/answers/figures/picture_answer.hpp"
#include "axisc/answers/machine/machine_answer.hpp"
#include "axisc/answers/report/report_answer.hpp"
#include "axisc/checking/path_machine.hpp"
#include "axisc/environment/failure.hpp"
#include "axisc/files/disk_files.hpp"
#include "presentation/pictures/svg.hpp"
#include "presentation/writers.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <nlohmann/json.hpp>

namespace axisc::says {

constexpr Sentence not_a_question{R"("{question}" is not a question: {known})",
                                  R"("{question}" ist keine Frage: {known})"};
constexpr Sentence unknown_word{R"("{key}" cannot be "{word}": {known})",
                                R"("{key}" kann nicht "{word}" sein: {known})"};
constexpr Sentence not_a_text{R"("{key}" of a question is a text)", R"("{key}" einer Frage ist ein Text)"};
constexpr Sentence unknown_key{R"(the question {question} has no "{key}"; it has {known})",
                               R"(die Frage {question} hat kein "{key}"; sie hat {known})"};
constexpr Sentence no_object{"a question is a JSON object whose values are texts",
                             "eine Frage ist ein JSON-Objekt, dessen Werte Texte sind"};

}  // namespace axisc::says

namespace axisc::web {

namespace {

/// What is asked, as texts by key.
class Asked {
 public:
  explicit Asked(std::string const& text) : values_(nlohmann::json::parse(text, nullptr, false)) {
    if (!values_.is_object()) throw Failure({.sentence = says::no_object, .arguments = {}});
  }

  [[nodiscard]] std::optional<std::string> find(std::string const& key) const {
    auto const found = values_.find(key);
    if (found == values_.end() || found->is_null()) return std::nullopt;
    if (found->is_string()) return found->get<std::string>();
    throw Failure({.sentence = says::not_a_text, .arguments = {{"key", key}}});
  }
  [[nodiscard]] std::string text(std::string const& key) const { return find(key).value_or(""); }

  /// The value of the row with that word; the first row's without one.
  template <typename Rows>
  [[nodiscard]] auto word(std::string const& key, Rows const& rows) const {
    auto const wanted = find(key);
    std::string known;
    for (auto const& [word, value] : rows) {
      if (!wanted || *wanted == word) return value;
      known.append(known.empty() ? "" : ", ").append(word);
    }
    throw Failure(
        {.sentence = says::unknown_word, .arguments = {{"key", key}, {"word", *wanted}, {"known", known}}});
  }

  void refuse_others(std::string_view question, std::string_view keys) const {
    auto const words = " question " + std::string(keys) + " ";
    for (auto const& [key, value] : values_.items()) {
      if (words.find(" " + key + " ") != std::string::npos) continue;
      throw Failure(
          {.sentence = says::unknown_key,
           .arguments = {{"question", std::string(question)}, {"key", key}, {"known", std::string(keys)}}});
    }
  }

 private:
  nlohmann::json values_;
};

using Answer = std::optional<std::string>;

std::string written(presentation::Document const& document, Asked const& asked, Language language) {
  return presentation::write(document, asked.word("format", presentation::formats), {.language = language});
}

Answer machine(Workspace& workspace, Asked const& asked, ErrorSink const& errors) {
  auto const path = machine_of_input(workspace, {.input = asked.text("input")}).machine;
  SourceSet sources;
  auto const loaded = validator::load(workspace.files(), path, workspace.options_of(path), sources);
  if (auto const* const error = std::get_if<configuration::FileError>(&loaded)) {
    throw unreadable(path, *error);
  }
  return written(machine_answer(std::get<validator::LoadedMachine>(loaded), sources), asked, errors.language);
}

Answer machine_of(Workspace& workspace, Asked const& asked, ErrorSink const& /*errors*/) {
  return machine_of_input(workspace, {.input = asked.text("input")}).machine;
}

Answer contour(Workspace& workspace, Asked const& asked, ErrorSink const& errors) {
  auto const input = asked.text("input");
  auto const checked = checked_machine(workspace, {.input = input}, errors);
  if (!checked) return std::nullopt;
  ContourQuestion const question{
      .machine = input, .group = checked->group, .filter = {}, .wanted = {}, .language = errors.language};
  return written(contour_answer(question, checked->machine, {}), asked, errors.language);
}

Answer picture(Workspace& workspace, Asked const& asked, ErrorSink const& errors) {
  PictureQuestion question;
  question.input = asked.text("input");
  question.kind = asked.word("kind", picture_kinds);
  question.axis = asked.find("axis");
  question.group = asked.find("group");
  question.before = asked.find("before");
  question.program = asked.find("program");
  question.plant = asked.find("plant");
  question.move = asked.find("move");
  question.language = errors.language;
  auto const figure = picture_answer(workspace, question, errors);
  return figure ? Answer(pictures::svg(*figure, errors.language)) : std::nullopt;
}

Answer report(Workspace& workspace, Asked const& asked, ErrorSink const& errors) {
  std::vector<Message> notes;
  auto report = report_answer(
      workspace, {.input = asked.text("input"), .before = asked.find("before"), .language = errors.language},
      errors, notes);
  return report ? Answer(std::move(report->page)) : std::nullopt;
}

Answer explain(Workspace& workspace, Asked const& asked, ErrorSink const& errors) {
  return written(explain_answer({.word = asked.text("word"), .of_axes = workspace.settings().catalogue("-")}),
                 asked, errors.language);
}

struct Question {
  std::string_view name, keys;
  Answer (*answer)(Workspace& workspace, Asked const& asked, ErrorSink const& errors);
};

constexpr std::array questions = {
    Question{.name = "machine", .keys = "input format", .answer = machine},
    Question{.name = "machine_of", .keys = "input", .answer = machine_of},
    Question{.name = "contour", .keys = "input format", .answer = contour},
    Question{.name = "picture", .keys = "input kind axis group before program plant move", .answer = picture},
    Question{.name = "report", .keys = "input before", .answer = report},
    Question{.name = "explain", .keys = "word format", .answer = explain}};

}  // namespace

std::optional<std::string> answer(Workspace& workspace, std::string const& question,
                                  ErrorSink const& errors) {
  Asked const asked(question);
  auto const name = asked.text("question");
  auto const* const found = std::find_if(questions.begin(), questions.end(),
                                         [&name](Question const& row) { return row.name == name; });
  if (found != questions.end()) {
    asked.refuse_others(found->name, found->keys);
    return found->answer(workspace, asked, errors);
  }
  std::string known;
  for (auto const& row : questions) known.append(known.empty() ? "" : ", ").append(row.name);
  throw Failure({.sentence = says::not_a_question, .arguments = {{"question", name}, {"known", known}}});
}

}  // namespace axisc::web
