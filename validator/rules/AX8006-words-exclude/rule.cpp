#include "validator/engine/rule.hpp"

#include "validator/rules/helpers.hpp"
#include "validator/rules/motion_blocks.hpp"

#include <algorithm>
#include <array>

namespace axisc::validator::checks::ax8006::says {

constexpr Sentence headline{"`{word}` must not stand in one block with `{other}`",
                            "`{word}` darf nicht mit `{other}` in einem Satz stehen"};
constexpr Sentence limit{"G08, G09, G193 and G293 exclude each other",
                         "G08, G09, G193 und G293 schließen einander aus"};
constexpr Sentence other_here{"the other word", "das andere Wort"};
constexpr Sentence reaction{"it aborts the program", "sie bricht das Programm ab"};
constexpr Sentence help{"leave out one of them", "eines davon weglassen"};

}  // namespace axisc::validator::checks::ax8006::says

namespace axisc::validator::checks::ax8006 {
namespace {

bool is_about_feed(BlockFunction const& function) {
  constexpr std::array numbers = {8, 9, 193, 293};
  return std::find(numbers.begin(), numbers.end(), function.number) != numbers.end();
}

void words_exclude(ProgramContext const& context, Report& report) {
  auto const written = [&](Span span) { return std::string(context.text.substr(span.begin, span.size())); };
  for (grammar::WantedBlock const& wanted : context.program.tree.blocks) {
    auto functions = MotionBlock(wanted, context.text).functions();
    std::erase_if(functions, [](BlockFunction const& function) { return !is_about_feed(function); });
    auto const other = std::find_if(functions.begin(), functions.end(), [&](BlockFunction const& function) {
      return function.number != functions.front().number;
    });
    if (other == functions.end()) continue;
    SourceId const source = context.program.source;
    Finding& finding = report.add(Place{.source = source, .span = other->span},
                                  message(says::headline, {{"word", written(other->span)},
                                                           {"other", written(functions.front().span)}}));
    finding.notes.push_back(message(says::limit));
    finding.help.push_back(message(says::help));
    finding.related.push_back(
        {.place = {.source = source, .span = functions.front().span}, .message = message(says::other_here)});
    set_reaction(finding, says::reaction);
  }
}

}  // namespace

extern constinit Rule const rule{
    .control = "20109",
    .check = words_exclude,
};

}  // namespace axisc::validator::checks::ax8006
