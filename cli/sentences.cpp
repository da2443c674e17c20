#include "cli/sentences.hpp"

namespace axisc::cli::says {

constinit Sentence const cannot_read{"cannot read {file}: {reason}", "{file} ist nicht lesbar: {reason}"};

constinit Sentence const cannot_write{
    "cannot write {file}: {reason}; an existing file is unchanged",
    "{file} ist nicht schreibbar: {reason}; eine vorhandene Datei bleibt unverändert"};

constinit Sentence const bad_choice{"{option} does not know \"{value}\"; choose from {choices}",
                                    "{option} kennt \"{value}\" nicht; möglich sind {choices}"};
constinit Sentence const bad_count{"{option} needs a positive whole number, not \"{value}\"",
                                   "{option} braucht eine positive ganze Zahl, nicht \"{value}\""};
constinit Sentence const option_stdin_filename{
    "the name of the file that standard input (-) is the text of, for its settings and in messages",
    "der Name der Datei, deren Text die Standardeingabe (-) ist, für ihre Einstellungen und in Meldungen"};
constinit Sentence const nc_program{
    "{file} is an NC program; compile the machine file that names it",
    "{file} ist ein NC-Programm; zu übersetzen ist die Maschinendatei, die es nennt"};
constinit Sentence const runtime{"the runtime stopped: {reason} ({status})",
                                 "das Laufzeitsystem hielt an: {reason} ({status})"};
constinit Sentence const unexpected{"unexpected failure: {reason}", "unerwarteter Fehler: {reason}"};
constinit Sentence const help_usage{"Usage", "Aufruf"};
constinit Sentence const help_options{"OPTIONS", "OPTIONEN"};
constinit Sentence const help_options_heading{"Options", "Optionen"};
constinit Sentence const argument_inputs{
    "axis lists (*.lis, *.xml), machine files (*.json), TwinCAT projects (*.tsproj, *.xti), NC programs "
    "(*.nc), folders with any of them, @FILE with one name per line, or - for standard input",
    "Achslisten (*.lis, *.xml), Maschinendateien (*.json), TwinCAT-Projekte (*.tsproj, *.xti), NC-Programme "
    "(*.nc), Ordner mit solchen, @DATEI mit einem Namen je Zeile, oder - für die Standardeingabe"};
constinit Sentence const option_help{"print this help", "diese Hilfe zeigen"};
constinit Sentence const option_version{"print the version", "die Version zeigen"};
constinit Sentence const option_lang{"language of messages (default: from the locale, else en)",
                                     "Sprache der Meldungen (Standardwert: nach der Locale, sonst en)"};
constinit Sentence const option_cycle_time{
    "NC cycle time: 1ms, 250us, or a bare number of µs; takes precedence over a machine file",
    "NC-Zykluszeit: 1ms, 250us oder eine bloße Zahl in µs; geht einer Maschinendatei vor"};
constinit Sentence const option_baseline{"hide the findings that this file records",
                                         "die Befunde ausblenden, die diese Datei festhält"};

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

}  // namespace axisc::cli::says
