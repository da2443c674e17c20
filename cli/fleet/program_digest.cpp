#include "cli/fleet/program_digest.hpp"

#include "cli/version.hpp"
#include "system/file.hpp"
#include "system/process.hpp"

#include <string>

namespace axisc::cli {

Digest program_digest() {
  std::string identity = system::build_identity();
  if (identity.empty()) {
    if (auto const bytes = system::bytes_of(system::program_path())) {
      identity = hexadecimal(digest_of(*bytes));
    }
  }
  Hasher hasher;
  hasher.text(version_text());
  hasher.text(identity);
  return hasher.finish();
}

}  // namespace axisc::cli
