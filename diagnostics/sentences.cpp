#include "diagnostics/sentences.hpp"

namespace axisc::says {

constinit Sentence const word_error{"error", "Fehler"};
constinit Sentence const word_warning{"warning", "Warnung"};
constinit Sentence const word_note{"note", "Hinweis"};
constinit Sentence const word_control{"control", "Steuerung"};
constinit Sentence const word_help{"help", "Hilfe"};
constinit Sentence const word_fix{"fix", "Korrektur"};
constinit Sentence const control_message{"message {number}", "Meldung {number}"};
constinit Sentence const control_messages{"messages {number}", "Meldungen {number}"};

}  // namespace axisc::says
