// One value is written: every other byte stays, and what the check would refuse is not written.
#include "axisc/answers/values/set_values.hpp"

#include "axisc/environment/failure.hpp"
#include "axisc/workspace/workspace.hpp"
#include "diagnostics/finding.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

#include <string>
#include <vector>

using namespace axisc;
using axisc::test::TemporaryFolder;

namespace {

struct Written {
  std::string bytes;  ///< empty: nothing to write
  std::vector<std::string> errors;
  std::string refusal;
};

Written set(std::string const& input, std::vector<std::string> words) {
  Workspace workspace;
  Written written;
  ErrorSink const errors{.language = Language::english,
                         .take = [&](std::vector<Finding> const& findings, SourceSet const&) {
                           for (auto const& finding : findings) {
                             written.errors.push_back(code_text(finding.code));
                           }
                         }};
  try {
    auto const made = set_values(workspace, {.machine = {.input = input}, .words = std::move(words)}, errors);
    if (made && !made->edits.edited.empty()) written.bytes = made->edits.edited.begin()->second;
  } catch (Failure const& failure) {
    written.refusal = failure.sentence(Language::english);
  }
  return written;
}

std::string const plain =
    "kopf.achs_nr              1\n"
    "filter[0].enable          1          ( P-AXIS-00319\n"
    "filter[0].fg_f0           30         ( P-AXIS-00067 : notch\n"
    "filter[0].order           2\n"
    "kenngr.achs_typ           1\n"
    "Ende\n";

std::string replaced(std::string text, std::string const& before, std::string const& after) {
  auto const at = text.find(before);
  REQUIRE(at != std::string::npos);
  return text.replace(at, before.size(), after);
}

}  // namespace

TEST_CASE("a value is replaced where it stands, with its unit converted") {
  TemporaryFolder const folder;
  auto const list = folder.write("x.lis", plain);
  CHECK(set(list, {"filter[0].fg_f0=48Hz"}).bytes == replaced(plain, "30 ", "48 "));
  CHECK(set(list, {"filter[0].fg_f0=0.048kHz"}).bytes == replaced(plain, "30 ", "48 "));
  CHECK(set(list, {"filter[0].fg_f0=48"}).bytes == replaced(plain, "30 ", "48 "));
  CHECK(set(list, {"filter[0].order=1", "filter[0].fg_f0=48"}).bytes ==
        replaced(replaced(plain, "30 ", "48 "), "order           2", "order           1"));
  CHECK(set(list, {"filter[0].fg_f0=30.0"}).bytes.empty());
}

TEST_CASE("a word is written as the catalogue spells it") {
  TemporaryFolder const folder;
  std::string const list = replaced(plain, "Ende\n", "filter[0].type            lowpass\nEnde\n");
  auto const path = folder.write("x.lis", list);
  CHECK(set(path, {"filter[0].type=bandstop"}).bytes == replaced(list, "lowpass", "BANDSTOP"));
  CHECK(set(path, {"filter[0].enable=false"}).bytes ==
        replaced(list, "1          ( P-AXIS-00319", "FALSE      ( P-AXIS-00319"));
  CHECK(set(path, {"kopf.log_achs_name=x_achse"}).bytes.find(" x_achse\n") != std::string::npos);
}

TEST_CASE("a missing line follows its family, aligned as that is") {
  TemporaryFolder const folder;
  auto const list = folder.write("x.lis", plain);
  CHECK(set(list, {"filter[0].type=BANDSTOP"}).bytes ==
        replaced(plain, "filter[0].order           2\n",
                 "filter[0].order           2\nfilter[0].type            BANDSTOP\n"));
  CHECK(set(list, {"getriebe[0].dynamik.vb_max=300mm/s"}).bytes ==
        replaced(plain, "Ende\n", "getriebe[0].dynamik.vb_max 300000\nEnde\n"));
  CHECK(set(list, {"filter[0].time_constant=12ms"}).bytes ==
        replaced(plain, "filter[0].order           2\n",
                 "filter[0].order           2\nfilter[0].time_constant   12000\n"));
}

TEST_CASE("encoding, line ends, byte order mark and comments stay") {
  TemporaryFolder const folder;
  auto const check = [&](std::string const& bytes) {
    auto const list = folder.write("x.lis", bytes);
    CHECK(set(list, {"filter[0].fg_f0=48Hz"}).bytes == replaced(bytes, "30 ", "48 "));
    auto const added = set(list, {"filter[0].guete=2"}).bytes;
    auto const end = bytes.find("\r\n") == std::string::npos ? "\n" : "\r\n";
    auto const order = std::string("filter[0].order           2") + end;
    CHECK(added == replaced(bytes, order, order + "filter[0].guete           2" + end));
  };
  auto const crlf = [](std::string text) {
    for (auto at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 2)) {
      text.insert(at, 1, '\r');
    }
    return text;
  };
  check(plain);
  check(crlf(plain));
  check("\xEF\xBB\xBF" + plain);
  check("# Achsliste X: Tisch l\xE4ngs\n" + plain);
  check("# l\xE4ngs\r\n" + crlf(plain));
  check("\tkopf.mds_ident\t1\n\n\n" + plain);
}

