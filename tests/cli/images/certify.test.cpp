#include "cli/compiled_machine.hpp"
#include "runtime/format/crc32c.hpp"

#include <cstring>

#include <nlohmann/json.hpp>

namespace certify_test {

using namespace axisc::test;
using Catch::Matchers::Contains;

namespace {

std::uint32_t number_at(std::string const& image, std::size_t at) {
  std::uint32_t number = 0;
  std::memcpy(&number, &image.at(at), sizeof number);
  return number;
}

void put_checksum(std::string& image, std::size_t at, std::size_t begin, std::size_t size) {
  std::memset(&image.at(at), 0, 4);
  std::uint32_t const checksum = axim_crc32c(reinterpret_cast<std::uint8_t const*>(&image.at(begin)), size);
  std::memcpy(&image.at(at), &checksum, sizeof checksum);
}

/// Place of the first record of the section `bounds`.
std::size_t bounds_at(std::string const& image) {
  for (std::size_t entry = 128; entry < 128 + 32 * std::size_t{number_at(image, 28)}; entry += 32) {
    if (number_at(image, entry) == 20) return number_at(image, entry + 8);
  }
  FAIL("no section `bounds`");
  return 0;
}

/// The image with a distance that is smaller by 2^-38.
std::string with_wrong_distance(std::string image) {
  std::size_t const at = bounds_at(image) + 48;
  double distance = 0;
  std::memcpy(&distance, &image.at(at), sizeof distance);
  distance *= 1 - 0x1p-38;
  std::memcpy(&image.at(at), &distance, sizeof distance);
  std::size_t const end = 128 + 32 * std::size_t{number_at(image, 28)};
  put_checksum(image, 24, end, image.size() - end);
  put_checksum(image, 12, 0, end);
  return image;
}

}  // namespace

TEST_CASE("certify says what holds for every setpoint, and that the image claims it") {
  TemporaryFolder const folder;
  auto const there = compiled(folder);
  auto const text = run_axisc({"certify", "m.axim"}, there);
  CHECK(text.status == 0);
  for (std::string const part : {"SHA-256", "poles within 0.", "no setpoint is amplified more than 1 ",
                                 "IMPLAUSIBLE above", "for good", "Verified: ", "Not covered: the drive"}) {
    CHECK_THAT(text.out, Contains(part));
  }
  CHECK_THAT(text.out, !Contains("safe"));
  auto const german = run_axisc({"certify", "m.axim", "--lang", "de"}, there);
  for (std::string const part : {"Pole innerhalb von 0,", "kein Sollwert wird mehr als 1-fach",
                                 "Ausgang == Sollwert", "Bestätigt: ", "Nicht abgedeckt: der Antrieb"}) {
    CHECK_THAT(german.out, Contains(part));
  }
  for (std::string const format : {"html", "markdown", "csv"}) {
    CHECK(run_axisc({"certify", "m.axim", "--format", format}, there).status == 0);
  }
}

TEST_CASE("certify in JSON has every field of the records") {
  TemporaryFolder const folder;
  auto const there = compiled(folder);
  auto const all = nlohmann::json::parse(run_axisc({"certify", "m.axim", "--format", "json"}, there).out);
  CHECK(all.at("verified") == true);
  CHECK(all.at("failures") == 0);
  auto const axis =
      nlohmann::json::parse(run_axisc({"certify", "m.axim", "--axis", "X", "--format", "json"}, there).out);
  REQUIRE(axis.at("axes").size() == 1);
  CHECK(axis.at("record_count") == all.at("record_count"));
  auto const& record = axis.at("axes").at(0).at("records").at(0);
  CHECK(record.at("gain_low") <= record.at("gain_high"));
  CHECK(record.at("verdict") == "verified");
  CHECK(run_axisc({"certify", "m.axim", "--axis", "Q"}, there).status == 2);
}

TEST_CASE("a claim that is not true is named, and the exit status is 1") {
  TemporaryFolder const folder;
  auto const there = compiled(folder);
  folder.write("wrong.axim", with_wrong_distance(folder.read("m.axim")));
  auto const text = run_axisc({"certify", "wrong.axim"}, there);
  CHECK(text.status == 1);
  CHECK_THAT(text.out, Contains("FALSE: distance_high"));
  CHECK_THAT(text.out, Contains("NOT TRUE: 1;"));
  auto const json =
      nlohmann::json::parse(run_axisc({"certify", "wrong.axim", "--format", "json"}, there).out);
  CHECK(json.at("verified") == false);
  CHECK(json.at("failures") == 1);
  CHECK(json.at("axes").at(0).at("records").at(0).at("false_field") == "distance_high");
  // The claims of all axes decide, whichever is shown.
  CHECK(run_axisc({"certify", "wrong.axim", "--axis", "Y"}, there).status == 1);
}

TEST_CASE("what is not proved is not shown as 0") {
  TemporaryFolder const folder;
  auto const there = in_folder(folder.path());
  folder.write("x.lis", "filter[0].enable 1\nfilter[0].order 2\nfilter[0].fg_f0 499.999\n");
  auto const compile =
      run_axisc({"compile", "x.lis", "--cycle-time", "1ms", "-o", "x.axim", "--quiet"}, there);
  REQUIRE(compile.status == 0);
  auto const text = run_axisc({"certify", "x.axim"}, there).out;
  CHECK_THAT(text, Contains("not bounded: ") && Contains("not claimed: ") && Contains("too close to half"));
  // The column of the roundings has nothing in its only row.
  CHECK_THAT(text, !Contains("rounding per"));
}

TEST_CASE("--no-bounds leaves the section out, --strip keeps it") {
  TemporaryFolder const folder;
  auto const there = compiled(folder);
  std::string const machine = std::string(AXISC_SOURCE_DIR) + "/tests/cli/data/machine/machine.json";
  REQUIRE(run_axisc({"compile", machine, "-o", "n.axim", "--no-bounds", "--quiet"}, there).status == 0);
  REQUIRE(run_axisc({"compile", machine, "-o", "s.axim", "--strip", "--quiet"}, there).status == 0);
  CHECK(bounds_at(folder.read("s.axim")) > 0);
  std::string const without = folder.read("n.axim");
  std::string const with = folder.read("m.axim");
  CHECK(number_at(without, 28) + 1 == number_at(with, 28));
  auto const shown = run_axisc({"certify", "n.axim"}, there);
  CHECK(shown.status == 0);
  CHECK_THAT(shown.out, Contains("claims no bounds"));
  CHECK_THAT(run_axisc({"inspect", "n.axim"}, there).out, Contains("proved bounds  none"));
  CHECK_THAT(run_axisc({"inspect", "m.axim"}, there).out, Contains("`axisc certify` checks them"));
}

}  // namespace certify_test
