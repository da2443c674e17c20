#include "schema/catalogue.hpp"
#include "schema/plain_suggestion.hpp"
#include "support/catch.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace axisc::schema;
using Names = std::vector<std::string>;

std::string best(std::string_view name) {
  Names const names = suggest_names(name);
  return names.empty() ? "" : names.front();
}

std::string_view best_symbol(std::string_view parameter_name, std::string_view word) {
  auto const symbols = suggest_symbols(parameter(find(parameter_name).parameter), word);
  return symbols.empty() ? "" : symbols.front();
}

TEST_CASE("slips in one part keep the index") {
  CHECK(suggest_names("filter[2].oder") == Names{"filter[2].order"});
  CHECK(best("filtr[0].order") == "filter[0].order");
  CHECK(best("filter[1].enabel") == "filter[1].enable");
  CHECK(best("Filter[1].Enabel") == "filter[1].enable");
  CHECK(best("filter[0].timeconstant") == "filter[0].time_constant");
  CHECK(best("filter[0].share_procent") == "filter[0].share_percent");
  CHECK(best("filter[0].fgf0") == "filter[0].fg_f0");
  CHECK(best("vibguard.freq") == "vib_guard.freq");
  CHECK(best("kenngr.achstyp") == "kenngr.achs_typ");
  CHECK(best("kopf.achs_nummer") == "kopf.achs_nr");
}

TEST_CASE("a shortened part is found") {
  CHECK(best("filter[0].share") == "filter[0].share_percent");
  CHECK(best("kenngr.position_window") == "kenngr.filter_position_window");
  CHECK(best("fir.enable") == "filter_fir.enable");
}

TEST_CASE("a missing, superfluous or misspelled prefix is found") {
  CHECK(best("add_interface.filter[0].order") == "lr_param.add_interface.filter[0].order");
  CHECK(best("improved_position_control.enable") == "lr_param.improved_position_control.enable");
  CHECK(best("lr_param.filter[1].order") == "filter[1].order");
  CHECK(best("filter.fir.enable") == "filter_fir.enable");
  CHECK(best("lr.param.add_interface.enable") == "lr_param.add_interface.enable");
}

TEST_CASE("a name known in another family is found, unless many families know it") {
  CHECK(best("kenngr.achs_nr") == "kopf.achs_nr");
  CHECK(best("antr.antr_typ") == "kenngr.antr_typ");
  CHECK(suggest_names("foo.enable").empty());
}

TEST_CASE("names with as many indices come first") {
  std::string const stage = "lr_param.improved_position_control.stage[1]";
  CHECK(best(stage + ".filter[1].ordr") == stage + ".filter[1].order");
  CHECK(best(stage + ".filter.ordr") == stage + ".filter.order");
}

TEST_CASE("an index that is missing becomes 0") {
  CHECK(best("filter.oder") == "filter[0].order");
}

TEST_CASE("nothing is suggested for what resembles nothing") {
  CHECK(suggest_names("xyz.abc").empty());
  CHECK(suggest_names("").empty());
  CHECK(suggest_names("a").empty());
  CHECK(suggest_names("filter[9].oder").empty());  // filter[9].order does not exist either
  CHECK(suggest_names(std::string(100000, 'a')).empty());
}

TEST_CASE("suggestions are known names, at most three") {
  for (std::size_t i = 0; i < parameters().size(); i += 9) {
    std::string name = slot_name(parameters()[i].first_slot);
    name.erase(name.size() - 2, 1);
    Names const names = suggest_names(name);
    REQUIRE(names.size() <= 3);
    for (std::string const& suggestion : names) REQUIRE(find(suggestion).status == NameLookup::Status::found);
  }
}

TEST_CASE("a name with one letter lost leads back to itself") {
  for (std::size_t i = 0; i < parameters().size(); i += 7) {
    std::string const right = slot_name(parameters()[i].first_slot);
    std::string wrong = right;
    wrong.erase(wrong.rfind('.') + 2, 1);
    if (find(wrong).status != NameLookup::Status::unknown) continue;
    if (right.size() - right.rfind('.') < 5) continue;
    Names const names = suggest_names(wrong);
    INFO(wrong);
    // Rows that differ in one letter only (a number at the end) may crowd it out.
    if (names.size() < 3) REQUIRE(std::find(names.begin(), names.end(), right) != names.end());
  }
}

TEST_CASE("one slip is found the long way too") {
  for (std::size_t i = 0; i < parameters().size(); ++i) {
    std::string name = slot_name(parameters()[i].first_slot);
    std::size_t const at = i % (name.size() - 1);
    if (i % 3 == 0) name.erase(at, 1);
    if (i % 3 == 1) std::swap(name[at], name[at + 1]);
    if (i % 3 == 2) name.insert(at, 1, 'e');
    INFO(name);
    REQUIRE(suggest_names(name) == axisc::test::suggest_names_plainly(name));
  }
}

TEST_CASE("what is ruled out early would not have been suggested") {
  std::uint32_t state = 20240229;
  auto const below = [&state](std::size_t count) {
    state = state * 1664525U + 1013904223U;
    return static_cast<std::size_t>(state >> 8U) % count;
  };
  constexpr std::string_view letters = "abcdefghiklmnoprstuvwxyz_.[]019";
  for (int round = 0; round < 1000; ++round) {
    Parameter const& known = parameters()[below(parameters().size())];
    std::string name = slot_name(known, slot_of(known));
    // A few slips; or the quantity of one name in the family of another.
    for (std::size_t slips = below(6); slips > 0; --slips) {
      std::size_t const at = below(name.size());
      std::size_t const what = below(4);
      if (what == 0) name.insert(at, 1, letters[below(letters.size())]);
      if (what == 1 && name.size() > 1) name.erase(at, 1);
      if (what == 2) name[at] = letters[below(letters.size())];
      if (what == 3 && at > 0) std::swap(name[at - 1], name[at]);
    }
    if (below(4) == 0) {
      Parameter const& other = parameters()[below(parameters().size())];
      std::string const family(other.name.substr(0, other.name.find('.')));
      name = family + name.substr(std::min(name.find('.'), name.size()));
    }
    INFO(name);
    REQUIRE(suggest_names(name) == axisc::test::suggest_names_plainly(name));
  }
}

TEST_CASE("symbols are suggested from their own enumeration") {
  CHECK(best_symbol("filter[0].type", "LOWPAS") == "LOWPASS");
  CHECK(best_symbol("filter[0].type", "lowpass") == "LOWPASS");
  CHECK(best_symbol("filter[0].type", "LOW") == "LOWPASS");
  CHECK(best_symbol("filter[0].type", "TIMEDELAY") == "TIME_DELAY");
  CHECK(best_symbol("filter[0].type", "BAND_STOP") == "BANDSTOP");
  CHECK(best_symbol("filter[0].type", "DELAY") == "TIME_DELAY");
  CHECK(best_symbol("filter[0].prototype", "BUTTER") == "BUTTERWORTH");
  CHECK(best_symbol("filter[0].prototype", "BESEL") == "BESSEL");
  CHECK(best_symbol("lr_param.improved_position_control.stage[0].mode", "INDIREKT") == "INDIRECT");
  CHECK(best_symbol("filter[0].enable", "TRUEE") == "TRUE");
  CHECK(best_symbol("filter[0].type", "XYZ").empty());
  CHECK(best_symbol("filter[0].order", "LOWPASS").empty());
  CHECK(best_symbol("filter[0].type", std::string(100000, 'A')).empty());
}

}  // namespace
