// Inlay hints.
#include "support/catch.hpp"
#include "support/conversation.hpp"

#include <algorithm>

namespace hints_test {

using namespace axisc::test;

namespace {

Json const whole_range = {{"start", {{"line", 0}, {"character", 0}}},
                          {"end", {{"line", 100}, {"character", 0}}}};

Json asked(std::string const& method, std::string const& path, std::string const& text,
           Json const& params = Json::object()) {
  return Conversation().open(path, text).ask(method, path, params).results()[0];
}

std::vector<std::string> labels(Json const& hints) {
  std::vector<std::string> found;
  for (auto const& hint : hints) {
    found.push_back(std::to_string(hint["position"]["line"].get<int>()) + ":" +
                    std::to_string(hint["position"]["character"].get<int>()) + " " +
                    hint["label"].get<std::string>());
  }
  return found;
}

}  // namespace

TEST_CASE("hints show the quantity behind a raw number") {
  auto const hints = asked("textDocument/inlayHint", "/x.lis",
                           "# \xC3\xBC\nfilter[0].fg_f0  42.5 ( Hz\nfilter[0].type LOWPASS\n"
                           "getriebe[0].dynamik.vb_max  500000\nkenngr.achs_typ 1\nunknown 5\n",
                           {{"range", whole_range}});
  auto const found = labels(hints);
  CHECK(std::count(found.begin(), found.end(), "1:21 = 42.5 Hz") == 1);
  CHECK(std::count(found.begin(), found.end(), "3:34 = 500 mm/s") == 1);
  auto const delay = labels(asked("textDocument/inlayHint", "/x.lis", "vorsteuer.velocity_delay_time 1500\n",
                                  {{"range", whole_range}}));
  CHECK(std::count(delay.begin(), delay.end(), "0:34 = 1.5 ms, 1.5 cycles") == 1);
  CHECK(std::none_of(found.begin(), found.end(), [](auto const& hint) { return hint.starts_with("4:"); }));
  CHECK(std::none_of(found.begin(), found.end(), [](auto const& hint) { return hint.starts_with("5:"); }));
}

TEST_CASE("hints name the defaults that a filter takes") {
  auto const hints =
      labels(asked("textDocument/inlayHint", "/x.lis",
                   "filter[0].enable 1\nfilter[0].order 2\nfilter[0].type BANDSTOP\nfilter[0].fg_f0 42\n",
                   {{"range", whole_range}}));
  auto const said = std::find_if(hints.begin(), hints.end(), [](auto const& hint) {
    return hint.find("by default") != std::string::npos;
  });
  REQUIRE(said != hints.end());
  CHECK(said->starts_with("2:23 "));
  CHECK(said->find("guete 1") != std::string::npos);
  CHECK(said->find("prototype CRIT_DAMPING") != std::string::npos);
  CHECK(said->find("order") == std::string::npos);
}

TEST_CASE("hints outside the range are not sent") {
  Json const range = {{"start", {{"line", 1}, {"character", 0}}}, {"end", {{"line", 2}, {"character", 0}}}};
  auto const hints =
      labels(asked("textDocument/inlayHint", "/x.lis",
                   "filter[0].fg_f0 1\nfilter[1].fg_f0 2\nfilter[2].fg_f0 3\n", {{"range", range}}));
  CHECK(hints == std::vector<std::string>{"1:17 = 2 Hz"});
}

TEST_CASE("hints show the jerk of a ramp time, and the value that counts instead") {
  std::string const gear = "getriebe[0].";
  auto const hints =
      labels(asked("textDocument/inlayHint", "/x.lis",
                   gear + "dynamik.a_max 1500\n" + gear + "slope_profil.a_beschl 2000\n" + gear +
                       "slope_profil.tr_beschl_zu 50000\n" + gear + "slope_profil.tr_beschl_ab 5000\n" +
                       gear + "lslope_profil.d_stufe_1 0\ngetriebe[1].slope_profil.tr_beschl_zu 50000\n",
                   {{"range", whole_range}}));
  // 1500 mm/s² in 50 ms are 30 m/s³. The least ramp time is 10 ms, the acceleration of STEP 1000 mm/s².
  CHECK(hints == std::vector<std::string>{
                     "0:30 = 1500 mm/s²", "1:38 = 2000 mm/s², 1500 mm/s² counts (P-AXIS-00008)",
                     "2:43 = 50 ms, 30 m/s³", "3:42 = 5 ms, 10 ms counts (P-AXIS-00201), 150 m/s³",
                     "4:37 = 0 mm/s², as for accelerating: 1000 mm/s²", "5:43 = 50 ms"});
}

}  // namespace hints_test
