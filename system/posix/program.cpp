#include "system/program.hpp"

#include "system/posix/error.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace axisc::system {
namespace {

/// Both ends are closed in other programs.
class Pipe {
 public:
  Pipe() { is_open_ = ::pipe2(ends_.data(), O_CLOEXEC) == 0; }
  Pipe(Pipe const&) = delete;
  Pipe& operator=(Pipe const&) = delete;
  ~Pipe() {
    if (!is_open_) return;
    ::close(reader());
    close_writer();
  }

  [[nodiscard]] bool is_open() const { return is_open_; }
  [[nodiscard]] int reader() const { return ends_[0]; }
  [[nodiscard]] int writer() const { return ends_[1]; }
  void close_writer() {
    if (ends_[1] >= 0) ::close(ends_[1]);
    ends_[1] = -1;
  }

 private:
  std::array<int, 2> ends_{-1, -1};
  bool is_open_ = false;
};

/// The streams of the new program. It must not inherit which signals this one ignores.
class Preparation {
 public:
  Preparation(Pipe const& output, Pipe const& errors) {
    ::posix_spawn_file_actions_init(&actions_);
    ::posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    ::posix_spawn_file_actions_adddup2(&actions_, output.writer(), STDOUT_FILENO);
    ::posix_spawn_file_actions_adddup2(&actions_, errors.writer(), STDERR_FILENO);
    ::posix_spawnattr_init(&attributes_);
    sigset_t usual;
    ::sigemptyset(&usual);
    ::sigaddset(&usual, SIGPIPE);
    ::sigaddset(&usual, SIGXFSZ);
    ::posix_spawnattr_setsigdefault(&attributes_, &usual);
    ::posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGDEF);
  }
  Preparation(Preparation const&) = delete;
  Preparation& operator=(Preparation const&) = delete;
  ~Preparation() {
    ::posix_spawn_file_actions_destroy(&actions_);
    ::posix_spawnattr_destroy(&attributes_);
  }

  /// 0, or the number of the error.
  int start(pid_t& process, std::vector<std::string> const& arguments) const {
    std::vector<char*> words;
    words.reserve(arguments.size() + 1);
    // The interface is older than const; nothing writes there.
    for (auto const& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
    words.push_back(nullptr);
    return ::posix_spawnp(&process, words.front(), &actions_, &attributes_, words.data(), environ);
  }

 private:
  posix_spawn_file_actions_t actions_{};
  posix_spawnattr_t attributes_{};
};

/// Both at once: a program may wait until one of them is read.
void read_to_the_end(Pipe const& output, Pipe const& errors, ProgramOutcome& outcome) {
  std::array<pollfd, 2> waiting{{{.fd = output.reader(), .events = POLLIN, .revents = 0},
                                 {.fd = errors.reader(), .events = POLLIN, .revents = 0}}};
  std::array<char, 1U << 14U> buffer{};
  while (waiting[0].fd >= 0 || waiting[1].fd >= 0) {
    if (::poll(waiting.data(), waiting.size(), -1) < 0 && errno != EINTR) return;
    for (auto& each : waiting) {
      if (each.fd < 0 || each.revents == 0) continue;
      ssize_t const got = ::read(each.fd, buffer.data(), buffer.size());
      if (got < 0 && errno == EINTR) continue;
      if (got > 0) {
        auto& text = &each == waiting.data() ? outcome.output : outcome.errors;
        text.append(buffer.data(), static_cast<std::size_t>(got));
      } else {
        each.fd = -1;
      }
    }
  }
}

}  // namespace

Result<ProgramOutcome> run_program(std::vector<std::string> const& arguments) {
  Pipe output;
  Pipe errors;
  if (!output.is_open() || !errors.is_open()) return last_error();
  pid_t process = 0;
  if (int const error = Preparation(output, errors).start(process, arguments); error != 0) {
    return error_of(error);
  }
  output.close_writer();
  errors.close_writer();
  ProgramOutcome outcome;
  read_to_the_end(output, errors, outcome);
  int status = 0;
  while (::waitpid(process, &status, 0) < 0) {
    if (errno != EINTR) return last_error();
  }
  constexpr int ended_by_signal = 128;
  outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : ended_by_signal;
  return outcome;
}

}  // namespace axisc::system
