// NC programs of a hundred megabytes are usual in die and mould making; what is kept of one does not grow
// with it.
#include "cli/program.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>

namespace long_program_test {

using namespace axisc::test;

namespace {

constexpr std::size_t megabyte = std::size_t{1} << 20U;

void write_long_program(std::string const& path, std::size_t bytes) {
  std::ofstream file(path, std::ios::binary);
  std::string block;
  while (block.size() < megabyte) block += "N10 G01 X1.5000 Y-2.2500 F4000 (#FILTER ON [ORDER=999])\r\n";
  for (std::size_t written = 0; written < bytes; written += block.size()) file << block;
  file << "#FILTER ON [ORDER=40]\r\nM30\r\n";
}

}  // namespace

TEST_CASE("a program of 100 MB needs no more memory than one of 1 MB") {
  TemporaryFolder const folder;
  folder.write("x.lis", "kopf.log_achs_name X\nfilter_fir.type 1\nfilter_fir.order 20\n");
  folder.write(
      "machine.json",
      R"({"cycle_time_us": 1000, "axes": [{"name": "X", "list": "x.lis"}], "programs": ["part.nc"]})");
  auto const peak_of = [&](std::size_t bytes, std::vector<std::string> const& words) {
    write_long_program(folder / "part.nc", bytes);
    auto const outcome = run_axisc(words, in_folder(folder.path()));
    INFO(outcome.out << outcome.err);
    CHECK(outcome.status == 0);
    return outcome.peak_memory;
  };
  for (std::vector<std::string> const& words : {std::vector<std::string>{"lint", "part.nc", "machine.json"},
                                                {"compile", "machine.json", "-o", "out.axim"}}) {
    std::size_t const small = peak_of(megabyte, words);
    CHECK(peak_of(100 * megabyte, words) < small + 16 * megabyte);
  }
}

}  // namespace long_program_test
