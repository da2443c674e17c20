// `@FILE`: more inputs than a command line may hold.
#include "cli/program.hpp"
#include "support/temporary_folder.hpp"

namespace response_file_test {

using namespace axisc::test;
using Catch::Matchers::Contains;

namespace {

std::string const sound = "kopf.achs_nr 1\nEnde\n";

struct Lists {
  Lists() {
    for (auto const* const name : {"a.lis", "b.lis", "with blank.lis", "sub/c.lis"})
      folder.write(name, sound);
  }
  [[nodiscard]] Outcome lint(std::vector<std::string> arguments, std::string const& input = {}) const {
    arguments.insert(arguments.begin(), "lint");
    auto surroundings = in_folder(folder.path());
    surroundings.input = input;
    return run_axisc(arguments, surroundings);
  }
  TemporaryFolder folder;
};

}  // namespace

TEST_CASE("a response file names one input per line") {
  Lists const lists;
  lists.folder.write("sub/names.txt", "a.lis\r\n\nwith blank.lis\nsub/c.lis");
  // Relative to the working folder, not to the response file.
  auto const outcome = lists.lint({"@sub/names.txt", "b.lis"});
  CHECK(outcome.status == 0);
  CHECK_THAT(outcome.out, Contains("4 files"));
  CHECK(outcome.err.empty());
}

TEST_CASE("response files of Windows have a byte order mark, or are refused as UTF-16") {
  TemporaryFolder const folder;
  auto const there = in_folder(folder.path());
  folder.write("x.lis", "filter_fir.type 1\nfilter_fir.order 300\n");
  folder.write("utf8.txt", "\xEF\xBB\xBFx.lis\r\n");
  CHECK(run_axisc({"lint", "@utf8.txt"}, there).status == 1);
  folder.write("utf16.txt", std::string("\xFF\xFEx\0.\0l\0i\0s\0", 12));
  auto const refused = run_axisc({"lint", "@utf16.txt"}, there);
  CHECK(refused.status == 2);
  CHECK_THAT(refused.err, Catch::Matchers::Contains("utf16.txt") && Catch::Matchers::Contains("UTF-16"));
}

TEST_CASE("a response file with NULs may hold names with line breaks", "[posix]") {
  Lists const lists;
  lists.folder.write("two\nlines.lis", sound);
  using namespace std::string_literals;
  lists.folder.write("names.txt", "a.lis\0two\nlines.lis\0"s);
  CHECK_THAT(lists.lint({"@names.txt"}).out, Contains("2 files"));
  CHECK_THAT(lists.lint({"@-"}, "a.lis\0b.lis\0"s).out, Contains("2 files"));
}

TEST_CASE("names in quotes, as Ninja writes them") {
  Lists const lists;
  lists.folder.write("it's.lis", sound);
  lists.folder.write("names.txt", "a.lis\n'with blank.lis'\n'it'\\''s.lis'\n");
  auto const outcome = lists.lint({"@names.txt"});
  CHECK(outcome.status == 0);
  CHECK_THAT(outcome.out, Contains("3 files"));
}

TEST_CASE("commands with several inputs take response files") {
  Lists const lists;
  lists.folder.write("names.txt", "a.lis\nb.lis\n");
  auto const there = in_folder(lists.folder.path());
  CHECK(run_axisc({"fmt", "--check", "@names.txt", "-j", "3"}, there).out ==
        "a.lis would be formatted\nb.lis would be formatted\n");
  auto const compiled =
      run_axisc({"compile", "@names.txt", "--output-folder", "out", "--cycle-time", "1ms"}, there);
  CHECK_THAT(compiled.err, Contains("2 written"));
  lists.folder.write("one.txt", "a.lis\n");
  CHECK(run_axisc({"compile", "@one.txt", "-o", "a.axim", "--cycle-time", "1ms"}, there).status == 0);
  CHECK_THAT(run_axisc({"compile", "@names.txt", "-o", "a.axim", "--cycle-time", "1ms"}, there).err,
             Contains("--output-folder"));
}

TEST_CASE("what is wrong in a response file has a place") {
  Lists const lists;
  auto const check = [&](std::string const& content, std::string const& expected) {
    lists.folder.write("names.txt", content);
    auto const outcome = lists.lint({"@names.txt"});
    INFO(expected);
    CHECK(outcome.status == 2);
    CHECK(lines_of(outcome.err) == 1);
    CHECK_THAT(outcome.err, Contains(expected));
  };
  check("a.lis\nmissing.lis\n", "cannot read missing.lis, named in names.txt:2");
  check("a.lis\n\n@other.txt\n", "names.txt:3: a response file cannot name another one");
  check("a.lis\n" + std::string(5000, 'x') + "\n", "names.txt:2: a name of 5000 bytes");
  check("\n\n", "names.txt names no input");
  CHECK_THAT(lists.lint({"@nowhere.txt"}).err, Contains("cannot read nowhere.txt"));
  // The inputs that are there are still checked, and a file of such a name has another way in.
  lists.folder.write("names.txt", "missing.lis\na.lis\n");
  CHECK_THAT(lists.lint({"@names.txt"}).out, Contains("1 file"));
  lists.folder.write("@odd.lis", sound);
  CHECK(lists.lint({"./@odd.lis"}).status == 0);
}

}  // namespace response_file_test
