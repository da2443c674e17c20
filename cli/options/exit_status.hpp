// How the program ends; scripts rely on the numbers.
#pragma once

namespace axisc::cli {

enum class ExitStatus : int {
  success = 0,   ///< nothing wrong; warnings may have been printed
  findings = 1,  ///< findings of severity error, or warnings with --werror
  failure = 2,   ///< the command line, a file or the environment is at fault
};

}  // namespace axisc::cli
