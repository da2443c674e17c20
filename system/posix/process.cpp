#include "system/process.hpp"

#include "system/posix/error.hpp"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <sys/ioctl.h>
#include <unistd.h>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace axisc::system {

void prepare_streams() {
  static_cast<void>(std::signal(SIGPIPE, SIG_IGN));
  static_cast<void>(std::signal(SIGXFSZ, SIG_IGN));
  for (int descriptor = STDIN_FILENO; descriptor <= STDERR_FILENO; ++descriptor) {
    // open() takes the lowest free number, which is this one. Writing to it fails like writing to the closed
    // one.
    if (::fcntl(descriptor, F_GETFD) == -1) static_cast<void>(::open("/dev/null", O_RDONLY));
  }
}

void keep_memory() {
#if defined(__GLIBC__)
  constexpr int kept = 1 << 25;
  constexpr int growth = 1 << 18;
  static_cast<void>(mallopt(M_MMAP_THRESHOLD, kept));
  static_cast<void>(mallopt(M_TRIM_THRESHOLD, kept));
  static_cast<void>(mallopt(M_TOP_PAD, growth));
#endif
}

bool is_terminal(Stream stream) {
  return ::isatty(static_cast<int>(stream)) == 1;
}

std::optional<std::size_t> terminal_width() {
  winsize size{};
  if (::ioctl(static_cast<int>(Stream::output), TIOCGWINSZ, &size) != 0 || size.ws_col == 0) {
    return std::nullopt;
  }
  return size.ws_col;
}

std::optional<Error> write(Stream stream, std::string_view bytes) {
  while (!bytes.empty()) {
    auto const written = ::write(static_cast<int>(stream), bytes.data(), bytes.size());
    if (written >= 0) {
      bytes.remove_prefix(static_cast<std::size_t>(written));
    } else if (errno != EINTR) {
      return last_error();
    }
  }
  return std::nullopt;
}

std::string_view environment_variable(char const* name) {
  char const* const value =
      std::getenv(name);  // NOLINT(concurrency-mt-unsafe): nothing changes the environment
  return value == nullptr ? std::string_view{} : value;
}

std::string_view language_of_settings() {
  return {};
}

bool shell_expands_patterns() {
  return true;
}

ProcessName process_name() {
  char host[256] = {};
  static_cast<void>(::gethostname(host, sizeof(host) - 1));
  return {.number = static_cast<std::uint64_t>(::getpid()), .host = host};
}

}  // namespace axisc::system
