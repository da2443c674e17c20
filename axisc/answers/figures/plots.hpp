// Figures of a machine: each shows what another command computes, for one state or for two beside each other.
#pragma once

#include "axisc/answers/contour/contour_groups.hpp"
#include "axisc/answers/dynamics/driven_axis.hpp"
#include "axisc/answers/execution/group_chains.hpp"
#include "axisc/answers/figures/measured_response.hpp"
#include "axisc/files/image_file.hpp"
#include "diagnostics/message.hpp"
#include "image/step_answers.hpp"
#include "presentation/pictures/figure.hpp"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace axisc {

/// An image after the commands of --at.
struct PlottedImage {
  ImageFile const& file;
  image::RuntimeHost& host;
  image::StepAnswers* steps =
      nullptr;  ///< where several figures show this image, as it starts; null: none kept
  machine::Machine const* machine = nullptr;  ///< from which it was compiled; null: not known

  [[nodiscard]] image::ImageContents const& contents() const { return file.contents; }
};

/// Axes that one picture shows: nobody tells more curves apart.
inline constexpr std::size_t most_drawn_axes = 100;

/// What the figures of one run have in common.
struct PlotSubject {
  PlottedImage now;
  std::optional<PlottedImage>
      before;                     ///< an earlier state of the same machine: axes are found by their names
  std::vector<std::size_t> axes;  ///< of `now`
  bool is_switched = false;       ///< --at said which FIR and HSC filters are on
  Language language = Language::english;
  std::map<std::size_t, std::string> called = {};  ///< axes that stand for equal ones: "X, Y, Z"

  [[nodiscard]] image::ImageContents const& contents() const { return now.contents(); }
  [[nodiscard]] std::string name(std::size_t axis) const {
    auto const found = called.find(axis);
    return found == called.end() ? axis_label(contents(), axis) : found->second;
  }
  /// "X, Y".
  [[nodiscard]] std::string names() const;
  [[nodiscard]] std::string say(SentenceRef text, std::vector<Argument> arguments = {}) const {
    return render({text, std::move(arguments)}, language);
  }
  /// Failure for more than most_drawn_axes.
  void require_drawable() const;
  /// The axis of `before` that has the name of an axis of `now`.
  [[nodiscard]] std::optional<std::size_t> axis_before(std::size_t axis) const;
};

/// Of some axes of an image, as it starts.
[[nodiscard]] std::vector<image::ChainFigures> figures_of(PlottedImage const& image,
                                                          std::vector<std::size_t> const& axes);

struct ResponsePlot {
  bool linear_frequency = false;
  bool linear_magnitude = false;
  bool wraps_phase = false;
  std::vector<double> marks = {};            ///< in Hz
  std::vector<MeasuredPoint> measured = {};  ///< drawn, and for a single axis what its chain makes of it
};

/// Magnitude, phase and group delay over frequency, as `response` computes them; of a single axis with each
/// of its filters.
[[nodiscard]] pictures::Figure response_figure(PlotSubject const& subject, ResponsePlot const& wanted);

/// The answer to a step of 1 in position, from standstill, and its velocity and acceleration, as `run`
/// computes them.
[[nodiscard]] pictures::Figure step_figure(PlotSubject const& subject);

/// Group delay at 0 Hz of each axis, one share per filter: with the FIR and HSC filters as --at switched
/// them, else on, and then also what it is before, where they are off at start-up.
[[nodiscard]] pictures::Figure delay_figure(PlotSubject const& subject);

/// Velocity and acceleration over time from rest to rest, as `simulate` plans them without filters; of a
/// single axis in G00, too. The machines of both states are known.
[[nodiscard]] pictures::Figure dynamics_figure(PlotSubject const& subject, WantedMove const& wanted);

/// Delay, -3 dB frequency, attenuation at characteristic frequencies and at `marks` (Hz), settling and
/// overshoot of each axis, with the difference where there are two states.
[[nodiscard]] pictures::Table chain_table(PlotSubject const& subject, std::vector<double> const& marks);

/// Whose contours are drawn.
struct ContourSubject {
  GroupChains& now;
  GroupChains* before = nullptr;
  design::CycleTime cycle_time;
  std::vector<std::string> axes;  ///< names of the group's
  Language language = Language::english;

  [[nodiscard]] std::string say(SentenceRef text, std::vector<Argument> arguments = {}) const {
    return render({text, std::move(arguments)}, language);
  }
};

/// The programmed corner and the filtered one, for each feed and order, as `contour` computes them; the plane
/// of the first axis and the one with the largest deviation.
[[nodiscard]] pictures::Figure corner_figure(ContourSubject const& subject, ContourRequest const& wanted);

/// Deviation of the radius over the angle, magnified.
[[nodiscard]] pictures::Figure circle_figure(ContourSubject const& subject, ContourRequest const& wanted);

/// "filter[0] BANDSTOP 42 Hz".
[[nodiscard]] std::string filter_label(image::ImageFilter const& filter, Language language);

}  // namespace axisc
