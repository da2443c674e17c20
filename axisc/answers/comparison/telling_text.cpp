#include "axisc/answers/comparison/telling_text.hpp"

#include "analysis/comparison/motion/telling_moves.hpp"
#include "axisc/answers/comparison/motion_words.hpp"
#include "axisc/answers/execution/path_dynamics.hpp"
#include "axisc/answers/simulation/followed_program.hpp"
#include "diagnostics/format_number.hpp"
#include "diagnostics/joined.hpp"
#include "diagnostics/message.hpp"
#include "presentation/value.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

namespace axisc::says {

constexpr Sentence telling_title{"Motions that tell how the control of {machine} plans a path.",
                                 "Bewegungen, die zeigen, wie die Steuerung von {machine} eine Bahn plant."};
constexpr Sentence record_it{
    "Record the unfiltered command position of each axis in every NC cycle, from the rest before the program "
    "to the rest after it, with the override at 100 %; then: axisc compare {machine} scope.csv --program "
    "this.nc",
    "Die ungefilterte Sollposition jeder Achse in jedem NC-Zyklus aufzeichnen, vom Stillstand vor dem "
    "Programm bis zum Stillstand danach, mit Override 100 %; danach: axisc compare {machine} scope.csv "
    "--program dieses.nc"};
constexpr Sentence travel_from_here{
    "The axes move from where they are, and return there. Keep this range clear:",
    "Die Achsen bewegen sich von dort aus, wo sie stehen, und kehren dorthin zurück. Diesen Weg freihalten:"};
constexpr Sentence travel_of_axis{"{axis}: {low} to {high} {unit}", "{axis}: {low} bis {high} {unit}"};
constexpr Sentence tells_keys{"A recording tells: {keys}.", "Eine Aufzeichnung entscheidet: {keys}."};
constexpr Sentence told_by{"{key}, {subject}: {words}", "{key}, {subject}: {words}"};
constexpr Sentence cannot_be_told{"{key} ({subject}) cannot be told on this machine; it takes {motion}.",
                                  "{key} ({subject}) lässt sich an dieser Maschine nicht feststellen; nötig "
                                  "ist {motion}."};
constexpr Sentence may_stay_open{
    "{key} ({subject}) may stay open, depending on what the control does; what always tells is {motion}.",
    "{key} ({subject}) bleibt vielleicht offen, je nachdem, was die Steuerung tut; immer entscheidet "
    "{motion}."};

}  // namespace axisc::says

namespace axisc {

namespace {

using comparison::MotionKey;
using comparison::Outlook;
using comparison::TellingProgram;

/// Where the axes go, from the beginning; position units.
struct Travel {
  motion::Point low{}, high{};

  void take(motion::Point const& point) {
    for (std::size_t i = 0; i < motion::most_axes; ++i) {
      low[i] = std::min(low[i], point[i]);
      high[i] = std::max(high[i], point[i]);
    }
  }
};

Travel travel_of(TellingProgram const& program) {
  Travel travel;
  for (auto const& part : program.parts) {
    for (auto const& move : part.moves) {
      for (auto const& block : move.blocks) {
        travel.take(block.end);
        if (!block.arc) continue;
        // The whole circle, even where the block is a part of it.
        auto corner = block.end;
        for (double const side : {-block.arc->radius, block.arc->radius}) {
          corner[block.arc->first] = block.arc->center_first + side;
          corner[block.arc->second] = block.arc->center_second + side;
          travel.take(corner);
        }
      }
    }
  }
  return travel;
}

class Text {
 public:
  explicit Text(Language language) : language_(language) {}

  void comment(Message const& message) {
    constexpr std::size_t width = 98;
    std::string const text = render(message, language_);
    std::string line = ";";
    for (std::size_t at = 0; at < text.size();) {
      auto const end = std::min(text.find(' ', at), text.size());
      if (line.size() + end - at >= width) {
        text_ += line + "\n";
        line = ";";
      }
      line += " " + text.substr(at, end - at);
      at = end + 1;
    }
    text_ += line + "\n";
  }
  void line(std::string_view words) {
    number_ += 10;
    text_ += "N" + std::to_string(number_) + " " + std::string(words) + "\n";
  }
  void plain(std::string_view words) { text_ += std::string(words) + "\n"; }

  [[nodiscard]] std::string const& text() const { return text_; }

 private:
  Language language_;
  std::string text_;
  int number_ = 0;
};

void describe_travel(TellingProgram const& program, motion::ProgramChannel const& channel, Text& text) {
  auto const travel = travel_of(program);
  text.comment({says::travel_from_here});
  for (std::size_t i = 0; i < channel.axes.size(); ++i) {
    if (travel.low[i] == travel.high[i]) continue;
    auto const shown = [](double units) { return format_rounded(units / motion::units_per_mm, 4); };
    text.comment({says::travel_of_axis,
                  {{"axis", channel.axes[i]},
                   {"low", shown(travel.low[i])},
                   {"high", shown(travel.high[i])},
                   {"unit", channel.rotary[i] ? "°" : "mm"}}});
  }
}

void describe_outlook(TellingProgram const& program, Text& text) {
  auto const words = comparison::motion_key_words();
  std::vector<std::string_view> told;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (program.outlook.at(i) == Outlook::told) told.push_back(words.at(i).key);
  }
  if (!told.empty()) text.comment({says::tells_keys, {{"keys", joined(told)}}});
  for (std::size_t i = 0; i < words.size(); ++i) {
    auto const outlook = program.outlook.at(i);
    if (outlook == Outlook::told) continue;
    auto const key = static_cast<MotionKey>(i);
    SentenceRef const sentence = outlook == Outlook::partly ? says::may_stay_open : says::cannot_be_told;
    text.comment({sentence,
                  {{"key", std::string(words.at(i).key)},
                   {"subject", presentation::wording_of(subject_of(key))},
                   {"motion", presentation::wording_of(telling_motion_of(key))}}});
  }
}

}  // namespace

std::string telling_text(machine::Machine const& machine, std::size_t group, std::string const& name,
                         Language language) {
  auto const channel = channel_of(machine, machine.groups[group]);
  auto const program = comparison::telling_program(channel, path_dynamics(machine, machine.groups[group]));
  Text text(language);
  text.plain("%TELL");
  text.comment({says::telling_title, {{"machine", name}}});
  text.comment({says::record_it, {{"machine", name}}});
  describe_travel(program, channel, text);
  describe_outlook(program, text);
  for (auto const& line : program.opening) text.line(line);
  auto const words = comparison::motion_key_words();
  for (auto const& part : program.parts) {
    auto const& [key, known] = words.at(comparison::index_of(part.key));
    text.comment({says::told_by,
                  {{"key", key},
                   {"subject", presentation::wording_of(subject_of(part.key))},
                   {"words", joined(known)}}});
    for (auto const& line : part.lines) text.line(line);
  }
  text.line("M30");
  return text.text();
}

}  // namespace axisc
