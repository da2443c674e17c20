// `axisc run --record` and `axisc replay`.
#include "cli/compiled_machine.hpp"
#include "runtime/format/recording_format.h"
#include "support/catch.hpp"

#include <cstdint>
#include <string_view>

namespace replay_test {

using namespace axisc::test;
using Catch::Matchers::Contains;

namespace {

/// CRC-32C, bit by bit.
std::uint32_t checksum(std::string_view bytes) {
  std::uint32_t sum = ~0U;
  for (char const byte : bytes) {
    sum ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit) sum = sum >> 1U ^ ((sum & 1U) != 0 ? 0x82F63B78U : 0);
  }
  return ~sum;
}

/// Makes the checksums of a recording right.
void sign_again(std::string& recording) {
  constexpr std::size_t header = 64;
  constexpr std::size_t sums = 48;
  auto const put = [&](std::size_t at, std::uint32_t sum) {
    for (std::size_t i = 0; i < 4; ++i) recording[at + i] = static_cast<char>(sum >> 8 * i);
  };
  put(sums, checksum(std::string_view(recording).substr(header)));
  put(sums + 4, 0);
  put(sums + 4, checksum(std::string_view(recording).substr(0, header)));
}

}  // namespace

TEST_CASE("a recording replays bit for bit, from its first cycle and from a later one") {
  TemporaryFolder const folder;
  auto const there = compiled(folder);
  for (std::string const cycles : {"1000", "40"}) {
    for (std::string const level : {"portable", "auto"}) {
      auto const made = run_axisc({"run", "m.axim", "--signal", "ramp:2000", "--cycles", "300", "--level",
                                   level, "--record", "r.axrd", "--record-cycles", cycles, "-o", "run.csv"},
                                  there);
      REQUIRE(made.status == 0);
      auto const replayed = run_axisc({"replay", "m.axim", "r.axrd", "-o", "replay.csv"}, there);
      INFO(replayed.out << replayed.err);
      CHECK(replayed.status == 0);
      CHECK_THAT(replayed.out, Contains("bit for bit"));
      // The outputs are those that `run` wrote: its last line holds the axes' outputs, the replay's every
      // second number.
      auto const run = folder.read("run.csv");
      auto const table = folder.read("replay.csv");
      std::string last = run.substr(run.rfind('\n', run.size() - 2) + 1);
      std::string const first_output = last.substr(0, last.find_first_of(",\n"));
      std::string const row = table.substr(table.rfind('\n', table.size() - 2) + 1);
      CHECK_THAT(row, Contains("," + first_output));
    }
  }
}

TEST_CASE("a replay says what happened in which cycle") {
  TemporaryFolder const folder;
  auto const there = compiled(folder);
  folder.write("in.csv", "X\n0\n0\nnan\nnan\n0\n1e9\n1e9\n1e9\n");
  REQUIRE(run_axisc({"run", "m.axim", "--input", "in.csv", "--record", "r.axrd", "--quiet"}, there).status ==
          0);
  auto const text = run_axisc({"replay", "m.axim", "r.axrd"}, there);
  CHECK(text.status == 0);
  CHECK_THAT(text.out, Contains("reset to 0"));
  CHECK_THAT(text.out, Contains("\n      2      3  X        ") && Contains("AXISRT_BAD_INPUT"));
  CHECK_THAT(text.out, Contains("AXISRT_IMPLAUSIBLE"));
  auto const json = run_axisc({"replay", "m.axim", "r.axrd", "--format", "json"}, there);
  CHECK_THAT(json.out, Contains("\"first_cycle\": 2") && Contains("\"differences\": 0"));
  auto const german = run_axisc({"replay", "m.axim", "r.axrd", "--lang", "de"}, there);
  CHECK_THAT(german.out, Contains("Bit für Bit") && Contains("zurückgesetzt auf 0"));
}

TEST_CASE("a jump of an output is a warning of `run`") {
  TemporaryFolder const folder;
  auto const there = compiled(folder);
  auto const run =
      run_axisc({"run", "m.axim", "--signal", "step", "--amplitude", "1e9", "--cycles", "5"}, there);
  CHECK(run.status == 0);
  CHECK_THAT(run.err, Contains("P-AXIS-00212") && Contains("cycle"));
  CHECK(run_axisc({"run", "m.axim", "--signal", "step", "--amplitude", "1e9", "--cycles", "5", "--quiet"},
                  there)
            .err.empty());
}

TEST_CASE("what is no recording of this image is refused in one line") {
  TemporaryFolder const folder;
  auto const there = compiled(folder);
  REQUIRE(run_axisc({"run", "m.axim", "--signal", "step", "--cycles", "20", "--record", "r.axrd"}, there)
              .status == 0);
  auto const expect = [&](std::vector<std::string> const& arguments, std::string const& what) {
    auto const outcome = run_axisc(arguments, there);
    INFO(outcome.err);
    CHECK(outcome.status == 2);
    CHECK(lines_of(outcome.err) == 1);
    CHECK_THAT(outcome.err, Contains(what));
  };
  expect({"replay", "m.axim", "m.axim"}, "AXISRT_BAD_RECORDING");
  expect({"replay", "m.axim", "nowhere.axrd"}, "nowhere.axrd");
  expect({"replay", "m.axim"}, "RECORDING");
  expect({"replay", "m.axim", "r.axrd", "-o", "r.axrd"}, "r.axrd");
  std::string bytes = folder.read("r.axrd");
  folder.write("cut.axrd", bytes.substr(0, bytes.size() - 8));
  expect({"replay", "m.axim", "cut.axrd"}, "cut.axrd");
  folder.write("empty.axrd", "");
  expect({"replay", "m.axim", "empty.axrd"}, "empty.axrd");
  std::string const machine = std::string(AXISC_SOURCE_DIR) + "/tests/cli/data/machine/machine.json";
  REQUIRE(
      run_axisc({"compile", machine, "-o", "newer.axim", "--image-version", "7", "--strip", "--quiet"}, there)
          .status == 0);
  expect({"replay", "newer.axim", "r.axrd"}, "AXISRT_OTHER_IMAGE");
  expect({"run", "m.axim", "--record-cycles", "7"}, "--record");
  expect({"run", "m.axim", "--record", "r.axrd", "--record-cycles", "0"}, "--record-cycles");
}

TEST_CASE("a status that is none makes a damaged recording") {
  TemporaryFolder const folder;
  auto const there = compiled(folder);
  REQUIRE(run_axisc({"run", "m.axim", "--cycles", "5", "--record", "r.axrd", "--quiet"}, there).status == 0);
  auto const recording = folder.read("r.axrd");
  // The head of the first entry after the saved state: kind, flags and status.
  constexpr std::size_t word = 8;
  auto const words_of_state = static_cast<unsigned char>(recording[3 * word]) +
                              256U * static_cast<unsigned char>(recording[3 * word + 1]);
  std::size_t const head = (axrd_header_words + words_of_state) * word;
  auto damaged = recording;
  damaged[head + 3] = '\x7F';
  sign_again(damaged);
  folder.write("d.axrd", damaged);
  auto const outcome = run_axisc({"replay", "m.axim", "d.axrd"}, there);
  CHECK(outcome.status == 2);
  CHECK_THAT(outcome.err, Contains("AX9004"));

  auto same = recording;
  sign_again(same);
  CHECK(same == recording);
}

}  // namespace replay_test
