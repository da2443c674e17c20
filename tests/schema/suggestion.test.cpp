#include "schema/catalogue.hpp"
#include "schema/plain_suggestion.hpp"
#include "support/catch.hpp"
#include "support/sanitized.hpp"

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
  Names const names = suggest_names(name).names;
  return names.empty() ? "" : names.front();
}

/// The name that may be written instead; empty where none is certain.
std::string certain(std::string_view name) {
  return suggest_names(name).is_certain ? best(name) : "";
}

std::string_view best_symbol(std::string_view parameter_name, std::string_view word) {
  auto const symbols = suggest_symbols(parameter(find(parameter_name).parameter), word);
  return symbols.empty() ? "" : symbols.front();
}

TEST_CASE("slips in one part keep the index") {
  CHECK(suggest_names("filter[2].oder").names == Names{"filter[2].order"});
  CHECK(certain("filter[2].oder") == "filter[2].order");
  CHECK(certain("filtr[0].order") == "filter[0].order");
  CHECK(certain("filter[1].enabel") == "filter[1].enable");
  CHECK(certain("Filter[1].Enabel") == "filter[1].enable");
  CHECK(certain("filter[0].timeconstant") == "filter[0].time_constant");
  CHECK(certain("filter[0].share_procent") == "filter[0].share_percent");
  CHECK(certain("filter[0].fgf0") == "filter[0].fg_f0");
  CHECK(certain("vibguard.freq") == "vib_guard.freq");
  CHECK(certain("kenngr.achstyp") == "kenngr.achs_typ");
}

TEST_CASE("slips in two parts are too many") {
  CHECK(suggest_names("filtr[0].oder").names.empty());
  CHECK(suggest_names("kengr.achstyp").names.empty());
}

TEST_CASE("a dot may stand for an underscore") {
  CHECK(certain("filter.fir.enable") == "filter_fir.enable");
  CHECK(certain("lr.param.add_interface.enable") == "lr_param.add_interface.enable");
}

TEST_CASE("in its own family a name may differ more, but is not certain then") {
  CHECK(best("filter[0].share") == "filter[0].share_percent");
  CHECK(certain("filter[0].share").empty());
  CHECK(best("kenngr.position_window") == "kenngr.filter_position_window");
  CHECK(best("fir.enable") == "filter_fir.enable");
  CHECK(certain("fir.enable").empty());
}

TEST_CASE("swapped words and parts are found") {
  CHECK(certain("fir_filter.enable") == "filter_fir.enable");
  CHECK(certain("fir_filter.type") == "filter_fir.type");
  CHECK(certain("fir_filter.order") == "filter_fir.order");
  CHECK(certain("filter[0].f0_fg") == "filter[0].fg_f0");
  CHECK(certain("add_interface.lr_param.enable") == "lr_param.add_interface.enable");
}

TEST_CASE("a missing part is found") {
  CHECK(certain("getriebe[0].vb_max") == "getriebe[0].dynamik.vb_max");
  CHECK(certain("getriebe[1].vb_max") == "getriebe[1].dynamik.vb_max");
  CHECK(best("add_interface.filter[0].order") == "lr_param.add_interface.filter[0].order");
  CHECK(best("improved_position_control.enable") == "lr_param.improved_position_control.enable");
  // What a name without its beginning meant is not certain.
  CHECK(certain("improved_position_control.enable").empty());
  CHECK(certain("max_vb_override").empty());
  CHECK(certain("trafo[0].param[0]").empty());
}

TEST_CASE("initials stand for a part") {
  CHECK(certain("lr_param.ipc.enable") == "lr_param.improved_position_control.enable");
  CHECK(suggest_names("lr_param.ip.enable").names.empty());
}

TEST_CASE("a former name is known, and nothing else is suggested for it") {
  for (std::string const part : {"type", "order", "enable"}) {
    auto const suggestions = suggest_names("vib_guard." + part);
    CHECK(suggestions.names == Names{"filter_fir." + part});
    CHECK(suggestions.is_former_name);
    CHECK(suggestions.is_certain);
  }
}

