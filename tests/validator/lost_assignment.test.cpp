// Which parameter a line was meant for that does not set it.
#include "validator/values/lost_assignment.hpp"

#include "support/catch.hpp"
#include "validator/values/line_value.hpp"
#include "validator/values/list_reader.hpp"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace axisc;
using namespace axisc::validator;

struct Lost {
  std::string parameter;
  std::string marked;
  bool guessed;
  friend bool operator==(Lost const&, Lost const&) = default;
};

std::vector<Lost> lost_in(std::string text) {
  SourceText const source("x.lis", std::move(text));
  ReadList const list = read_list(source);
  std::vector<Lost> result;
  for (LostAssignment const& lost : lost_assignments(source, list.tree, list.line_values)) {
    result.push_back({schema::slot_name(lost.slot), std::string(source.slice(lost.name)), lost.guessed});
  }
  return result;
}

}  // namespace

TEST_CASE("a broken line is meant for the parameter whose indices can be made whole") {
  CHECK(lost_in("filter[2].order") == std::vector<Lost>{{"filter[2].order", "filter[2].order", false}});
  CHECK(lost_in("filter[2.order 1") == std::vector<Lost>{{"filter[2].order", "filter[2.order ", false}});
  CHECK(lost_in("\t filter[ 2 ].order 1") ==
        std::vector<Lost>{{"filter[2].order", "filter[ 2 ].ord", false}});
  CHECK(lost_in("filter[].order 1") == std::vector<Lost>{{"filter[0].order", "filter[].order ", false}});
  CHECK(lost_in("filter[x2y].order 1") == std::vector<Lost>{{"filter[2].order", "filter[x2y].ord", false}});
  CHECK(lost_in("filter[2].Order") == std::vector<Lost>{{"filter[2].order", "filter[2].Order", false}});
}

TEST_CASE("a mistyped name is meant for what is suggested first") {
  CHECK(lost_in("filter[2].oder 1") == std::vector<Lost>{{"filter[2].order", "filter[2].oder", true}});
  CHECK(lost_in("filter.order 1") == std::vector<Lost>{{"filter[0].order", "filter.order", true}});
}

TEST_CASE("what resembles no parameter is meant for none") {
  CHECK(lost_in("xyz[2.abc 1\nxyz.abc 1\nfilter[99].order\nfilter[\n[\n=\n").empty());
  CHECK(lost_in("filter[2].order 1\n# comment\n\n").empty());
}
