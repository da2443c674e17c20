#include "system/posix/error.hpp"

#include <cerrno>
#include <system_error>

namespace axisc::system {

Error error_of(int number) {
  auto const refusal = [number] {
    switch (number) {
      case ENOENT:
      case ENOTDIR: return Refusal::not_found;
      case EEXIST: return Refusal::exists;
      case EISDIR: return Refusal::is_folder;
      case EACCES:
      case EPERM: return Refusal::no_permission;
      case EROFS: return Refusal::read_only;
      case ENOSPC:
      case EDQUOT:
      case EFBIG: return Refusal::no_space;
      case EPIPE: return Refusal::closed_pipe;
      case EBADF: return Refusal::not_open;
      case ELOOP: return Refusal::link_loop;
      default: return Refusal::other;
    }
  };
  return {.refusal = refusal(), .number = number};
}

Error last_error() {
  return error_of(errno);
}

std::string text_of(Error const& error) {
  return std::generic_category().message(error.number);
}

}  // namespace axisc::system
