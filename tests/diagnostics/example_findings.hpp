// Findings built by hand, for the tests of the writers.
#pragma once

#include "diagnostics/finding.hpp"
#include "support/catch.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace axisc::test {

/// A message that is the same in both languages.
inline Message say(std::string text) {
  return {axisc::says::as_given, {{.name = "text", .value = std::move(text)}}};
}

/// The place of the `nth` (from 0) occurrence of `bytes`.
inline Place place_of(SourceSet const& sources, SourceId id, std::string_view bytes, int nth = 0) {
  std::string_view const all = sources[id].bytes();
  std::size_t begin = all.find(bytes);
  for (; nth > 0; --nth) begin = all.find(bytes, begin + 1);
  REQUIRE(begin != std::string_view::npos);
  return {.source = id,
          .span = {.begin = static_cast<std::uint32_t>(begin),
                   .end = static_cast<std::uint32_t>(begin + bytes.size())}};
}

/// An error about a place, without anything beside it.
inline Finding error_at(Place place, std::string message) {
  Finding finding;
  finding.code = Code{3005};
  finding.name = "delay-too-long";
  finding.place = place;
  finding.message = say(std::move(message));
  return finding;
}

/// The example of the command line's contract: a delay of 12 cycles, on line 12, column 34 of axes/x.lis.
struct DelayExample {
  SourceSet sources;
  SourceId list{};
  Finding finding;

  DelayExample() {
    list = sources.add(SourceText(
        "axes/x.lis",
        std::string(11, '\n') + "filter[0].time_constant          12000      # dead time of the drive\n"));
    finding = error_at(place_of(sources, list, "12000"), "the delay must be shorter than 6 NC cycles");
    finding.label = say("12000 µs are 12 cycles of 1000 µs");
    finding.notes = {say("P-AXIS-00357: 0 ≤ time_constant < 6 T for TIME_DELAY")};
    finding.help = {say("`filter_fir.type 4` delays by up to 100 cycles")};
    finding.axis = "X";
    finding.parameter = "filter[0].time_constant";
    finding.p_axis = "P-AXIS-00357";
  }
};

/// Everything a finding can have: control, related places in two files, a fix.
struct FullExample {
  SourceSet sources;
  SourceId list{};
  SourceId defaults{};
  Finding finding;

  FullExample() {
    defaults = sources.add(SourceText("default.lis", "kenngr.achs_typ 1\nfilter[0].order 3\nEnde\n"));
    list = sources.add(SourceText(
        "x.lis", "filter[0].type LOWPASS\r\nfilter[0].quality 0,7  (G\xFCte)\r\nfilter[0].order 9\r\n"));
    finding = error_at(place_of(sources, list, "0,7"), "the quality must be a number");
    finding.severity = Severity::warning;
    finding.label = say("the control reads 0");
    finding.notes = {say("P-AXIS-00740: 1 ≤ guete ≤ 10"), say("a second note")};
    finding.control =
        ControlReaction{.message = "1001138", .reaction = say("the filter is switched off"), .value = "0"};
    finding.related = {
        {.place = place_of(sources, list, "filter[0].order 9"), .message = say("the order stands here")},
        {.place = place_of(sources, defaults, "3"), .message = say("the default list says 3")}};
    finding.fix = Fix{.title = say("write a decimal point"),
                      .edits = {{.place = place_of(sources, list, ","), .text = "."}},
                      .safety = FixSafety::safe};
    finding.axis = "X";
    finding.parameter = "filter[0].quality";
    finding.p_axis = "P-AXIS-00740";
  }
};

}  // namespace axisc::test
