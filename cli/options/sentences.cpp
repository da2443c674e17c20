#include "cli/options/sentences.hpp"

namespace axisc::cli::says {

constinit Sentence const one_output{"several inputs need --output-folder FOLDER instead of -o",
                                    "mehrere Eingaben brauchen --output-folder ORDNER statt -o"};

}  // namespace axisc::cli::says
