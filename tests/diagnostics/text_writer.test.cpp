#include "diagnostics/writers/report_writer.hpp"
#include "diagnostics/writers/writers.hpp"
#include "example_findings.hpp"
#include "support/catch.hpp"
#include "support/golden.hpp"

#include <string>

using namespace axisc;
using namespace axisc::test;

namespace {

std::string in_english(Finding const& finding, SourceSet const& sources) {
  return write_text(finding, sources, {.language = Language::english});
}

void check_text(std::string const& name, std::string const& actual) {
  check_golden("tests/diagnostics/data/text/" + name + ".txt", actual);
}

// A finding about `bytes` in a source that holds `text`.
std::string shown(std::string text, std::string_view bytes) {
  SourceSet sources;
  SourceId const id = sources.add(SourceText("x.lis", std::move(text)));
  return in_english(error_at(place_of(sources, id, bytes), "message"), sources);
}

}  // namespace

TEST_CASE("the example of the command line's contract, letter by letter") {
  DelayExample const example;
  CHECK(in_english(example.finding, example.sources) ==
        "error[AX3005]: the delay must be shorter than 6 NC cycles\n"
        "  --> axes/x.lis:12:34\n"
        "   |\n"
        "12 | filter[0].time_constant          12000      # dead time of the drive\n"
        "   |                                  ^^^^^ 12000 µs are 12 cycles of 1000 µs\n"
        "   |\n"
        "   = P-AXIS-00357: 0 ≤ time_constant < 6 T for TIME_DELAY\n"
        "   = help: `filter_fir.type 4` delays by up to 100 cycles\n");
}

TEST_CASE("text form of a finding with everything") {
  FullExample const example;
  check_text("everything.en", in_english(example.finding, example.sources));
  check_text("everything.de", write_text(example.finding, example.sources, {.language = Language::german}));
  check_text("everything.color", write_text(example.finding, example.sources, {.color = true}));
}

TEST_CASE("text form of a finding with nothing but its place") {
  DelayExample example;
  Finding const bare = error_at(*example.finding.place, "message");
  check_text("bare", in_english(bare, example.sources));
}

TEST_CASE("text form of a finding without place") {
  Finding finding;
  finding.code = Code{9001};
  finding.message = say("the file cannot be read");
  SourceSet const sources;
  SECTION("and without file") {
    CHECK(in_english(finding, sources) == "error[AX9001]: the file cannot be read\n");
  }
  SECTION("with a file") {
    finding.file = "axes/missing.lis";
    CHECK(in_english(finding, sources) == "error[AX9001]: the file cannot be read\n --> axes/missing.lis\n");
  }
  SECTION("with a file and a note") {
    finding.file = "axes/missing.lis";
    finding.notes = {say("it is a folder")};
    CHECK(in_english(finding, sources) ==
          "error[AX9001]: the file cannot be read\n --> axes/missing.lis\n  = it is a folder\n");
  }
}

TEST_CASE("equal findings are printed once, and their places are counted") {
  std::unique_ptr<ReportWriter> const report = text_report({});
  std::string text;
  for (std::string const name : {"a.lis", "b.lis", "c.lis"}) {
    SourceSet sources;
    auto const list = sources.add(SourceText(name, "kopf.achs_nr 1\nfoo 3\nfoo 4\n"));
    report->add(text, error_at(place_of(sources, list, "foo 3"), "unknown"), sources, {});
    report->add(text, error_at(place_of(sources, list, "foo 4"), "unknown"), sources, {});
  }
  auto const printed = text.size();
  report->end([&](std::string_view more) { text += more; }, {.has_summary = false});
  CHECK(text.substr(0, printed).find("a.lis:2:1") != std::string::npos);
  CHECK(text.substr(0, printed).find("a.lis:3:1") != std::string::npos);
  CHECK(text.substr(0, printed).find("b.lis") == std::string::npos);
  CHECK_THAT(text.substr(printed),
             Catch::Matchers::Contains("the same in more places: 2\n  ::: b.lis:2:1\n  ::: c.lis:2:1\n") &&
                 Catch::Matchers::Contains("  ::: b.lis:3:1\n  ::: c.lis:3:1\n"));
}

TEST_CASE("the first word of each severity") {
  DelayExample example;
  auto const headline = [&](Severity severity, Language language) {
    example.finding.severity = severity;
    std::string const text = write_text(example.finding, example.sources, {.language = language});
    return text.substr(0, text.find(':'));
  };
  CHECK(headline(Severity::error, Language::english) == "error[AX3005]");
  CHECK(headline(Severity::warning, Language::english) == "warning[AX3005]");
  CHECK(headline(Severity::note, Language::english) == "note[AX3005]");
  CHECK(headline(Severity::error, Language::german) == "Fehler[AX3005]");
  CHECK(headline(Severity::warning, Language::german) == "Warnung[AX3005]");
  CHECK(headline(Severity::note, Language::german) == "Hinweis[AX3005]");
}

