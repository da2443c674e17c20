// What fixes promise, on lists with planted mistakes.
#include "axisc/checking/fixing.hpp"
#include "support/catch.hpp"
#include "support/map_files.hpp"
#include "support/random_lists.hpp"
#include "validator/loading/loading.hpp"

#include <map>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

using namespace axisc;
using namespace axisc;

namespace {

constexpr std::uint32_t lists = 1000;
constexpr design::CycleTime one_millisecond{1'000'000};

validator::CheckOptions options() {
  validator::CheckOptions options;
  options.cycle_time = one_millisecond;
  return options;
}

std::string fixed(std::string const& list, FixChoice choice, FixFacts* facts = nullptr) {
  Workspace workspace({.options = options()});
  workspace.put("x.lis", list);
  IdentityPaths identity_paths(workspace.settings());
  auto const result = fix_inputs(workspace, {"x.lis"}, choice, {}, identity_paths, ChangeableFiles({}));
  if (facts != nullptr) *facts = result.facts;
  return result.edited.at("x.lis");
}

std::map<Identity, int> findings_of(std::string const& list) {
  tests::MapFiles files({{"x.lis", list}});
  SourceSet sources;
  std::map<Identity, int> counts;
  for (auto const& finding : validator::check(files, "x.lis", options(), sources).findings) {
    ++counts[identity_of(finding, sources)];
  }
  return counts;
}

using ValueFacts = std::tuple<schema::Slot, double, std::string, bool>;

/// What the control would run with.
std::vector<ValueFacts> effective_values(std::string const& list) {
  tests::MapFiles files({{"x.lis", list}});
  SourceSet sources;
  auto const loaded = validator::load(files, "x.lis", options(), sources);
  auto const& values = std::get<validator::LoadedMachine>(loaded).axes.front().merged.values;
  std::map<schema::Slot, ValueFacts> facts;
  for (validator::EffectiveValue const* const value : values.set_values()) {
    facts.emplace(value->slot, ValueFacts{value->slot, value->value.number, std::string(value->value.text),
                                          value->unusable});
  }
  std::vector<ValueFacts> all;
  for (auto const& [slot, fact] : facts) all.push_back(fact);
  return all;
}

bool introduces_finding(std::string const& before, std::string const& after) {
  auto const known = findings_of(before);
  for (auto const& [identity, number] : findings_of(after)) {
    auto const found = known.find(identity);
    if (found == known.end() || found->second < number) return true;
  }
  return false;
}

}  // namespace

TEST_CASE("safe fixes never change the effective values") {
  std::size_t applied = 0;
  for (std::uint32_t seed = 0; seed < lists; ++seed) {
    auto const list = tests::random_list(seed);
    FixFacts facts;
    auto const after = fixed(list, FixChoice::safe, &facts);
    applied += facts.applied;
    INFO(list << "\n---\n" << after);
    CHECK(effective_values(after) == effective_values(list));
  }
  CHECK(applied > lists);
}

TEST_CASE("fixes never introduce a finding, and a second run changes nothing") {
  for (auto const choice : {FixChoice::safe, FixChoice::all}) {
    std::size_t applied = 0;
    for (std::uint32_t seed = 0; seed < lists; ++seed) {
      auto const list = tests::random_list(seed);
      FixFacts facts;
      auto const after = fixed(list, choice, &facts);
      applied += facts.applied;
      INFO(list << "\n---\n" << after);
      CHECK(!introduces_finding(list, after));
      CHECK(fixed(after, choice) == after);
    }
    CHECK(applied > lists);
  }
}
