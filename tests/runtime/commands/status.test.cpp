#include "axisrt.h"
#include "support/catch.hpp"
#include "support/golden.hpp"

#include <map>
#include <regex>
#include <set>
#include <string>

namespace status_test {

namespace {

constexpr axisrt_status all_statuses[] = {AXISRT_OK,
                                          AXISRT_TOO_SHORT,
                                          AXISRT_WRONG_MAGIC,
                                          AXISRT_WRONG_VERSION,
                                          AXISRT_WRONG_SIZE,
                                          AXISRT_WRONG_CHECKSUM,
                                          AXISRT_OUT_OF_BOUNDS,
                                          AXISRT_OVERLAP,
                                          AXISRT_NOT_FINITE,
                                          AXISRT_UNSTABLE,
                                          AXISRT_KERNEL_TOO_LONG,
                                          AXISRT_UNKNOWN_KIND,
                                          AXISRT_INCONSISTENT_CYCLE,
                                          AXISRT_MISALIGNED,
                                          AXISRT_BOUND_FAILED,
                                          AXISRT_OTHER_CYCLE_TIME,
                                          AXISRT_SELF_TEST_FAILED,
                                          AXISRT_MEMORY_TOO_SMALL,
                                          AXISRT_BAD_ARGUMENT,
                                          AXISRT_NO_LEVEL,
                                          AXISRT_OTHER_AXES,
                                          AXISRT_OLDER_IMAGE,
                                          AXISRT_OTHER_IMAGE,
                                          AXISRT_BAD_RECORDING,
                                          AXISRT_UNSIGNED,
                                          AXISRT_WRONG_SIGNATURE,
                                          AXISRT_BAD_INPUT,
                                          AXISRT_NOT_RESET,
                                          AXISRT_IMPLAUSIBLE,
                                          AXISRT_BUSY,
                                          AXISRT_NO_BANK,
                                          AXISRT_NEEDS_STANDSTILL,
                                          AXISRT_NOT_WARM};

/// Name and number of each match of `pattern`, whose groups `name` and `number` say where they stand.
std::map<std::string, int> numbers_in(std::string const& text, char const* pattern, unsigned name,
                                      unsigned number) {
  std::map<std::string, int> found;
  std::regex const row(pattern);
  for (std::sregex_iterator i(text.begin(), text.end(), row), end; i != end; ++i) {
    INFO((*i)[name]);
    CHECK(found.emplace((*i)[name], std::stoi((*i)[number])).second);
  }
  return found;
}

}  // namespace

TEST_CASE("docs/runtime.md says what to do about every status of axisrt.h") {
  std::string const header = axisc::test::read_source_file("runtime/include/axisrt.h");
  std::string const document = axisc::test::read_source_file("docs/runtime.md");
  std::string const statuses = header.substr(0, header.find("} axisrt_status;"));
  auto const declared = numbers_in(statuses, R"((AXISRT_[A-Z_]+)\s*=\s*([0-9]+))", 1, 2);
  CHECK(declared.size() == std::size(all_statuses));
  CHECK(numbers_in(document, R"(\n\| ([0-9]+) \| `(AXISRT_[A-Z_]+)` \| [^|]+ \| [^|]*\|)", 2, 1) == declared);
}

TEST_CASE("every status has a text and a name of its own") {
  std::set<std::string> texts;
  std::set<std::string> names;
  for (axisrt_status const status : all_statuses) {
    std::string const text = axisrt_status_text(status);
    std::string const name = axisrt_status_name(status);
    CHECK(text.back() == '.');
    CHECK(name.rfind("AXISRT_", 0) == 0);
    texts.insert(text);
    names.insert(name);
  }
  CHECK(texts.size() == std::size(all_statuses));
  CHECK(names.size() == std::size(all_statuses));
}

TEST_CASE("the list of statuses is complete") {
  std::size_t known = 0;
  for (int value = 0; value < 64; ++value) {
    known += std::string(axisrt_status_name(static_cast<axisrt_status>(value))) != "unknown" ? 1 : 0;
  }
  CHECK(known == std::size(all_statuses));
}

TEST_CASE("a number that is no status has a text, too") {
  CHECK(std::string(axisrt_status_text(static_cast<axisrt_status>(39))) == "Unknown status.");
  CHECK(std::string(axisrt_status_name(static_cast<axisrt_status>(39))) == "unknown");
}

}  // namespace status_test