TEST_CASE("the caret stands under its token") {
  SECTION("behind tabs") {
    check_text("behind-tabs", shown("\tfilter[0].order\t\t20\t(x)\n", "20"));
  }
  SECTION("behind umlauts in UTF-8") {
    check_text("behind-umlauts", shown("name \"Köpfchen µ\" 20\n", "20"));
  }
  SECTION("behind umlauts in windows-1252") {
    check_text("behind-umlauts", shown("name \"K\xF6pfchen \xB5\" 20\n", "20"));
  }
  SECTION("behind a byte order mark and in front of CRLF") {
    check_text("behind-mark", shown("\xEF\xBB\xBF"
                                    "filter[0].order 20\r\n",
                                    "20"));
  }
  SECTION("behind control characters") {
    check_text("behind-control", shown("a\x1b[31m\x01 20\n", "20"));
  }
  SECTION("in a long line") {
    check_text("long-line",
               shown("name 1 (" + std::string(300, 'x') + " 20 " + std::string(300, 'y') + ")\n", "20"));
  }
  SECTION("at the end of the file") {
    SourceSet sources;
    SourceId const id = sources.add(SourceText("x.lis", "filter[0].order"));
    check_text("end-of-file",
               in_english(error_at({.source = id, .span = {.begin = 15, .end = 15}}, "message"), sources));
  }
  SECTION("as far as its first line goes") {
    check_text("several-lines", shown("one two\nthree\n", "two\nth"));
  }
}

TEST_CASE("what the control does, as far as it is known") {
  auto const control_line = [](ControlReaction reaction, Language language) {
    DelayExample example;
    example.finding.notes.clear();
    example.finding.help.clear();
    example.finding.control = std::move(reaction);
    std::string const text = write_text(example.finding, example.sources, {.language = language});
    std::size_t const begin = text.find("   = ");
    return begin == std::string::npos ? std::string() : text.substr(begin + 5);
  };
  ControlReaction const full{.message = "50663/60311", .reaction = say("filter off"), .value = "0"};
  CHECK(control_line(full, Language::english) == "control: messages 50663/60311: filter off; runs with 0\n");
  CHECK(control_line(full, Language::german) ==
        "Steuerung: Meldungen 50663/60311: filter off; arbeitet mit 0\n");
  CHECK(control_line({.message = "50663", .reaction = {}, .value = {}}, Language::german) ==
        "Steuerung: Meldung 50663\n");
  CHECK(control_line({.message = {}, .reaction = say("filter off"), .value = {}}, Language::english) ==
        "control: filter off\n");
  CHECK(control_line({.message = {}, .reaction = {}, .value = "20"}, Language::english) ==
        "control: runs with 20\n");
  CHECK(control_line({}, Language::english).empty());
}

TEST_CASE("line numbers of all parts share one gutter") {
  SourceSet sources;
  SourceId const id = sources.add(SourceText("x.lis", "a 1\n" + std::string(98, '\n') + "a 2\n"));
  Finding finding = error_at(place_of(sources, id, "1"), "assigned twice");
  finding.related = {{.place = place_of(sources, id, "2"), .message = say("this one wins")}};
  check_text("gutter", in_english(finding, sources));
}

TEST_CASE("fixes that add, remove and touch another file") {
  SourceSet sources;
  SourceId const x = sources.add(SourceText("x.lis", "filter[0].order 2\nfilter[0].order 3\n"));
  SourceId const y = sources.add(SourceText("y.lis", "filter[0].order 4\n"));
  Finding finding = error_at(place_of(sources, x, "order", 1), "message");
  finding.fix = Fix{.title = say("put things right"),
                    .edits = {{.place = place_of(sources, x, "filter[0].order 2\n"), .text = ""},
                              {.place = {.source = y, .span = {.begin = 18, .end = 18}},
                               .text = "filter[1].type TIME_DELAY\nfilter[1].order 2\n"}}};
  check_text("fix-several", in_english(finding, sources));
}

TEST_CASE("nothing from a file steers the terminal") {
  SourceSet sources;
  SourceId const id = sources.add(SourceText("evil\x1b[2J.lis", "a \x1b[31m\n"));
  Finding finding = error_at(place_of(sources, id, "a"), "unknown name \x1b[2J");
  finding.label = say("line\nbreak");
  std::string const text = in_english(finding, sources);
  CHECK(text.find('\x1b') == std::string::npos);
  CHECK(text.find("line␊break") != std::string::npos);
}
