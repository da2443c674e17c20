#include "cli/commands/sentences.hpp"

namespace axisc::cli::says {

constinit Sentence const bad_number{"{option} needs a number, not \"{value}\"",
                                    "{option} braucht eine Zahl, nicht \"{value}\""};
constinit Sentence const argument_input{
    "one axis list or machine file (*.json), or - for standard input",
    "eine Achsliste oder Maschinendatei (*.json), oder - für die Standardeingabe"};
constinit Sentence const argument_image{"a coefficient image, or - for standard input",
                                        "ein Koeffizientenabbild, oder - für die Standardeingabe"};
constinit Sentence const argument_machine_or_image{
    "a list, a machine file, a start-up list, a project, a folder with one machine, or an image",
    "eine Liste, eine Maschinendatei, eine Hochlaufliste, ein Projekt, ein Ordner mit einer Maschine oder "
    "ein Abbild"};
constinit Sentence const option_at{
    "execute a command before that cycle; only for images with kernel banks",
    "vor diesem Zyklus einen Befehl ausführen; nur für Abbilder mit Kernbänken"};
constinit Sentence const option_level{
    "instruction set: portable (default) gives the same bits everywhere, auto uses what a controller with "
    "this processor would use",
    "Befehlssatz: portable (Standardwert) gibt überall dieselben Bits, auto nimmt, was eine Steuerung mit "
    "diesem Prozessor verwenden würde"};

constinit Sentence const option_setpoint_column{"column before the filters: name, or number from 1",
                                                "Spalte vor den Filtern: Name oder Nummer ab 1"};
constinit Sentence const option_filtered_column{"column behind the filters", "Spalte hinter den Filtern"};
constinit Sentence const option_group{"only this group (NC channel)", "nur diese Gruppe (NC-Kanal)"};

}  // namespace axisc::cli::says
