#include "axisc/files/output_file.hpp"

#include "axisc/environment/failure.hpp"
#include "support/temporary_folder.hpp"

#include <csignal>
#include <sys/stat.h>
#include <sys/wait.h>
#include <sys/xattr.h>
#include <unistd.h>

namespace output_file_test {

using namespace axisc;
using namespace axisc;
namespace fs = std::filesystem;

namespace {

void write(std::string const& path, std::string_view bytes) {
  OutputFile file(path);
  file.write(bytes);
  file.commit();
}

std::string failure_of(std::string const& path) {
  try {
    write(path, "new");
  } catch (Failure const& failure) {
    return failure.what();
  }
  return "no failure";
}

}  // namespace

TEST_CASE("a new file has the usual mode") {
  test::TemporaryFolder const folder;
  auto const mask = ::umask(027);
  write(folder / "out", "bytes");
  ::umask(mask);
  CHECK(folder.read("out") == "bytes");
  CHECK(fs::status(folder / "out").permissions() == static_cast<fs::perms>(0640));
  CHECK(folder.entries() == 1);
}

TEST_CASE("an old file keeps its mode and is replaced at once") {
  test::TemporaryFolder const folder;
  folder.write("out", "old and longer");
  fs::permissions(folder / "out", static_cast<fs::perms>(0604));
  {
    OutputFile file(folder / "out");
    file.write("new");
    CHECK(folder.read("out") == "old and longer");
    file.commit();
  }
  CHECK(folder.read("out") == "new");
  CHECK(fs::status(folder / "out").permissions() == static_cast<fs::perms>(0604));
  CHECK(folder.entries() == 1);
}

TEST_CASE("without commit nothing is left behind") {
  test::TemporaryFolder const folder;
  folder.write("out", "old");
  {
    OutputFile file(folder / "out");
    file.write("half");
  }
  CHECK(folder.read("out") == "old");
  CHECK(folder.entries() == 1);
}

TEST_CASE("an interrupted program leaves no temporary file behind") {
  test::TemporaryFolder const folder;
  folder.write("out", "old");
  for (int const signal : {SIGINT, SIGTERM, SIGHUP}) {
    pid_t const child = ::fork();
    REQUIRE(child >= 0);
    if (child == 0) {
      static_cast<void>(::signal(signal, SIG_DFL));  // the test program handles it
      OutputFile file(folder / "out");
      file.write("half");
      static_cast<void>(::raise(signal));
      ::_exit(0);
    }
    int status = 0;
    REQUIRE(::waitpid(child, &status, 0) == child);
    CHECK(WIFSIGNALED(status));
    CHECK(WTERMSIG(status) == signal);
    CHECK(folder.read("out") == "old");
    CHECK(folder.entries() == 1);
  }
}

TEST_CASE("a signal that is ignored does not interrupt") {
  test::TemporaryFolder const folder;
  pid_t const child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    static_cast<void>(::signal(SIGHUP, SIG_IGN));
    OutputFile file(folder / "out");
    file.write("all");
    static_cast<void>(::raise(SIGHUP));
    file.commit();
    ::_exit(0);
  }
  int status = 1;
  REQUIRE(::waitpid(child, &status, 0) == child);
  CHECK(status == 0);
  CHECK(folder.read("out") == "all");
}

TEST_CASE("a file that was changed since it was read stays as it is") {
  test::TemporaryFolder const folder;
  folder.write("x.lis", "new by another program");
  std::string said;
  try {
    replace_content(folder / "x.lis", "as it was read", "formatted");
  } catch (Failure const& failure) {
    said = failure.what();
  }
  CHECK_THAT(said, Catch::Matchers::Contains("changed while"));
  CHECK(folder.read("x.lis") == "new by another program");
  CHECK(folder.entries() == 1);
  replace_content(folder / "x.lis", "new by another program", "formatted");
  CHECK(folder.read("x.lis") == "formatted");
}

TEST_CASE("extended attributes are kept") {
  test::TemporaryFolder const folder;
  folder.write("out", "old");
  // Not every file system has them.
  if (::setxattr((folder / "out").c_str(), "user.origin", "plant 3", 7, 0) != 0) return;
  write(folder / "out", "new");
  char value[16] = {};
  CHECK(::getxattr((folder / "out").c_str(), "user.origin", value, sizeof(value)) == 7);
  CHECK(std::string(value) == "plant 3");
}

TEST_CASE("a symbolic link is followed") {
  test::TemporaryFolder const folder;
  folder.write("real/target", "old");
  fs::create_symlink("real/target", folder / "link");
  write(folder / "link", "new");
  CHECK(fs::is_symlink(folder / "link"));
  CHECK(folder.read("real/target") == "new");

  fs::create_symlink("real/not-yet", folder / "dangling");
  write(folder / "dangling", "first");
  CHECK(fs::is_symlink(folder / "dangling"));
  CHECK(folder.read("real/not-yet") == "first");
}

TEST_CASE("a device is written directly") {
  write("/dev/null", "gone");
  struct stat facts {};
  REQUIRE(::stat("/dev/null", &facts) == 0);
  CHECK(S_ISCHR(facts.st_mode));
  CHECK(failure_of("/dev/full") == "cannot write /dev/full: no space is left; an existing file is unchanged");
}

TEST_CASE("what cannot be written is said in one sentence") {
  test::TemporaryFolder const folder;
  auto const file = folder.write("file", "x");
  CHECK(failure_of(folder.path()) == "cannot write " + folder.path() + ": it is a folder; name a file in it");
  CHECK_THAT(failure_of(folder / "missing/out"),
             Catch::Matchers::EndsWith("its folder does not exist; create it first"));
  CHECK_THAT(failure_of(file + "/out"),
             Catch::Matchers::EndsWith("its folder does not exist; create it first"));
  if (::geteuid() != 0) {
    fs::permissions(file, static_cast<fs::perms>(0444));
    CHECK_THAT(failure_of(file), Catch::Matchers::Contains("permission denied"));
    CHECK(folder.read("file") == "x");
  }
}

}  // namespace output_file_test
