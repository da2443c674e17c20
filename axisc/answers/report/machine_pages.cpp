#include "axisc/answers/report/machine_pages.hpp"

#include "axisc/answers/figures/plots.hpp"
#include "axisc/answers/report/report_page.hpp"
#include "axisc/checking/compilable.hpp"
#include "axisc/checking/path_machine.hpp"
#include "axisc/environment/failure.hpp"
#include "axisc/files/disk_files.hpp"
#include "diagnostics/format_number.hpp"
#include "validator/loading/loader.hpp"

#include <array>
#include <numbers>
#include <utility>

namespace axisc::says {

constexpr Sentence errors_first{"{machine} has errors: correct them first, they are among the problems",
                                "{machine} hat Fehler: zuerst diese beheben, sie stehen unter den Problemen"};
constexpr Sentence unknown_picture_kind{"no picture \"{kind}\": response, step, delay, corner or circle",
                                        "kein Bild \"{kind}\": response, step, delay, corner oder circle"};
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

namespace axisc {

namespace {

constexpr int shown_digits = 3;
constexpr double mm_per_min_of_um_per_s = 0.06;
constexpr double quarter_turn = std::numbers::pi / 2;

}  // namespace

MachinePages::MachinePages(configuration::Files& files, std::string path, validator::CheckOptions options,
                           Language language)
    : path_(std::move(path)), language_(language) {
  options.machine = true;
  result_ = validator::check(files, path_, options, sources_,
                             [this](Finding& finding) { findings_.push_back(std::move(finding)); });
  if (result_.unreadable) throw unreadable(path_, *result_.unreadable);
  if (!result_.machine) return;
  require_cycle_time(path_, result_);
  image_.emplace(image_of(*result_.machine, path_));
  host_.emplace(start_runtime(path_, *image_));
}

std::string MachinePages::report() {
  ReportSubject shown{
      .input = name(), .findings = {}, .counts = {}, .plots = {}, .contour = {}, .language = language_};
  shown.contour.feeds = {1000, 2000, 4000};
  for (auto const& finding : findings_) add_finding(shown, finding, sources_);
  if (image_) {
    shown.machine = &*result_.machine;
    shown.plots.emplace(PlotSubject{.now = {.file = *image_, .host = *host_},
                                    .before = std::nullopt,
                                    .axes = chosen_axes(image_->contents, std::nullopt),
                                    .language = language_});
  }
  return report_page(shown);
}

pictures::Figure MachinePages::figure(std::string const& kind, std::optional<std::string> const& axis) {
  if (!image_) throw Failure({.sentence = says::errors_first, .arguments = {{"machine", name()}}});
  auto const subject = [&](std::optional<std::string> const& wanted) {
    return PlotSubject{.now = {.file = *image_, .host = *host_},
                       .before = std::nullopt,
                       .axes = chosen_axes(image_->contents, wanted),
                       .language = language_};
  };
  if (kind == "response") return response_figure(subject(axis), {});
  if (kind == "step") return step_figure(subject(axis));
  if (kind == "delay") return delay_figure(subject(std::nullopt));
  if (kind != "corner" && kind != "circle") {
    throw Failure({.sentence = says::unknown_picture_kind, .arguments = {{"kind", kind}}});
  }
  auto const& machine = *result_.machine;
  auto const group = chosen_group(machine, std::nullopt, path_);
  GroupChains chains(machine, group, filters_on(), path_);
  std::vector<std::string> axes;
  for (auto const member : machine.groups[group].axes) axes.push_back(axis_label(image_->contents, member));
  ContourSubject const contours{.now = chains,
                                .before = nullptr,
                                .cycle_time = image_->contents.cycle_time,
                                .axes = std::move(axes),
                                .language = language_};
  return kind == "corner" ? corner_figure(contours, {}) : circle_figure(contours, {});
}

std::string MachinePages::cascade(std::optional<std::string> const& axis) {
  if (!image_) return say(says::no_figures);
  std::string text;
  auto const& machine = *result_.machine;
  for (std::size_t i = 0; i < machine.groups.size(); ++i) {
    auto const& axes = machine.groups[i].axes;
    std::optional<std::vector<motion::ChainAnswer>> answers;
    for (std::size_t k = 0; k < axes.size(); ++k) {
      auto const& member = machine.axes[axes[k]];
      if (axis && member.name != *axis) continue;
      if (!answers) answers = GroupChains(machine, i, filters_on(), path_).answers(std::nullopt);
      if (!text.empty()) text += "; ";
      if (!axis) text += member.name + ": ";
      text += cascade_text((*answers)[k], member);
    }
  }
  return text.empty() ? say(says::no_channel) : text;
}

std::string MachinePages::name() const {
  return std::string(validator::file_name(path_));
}

std::string MachinePages::say(SentenceRef text) const {
  return render({.sentence = text, .arguments = {{"machine", name()}}}, language_);
}

/// The corner is between two axes with this chain.
std::string MachinePages::cascade_text(motion::ChainAnswer const& answer,
                                       machine::AxisConfiguration const& axis) const {
  auto const cycle_time = result_.machine->cycle_time;
  std::vector<Argument> arguments{
      {"delay", format_rounded(answer.delay * cycle_time.microseconds() / 1000, shown_digits)}};
  double const feed = axis.velocity_limit * mm_per_min_of_um_per_s;
  if (axis.type != machine::AxisType::translatory) {
    return render({.sentence = says::cascade_not_straight, .arguments = arguments}, language_);
  }
  if (feed <= 0) return render({.sentence = says::cascade_no_feed, .arguments = arguments}, language_);
  std::array const both = {answer, answer};
  auto const corner = motion::predict_corner(both, path_velocity(feed, cycle_time), quarter_turn);
  arguments.push_back({"deviation", format_rounded(corner.deviation / motion::units_per_mm, shown_digits)});
  arguments.push_back({"feed", format_rounded(feed, shown_digits)});
  return render({.sentence = says::cascade_line, .arguments = arguments}, language_);
}

}  // namespace axisc
