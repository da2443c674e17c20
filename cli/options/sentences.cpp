#include "cli/options/sentences.hpp"

namespace axisc::cli::says {

constinit Sentence const help_usage{"Usage", "Aufruf"};
constinit Sentence const help_options{"OPTIONS", "OPTIONEN"};
constinit Sentence const help_options_heading{"Options", "Optionen"};
constinit Sentence const argument_inputs{
    "axis lists (*.lis, *.xml), machine files (*.json), TwinCAT projects (*.tsproj, *.xti), NC programs "
    "(*.nc), folders with any of them, @FILE with one name per line, or - for standard input",
    "Achslisten (*.lis, *.xml), Maschinendateien (*.json), TwinCAT-Projekte (*.tsproj, *.xti), NC-Programme "
    "(*.nc), Ordner mit solchen, @DATEI mit einem Namen je Zeile, oder - für die Standardeingabe"};
constinit Sentence const option_stdin_filename{
    "the name of the file that standard input (-) is the text of, for its settings and in messages",
    "der Name der Datei, deren Text die Standardeingabe (-) ist, für ihre Einstellungen und in Meldungen"};
constinit Sentence const option_help{"print this help", "diese Hilfe zeigen"};
constinit Sentence const option_version{"print the version", "die Version zeigen"};
constinit Sentence const option_lang{"language of messages (default: from the locale, else en)",
                                     "Sprache der Meldungen (Standardwert: nach der Locale, sonst en)"};
constinit Sentence const option_cycle_time{
    "NC cycle time: 1ms, 250us, or a bare number of µs; takes precedence over a machine file",
    "NC-Zykluszeit: 1ms, 250us oder eine bloße Zahl in µs; geht einer Maschinendatei vor"};
constinit Sentence const option_baseline{"hide the findings that this file records",
                                         "die Befunde ausblenden, die diese Datei festhält"};

constinit Sentence const one_output{"several inputs need --output-folder FOLDER instead of -o",
                                    "mehrere Eingaben brauchen --output-folder ORDNER statt -o"};

}  // namespace axisc::cli::says
