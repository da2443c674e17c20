#include "analysis/motion/program/sentences.hpp"

namespace axisc::motion::says {

constinit Sentence const not_simulated{"the simulation ignores `{word}`", "die Simulation übergeht `{word}`"};
constinit Sentence const cannot_simulate{
    "`{word}` cannot be simulated: it would change the path or the filters",
    "`{word}` ist nicht simulierbar: es würde die Bahn oder die Filter ändern"};
constinit Sentence const cannot_simulate_here{"`{word}` cannot be simulated here",
                                              "`{word}` ist hier nicht simulierbar"};
constinit Sentence const cannot_simulate_beside_dwell{
    "`{word}` cannot be simulated here: a dwell (G04) needs a block of its own",
    "`{word}` ist hier nicht simulierbar: eine Verweilzeit (G04) braucht einen eigenen Satz"};
constinit Sentence const cannot_simulate_twice{"`{word}`: this block has a value for it already",
                                               "`{word}`: dieser Satz hat schon einen Wert dafür"};
constinit Sentence const cannot_simulate_open{"`{word}` is not closed", "`{word}` wird nicht geschlossen"};
constinit Sentence const cannot_simulate_depth{
    "`{word}`: loops and subprograms are nested too deeply",
    "`{word}`: Schleifen und Unterprogramme sind zu tief verschachtelt"};

}  // namespace axisc::motion::says
