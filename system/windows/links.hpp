// Which files are links.
#pragma once

#include <windows.h>

namespace axisc::system {

/// Files that a service fetches when they are read are reparse points, too, but not links.
[[nodiscard]] inline bool is_link(DWORD attributes, DWORD reparse_tag) {
  return (attributes & FILE_ATTRIBUTE_REPARSE_POINT) != 0 &&
         (reparse_tag == IO_REPARSE_TAG_SYMLINK || reparse_tag == IO_REPARSE_TAG_MOUNT_POINT);
}

}  // namespace axisc::system
