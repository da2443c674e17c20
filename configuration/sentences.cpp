#include "configuration/sentences.hpp"

namespace axisc::configuration::says {

constinit Sentence const json_did_you_mean{"did you mean \"{suggestion}\"?", "ist \"{suggestion}\" gemeint?"};
constinit Sentence const json_known_keys{"keys here: {keys}", "Schlüssel an dieser Stelle: {keys}"};
constinit Sentence const json_missing_key{"the key \"{key}\" is missing here",
                                          "hier fehlt der Schlüssel \"{key}\""};
constinit Sentence const json_cycle_time{
    "the cycle time must be 20 to 100000 µs, not {value} µs; a millisecond is 1000",
    "die Zykluszeit muss 20 bis 100000 µs betragen, nicht {value} µs; eine Millisekunde ist 1000"};
constinit Sentence const json_write_number{"write {replacement}, without quotes",
                                           "{replacement} schreiben, ohne Anführungszeichen"};
constinit Sentence const json_repeated_value{R"("{value}" is in "{key}" twice)",
                                             R"("{value}" steht zweimal in "{key}")"};
constinit Sentence const xml_spelling{
    "{written} is not read, because names in XML have one spelling, without a prefix; write {meant}",
    "{written} wird nicht gelesen, denn Namen in XML haben eine einzige Schreibweise, ohne Präfix; {meant} "
    "schreiben"};

}  // namespace axisc::configuration::says
