#include "editor/capabilities/pages.hpp"

#include "axisc/answers/explain/explain_formats.hpp"
#include "axisc/answers/figures/plots.hpp"
#include "axisc/answers/figures/script_digest.hpp"
#include "axisc/answers/machine/machine_formats.hpp"
#include "axisc/answers/report/html.hpp"
#include "axisc/answers/report/report_page.hpp"
#include "axisc/asked/finding_codes.hpp"
#include "axisc/checking/compilable.hpp"
#include "axisc/checking/path_machine.hpp"
#include "axisc/environment/failure.hpp"
#include "axisc/files/disk_files.hpp"
#include "diagnostics/format_number.hpp"
#include "editor/reading/requests.hpp"
#include "presentation/pictures/page.hpp"
#include "presentation/pictures/svg_text.hpp"
#include "validator/engine/rule.hpp"
#include "validator/loading/loader.hpp"

#include <algorithm>
#include <array>
#include <variant>

namespace axisc::says {

constexpr Sentence title_report{"Report: {machine}", "Bericht: {machine}"};
constexpr Sentence title_machine{"Machine: {machine}", "Maschine: {machine}"};
constexpr Sentence errors_first{"{machine} has errors: correct them first, they are among the problems",
                                "{machine} hat Fehler: zuerst diese beheben, sie stehen unter den Problemen"};
constexpr Sentence unknown_picture_kind{"no picture \"{kind}\": response, step, delay, corner or circle",
                                        "kein Bild \"{kind}\": response, step, delay, corner oder circle"};
constexpr Sentence unknown_rule{"no rule \"{code}\"", "keine Regel \"{code}\""};
constexpr Sentence cascade_line{"delay {delay} ms, {deviation} mm at a corner at {feed} mm/min",
                                "Verzögerung {delay} ms, {deviation} mm an einer Ecke bei {feed} mm/min"};
constexpr Sentence cascade_not_straight{
    "delay {delay} ms; no corner deviation in mm: the axis is not translatory",
    "Verzögerung {delay} ms; keine Eckenabweichung in mm: die Achse ist nicht translatorisch"};
constexpr Sentence cascade_no_feed{
    "delay {delay} ms; no corner deviation: the axis has no feed limit",
    "Verzögerung {delay} ms; keine Eckenabweichung: die Achse hat keine Vorschubgrenze"};
constexpr Sentence no_figures{"no figures: {machine} has errors, they are among the problems",
                              "keine Werte: {machine} hat Fehler, sie stehen unter den Problemen"};
constexpr Sentence no_channel{"no figures: the axis is in no channel of {machine}",
                              "keine Werte: die Achse ist in keinem Kanal von {machine}"};

}  // namespace axisc::says

namespace axisc::editor {

namespace {

constexpr int shown_digits = 3;
constexpr double mm_per_min_of_um_per_s = 0.06;
constexpr double quarter_turn = 1.5707963267948966;

class PagesOfMachine {
 public:
  explicit PagesOfMachine(PageSubject const& subject) : subject_(subject), language_(subject.language) {
    auto asked = subject.options(subject.machine);
    asked.machine = true;
    result_ = validator::check(subject.files, subject.machine, asked, sources_,
                               [this](Finding& finding) { findings_.push_back(std::move(finding)); });
    if (result_.unreadable) throw unreadable(subject.machine, *result_.unreadable);
    if (!result_.machine) return;
    require_cycle_time(subject.machine, result_);
    image_.emplace(image_of(*result_.machine, subject.machine));
    host_.emplace(start_runtime(subject.machine, *image_));
  }

  [[nodiscard]] Page report() {
    ReportSubject shown{
        .input = name(), .findings = {}, .counts = {}, .plots = {}, .contour = {}, .language = language_};
    shown.contour.feeds = {1000, 2000, 4000};
    for (auto const& finding : findings_) add_finding(shown, finding, sources_);
    if (image_) {
      shown.machine = &*result_.machine;
      shown.plots.emplace(plots(std::nullopt));
    }
    return {.title = say(says::title_report),
            .html = report_page(shown),
            .script_digests = {script_digest(pictures::page_script(language_))}};
  }

  [[nodiscard]] Page plot(std::string const& kind) {
    require_image();
    auto const figure = figure_of(kind);
    return {.title = figure.title,
            .html = pictures::page(figure, language_),
            .script_digests = {script_digest(pictures::page_script(language_))}};
  }

  /// For the axis of the subject, or for each axis with its name. Gives the reason if there are no figures.
  [[nodiscard]] std::string cascade() {
    std::string text;
    if (!image_) return say(says::no_figures);
    auto const& machine = *result_.machine;
    for (std::size_t i = 0; i < machine.groups.size(); ++i) {
      auto const& axes = machine.groups[i].axes;
      std::optional<std::vector<motion::ChainAnswer>> answers;
      for (std::size_t k = 0; k < axes.size(); ++k) {
        auto const& axis = machine.axes[axes[k]];
        if (subject_.axis && axis.name != *subject_.axis) continue;
        if (!answers) answers = GroupChains(machine, i, filters_on(), subject_.machine).answers(std::nullopt);
        if (!text.empty()) text += "; ";
        if (!subject_.axis) text += axis.name + ": ";
        text += cascade_text((*answers)[k], axis);
      }
    }
    return text.empty() ? say(says::no_channel) : text;
  }

