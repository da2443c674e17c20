// Memory does not grow with the number of inputs, except for SARIF by their findings.
#include "cli/program.hpp"
#include "support/golden.hpp"
#include "support/sanitized.hpp"
#include "support/temporary_folder.hpp"

namespace memory_test {

using namespace axisc::test;

namespace {

/// Under the address sanitizer nothing is used again for a while.
constexpr bool keeps_what_is_freed = sanitized;

}  // namespace

// Some inputs wait for their turn, more of them where more threads finish early; 80 MB of findings do not.
TEST_CASE("findings of many inputs do not stay in memory") {
  TemporaryFolder const folder;
  std::string list = "kopf.achs_nr 1\n";
  for (int i = 0; i < 1000; ++i) list += "= " + std::to_string(i) + "\n";
  list += "Ende\n";
  auto const first = folder.write("lists/0.lis", list);
  constexpr int inputs = sanitized ? 4 : 80;
  for (int i = 1; i < inputs; ++i) {
    std::filesystem::create_hard_link(first, folder / ("lists/" + std::to_string(i) + ".lis"));
  }
  for (std::string const format : {"text", "json", "jsonl", "sarif", "github", "gitlab", "junit"}) {
    auto const few = run_axisc({"lint", "lists/0.lis", "--format", format}, in_folder(folder.path()));
    auto const many = run_axisc({"lint", "lists", "--format", format}, in_folder(folder.path()));
    CHECK(many.status == few.status);
    INFO(format << ": " << many.out.size() << " bytes of findings");
    // The heads of SARIF and JUnit are about all findings, so they wait for the last one.
    std::size_t const waiting = format == "sarif" || format == "junit" ? many.out.size() * 5 / 4 : 0;
    if (!keeps_what_is_freed) CHECK(many.peak_memory < few.peak_memory + waiting + (std::size_t{52} << 20U));
  }
}

TEST_CASE("findings of one long list are printed as they come") {
  TemporaryFolder const folder;
  std::string list = "kopf.achs_nr 1\n";
  folder.write("short.lis", list + "Ende\n");
  constexpr int mistakes = sanitized ? 6000 : 60000;
  for (int i = 0; i < mistakes; ++i) list += "= " + std::to_string(i) + "\n";
  folder.write("long.lis", list + "Ende\n");
  for (std::string const format : {"text", "json", "gitlab"}) {
    auto const few = run_axisc({"lint", "short.lis", "--format", format}, in_folder(folder.path()));
    auto const many = run_axisc({"lint", "long.lis", "--format", format}, in_folder(folder.path()));
    INFO(format << ": " << many.out.size() << " bytes of findings");
    CHECK(many.out.size() > std::size_t{mistakes} * 140);
    // A place for each of them stays.
    if (!keeps_what_is_freed) CHECK(many.peak_memory < few.peak_memory + mistakes * std::size_t{250});
  }
}

}  // namespace memory_test