TEST_CASE("a default is written where no list says it, and not where the default list does") {
  TemporaryFolder const folder;
  auto const list = folder.write("x.lis", plain);
  CHECK(set(list, {"filter_fir.share=100"}).bytes ==
        replaced(plain, "Ende\n", "filter_fir.share          100\nEnde\n"));
  CHECK(set(list, {"filter[1].type=LOWPASS", "filter[1].fg_f0=40"}).bytes ==
        replaced(plain, "Ende\n", "filter[1].type            LOWPASS\nfilter[1].fg_f0           40\nEnde\n"));
  folder.write("default.lis", "filter_fir.share 100\nEnde\n");
  auto const machine = folder.write(
      "machine.json", R"({"default_list": "default.lis", "axes": [{"name": "X", "list": "x.lis"}]})");
  CHECK(set(machine, {"X", "filter_fir.share=100"}).bytes.empty());
}

TEST_CASE("setting a value again writes nothing") {
  TemporaryFolder const folder;
  for (std::string const assignment :
       {"filter[0].fg_f0=48Hz", "filter[0].type=BANDSTOP", "filter[2].order=0", "kenngr.achs_mode=0x1",
        "getriebe[0].dynamik.vb_max=300mm/s", "kopf.log_achs_name=X"}) {
    INFO(assignment);
    auto const list = folder.write("x.lis", plain);
    auto const first = set(list, {assignment});
    CHECK(first.refusal.empty());
    CHECK(first.errors.empty());
    if (first.bytes.empty()) continue;
    folder.write("x.lis", first.bytes);
    CHECK(set(list, {assignment}).bytes.empty());
  }
}

TEST_CASE("what the check would refuse is not written") {
  TemporaryFolder const folder;
  auto const list = folder.write("x.lis", plain);
  auto const errors = [&](std::string const& assignment) { return set(list, {assignment}).errors; };
  using Codes = std::vector<std::string>;
  // 0.5/T is 500 Hz at 1 ms, which is assumed.
  CHECK(errors("filter[0].fg_f0=600Hz") == Codes{"AX3002"});
  CHECK(errors("filter[0].order=9") == Codes{"AX3001"});
  CHECK(errors("filter[0].type=BANDSTOPP") == Codes{"AX2007"});
  CHECK(errors("filter[0].order=two") == Codes{"AX2003"});
  // An error that was there already is still one.
  auto const wrong = folder.write("y.lis", replaced(plain, "30 ", "700 "));
  CHECK(set(wrong, {"filter[0].fg_f0=600"}).errors == Codes{"AX3002"});
  CHECK(set(wrong, {"filter[0].order=1"}).errors.empty());
}

TEST_CASE("words that cannot be written are refused with the reason") {
  TemporaryFolder const folder;
  auto const list = folder.write("x.lis", plain);
  auto const refusal = [&](std::string const& assignment) { return set(list, {assignment}).refusal; };
  CHECK(refusal("filter[0].fg_f0") == "\"filter[0].fg_f0\" has no value; write filter[0].fg_f0=VALUE");
  CHECK(refusal("filter[0].odrer=1") ==
        "there is no axis parameter \"filter[0].odrer\"; did you mean filter[0].order?");
  CHECK(refusal("P-AXIS-00099=3") ==
        "there is no axis parameter \"P-AXIS-00099\"; did you mean getriebe[0].kv?");
  CHECK(refusal("filter[].order=1") ==
        "there is no `filter[].order`; write one of filter[0].order to filter[2].order");
  CHECK(
      refusal("filter[0].fg_f0=48ms") ==
      "\"ms\" is not a unit of `filter[0].fg_f0`, whose number is in Hz; without a unit it is written as it "
      "is");
  CHECK(refusal("filter[0].order=2Hz") == "`filter[0].order` has no unit: write the number alone");
  CHECK(refusal("filter[0].time_constant=0.5us") ==
        "0.5us is not a whole number in µs, as `filter[0].time_constant` needs it");
  for (std::string const value : {"1\nfilter[1].enable 1", "1 # x", "1 2"}) {
    INFO(value);
    CHECK_THAT(refusal("filter[0].order=" + value), Catch::Matchers::Contains("a list reads something else"));
  }
  CHECK(set(list, {"filter[0].order=1", "filter[0].order=2"}).refusal == "`filter[0].order` is given twice");
  CHECK_THAT(set(list, {}).refusal, Catch::Matchers::Contains("name a parameter and its value"));
}

TEST_CASE("a character that the encoding of the list lacks is named as the cause") {
  TemporaryFolder const folder;
  auto const list = folder.write("x.lis", "# l\xE4ngs\n" + plain);
  CHECK(set(list, {"kopf.log_achs_name=\xE2\x86\x92X"}).refusal ==
        "`kopf.log_achs_name` cannot be \"\xE2\x86\x92X\": " + list +
            " is in windows-1252, which lacks a character of it");
  CHECK_FALSE(set(list, {"kopf.log_achs_name=\xC3\x84X"}).bytes.empty());
}

TEST_CASE("a list outside of what the user names is not written") {
  TemporaryFolder const folder;
  folder.write("lists/x.lis", plain);
  auto const machine = folder.write("machine/machine.json", R"({"machine": "m", "cycle_time_us": 1000,
    "axes": [{"name": "X", "list": "../lists/x.lis"}]})");
  CHECK_THAT(set(machine, {"X", "filter[0].fg_f0=48"}).refusal,
             Catch::Matchers::Contains("lies outside what the command line names"));
}
