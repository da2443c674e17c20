#include "axisc/answers/inspect/inspect_writer.hpp"

#include "axisc/answers/sentences.hpp"
#include "axisc/answers/text_table.hpp"
#include "diagnostics/format_number.hpp"
#include "diagnostics/terminal.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace axisc::says {

constexpr Sentence section{"section {number}", "Abschnitt {number}"};
constexpr Sentence poles{"poles: {first}; {second}", "Pole: {first}; {second}"};
constexpr Sentence pole{"radius {radius} at {frequency} Hz", "Radius {radius} bei {frequency} Hz"};

}  // namespace axisc::says

namespace axisc {

namespace {

constexpr std::size_t label_width = 23;
constexpr int figures = 5;

}  // namespace

std::string InspectWriter::say(SentenceRef text, std::vector<Argument> arguments) const {
  return render({.sentence = text, .arguments = std::move(arguments)}, language_);
}

std::string InspectWriter::row(SentenceRef label, std::string const& value) const {
  return "  " + padded(say(label), label_width) + printable(value) + "\n";
}

std::string InspectWriter::rounded(double value) const {
  return format_rounded(value, figures).in(language_);
}

std::string InspectWriter::exact(double value) const {
  return exact_number(value).in(language_);
}

std::string InspectWriter::milliseconds(double cycles) const {
  return rounded(cycles * image_.cycle_time.seconds() * 1e3);
}

std::string InspectWriter::delay(double cycles) const {
  return say(says::inspect_delay_value, {{"cycles", rounded(cycles)}, {"ms", milliseconds(cycles)}});
}

std::string InspectWriter::section(std::size_t index, design::FilterDesign const& made) const {
  auto const& section = made.sections[index];
  auto const direct = design::direct_form(section, made.blocks_constant);
  auto const [first, second] = design::poles(section);
  auto const head = say(says::section, {{"number", std::to_string(index + 1)}});
  std::string const below(display_width(head), ' ');
  return "    " + head + "  b0 " + exact(direct.b0) + "  b1 " + exact(direct.b1) + "  b2 " +
         exact(direct.b2) + "  a1 " + exact(direct.a1) + "  a2 " + exact(direct.a2) + "\n    " + below +
         "  p " + exact(section.p) + "  q " + exact(section.q) + "  k " + exact(section.k) + "  b " +
         exact(section.b) + "\n    " + below + "  " +
         say(says::poles, {{"first", pole(first)}, {"second", pole(second)}}) + "\n";
}

std::string InspectWriter::pole(std::complex<double> pole) const {
  double const frequency = std::abs(std::arg(pole)) / (2 * std::numbers::pi * image_.cycle_time.seconds());
  return say(says::pole, {{"radius", format_rounded(std::abs(pole), 9)}, {"frequency", rounded(frequency)}});
}

}  // namespace axisc
