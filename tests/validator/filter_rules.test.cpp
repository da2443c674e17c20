// The rules about filters through the front door: a list in, findings out.
#include "diagnostics/message.hpp"
#include "support/catch.hpp"
#include "validator/check.hpp"

#include <string>
#include <variant>
#include <vector>

namespace filter_rules_test {

namespace {

using namespace axisc;
using machine::AxisType;

/// The only file there is.
class OneList final : public configuration::Files {
 public:
  explicit OneList(std::string text) : text_(std::move(text)) {}
  std::variant<std::string, configuration::FileError> read(std::string const& /*path*/) override {
    return text_;
  }

 private:
  std::string text_;
};

struct Options {
  double cycle_us = 1000;
  AxisType axis = AxisType::translatory;
  bool pedantic = false;
  std::vector<Code> disabled = {};
};

class Run {
 public:
  explicit Run(std::string const& list, Options const& options = {}) {
    OneList files(list);
    validator::CheckOptions check;
    check.cycle_time = design::CycleTime{static_cast<std::uint32_t>(options.cycle_us * 1e3)};
    check.axis_type = options.axis;
    check.pedantic = options.pedantic;
    check.disabled = options.disabled;
    findings_ = validator::check(files, "x.lis", check, sources_).findings;
  }

  /// "2 AX3005" per finding, in output order.
  [[nodiscard]] std::vector<std::string> lines() const {
    std::vector<std::string> lines;
    for (Finding const& finding : findings_) {
      std::string const line = finding.place ? std::to_string(position(*finding.place).line) : "-";
      lines.push_back(line + " " + code_text(finding.code));
    }
    return lines;
  }
  [[nodiscard]] std::vector<Finding> const& findings() const { return findings_; }
  [[nodiscard]] Finding const& only() const {
    REQUIRE(findings_.size() == 1);
    return findings_.front();
  }
  [[nodiscard]] Position position(Place const& place) const {
    return sources_[place.source].position(place.span.begin);
  }

