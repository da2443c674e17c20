// The worked examples of the delay budget, by hand: T = 1 ms; a PT1 of 4 ms, pre-warped, delays by
// 1/(2 tan(T/2τ)) = 3.97914 cycles.
#include "validator/views/delay_budget.hpp"

#include "support/catch.hpp"
#include "support/map_files.hpp"
#include "validator/loading/loader.hpp"

#include <cmath>
#include <string>

namespace delay_budget_test {

namespace {

using namespace axisc;
using validator::DelayBudget;
using validator::DelayState;

constexpr design::CycleTime one_millisecond{1'000'000};
std::string const pt1 =
    "filter[0].type PT1\nfilter[0].enable 1\nfilter[0].order 1\nfilter[0].time_constant 4000\n";
std::string const added_velocity = "vorsteuer.vorsteuerung ADD_VEL\nvorsteuer.default_active 1\n";
std::string const profidrive = "kenngr.antr_typ 3\n";
std::string const sercos = "kenngr.antr_typ 2\n";
double const pt1_cycles = 0.5 / std::tan(1.0 / 8);

struct Loaded {
  tests::MapFiles files;
  SourceSet sources;
  validator::LoadedMachine machine;

  explicit Loaded(std::string const& lines)
      : files({{"x.lis", lines}}),
        machine(std::get<validator::LoadedMachine>(validator::load(files, "x.lis", {}, sources))) {}
  [[nodiscard]] validator::LoadedAxis const& axis() const { return machine.axes.front(); }
};

DelayBudget budget(std::string const& lines, DelayState state = DelayState::at_start) {
  Loaded const loaded(lines);
  auto const found = validator::delay_budget(loaded.axis(), one_millisecond, state);
  REQUIRE(found);
  return *found;
}

TEST_CASE("position and velocity of a PROFIdrive axis: the default shift of 3 cycles makes the lead") {
  auto const found = budget(pt1 + added_velocity + profidrive);
  CHECK(found.feeds_forward);
  CHECK(found.position == Approx(pt1_cycles + 5));
  CHECK(found.velocity == Approx(pt1_cycles + 2));
  CHECK(found.lead() == Approx(3));
}

TEST_CASE("without the delay of feedforward both lose the five cycles") {
  auto const found = budget(pt1 + added_velocity + profidrive + "vorsteuer.feedforward_without_delay 1\n");
  CHECK(found.position == Approx(pt1_cycles));
  CHECK(found.velocity == Approx(pt1_cycles - 3));
  CHECK(found.lead() == Approx(3));
}

TEST_CASE("SERCOS knows no shift") {
  CHECK(budget(pt1 + added_velocity + sercos).lead() == Approx(0).margin(1e-12));
}

TEST_CASE("a time delay of the position alone is a lead, which a delay of the velocity takes back") {
  std::string const delay =
      "filter[1].type TIME_DELAY\nfilter[1].enable 1\nfilter[1].order 1\nfilter[1].time_constant 2000\n"
      "kenngr.delay_filter_only_position 1\n";
  auto const found = budget(pt1 + delay + added_velocity + sercos);
  CHECK(found.position == Approx(pt1_cycles + 7));
  CHECK(found.velocity == Approx(pt1_cycles + 5));
  CHECK(found.lead() == Approx(2));
  auto const balanced =
      budget(pt1 + delay + added_velocity + sercos + "vorsteuer.velocity_delay_time 1500\n");
  CHECK(balanced.velocity == Approx(pt1_cycles + 6.5));
  CHECK(balanced.lead() == Approx(0.5));
  // An axis with the same filters and nothing fed forward.
  auto const other = budget(pt1 + delay + sercos);
  CHECK_FALSE(other.feeds_forward);
  CHECK(other.position == Approx(pt1_cycles + 2));
  CHECK(other.lead() == 0);
  // 5 ms apart at 4000 mm/min: 166.7 µm on a line at 45°.
  double const feed = 4000 / 0.06;
  CHECK(validator::deviation_of_mismatch(feed, found.position - other.position, one_millisecond) ==
        Approx(166.67).margin(0.005));
}

TEST_CASE("feedforward that G135 switches on, and that nothing can switch on") {
  std::string const off_at_start = pt1 + sercos + "vorsteuer.vorsteuerung VEL\n";
  CHECK_FALSE(budget(off_at_start).feeds_forward);
  CHECK(budget(off_at_start, DelayState::fed_forward).position == Approx(pt1_cycles + 5));
  std::string const disabled = off_at_start + "vorsteuer.global_disable 1\n";
  CHECK_FALSE(budget(disabled, DelayState::fed_forward).feeds_forward);
}

TEST_CASE("the lag of a position controller in the NC: (1 - w)/Kv") {
  std::string const in_nc = "kenngr.antr_typ 4\ngetriebe[0].kv 6000\n";  // Kv = 60 1/s
  CHECK(budget(in_nc).position == Approx(1000.0 / 60));
  std::string const half = in_nc +
                           "vorsteuer.vorsteuerung VEL\nvorsteuer.default_active 1\n"
                           "vorsteuer.vs_v_faktor 1\nvorsteuer.vs_v_nenner 2\n";
  CHECK(budget(half).position == Approx(5 + 500.0 / 60));
}

TEST_CASE("a lead takes an accelerating axis ahead by a L/Kv") {
  // 3 m/s², 3 ms, 60 1/s: 150 µm.
  Loaded const loaded("getriebe[0].kv 6000\ngetriebe[0].dynamik.a_max 3000\n");
  CHECK(validator::deviation_of_lead(loaded.axis(), 3, one_millisecond).value() == Approx(150));
}

TEST_CASE("the balancing filter delays the position of a PROFIdrive axis alone") {
  std::string const filter = "vorsteuer.timeconst_sym_filter 2000\n";
  CHECK(budget(added_velocity + profidrive + filter).lead() == Approx(5));
  CHECK(budget(added_velocity + sercos + filter).lead() == Approx(0).margin(1e-12));
}

TEST_CASE("a FIR filter that is off at the start delays after #FILTER ON") {
  std::string const off = "filter_fir.type 1\nfilter_fir.order 40\n";
  auto const start = budget(off);
  CHECK(start.position == 0);
  CHECK(start.has_filter_off);
  auto const on = budget(off, DelayState::filters_on);
  CHECK(on.position == Approx(20));  // half of the order
  CHECK_FALSE(on.has_filter_off);
  CHECK(budget(off + "filter_fir.enable 1\n").position == Approx(20));
}

}  // namespace

}  // namespace delay_budget_test