 private:
  [[nodiscard]] std::string name() const { return std::string(validator::file_name(subject_.machine)); }
  [[nodiscard]] std::string say(SentenceRef text) const {
    return editor::say(text, language_, {{"machine", name()}});
  }
  [[nodiscard]] PlotSubject plots(std::optional<std::string> const& axis) {
    return {.now = {.file = *image_, .host = *host_},
            .before = std::nullopt,
            .axes = chosen_axes(image_->contents, axis),
            .language = language_};
  }
  void require_image() const {
    if (!image_) throw RequestRefused(say(says::errors_first));
  }

  [[nodiscard]] pictures::Figure figure_of(std::string const& kind) {
    if (kind == "response") return response_figure(plots(subject_.axis), {});
    if (kind == "step") return step_figure(plots(subject_.axis));
    if (kind == "delay") return delay_figure(plots(std::nullopt));
    if (kind != "corner" && kind != "circle") {
      throw RequestRefused(editor::say(says::unknown_picture_kind, language_, {{"kind", kind}}));
    }
    auto const& machine = *result_.machine;
    auto const group = chosen_group(machine, std::nullopt, subject_.machine);
    GroupChains chains(machine, group, filters_on(), subject_.machine);
    std::vector<std::string> axes;
    for (auto const axis : machine.groups[group].axes) axes.push_back(axis_label(image_->contents, axis));
    ContourSubject const contours{.now = chains,
                                  .before = nullptr,
                                  .cycle_time = image_->contents.cycle_time,
                                  .axes = std::move(axes),
                                  .language = language_};
    return kind == "corner" ? corner_figure(contours, {}) : circle_figure(contours, {});
  }

  /// The corner is between two axes with this chain.
  [[nodiscard]] std::string cascade_text(motion::ChainAnswer const& answer,
                                         machine::AxisConfiguration const& axis) const {
    auto const cycle_time = result_.machine->cycle_time;
    std::vector<Argument> arguments{
        {"delay", format_rounded(answer.delay * cycle_time.microseconds() / 1000, shown_digits)}};
    double const feed = axis.velocity_limit * mm_per_min_of_um_per_s;
    if (axis.type != machine::AxisType::translatory) {
      return editor::say(says::cascade_not_straight, language_, arguments);
    }
    if (feed <= 0) return editor::say(says::cascade_no_feed, language_, arguments);
    std::array const both = {answer, answer};
    auto const corner = motion::predict_corner(both, path_velocity(feed, cycle_time), quarter_turn);
    arguments.push_back({"deviation", format_rounded(corner.deviation / motion::units_per_mm, shown_digits)});
    arguments.push_back({"feed", format_rounded(feed, shown_digits)});
    return editor::say(says::cascade_line, language_, arguments);
  }

  PageSubject const& subject_;
  Language language_;
  SourceSet sources_;
  std::vector<Finding> findings_;
  validator::CheckResult result_;
  std::optional<ImageFile> image_;
  std::optional<image::RuntimeHost> host_;
};

/// `body` is HTML.
Page whole_page(std::string const& title, std::string const& body, Language language) {
  return {.title = title,
          .html = "<!doctype html>\n<html lang=\"" + std::string(language == Language::german ? "de" : "en") +
                  "\">\n<head><meta charset=\"utf-8\"><title>" + pictures::escaped(title) +
                  "</title>\n<style>" + pictures::page_style() +
                  "pre {white-space: pre-wrap}</style></head>\n<body>" + body + "</body>\n</html>\n"};
}

Page machine_page(PageSubject const& subject) {
  auto const language = subject.language;
  SourceSet sources;
  auto const loaded =
      validator::load(subject.files, subject.machine, subject.options(subject.machine), sources);
  if (auto const* const error = std::get_if<configuration::FileError>(&loaded)) {
    throw unreadable(subject.machine, *error);
  }
  auto const name = std::string(validator::file_name(subject.machine));
  auto const title = say(says::title_machine, language, {{"machine", name}});
  auto const text = machine_text(std::get<validator::LoadedMachine>(loaded), sources, language);
  return whole_page(title, text_of("h1", title) + "\n" + text_of("pre", text), language);
}

Page explanation_page(PageSubject const& subject) {
  auto const language = subject.language;
  auto const word = subject.words.empty() ? std::string() : subject.words.front();
  auto const code = find_code(word);
  auto const* const rule = code ? validator::find_rule(*code) : nullptr;
  if (rule == nullptr) {
    throw RequestRefused(say(says::unknown_rule, language, {{"code", word}}));
  }
  return whole_page(code_text(rule->code), html_of_markdown(explain_rule(*rule, 1, language), 0), language);
}

/// The client shows why an input fails.
template <Page (*make)(PageSubject const&)>
Page page(PageSubject const& subject) {
  try {
    return make(subject);
  } catch (Failure const& failure) {
    throw RequestRefused(failure.sentence(subject.language));
  }
}

Page report_of_machine(PageSubject const& subject) {
  return PagesOfMachine(subject).report();
}

Page plot_of_machine(PageSubject const& subject) {
  auto const kind = subject.words.empty() ? std::string("response") : subject.words.front();
  return PagesOfMachine(subject).plot(kind);
}

constexpr std::array commands = {PageCommand{.name = "axisc.report", .page = page<report_of_machine>},
                                 PageCommand{.name = "axisc.plot", .page = page<plot_of_machine>},
                                 PageCommand{.name = "axisc.machine", .page = page<machine_page>},
                                 PageCommand{.name = "axisc.explain", .page = page<explanation_page>}};

}  // namespace

std::span<PageCommand const> page_commands() {
  return commands;
}

std::string cascade_line(PageSubject const& subject) {
  try {
    return PagesOfMachine(subject).cascade();
  } catch (Failure const& failure) {
    return failure.sentence(subject.language);
  }
}

}  // namespace axisc::editor
