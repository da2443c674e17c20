#include "axisc/environment/sentences.hpp"

namespace axisc::says {

constinit Sentence const cannot_read{"cannot read {file}: {reason}", "{file} ist nicht lesbar: {reason}"};

constinit Sentence const cannot_write{
    "cannot write {file}: {reason}; an existing file is unchanged",
    "{file} ist nicht schreibbar: {reason}; eine vorhandene Datei bleibt unverändert"};

constinit Sentence const bad_choice{"{option} does not know \"{value}\"; choose from {choices}",
                                    "{option} kennt \"{value}\" nicht; möglich sind {choices}"};
constinit Sentence const bad_count{"{option} needs a positive whole number, not \"{value}\"",
                                   "{option} braucht eine positive ganze Zahl, nicht \"{value}\""};
constinit Sentence const nc_program{
    "{file} is an NC program; compile the machine file that names it",
    "{file} ist ein NC-Programm; zu kompilieren ist die Maschinendatei, die es nennt"};
constinit Sentence const runtime{"the runtime stopped: {reason} ({status})",
                                 "das Laufzeitsystem hielt an: {reason} ({status})"};
constinit Sentence const unexpected{"unexpected failure: {reason}", "unerwarteter Fehler: {reason}"};

constinit Sentence const blocks_constant{
    "axis {axis} of group {group} does not follow a constant velocity: a filter blocks the constant part",
    "Achse {axis} der Gruppe {group} folgt keiner konstanten Geschwindigkeit: ein Filter sperrt den "
    "Gleichanteil"};
constinit Sentence const no_velocities{
    "nothing in {file} uses velocities; --port setpoint or --port interface can be fed",
    "nichts in {file} verwendet Geschwindigkeiten; möglich sind --port setpoint und --port interface"};
constinit Sentence const no_interface_filter{
    "none of the requested axes in {file} has a filter on its additional interface",
    "keine der verlangten Achsen in {file} hat einen Filter auf der Zusatzschnittstelle"};

}  // namespace axisc::says
