#include "system/program.hpp"

#include "system/posix/error.hpp"

#include <cerrno>

namespace axisc::system {

// A browser runs one program.
Result<ProgramOutcome> run_program(std::vector<std::string> const& /*arguments*/) {
  return error_of(ENOSYS);
}

}  // namespace axisc::system
