#include "axisc/environment/version.hpp"

#include "axisrt.h"
#include "runtime/format/image_format.h"

namespace axisc {

std::string_view program_version() {
  return AXISC_VERSION;
}

std::string version_text() {
  std::string text = "axisc " AXISC_VERSION " (" AXISC_ORIGIN "; image format ";
  text.append(std::to_string(axim_major)).append(".").append(std::to_string(axim_minor));
  return text + ", runtime interface " + std::to_string(AXISRT_ABI_VERSION) + ")\n";
}

}  // namespace axisc
