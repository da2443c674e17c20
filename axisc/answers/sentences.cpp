#include "axisc/answers/sentences.hpp"

namespace axisc::says {

constinit Sentence const inspect_cycle_time{"NC cycle time", "NC-Zykluszeit"};
constinit Sentence const inspect_column_type{"type", "Typ"};
constinit Sentence const inspect_column_order{"order", "Ordnung"};
constinit Sentence const inspect_column_frequency{"frequency", "Frequenz"};
constinit Sentence const inspect_column_quality{"quality", "Güte"};
constinit Sentence const inspect_column_share{"share", "Anteil"};
constinit Sentence const inspect_column_delay{"delay", "Verzögerung"};
constinit Sentence const inspect_column_overshoot{"overshoot", "Überschwingen"};
constinit Sentence const inspect_column_peak_gain{"peak gain", "Spitzenverstärkung"};
constinit Sentence const inspect_delay_value{"{cycles} cycles ({ms} ms)", "{cycles} Zyklen ({ms} ms)"};

}  // namespace axisc::says