TEST_CASE("nothing is suggested across families") {
  for (char const* const name :
       {"kenngr.achs_nr", "antr.antr_typ", "foo.enable", "path[0].type", "listen", "windows_time",
        "default_index", "wz[1].laenge", "wz[1].param[0]", "lr_param.filter[1].order"}) {
    INFO(name);
    CHECK(certain(name).empty());
    CHECK(suggest_names(name).names.empty());
  }
}

TEST_CASE("of several equally good names none is certain") {
  CHECK(suggest_names("antr.sercos.ident[0].lst").names.size() <= 3);
  auto const suggestions = suggest_names("handbetrieb.hr.schalte");
  if (suggestions.names.size() > 1) CHECK_FALSE(suggestions.is_certain);
}

TEST_CASE("names with as many indices come first") {
  std::string const stage = "lr_param.improved_position_control.stage[1]";
  CHECK(certain(stage + ".filter[1].ordr") == stage + ".filter[1].order");
  CHECK(best(stage + ".filter.ordr") == stage + ".filter.order");
}

TEST_CASE("an index that is missing becomes 0, which is not certain") {
  CHECK(best("filter.oder") == "filter[0].order");
  CHECK(certain("filter.oder").empty());
}

TEST_CASE("nothing is suggested for what resembles nothing") {
  CHECK(suggest_names("xyz.abc").names.empty());
  CHECK(suggest_names("").names.empty());
  CHECK(suggest_names("a").names.empty());
  CHECK(suggest_names("filter[9].oder").names.empty());  // filter[9].order does not exist either
  CHECK(suggest_names(std::string(100000, 'a')).names.empty());
}

TEST_CASE("suggestions are known names, at most three") {
  for (std::size_t i = 0; i < parameters().size(); i += 9) {
    std::string name = slot_name(parameters()[i].first_slot);
    name.erase(name.size() - 2, 1);
    Names const names = suggest_names(name).names;
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
    Names const names = suggest_names(wrong).names;
    INFO(wrong);
    // Rows that differ in one letter only (a number at the end) may crowd it out.
    if (names.size() < 3) REQUIRE(std::find(names.begin(), names.end(), right) != names.end());
  }
}

TEST_CASE("one slip is found the long way too") {
  // One name of each family and more; the long way takes a hundredth of a second.
  for (std::size_t i = 0; i < parameters().size(); i += axisc::test::sanitized ? 37 : 5) {
    std::string name = slot_name(parameters()[i].first_slot);
    std::size_t const at = i % (name.size() - 1);
    if (i % 3 == 0) name.erase(at, 1);
    if (i % 3 == 1) std::swap(name[at], name[at + 1]);
    if (i % 3 == 2) name.insert(at, 1, 'e');
    if (find(name).status != NameLookup::Status::unknown) continue;
    INFO(name);
    auto const plain = axisc::test::suggest_names_plainly(name);
    REQUIRE(suggest_names(name).names == plain.names);
    REQUIRE(suggest_names(name).is_certain == plain.certain);
  }
}

TEST_CASE("what is ruled out early would not have been suggested") {
  std::uint32_t state = 20240229;
  auto const below = [&state](std::size_t count) {
    state = state * 1664525U + 1013904223U;
    return static_cast<std::size_t>(state >> 8U) % count;
  };
  constexpr std::string_view letters = "abcdefghiklmnoprstuvwxyz_.[]019";
  for (int round = 0; round < (axisc::test::sanitized ? 40 : 250); ++round) {
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
    if (find(name).status != NameLookup::Status::unknown) continue;
    INFO(name);
    auto const plain = axisc::test::suggest_names_plainly(name);
    REQUIRE(suggest_names(name).names == plain.names);
    REQUIRE(suggest_names(name).is_certain == plain.certain);
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
