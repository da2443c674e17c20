#include "validator/commands/command_mistake.hpp"

#include <utility>

namespace axisc::validator::says {

constexpr Sentence filter_syntax_syntax_filter{
    "the syntax is `#FILTER [ON | OFF] [ORDER=.. ORDER_TIME=.. SHARE=.. AX_DEV=.. FCUT=.. ACC_FACT=.. "
    "QUALITY=..]` or `#FILTER ON [HSC]`",
    "die Schreibweise ist `#FILTER [ON | OFF] [ORDER=.. ORDER_TIME=.. SHARE=.. AX_DEV=.. FCUT=.. ACC_FACT=.. "
    "QUALITY=..]` oder `#FILTER ON [HSC]`"};
constexpr Sentence filter_syntax_syntax_guard{
    "the syntax is `#VIB GUARD [ON | OFF] [MODE=.. FREQ=.. DAMPING=.. AX_DEV=.. ACC_FACT=..]`",
    "die Schreibweise ist `#VIB GUARD [ON | OFF] [MODE=.. FREQ=.. DAMPING=.. AX_DEV=.. ACC_FACT=..]`"};

}  // namespace axisc::validator::says

namespace axisc::validator {

using grammar::CommandKind;

std::string_view proper_name(CommandKind kind) {
  return kind == CommandKind::filter ? "#FILTER" : "#VIB GUARD";
}

Message syntax_of(CommandKind kind) {
  return {kind == CommandKind::filter ? says::filter_syntax_syntax_filter : says::filter_syntax_syntax_guard};
}

CommandMistake& add_mistake(CheckedCommand& checked, CommandKind kind, Code code, Span span, SentenceRef text,
                            std::vector<Argument> arguments) {
  CommandMistake& mistake = checked.mistakes.emplace_back();
  mistake.code = code;
  mistake.span = span;
  mistake.message = {text, std::move(arguments)};
  if (code == syntax_mistake) mistake.notes.push_back(syntax_of(kind));
  return mistake;
}

}  // namespace axisc::validator
