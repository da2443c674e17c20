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

constinit Sentence const control_defaults{
    "without it, the control's own defaults count here for what the axis lists leave open",
    "ohne sie gelten hier für alles, was die Achslisten offenlassen, die Standardwerte der Steuerung"};

constinit Sentence const unnamed_list{"the control reads `{parameter}` as well, but no line sets it",
                                      "die Steuerung liest auch `{parameter}`, aber keine Zeile setzt es"};

constinit Sentence const milliseconds_meant{"the value is in µs: {value} ms are `{replacement}`",
                                            "der Wert gilt in µs: {value} ms sind `{replacement}`"};

constinit Sentence const program_reaction_aborted{"the NC program is aborted",
                                                  "das NC-Programm wird abgebrochen"};

constinit Sentence const guard_stops_motion{"the motion stops", "die Bewegung hält an"};

}  // namespace axisc::validator::says