 private:
  SourceSet sources_;
  std::vector<Finding> findings_;
};

using Lines = std::vector<std::string>;

Lines lines(std::string const& list, Options const& options = {}) {
  return Run(list, options).lines();
}

std::string english(Message const& message) {
  return render(message, Language::english);
}

// An active filter[0]; its lines are 1 to 3, what `more` adds follows.
std::string filter(std::string const& type, std::string const& order, std::string const& more = "") {
  return "filter[0].enable 1\nfilter[0].order " + order + "\nfilter[0].type " + type + "\n" + more;
}

// The same in the additional interface.
std::string interface(std::string const& type, std::string const& order, std::string const& more = "") {
  std::string const prefix = "lr_param.add_interface.filter[0].";
  std::string list;
  std::string const source = filter(type, order, more);
  for (std::size_t begin = 0; begin < source.size();) {
    std::size_t const end = source.find('\n', begin) + 1;
    list += prefix + source.substr(begin + std::string("filter[0].").size(),
                                   end - begin - std::string("filter[0].").size());
    begin = end;
  }
  return list;
}

}  // namespace

TEST_CASE("AX3001: every type has its range of orders") {
  struct Case {
    std::string type;
    int highest;
  };
  for (Case const& one : {Case{"LOWPASS", 6}, Case{"HIGHPASS", 6}, Case{"ALLPASS", 6}, Case{"BANDPASS", 3},
                          Case{"BANDSTOP", 3}, Case{"PT1", 1}, Case{"PT2", 2}}) {
    INFO(one.type);
    // Switched off, so that nothing else is judged.
    std::string const type = "filter[0].type " + one.type + "\nfilter[0].order ";
    CHECK(lines(type + std::to_string(one.highest)).empty());
    CHECK(lines(type + std::to_string(one.highest + 1)) == Lines{"2 AX3001"});
    CHECK(lines(type + "0").empty());
  }
  CHECK(lines("filter[0].type PT2\nfilter[0].order 1") == Lines{"2 AX3001"});
  CHECK(lines("filter[0].type TIME_DELAY\nfilter[0].order 1000").empty());
  CHECK(lines("filter[0].prototype HSC\nfilter[0].type HSC_MEAN\nfilter[0].order 200").empty());
  CHECK(lines("filter[0].prototype HSC\nfilter[0].type HSC_MEAN\nfilter[0].order 201") == Lines{"3 AX3001"});
}

TEST_CASE("AX3001: the additional interface computes the order of PT1 and PT2") {
  CHECK(lines(interface("PT1", "5", "filter[0].time_constant 5000\n")).empty());
  CHECK(lines(interface("PT2", "1", "filter[0].time_constant 5000\n")).empty());
  CHECK(lines(interface("BANDSTOP", "4")) == Lines{"2 AX3001"});
  CHECK(lines(interface("LOWPASS", "7")) == Lines{"2 AX3001"});
}

TEST_CASE("AX3001: FIR filters reach 200, their time delay 100") {
  CHECK(lines("filter_fir.type 1\nfilter_fir.order 200").empty());
  CHECK(lines("filter_fir.type 1\nfilter_fir.order 201") == Lines{"2 AX3001"});
  CHECK(lines("filter_fir.type 4\nfilter_fir.order 100").empty());
  CHECK(lines("filter_fir.type 4\nfilter_fir.order 101") == Lines{"2 AX3001"});
  CHECK(lines("filter_fir.order 300\nfilter_fir.type 1") == Lines{"1 AX3001"});
}

TEST_CASE("AX3001 offers the highest order, which changes the machine") {
  Run const run("filter[0].type BANDSTOP\nfilter[0].order 5 ( hoch");
  Finding const& finding = run.only();
  CHECK(english(finding.message) == "order 5 is not allowed for `BANDSTOP`");
  REQUIRE(finding.fix);
  CHECK(finding.fix->safety == FixSafety::changes_behaviour);
  REQUIRE(finding.fix->edits.size() == 1);
  CHECK(finding.fix->edits[0].text == "3");
  CHECK(finding.fix->edits[0].place == finding.place);
  REQUIRE(finding.related.size() == 1);
  CHECK(run.position(finding.related[0].place).line == 1);
  REQUIRE(finding.control);
  CHECK(finding.control->message == "50553");

  Run const fir("filter_fir.order 250");
  REQUIRE(fir.only().control);
  CHECK(fir.only().control->message == "50911");
  CHECK(fir.only().control->value == "200");
}

TEST_CASE("AX3002 and AX3003: characteristic frequencies of active filters") {
  CHECK(lines(filter("LOWPASS", "1", "filter[0].fg_f0 500\n")) == Lines{"4 AX3002"});
  CHECK(lines(filter("LOWPASS", "1", "filter[0].fg_f0 499\n")).empty());
  CHECK(lines(filter("LOWPASS", "1", "filter[0].fg_f0 0\n")) == Lines{"4 AX3003"});
  CHECK(lines(filter("LOWPASS", "1", "filter[0].fg_f0 -1\n")) == Lines{"4 AX3003"});
  CHECK(lines("filter[0].fg_f0 900").empty());
  CHECK(lines(interface("ALLPASS", "1", "filter[0].fg_f0 500\n")) == Lines{"4 AX3002"});
  CHECK(lines(interface("ALLPASS", "1", "filter[0].fg_f0 0\n")) == Lines{"4 AX3003"});
}

TEST_CASE("AX3002: the default frequency is judged too, at enable") {
  CHECK(lines(filter("LOWPASS", "1"), {.cycle_us = 20000}) == Lines{"1 AX3002"});
}

TEST_CASE("AX3002 and AX3003: HSC NoVib and windowed sinc") {
  std::string const novib = "filter[0].prototype HSC\nfilter[0].type HSC_SHAPER\nfilter[0].order 1\n";
  CHECK(lines(novib + "filter[0].fg_f0 500") == Lines{"4 AX3002"});
  CHECK(lines(novib + "filter[0].fg_f0 0") == Lines{"4 AX3003"});
  CHECK(lines(novib + "filter[0].fg_f0 50").empty());
  CHECK(lines("filter_fir.type 3\nfilter_fir.order 20\nfilter_fir.fcut 500") == Lines{"3 AX3002"});
  CHECK(lines("filter_fir.type 3\nfilter_fir.order 20\nfilter_fir.fcut 0") == Lines{"3 AX3003"});
  CHECK(lines("filter_fir.type 3\nfilter_fir.order 20\nfilter_fir.fcut 499").empty());
}

TEST_CASE("AX3002 and AX3003: stages of the Improved Position Control") {
  std::string const ipc = "lr_param.improved_position_control.";
  std::string const stage = ipc + "stage[1].";
  std::string const on = ipc + "enable 1\n" + ipc + "v_add_max_fact 100\n" + stage + "mode DIRECT\n" + stage +
                         "filter.order 1\n" + stage + "filter.q_factor 2\n";
  Options const slow{.cycle_us = 2000};
  CHECK(lines(on + stage + "filter.fg_f0 250", slow) == Lines{"6 AX3002"});
  CHECK(lines(on + stage + "filter.fg_f0 249", slow).empty());
  CHECK(lines(on + stage + "filter.fg_f0 0", slow) == Lines{"6 AX3003"});
  CHECK(lines(stage + "filter.fg_f0 300", slow).empty());

  std::string const newer = ipc + "enable 1\n" + ipc + "v_add_max_fact 100\n" + stage + "mode DIRECT\n" +
                            stage + "filter[0].order 1\n" + stage + "filter[0].q_factor 2\n" + stage +
                            "filter[1].order 1\n";
  std::string const first = stage + "filter[0].fg_f0 50\n";
  CHECK(lines(newer + stage + "filter[0].fg_f0 250", slow) == Lines{"7 AX3002"});
  CHECK(lines(newer + first + stage + "filter[1].fg_f0 250", slow).empty());
  CHECK(lines(newer + first + stage + "filter[1].fg_f0 250\n" + stage + "filter[1].type ALLPASS", slow) ==
        Lines{"8 AX3002"});
}

TEST_CASE("AX3002 names the limit in hertz and the control's number") {
  Run const run(filter("LOWPASS", "1", "filter[0].fg_f0 600\n"));
  CHECK(english(run.only().message) == "600 Hz is not below half the sampling rate, 500 Hz");
  CHECK(run.only().control->message == "50557");
  CHECK(Run(interface("LOWPASS", "1", "filter[0].fg_f0 600\n")).only().control->message == "70420");
}

TEST_CASE("AX3004: PT1 and PT2 from one cycle on") {
  for (std::string const type : {"PT1", "PT2"}) {
    std::string const order = type == "PT1" ? "1" : "2";
    CHECK(lines(filter(type, order, "filter[0].time_constant 999\n")) == Lines{"4 AX3004"});
    CHECK(lines(filter(type, order, "filter[0].time_constant 1000\n")).empty());
    CHECK(lines(interface(type, order, "filter[0].time_constant 1\n")) == Lines{"4 AX3004"});
  }
  CHECK(lines(filter("PT1", "1", "filter[0].time_constant 249\n"), {.cycle_us = 250}) == Lines{"4 AX3004"});
  CHECK(lines(interface("PT1", "1")) == Lines{"1 AX3004"});
  CHECK(lines("lr_param.add_interface.filter[0].type PT1").empty());
  CHECK(lines("filter[0].type PT1\nfilter[0].time_constant 10") == Lines{"2 AX3004"});
}

TEST_CASE("AX3004 suggests microseconds where milliseconds may be meant") {
  Run const run(filter("PT1", "1", "filter[0].time_constant 10\n"));
  REQUIRE(run.only().help.size() == 2);
  CHECK(english(run.only().help[0]) == "the value is in µs: 10 ms are `filter[0].time_constant 10000`");
  CHECK(Run(filter("PT1", "1", "filter[0].time_constant 0\n")).only().help.size() == 1);
}

TEST_CASE("AX3004 and AX3005: the control's number depends on who runs the filter") {
  std::string const too_short = "filter[0].time_constant 10\n";
  CHECK(Run(filter("PT1", "1", too_short)).only().control->message == "50663");
  CHECK(Run(filter("PT1", "1", too_short), {.axis = AxisType::rotary}).only().control->message == "50663");
  CHECK(Run(filter("PT1", "1", too_short), {.axis = AxisType::spindle}).only().control->message == "60311");
  CHECK(Run(interface("PT1", "1", too_short)).only().control->message == "70451");
  std::string const too_long = "filter[0].time_constant 7000\n";
  CHECK(Run(filter("TIME_DELAY", "1", too_long)).only().control->message == "50663");
  CHECK(Run(interface("TIME_DELAY", "1", too_long)).only().control->message == "70451");
}

TEST_CASE("AX3005: less than six cycles") {
  CHECK(lines(filter("TIME_DELAY", "1", "filter[0].time_constant 6000\n")) == Lines{"4 AX3005"});
  CHECK(lines(filter("TIME_DELAY", "1", "filter[0].time_constant 5999\n")).empty());
  CHECK(lines(filter("TIME_DELAY", "1", "filter[0].time_constant 0\n")).empty());
  CHECK(lines(filter("TIME_DELAY", "1")) == Lines{"1 AX3005"});
  CHECK(lines(filter("TIME_DELAY", "1"), {.cycle_us = 2000}).empty());
  CHECK(lines(filter("TIME_DELAY", "1", "filter[0].time_constant 10000\n")) == Lines{"4 AX3005"});
  CHECK(lines("filter[0].type TIME_DELAY\nfilter[0].time_constant 6000") == Lines{"2 AX3005"});
  CHECK(lines("filter[0].type TIME_DELAY\nfilter[0].time_constant 10000").empty());
  CHECK(lines("filter[0].type TIME_DELAY").empty());
  CHECK(lines(interface("TIME_DELAY", "1", "filter[0].time_constant 6000\n")) == Lines{"4 AX3005"});
  CHECK(lines(interface("TIME_DELAY", "1")).empty());
}

TEST_CASE("AX3005 says how long the delay is in cycles, and what delays longer") {
  Run const run(filter("TIME_DELAY", "1", "filter[0].time_constant 12000\n"));
  Finding const& finding = run.only();
  CHECK(english(finding.message) == "the delay must be shorter than 6 NC cycles");
  CHECK(render(finding.message, Language::german) == "die Verzögerung muss kürzer als 6 NC-Zyklen sein");
  REQUIRE(finding.label);
  CHECK(english(*finding.label) == "12000 µs (12 ms) are 12 cycles of 1000 µs");
  REQUIRE_FALSE(finding.notes.empty());
  CHECK(english(finding.notes[0]) ==
        "P-AXIS-00357: 0 ≤ time_constant < 6 T = 6000 µs (6 ms) for `TIME_DELAY`");
  REQUIRE(finding.help.size() == 2);
  CHECK(english(finding.help[0]) == "`filter[0].time_constant 5999` is the longest here");
  CHECK(english(finding.help[1]) == "`filter_fir.type 4` delays by up to 100 cycles");
  REQUIRE(finding.control);
  REQUIRE(finding.control->reaction);
  CHECK(english(*finding.control->reaction) == "the filter is switched off");
}

TEST_CASE("AX3007: enabled, but order 0") {
  CHECK(lines("filter[1].enable 1\nfilter[1].fg_f0 20") == Lines{"1 AX3007"});
  CHECK(lines("filter[1].order 0\nfilter[1].enable 1") == Lines{"2 AX3007"});
  CHECK(lines("filter[1].enable 1\nfilter[1].type TIME_DELAY") == Lines{"1 AX3007"});
  CHECK(lines(interface("PT2", "0", "filter[0].time_constant 5000\n")) == Lines{"1 AX3007"});
  CHECK(lines("lr_param.add_interface.filter[0].enable 1\n"
              "lr_param.add_interface.filter[0].time_constant 5000")
            .empty());
  CHECK(lines("filter[1].enable 0\nfilter[1].order 0").empty());
}

TEST_CASE("AX3008: an order without enable is a note") {
  Options const pedantic{.pedantic = true};
  CHECK(lines("filter[1].order 2", pedantic) == Lines{"1 AX3008"});
  CHECK(lines("filter[1].order 2").empty());
  CHECK(lines("filter[1].order 0", pedantic).empty());
  CHECK(lines("lr_param.add_interface.filter[0].order 2", pedantic) == Lines{"1 AX3008"});
  CHECK(lines("lr_param.add_interface.filter[0].fg_f0 20", pedantic).empty());
}

TEST_CASE("AX3009: one finding for each parameter that the type ignores") {
  std::string const all =
      "filter[0].prototype BESSEL\nfilter[0].fg_f0 20\nfilter[0].guete 4\nfilter[0].time_constant 5000\n";
  CHECK(lines(filter("LOWPASS", "1", all)) == Lines{"6 AX3009", "7 AX3009"});
  CHECK(lines(interface("BANDPASS", "1", all)) == Lines{"7 AX3009"});
  CHECK(lines(filter("PT1", "1", all)) == Lines{"4 AX3009", "5 AX3009", "6 AX3009"});
  CHECK(lines(filter("TIME_DELAY", "1", all)) == Lines{"4 AX3009", "5 AX3009", "6 AX3009"});
  CHECK(lines(interface("PT2", "2", all)) == Lines{"4 AX3009", "5 AX3009", "6 AX3009"});
  CHECK(lines("filter[0].guete 4").empty());
}

TEST_CASE("AX3009: a value that another parameter refers to has an effect") {
  std::string const fir =
      "filter_fir.enable 1\nfilter_fir.type 1\nfilter_fir.order 10\nfilter_fir.fcut 2.5e1\n";
  std::string const lowpass =
      "filter[0].enable 1\nfilter[0].type LOWPASS\nfilter[0].order 2\nfilter[0].fg_f0 ";
  CHECK(lines(fir + lowpass + "P-AXIS-00585\n").empty());
  CHECK(lines(fir + lowpass + "20\n") == Lines{"4 AX3009"});
}

TEST_CASE("AX3009: the default written out is no finding") {
  CHECK(lines(filter("LOWPASS", "1", "filter[0].guete 1.0\nfilter[0].time_constant 10000\n")).empty());
  CHECK(lines(filter("PT1", "1", "filter[0].prototype CRIT_DAMPING\nfilter[0].fg_f0 3.0e1\n")).empty());
}

TEST_CASE("AX3009: configured HSC and FIR filters") {
  std::string const hsc = "filter[0].prototype HSC\nfilter[0].order 20\nfilter[0].type ";
  CHECK(lines(hsc + "HSC_MEAN\nfilter[0].guete 4\nfilter[0].fg_f0 20") == Lines{"4 AX3009", "5 AX3009"});
  CHECK(lines(hsc + "HSC_SHAPER\nfilter[0].guete 4\nfilter[0].fg_f0 20") == Lines{"4 AX3009"});
  std::string const fir = "filter_fir.fcut 50\nfilter_fir.quality 0.5\nfilter_fir.order 20\nfilter_fir.type ";
  CHECK(lines(fir + "1") == Lines{"1 AX3009", "2 AX3009"});
  CHECK(lines(fir + "2") == Lines{"1 AX3009"});
  CHECK(lines(fir + "3") == Lines{"2 AX3009"});
  CHECK(lines(fir + "4") == Lines{"1 AX3009", "2 AX3009"});
  CHECK(lines(fir + "0").empty());
}

TEST_CASE("AX3012: types that are not documented") {
  for (std::string const type : {"7", "9", "13", "HSC_SINE", "HSC_GAUSS", "PT2_FD"}) {
    CHECK(lines("filter[0].type " + type) == Lines{"1 AX3012"});
    CHECK(lines("lr_param.add_interface.filter[0].type " + type) == Lines{"1 AX3012"});
  }
  for (std::string const type : {"HSC_MEAN", "12"}) {
    CHECK(lines("lr_param.add_interface.filter[0].type " + type) == Lines{"1 AX3012"});
  }
}

TEST_CASE("AX3013: low-passes that overshoot, with the overshoot of this one") {
  auto const overshoot = [](std::string const& prototype, std::string const& order,
                            std::string const& more = "") {
    Run const run(filter("LOWPASS", order, "filter[0].prototype " + prototype + "\n" + more));
    REQUIRE(run.lines() == Lines{"4 AX3013"});
    REQUIRE(run.only().label);
    return english(*run.only().label);
  };
  CHECK(overshoot("BUTTERWORTH", "2", "filter[0].fg_f0 1\n") == "a step overshoots by 4.3 %");
  CHECK(overshoot("BUTTERWORTH", "4", "filter[0].fg_f0 1\n") == "a step overshoots by 10.8 %");
  CHECK(overshoot("BUTTERWORTH", "6", "filter[0].fg_f0 1\n") == "a step overshoots by 14.3 %");
  CHECK(overshoot("BUTTERWORTH", "2", "filter[0].share_percent 50\nfilter[0].fg_f0 1\n") ==
        "a step overshoots by 2.2 %");
  CHECK(overshoot("BESSEL", "2", "filter[0].fg_f0 1\n") == "a step overshoots by 0.4 %");
  CHECK(lines(filter("LOWPASS", "1", "filter[0].prototype BUTTERWORTH\n")).empty());
  CHECK(lines(filter("LOWPASS", "6")).empty());
  CHECK(lines(interface("LOWPASS", "6", "filter[0].prototype BUTTERWORTH\n")).empty());
}

TEST_CASE("AX3014: all-passes above order 1 without Bessel") {
  CHECK(lines(filter("ALLPASS", "2", "filter[0].prototype BUTTERWORTH\n")) == Lines{"4 AX3014"});
  CHECK(lines(filter("ALLPASS", "2")) == Lines{"1 AX3014"});
  CHECK(lines(filter("ALLPASS", "2", "filter[0].prototype BESSEL\n")).empty());
  CHECK(lines(filter("ALLPASS", "1")).empty());
  CHECK(lines(interface("ALLPASS", "2")) == Lines{"1 AX3014"});
}

TEST_CASE("AX3015: share 0 of what is active or configured") {
  CHECK(lines(filter("LOWPASS", "1", "filter[0].share_percent 0\n")) == Lines{"4 AX3015"});
  CHECK(lines(interface("LOWPASS", "1", "filter[0].share_percent 0\n")) == Lines{"4 AX3015"});
  CHECK(lines("filter[0].prototype HSC\nfilter[0].order 20\nfilter[0].share_percent 0") == Lines{"3 AX3015"});
  CHECK(lines("filter_fir.type 2\nfilter_fir.order 20\nfilter_fir.share 0") == Lines{"3 AX3015"});
  CHECK(lines("filter[0].share_percent 0").empty());
}

TEST_CASE("AX3017: high-pass and band-pass on absolute positions") {
  CHECK(lines(filter("HIGHPASS", "1")) == Lines{"3 AX3017"});
  CHECK(lines(filter("BANDPASS", "1")) == Lines{"3 AX3017"});
  CHECK(lines(interface("HIGHPASS", "1")).empty());
  CHECK(lines("filter[0].type HIGHPASS").empty());
  Run const run(filter("HIGHPASS", "1", "filter[0].share_percent 25\n"));
  CHECK(english(*run.only().label) == "with a share of 25 %, 75 % of a constant position remains");
}

TEST_CASE("AX3040 replaces AX3004 for the interface filter with its defaults") {
  CHECK(lines("lr_param.add_interface.filter[0].enable 1") == Lines{"1 AX3040"});
  CHECK(lines(interface("PT2", "2")) == Lines{"1 AX3040"});
  CHECK(lines("lr_param.add_interface.filter[0].enable 1", {.disabled = {Code{3040}}}) == Lines{"1 AX3004"});
  CHECK(lines("lr_param.add_interface.filter[0].order 2").empty());
}

TEST_CASE("AX3041: the interface is off, at the later of the two lines") {
  std::string const off = "lr_param.add_interface.enable 0\n";
  std::string const on = interface("PT2", "2", "filter[0].time_constant 5000\n");
  CHECK(lines(off + on) == Lines{"2 AX3041"});
  CHECK(lines(on + off) == Lines{"5 AX3041"});
  CHECK(lines(on).empty());
  CHECK(lines(off).empty());
}

TEST_CASE("AX6001: poles too close to the unit circle") {
  CHECK(lines(filter("LOWPASS", "1", "filter[0].fg_f0 1e-7\n")) == Lines{"1 AX6001"});
  CHECK(lines(interface("LOWPASS", "1", "filter[0].fg_f0 1e-7\n")) == Lines{"1 AX6001"});
  CHECK(lines(interface("LOWPASS", "1", "filter[0].fg_f0 1e-6\n")).empty());
  CHECK(lines(interface("LOWPASS", "6", "filter[0].fg_f0 1e-6\n")).empty());
}

TEST_CASE("AX6003: chains that need more than ten seconds") {
  // One pole settles to 1e-4 after 9.2 time constants: 10 s are 0.1466 Hz.
  CHECK(lines(filter("LOWPASS", "1", "filter[0].fg_f0 0.146\n")) == Lines{"1 AX6003"});
  CHECK(lines(filter("LOWPASS", "1", "filter[0].fg_f0 0.147\n")).empty());
  CHECK(lines(filter("LOWPASS", "1", "filter[0].fg_f0 0.146\n"), {.cycle_us = 125}) == Lines{"1 AX6003"});
  CHECK(lines(filter("LOWPASS", "1", "filter[0].fg_f0 0.001\n")) == Lines{"1 AX6003"});
  CHECK(lines(filter("PT1", "1", "filter[0].time_constant 1100000\n")) == Lines{"1 AX6003"});
  CHECK(lines(filter("PT1", "1", "filter[0].time_constant 1080000\n")).empty());
  // Each of the two is quick enough alone.
  std::string const second = "filter[1].enable 1\nfilter[1].order 1\nfilter[1].fg_f0 0.16\n";
  CHECK(lines(second).empty());
  CHECK(lines(filter("LOWPASS", "1", "filter[0].fg_f0 0.17\n") + second) == Lines{"5 AX6003"});
  CHECK(lines(interface("LOWPASS", "1", "filter[0].fg_f0 0.01\n")).empty());
  CHECK(lines(filter("LOWPASS", "1", "filter[0].share_percent 0\nfilter[0].fg_f0 0.01\n")) ==
        Lines{"4 AX3015"});
}

TEST_CASE("AX6003 yields to AX6001 and steps in where that is disabled") {
  std::string const list = filter("LOWPASS", "1", "filter[0].fg_f0 1e-7\n");
  CHECK(lines(list, {.disabled = {Code{6001}}}) == Lines{"1 AX6003"});
}

TEST_CASE("AX6003 knows a slow band-stop that has hardly begun to ring") {
  Lines const expected{"1 AX6003", "3 AX6004"};
  CHECK(lines(filter("BANDSTOP", "1", "filter[0].fg_f0 0.0001\nfilter[0].guete 10\n")) == expected);
  CHECK(lines(filter("BANDSTOP", "1", "filter[0].fg_f0 0.05\nfilter[0].guete 10\n")) == expected);
}

TEST_CASE("AX6004: band-stops that overshoot by more than 1 %") {
  std::string const more = "filter[0].prototype BUTTERWORTH\nfilter[0].fg_f0 20\nfilter[0].guete 4\n";
  Run const run(filter("BANDSTOP", "2", more));
  REQUIRE(run.lines() == Lines{"3 AX6004"});
  CHECK(english(run.only().message) == "the band-stop `filter[0]` overshoots by 21.5 %");
  CHECK(english(run.only().notes.at(0)).find("P-AXIS-00440") != std::string::npos);
  CHECK(lines(filter("BANDSTOP", "2", more + "filter[0].share_percent 4\n")).empty());
  CHECK(lines(interface("BANDSTOP", "2", more)).empty());
}

TEST_CASE("AX6005: peak gain of the chain, at the last filter") {
  Options const pedantic{.pedantic = true};
  CHECK(lines(filter("ALLPASS", "2", "filter[0].prototype BESSEL\nfilter[0].fg_f0 20\n"), pedantic) ==
        Lines{"1 AX6005"});
  CHECK(lines(filter("LOWPASS", "4"), pedantic).empty());
  std::string const second = "filter[2].enable 1\nfilter[2].order 1\nfilter[2].fg_f0 200\n";
  CHECK(lines(filter("BANDSTOP", "3", "filter[0].fg_f0 20\n") + second, pedantic) ==
        Lines{"3 AX6004", "5 AX6005"});
}

TEST_CASE("AX6005: filters too slow to sum up their peak gain get an upper bound") {
  // After ten seconds this notch has hardly begun; its peak gain is 3.357.
  Run const run(
      filter("BANDSTOP", "3", "filter[0].prototype BUTTERWORTH\nfilter[0].fg_f0 0.05\nfilter[0].guete 10\n"),
      {.cycle_us = 125, .pedantic = true, .disabled = {Code{6003}, Code{6008}}});
  REQUIRE(run.lines() == Lines{"1 AX6005", "3 AX6004"});
  Finding const& finding = run.findings()[0];
  CHECK(english(finding.message).find("by a factor of up to ") != std::string::npos);
  std::string const label = english(*finding.label);
  std::string const before = "peak gain Σ|h| ≤ ";
  REQUIRE(label.rfind(before, 0) == 0);
  CHECK(std::stod(label.substr(before.size())) > 3.357);
}

TEST_CASE("AX6008: chains about which an image proves less than usual") {
  Options const pedantic{.pedantic = true};
  auto const slow = [](std::string const& frequency) {
    return filter("LOWPASS", "1", "filter[0].fg_f0 " + frequency + "\n");
  };
  // One pole shrinks to 2^-24 within 2^21 cycles from 24 ln 2/(2 π T 2^21) = 0.001262 Hz on.
  CHECK(lines(slow("0.00124"), pedantic) == Lines{"1 AX6003", "4 AX6008"});
  CHECK(lines(slow("0.00128"), pedantic) == Lines{"1 AX6003"});
  CHECK(lines(slow("0.00124")) == Lines{"1 AX6003"});
  CHECK(lines(slow("0.01262"), {.cycle_us = 100, .pedantic = true}) == Lines{"1 AX6003", "4 AX6008"});
  CHECK(lines(slow("1e-7"), pedantic) == Lines{"1 AX6001"});
  CHECK(lines(interface("LOWPASS", "1", "filter[0].fg_f0 0.00124\n"), pedantic) == Lines{"4 AX6008"});
  // The slowest filter of a chain is meant; at the default frequency its `enable`.
  CHECK(lines(slow("0.00124") + "filter[1].enable 1\nfilter[1].order 1\n", pedantic) ==
        Lines{"1 AX6003", "4 AX6008"});
  // Poles at -1 + 2/tan(π f T), twice: rounding of the states counts for more than 2^-25.
  Options const without_gain{.pedantic = true, .disabled = {Code{6005}}};
  auto const fast = [&](std::string const& frequency) {
    return lines(filter("LOWPASS", "2", "filter[0].fg_f0 " + frequency + "\n"), without_gain);
  };
  CHECK(fast("499.99") == Lines{"2 AX6008", "4 AX6006"});
  CHECK(fast("499") == Lines{"4 AX6006"});
}

TEST_CASE("AX6008 says what is not claimed") {
  Options const options{.pedantic = true, .disabled = {Code{6003}, Code{6005}, Code{6007}}};
  // Three equal poles leave (x^2/2 + x + 1) e^-x of a step: 2^-44 at x = 37.1, in 2^22 cycles for 0.00141 Hz.
  auto const three = [](std::string const& frequency) {
    std::string list;
    for (char const i : {'0', '1', '2'}) {
      std::string const name = std::string("filter[") + i + "].";
      list += name + "enable 1\n" + name + "order 1\n" + name + "fg_f0 " + frequency + "\n";
    }
    return list;
  };
  Run const loose(three("0.0013"), options);
  CHECK(english(*loose.only().label) == "not at rest after 4194304 cycles");
  CHECK(lines(three("0.0016"), options).empty());
  Run const alone(filter("LOWPASS", "1", "filter[0].fg_f0 0.001\n"), options);
  CHECK(english(*alone.only().label) == "not proved to come to rest: rounding may keep it moving");
}

TEST_CASE("one mistake, one message") {
  // A type that cannot be read: nothing is known about the filter.
  CHECK(lines(filter("BANDSTP", "9", "filter[0].guete 4\nfilter[0].fg_f0 900\n")) == Lines{"3 AX2007"});
  // An order that cannot be read: nobody knows whether the filter is active.
  CHECK(lines(filter("PT1", "1,0", "filter[0].prototype BESSEL\n")) == Lines{"2 AX1005"});
  CHECK(lines(filter("LOWPASS", "4", "filter[0].prototype BUTERWORTH\n")) == Lines{"4 AX2007"});
  CHECK(lines(filter("LOWPASS", "4", "filter[0].fg_f0 9oo\n")) == Lines{"4 AX1006"});
  CHECK(lines(filter("TIME_DELAY", "1", "filter[0].time_constant -5\n")) == Lines{"4 AX2004"});
  CHECK(lines("filter[0].enable JA\nfilter[0].fg_f0 600") == Lines{"1 AX2003"});
  // Both an error and a warning at one value.
  CHECK(lines(filter("LOWPASS", "1", "filter[0].guete 20\n")) == Lines{"4 AX2005"});
  CHECK(lines(filter("LOWPASS", "1", "filter[0].fg_f0 -5\n")) == Lines{"4 AX3003"});
}

TEST_CASE("mistakes of one filter that are independent are all reported") {
  CHECK(lines(filter("LOWPASS", "9", "filter[0].prototype BUTTERWORTH\nfilter[0].fg_f0 900\n")) ==
        Lines{"2 AX3001", "4 AX3013", "5 AX3002"});
}

TEST_CASE("a value behind a reference is judged, and not repaired there") {
  Run const run("filter[0].type BANDSTOP\nfilter[0].order P-AXIS-00140.1\nfilter[1].order 5\n");
  REQUIRE(run.lines() == Lines{"2 AX3001"});
  CHECK_FALSE(run.only().fix);
}

TEST_CASE("the manual's examples lint without errors") {
  std::string const open = "lr_param.add_interface.enable 1\n";
  CHECK(lines(filter("LOWPASS", "4",
                     "filter[0].prototype CRIT_DAMPING\nfilter[0].fg_f0 15\nfilter[0].share_percent 100\n"))
            .empty());
  CHECK(lines(open + interface("LOWPASS", "3",
                               "filter[0].prototype BUTTERWORTH\nfilter[0].fg_f0 8\n"
                               "filter[0].share_percent 100\n"))
            .empty());
  CHECK(lines(filter("BANDSTOP", "2",
                     "filter[0].prototype BUTTERWORTH\nfilter[0].fg_f0 20\nfilter[0].guete 4\n"
                     "filter[0].share_percent 100\n")) == Lines{"3 AX6004"});
  CHECK(lines(open + interface("BANDSTOP", "3",
                               "filter[0].prototype BUTTERWORTH\nfilter[0].fg_f0 17\nfilter[0].guete 1.8\n"
                               "filter[0].share_percent 100\n"))
            .empty());
  std::string const share = "filter[0].share_percent 100\n";
  CHECK(lines(filter("PT1", "1", "filter[0].time_constant 10000\n" + share)).empty());
  CHECK(lines(open + interface("PT1", "1", "filter[0].time_constant 10000\n" + share)).empty());
  CHECK(lines(filter("PT2", "2", "filter[0].time_constant 5000\n" + share)).empty());
  CHECK(lines(open + interface("PT2", "2", "filter[0].time_constant 5000\n" + share)).empty());
  CHECK(lines(filter("TIME_DELAY", "1", "filter[0].time_constant 2000\n" + share)).empty());
  CHECK(lines(open + interface("TIME_DELAY", "1", "filter[0].time_constant 2000\n" + share)).empty());
}

}  // namespace filter_rules_test
