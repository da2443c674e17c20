// Signed images: keys, signing, and every command that reads an image.
#include "cli/compiled_machine.hpp"
#include "support/catch.hpp"

#include <filesystem>
#include <sys/stat.h>

namespace sign_test {

using namespace axisc::test;
using Catch::Matchers::Contains;

namespace {

unsigned mode_of(std::string const& path) {
  struct stat facts {};
  REQUIRE(::stat(path.c_str(), &facts) == 0);
  return facts.st_mode & 0777U;
}

/// An image m.axim, the same signed as s.axim, keys a and b.
Surroundings prepared(TemporaryFolder const& folder) {
  Surroundings there = compiled(folder);
  for (std::string const key : {"a", "b"}) REQUIRE(run_axisc({"keygen", key}, there).status == 0);
  REQUIRE(run_axisc({"sign", "m.axim", "--key", "a", "-o", "s.axim", "--quiet"}, there).status == 0);
  return there;
}

}  // namespace

TEST_CASE("a secret key is for its owner alone, is never printed and never overwritten", "[posix]") {
  TemporaryFolder const folder;
  auto const there = in_folder(folder.path());
  auto const made = run_axisc({"keygen", "plant.key"}, there);
  CHECK(made.status == 0);
  std::string const path = folder.path() + "/plant.key";
  auto const secret = folder.read("plant.key");
  auto const open = folder.read("plant.key.pub");
  CHECK(mode_of(path) == 0600);
  CHECK(secret.rfind("axisc-secret-key-1 ", 0) == 0);
  CHECK(open.rfind("axisc-public-key-1 ", 0) == 0);
  CHECK_THAT(made.out, Contains("plant.key.pub") && !Contains(secret.substr(19, 32)));
  CHECK(made.err.empty());
  CHECK(folder.entries() == 2);

  auto const again = run_axisc({"keygen", "plant.key"}, there);
  CHECK(again.status == 2);
  CHECK_THAT(again.err, Contains("exists already"));
  CHECK(folder.read("plant.key") == secret);
  CHECK(folder.read("plant.key.pub") == open);

  std::filesystem::remove(path + ".pub");
  CHECK(run_axisc({"keygen", "plant.key"}, there).status == 2);
  CHECK(folder.read("plant.key") == secret);
  CHECK_FALSE(std::filesystem::exists(path + ".pub"));
}

TEST_CASE("a secret key that others may read, or that is none, is refused", "[posix]") {
  TemporaryFolder const folder;
  auto const there = prepared(folder);
  std::string const path = folder.path() + "/a";
  ::chmod(path.c_str(), 0640);
  auto const shared = run_axisc({"sign", "m.axim", "--key", "a"}, there);
  CHECK(shared.status == 2);
  CHECK_THAT(shared.err, Contains("chmod 600 a") && Contains("AX9001"));
  ::chmod(path.c_str(), 0600);

  CHECK_THAT(run_axisc({"sign", "m.axim", "--key", "a.pub"}, there).err, Contains("is not a secret key"));
  CHECK_THAT(run_axisc({"sign", "m.axim", "--key", "nothing"}, there).err, Contains("no such file"));
  CHECK_THAT(run_axisc({"inspect", "s.axim", "--key", "a"}, there).err, Contains("is not a public key"));
  auto damaged = folder.read("a");
  damaged[25] = damaged[25] == '0' ? '1' : '0';
  folder.write("a", damaged);
  CHECK_THAT(run_axisc({"sign", "m.axim", "--key", "a"}, there).err,
             Contains("is not a secret key") && !Contains(damaged.substr(19, 32)));
  CHECK_THAT(run_axisc({"sign", "m.axim"}, there).err, Contains("--key is missing"));
}

TEST_CASE("inspect says whether an image is signed, and checks it with a key") {
  TemporaryFolder const folder;
  auto const there = prepared(folder);
  CHECK_THAT(run_axisc({"inspect", "m.axim"}, there).out, Contains("signature      none"));
  CHECK_THAT(run_axisc({"inspect", "s.axim"}, there).out, Contains("(not checked)"));
  auto const right = run_axisc({"inspect", "s.axim", "--key", "a.pub"}, there);
  CHECK(right.status == 0);
  CHECK_THAT(right.out, Contains(", valid"));
  CHECK_THAT(run_axisc({"inspect", "s.axim", "--key", "a.pub", "--format", "json"}, there).out,
             Contains("\"checked\": true"));
  CHECK_THAT(run_axisc({"inspect", "m.axim", "--format", "json"}, there).out,
             Contains("\"signature\": null"));

  auto const unsigned_image = run_axisc({"inspect", "m.axim", "--key", "a.pub"}, there);
  CHECK(unsigned_image.status == 2);
  CHECK_THAT(unsigned_image.err, Contains("AXISRT_UNSIGNED") && Contains("axisc sign"));
  auto const other = run_axisc({"inspect", "s.axim", "--key", "b.pub"}, there);
  CHECK(other.status == 2);
  CHECK_THAT(other.err, Contains("AXISRT_WRONG_SIGNATURE") && Contains("was signed with key"));
}

TEST_CASE("every command reads a signed image like the unsigned one") {
  TemporaryFolder const folder;
  auto const there = prepared(folder);
  CHECK(run_axisc({"run", "s.axim", "--cycles", "20"}, there).out ==
        run_axisc({"run", "m.axim", "--cycles", "20"}, there).out);
  CHECK(run_axisc({"response", "s.axim"}, there).out == run_axisc({"response", "m.axim"}, there).out);
  auto const diff = run_axisc({"diff", "s.axim", "m.axim"}, there);
  CHECK(diff.status == 0);
  auto const as_list = run_axisc({"inspect", "m.axim", "--as-list"}, there).out;
  REQUIRE(run_axisc({"sign", "m.axim", "--key", "a", "--quiet"}, there).status == 0);
  CHECK(run_axisc({"inspect", "m.axim", "--as-list"}, there).out == as_list);
}

TEST_CASE("signing again replaces the signature; the image's bytes stay") {
  TemporaryFolder const folder;
  auto const there = prepared(folder);
  auto const image = folder.read("m.axim");
  auto const once = folder.read("s.axim");
  REQUIRE(once.size() == image.size() + 80);
  CHECK(once.substr(0, image.size()) == image);
  CHECK(once.substr(image.size(), 4) == "AXSG");
  CHECK(run_axisc({"sign", "s.axim", "--key", "a"}, there).status == 0);
  CHECK(folder.read("s.axim") == once);
  CHECK(run_axisc({"sign", "s.axim", "--key", "b"}, there).status == 0);
  CHECK(folder.read("s.axim").size() == once.size());
  CHECK(run_axisc({"inspect", "s.axim", "--key", "b.pub"}, there).status == 0);
}

TEST_CASE("a signed image that was changed or cut off is refused") {
  TemporaryFolder const folder;
  auto const there = prepared(folder);
  auto bytes = folder.read("s.axim");
  auto changed = bytes;
  changed.back() = static_cast<char>(changed.back() ^ 1);
  folder.write("s.axim", changed);
  auto const outcome = run_axisc({"inspect", "s.axim", "--key", "a.pub", "--lang", "de"}, there);
  CHECK(outcome.status == 2);
  CHECK_THAT(outcome.err, Contains("AXISRT_WRONG_SIGNATURE") && Contains("verändert"));
  bytes.pop_back();
  folder.write("s.axim", bytes);
  CHECK_THAT(run_axisc({"inspect", "s.axim"}, there).err, Contains("AXISRT_WRONG_SIZE"));
}

TEST_CASE("a full disk leaves the old image and no half key") {
  TemporaryFolder const folder;
  auto const there = prepared(folder);
  auto const outcome = run_axisc({"sign", "m.axim", "--key", "a", "-o", "/dev/full"}, there);
  CHECK(outcome.status == 2);
  CHECK_THAT(outcome.err, Contains("no space"));
  CHECK(run_axisc({"keygen", "no/such/folder/key"}, there).status == 2);
}

}  // namespace sign_test
