#include "validator/sentences.hpp"

namespace axisc::validator::says {

constinit Sentence const parameter_did_you_mean{"did you mean `{suggestion}`?",
                                                "ist `{suggestion}` gemeint?"};

constinit Sentence const filter_reaction_inactive{"the setpoint passes unfiltered",
                                                  "der Sollwert läuft ungefiltert durch"};
constinit Sentence const filter_reaction_clipped{"the highest possible order is used",
                                                 "die höchste mögliche Ordnung wird verwendet"};

constinit Sentence const cycle_time_assumed_note{"with the assumed cycle time of 1 ms",
                                                 "mit der angenommenen Zykluszeit von 1 ms"};

constinit Sentence const milliseconds_meant{"the value is in µs: {value} ms are `{replacement}`",
                                            "der Wert gilt in µs: {value} ms sind `{replacement}`"};

constinit Sentence const program_reaction_aborted{"the NC program is aborted",
                                                  "das NC-Programm wird abgebrochen"};

}  // namespace axisc::validator::says
