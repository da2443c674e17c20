// What a person at a terminal sees of long work, and a pipe does not.
#include "cli/program.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

using namespace axisc::test;
using Catch::Matchers::Contains;

namespace {

/// Standard error of a lint of `folder` whose standard error is a terminal.
std::string seen_on_terminal(std::string const& folder) {
  int const terminal = ::posix_openpt(O_RDWR | O_NOCTTY);
  REQUIRE(terminal >= 0);
  REQUIRE(::grantpt(terminal) == 0);
  REQUIRE(::unlockpt(terminal) == 0);
  auto const child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    char name[128] = {};
    if (::ptsname_r(terminal, name, sizeof(name)) != 0) ::_exit(126);
    if (::dup2(::open("/dev/null", O_WRONLY), 1) < 0) ::_exit(126);
    if (::dup2(::open(name, O_RDWR | O_NOCTTY), 2) < 0) ::_exit(126);
    ::close(terminal);
    ::execl(AXISC_PROGRAM, AXISC_PROGRAM, "lint", folder.c_str(), "--format", "sarif", "-j", "1", "--lang",
            "en", nullptr);
    ::_exit(127);
  }
  // Stopped on its way, so that it takes longer than a person is left without a word, however fast the
  // machine is.
  std::this_thread::sleep_for(std::chrono::milliseconds(60));
  ::kill(child, SIGSTOP);
  std::this_thread::sleep_for(std::chrono::milliseconds(600));
  ::kill(child, SIGCONT);
  std::string text;
  char block[4096];
  // The end is an error: nobody has the other side open any more.
  for (auto got = ::read(terminal, block, sizeof(block)); got > 0;
       got = ::read(terminal, block, sizeof(block))) {
    text.append(block, static_cast<std::size_t>(got));
  }
  int status = 0;
  REQUIRE(::waitpid(child, &status, 0) == child);
  ::close(terminal);
  return text;
}

}  // namespace

TEST_CASE("long work shows how far it is, on a terminal only") {
  TemporaryFolder const folder;
  std::string list = "kenngr.achs_typ 1\n";
  for (int i = 0; i < 600; ++i) list += "= 5\n";
  auto const first = folder.write("0.lis", list);
  for (int i = 1; i < 300; ++i) {
    std::filesystem::create_hard_link(first, folder / (std::to_string(i) + ".lis"));
  }
  auto const text = seen_on_terminal(folder.path());
  CHECK_THAT(text, Contains(" of 300, ") && Contains("per second") && Contains("[#"));
  // The line is gone at the end.
  CHECK_THAT(text, Catch::Matchers::EndsWith("\r\033[K"));
  CHECK(run_axisc({"lint", folder / "0.lis", "--format", "sarif", "-j", "1"}).err.empty());
}
