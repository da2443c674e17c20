// Machine files: what is wrong in them, at the right line and column.
#include "configuration/machine_file.hpp"

#include "configuration/located_json.hpp"
#include "support/catch.hpp"
#include "support/checked.hpp"

namespace {

using namespace axisc;
using tests::Checked;
using tests::Lines;

Lines found(std::string const& machine) {
  return Checked({{"m.json", machine}, {"x.lis", "kopf.achs_nr 1\n"}}, "m.json").found();
}

Lines with_key(std::string const& member) {
  return found("{\n" + member + ",\n\"axes\": [{\"name\": \"X\", \"list\": \"x.lis\"}]}\n");
}

}  // namespace

TEST_CASE("what is no JSON is reported where it stops being JSON") {
  CHECK(found("{\"axes\": [1,]}") == Lines{"1:13 AX4020"});
  CHECK(found("{\"axes\": 1 \"b\": 2}") == Lines{"1:12 AX4020"});
  CHECK(found("{\"axes\":\n  tru}") == Lines{"2:3 AX4020"});
  CHECK(found("{\"axes\": [") == Lines{"1:11 AX4020"});
  CHECK(found("{\"axes\": \"open") == Lines{"1:10 AX4020"});
  CHECK(found("{\"axes\": []} 5") == Lines{"1:14 AX4020"});
  CHECK(found("{") == Lines{"1:2 AX4020"});
  CHECK(found("{\"axes\": [1,,2]}") == Lines{"1:13 AX4020"});
  CHECK(found("{\"axes\": 1.e}").size() == 1);
}

TEST_CASE("hostile nesting is an error like any other") {
  std::string const deep = "{\"axes\": " + std::string(100'000, '[') + std::string(100'000, ']') + "}";
  CHECK(found(deep) == Lines{"1:73 AX4020"});
}

TEST_CASE("columns count characters") {
  CHECK(with_key("\"machine\": \"Fräse\", \"zyklus\": 1") == Lines{"2:21 AX4020"});
  CHECK(found("\xEF\xBB\xBF{\"axis\": 1, \"axes\": [{\"name\": \"X\", \"list\": \"x.lis\"}]}") ==
        Lines{"1:2 AX4020"});
  CHECK(with_key("\"a\\\"b\": 1, \"inch\": 2") == Lines{"2:1 AX4020", "2:20 AX4020"});
}

TEST_CASE("cycle times from 20 µs to 100 ms") {
  for (char const* const good : {"1000", "62.5", "20", "100000", "1e3"}) {
    INFO(good);
    CHECK(with_key(std::string("\"cycle_time_us\": ") + good).empty());
  }
  for (char const* const bad : {"0", "-1000", "1000001", "0.0001", "1", "19.999", "100000.5", "1e300",
                                "\"1000\"", "null", "[1000]"}) {
    INFO(bad);
    CHECK(with_key(std::string("\"cycle_time_us\": ") + bad) == Lines{"2:18 AX4020"});
  }
}

TEST_CASE("wrong types are reported at the value") {
  for (char const* const member :
       {"\"machine\": 5", "\"default_list\": []", "\"groups\": {}", "\"groups\": [5]", "\"gantries\": 1",
        "\"programs\": \"part.nc\"", "\"programs\": [5]", "\"filter_sets\": {}", "\"inch\": 0",
        "\"machine\": \"\""}) {
    INFO(member);
    CHECK(with_key(member).size() == 1);
  }
  CHECK(found("[\"axes\"]") == Lines{"1:1 AX4020"});
  CHECK(found("{\"axes\": {}}") == Lines{"1:10 AX4020"});
  CHECK(found("{\"axes\": []}") == Lines{"1:10 AX4020"});
  CHECK(found("{}") == Lines{"1:1 AX4020"});
}

TEST_CASE("a known key is suggested for an unknown one") {
  Checked const checked(
      {{"m.json", "{\"axes\": [{\"name\": \"X\", \"lists\": \"x.lis\", \"list\": \"x.lis\"}]}"},
       {"x.lis", "# X\n"}},
      "m.json");
  REQUIRE(checked.result.findings.size() == 1);
  Finding const& finding = checked.result.findings.front();
  CHECK(finding.help.size() == 1);
  REQUIRE(finding.fix);
  CHECK(finding.fix->edits[0].text == "\"list\"");
}

TEST_CASE("names that dangle or repeat") {
  std::string const axes = "\"axes\": [{\"name\": \"X\", \"list\": \"x.lis\"}]";
  CHECK(found("{" + axes + ",\n\"groups\": [{\"axes\": [\"X\", \"Y\"]}]}") == Lines{"2:27 AX4020"});
  CHECK(found("{" + axes + ",\n\"gantries\": [{\"master\": \"Y\", \"slaves\": [\"X\"]}]}") ==
        Lines{"2:25 AX4020"});
  CHECK(found("{" + axes + ",\n\"gantries\": [{\"slaves\": [\"X\"]}]}") == Lines{"2:14 AX4020"});
}

TEST_CASE("names that may occur once") {
  std::string const axes =
      "{\"axes\": [{\"name\": \"X\", \"list\": \"x.lis\"}, {\"name\": \"Y\", \"list\": \"x.lis\"}, "
      "{\"name\": \"Z\", \"list\": \"x.lis\"}], \"cycle_time_us\": 1000,\n";
  auto const mistakes = [&](std::string const& member) {
    Lines lines;
    for (auto const& line : found(axes + member + "}")) {
      if (line.find("AX4020") != std::string::npos) lines.push_back(line);
    }
    return lines;
  };
  CHECK(mistakes(R"("groups": [{"name": "a", "axes": ["X", "Y"]}, {"name": "b", "axes": ["Z"]}])").empty());
  CHECK(mistakes(R"("groups": [{"name": "a", "axes": ["X"]}, {"name": "a", "axes": ["Z"]}])") ==
        Lines{"2:51 AX4020"});
  CHECK(mistakes(R"("groups": [{"axes": ["X", "Y"]}, {"axes": ["Z", "X"]}])") == Lines{"2:49 AX4020"});
  CHECK(mistakes(R"("groups": [{"axes": ["X", "Y", "X"]}])") == Lines{"2:32 AX4020"});
  CHECK(mistakes(R"("gantries": [{"master": "X", "slaves": ["Y", "Z"]}])").empty());
  CHECK(mistakes(R"("gantries": [{"master": "X", "slaves": ["Y", "Y"]}])") == Lines{"2:46 AX4020"});
  CHECK(mistakes(R"("gantries": [{"master": "X", "slaves": ["Y"]}, {"master": "Z", "slaves": ["Y"]}])") ==
        Lines{"2:75 AX4020"});
  CHECK(mistakes(R"("gantries": [{"master": "X", "slaves": ["X"]}])") == Lines{"2:41 AX4020"});
  CHECK(mistakes(R"("gantries": [{"master": "X", "slaves": ["Y"]}, {"master": "Y", "slaves": ["X"]}])") ==
        Lines{"2:75 AX4020"});
}

TEST_CASE("a file that cannot be read is reported where it is named") {
  std::string const machine = "{\"axes\": [{\"name\": \"X\", \"list\": \"x.lis\"}]}";
  SECTION("missing") {
    Checked const checked({{"m.json", machine}}, "m.json");
    CHECK(checked.found() == Lines{"1:33 AX4020"});
    CHECK_FALSE(checked.result.machine.has_value());
  }
  SECTION("binary") {
    Checked const checked({{"m.json", machine}, {"x.lis", std::string(200, '\x01')}}, "m.json");
    CHECK(checked.found() == Lines{"1:33 AX4020"});
  }
  SECTION("without its default list the control's own defaults count") {
    std::string const with_default =
        "{\"default_list\": \"d.lis\", \"axes\": [{\"name\": \"X\", \"list\": \"x.lis\"}], "
        "\"cycle_time_us\": 1000}";
    Checked const checked(
        {{"m.json", with_default},
         {"x.lis", "filter[0].enable 1\nfilter[0].order 2\nfilter[0].fg_f0 900\nfilter[0].oder 1\n"}},
        "m.json");
    // 900 Hz is more than half of 1 kHz.
    CHECK(checked.found() == Lines{"1:18 AX4020", "x.lis:3:17 AX3002", "x.lis:4:1 AX2001"});
    CHECK_THAT(render(checked.result.findings[0].notes.at(0), Language::english),
               Catch::Matchers::Contains("the control's own defaults count"));
    CHECK_FALSE(checked.result.machine.has_value());
  }
}

TEST_CASE("machine files do not name one another") {
  std::string const other = R"({"axes": [{"name": "Y", "list": "x.lis"}]})";
  for (std::string const& member :
       {std::string(R"("default_list": "m.json")"), std::string(R"("programs": ["other.json"])"),
        std::string(R"("groups": [{"axes": ["X"], "programs": ["other.json"]}])"),
        std::string(R"("gantries": [], "default_list": "./other.json")")}) {
    Checked const checked({{"m.json", R"({"axes": [{"name": "X", "list": "x.lis"}], )" + member + "}"},
                           {"other.json", other},
                           {"x.lis", "# X\n"}},
                          "m.json");
    INFO(member);
    REQUIRE(checked.result.findings.size() == 1);
    CHECK(checked.result.findings[0].code == Code{4020});
    CHECK_FALSE(checked.result.machine.has_value());
  }
  Checked const as_list({{"m.json", R"({"axes": [{"name": "X", "list": "other.json"}]})"},
                         {"other.json", other},
                         {"x.lis", "# X\n"}},
                        "m.json");
  CHECK(as_list.found() == Lines{"1:33 AX4020"});
}

TEST_CASE("names are visible, filter sets are few") {
  CHECK(with_key(R"("machine": "a\u001bb")") == Lines{"2:12 AX4020"});
  CHECK(with_key(R"("machine": "Fräse ²")").empty());
  std::string sets = R"("#FILTER ON [ORDER=20]")";
  for (int i = 1; i < 1000; ++i) sets += R"(, "#FILTER ON [ORDER=20]")";
  CHECK(with_key("\"filter_sets\": [" + sets + "]").size() != 1);
  CHECK(with_key("\"filter_sets\": [" + sets + R"(, "#FILTER ON [ORDER=21]"])").front() == "2:16 AX4020");
}

TEST_CASE("the input itself may be unreadable") {
  CHECK(Checked({}, "x.lis").result.unreadable == configuration::FileError::not_found);
  CHECK(Checked({{"x.lis", "\xFF\xFEk\0o\0"}}, "x.lis").result.unreadable == configuration::FileError::utf16);
  CHECK(Checked({{"x.lis", std::string("AXIM\0\1", 6)}}, "x.lis").result.unreadable ==
        configuration::FileError::image);
  CHECK(Checked({{"x.lis", std::string(100, '\0')}}, "x.lis").result.unreadable ==
        configuration::FileError::binary);
  CHECK(Checked({{"x.lis", std::string((1U << 20U) + 1, 'x')}}, "x.lis").result.unreadable ==
        configuration::FileError::line_too_long);
  CHECK_FALSE(Checked({{"x.lis", "kopf.achs_nr \x01\n"}}, "x.lis").result.unreadable.has_value());
}

TEST_CASE("a file in JSON is a machine file, another one a list") {
  CHECK(configuration::looks_like_machine_file("\xEF\xBB\xBF \n{\"axes\": []}"));
  CHECK(configuration::looks_like_machine_file("\"axes\": []"));
  CHECK_FALSE(configuration::looks_like_machine_file("kopf.achs_nr 1\n"));
  CHECK_FALSE(configuration::looks_like_machine_file(""));
}

TEST_CASE("a bus in the place of a drive is told the drives that it has") {
  for (std::string const word : {"EtherCAT", "ethercat"}) {
    Checked const checked(
        {{"m.json", R"({"axes": [{"name": "X", "list": "x.lis", "drive": ")" + word + "\"}]}"},
         {"x.lis", "# X\n"}},
        "m.json");
    REQUIRE(checked.result.findings.size() == 1);
    REQUIRE(checked.result.findings.front().help.size() == 1);
    CHECK(render(checked.result.findings.front().help[0], Language::english).find("CoE") !=
          std::string::npos);
  }
}

TEST_CASE("what is wrong in a machine file has a remedy") {
  auto const finding = [](std::string const& machine) {
    return Checked({{"m.json", machine}, {"x.lis", "kopf.achs_nr 1\n"}}, "m.json").result.findings.at(0);
  };
  std::string const axes = "\"axes\": [{\"name\": \"X\", \"list\": \"x.lis\"}]";
  auto const number = [&](std::string const& text) {
    auto const fix = finding("{" + axes + ", \"cycle_time_us\": " + text + "}").fix;
    return fix ? fix->edits.at(0).text : "";
  };
  CHECK(number("\"1ms\"") == "1000");
  CHECK(number("\"2 ms\"") == "2000");
  CHECK(number("\"0.001s\"") == "1000");
  CHECK(number("\"500µs\"") == "500");
  CHECK(number("\"1000\"") == "1000");
  CHECK(number("\"1 h\"").empty());
  CHECK(number("\"5s\"").empty());
  Finding const unknown = finding("{" + axes + ", \"groups\": [{\"axes\": [\"Z\"]}]}");
  CHECK(render(unknown.notes.at(0), Language::english) == "its axes: X");
  Finding const list = finding("{\"axes\": [{\"name\": \"X\", \"list\": \"./xx.lis\"}]}");
  CHECK(render(list.help.at(0), Language::english) == "did you mean \"./x.lis\"?");
  CHECK_FALSE(list.fix);
}

TEST_CASE("a machine file from Windows names the same lists everywhere") {
  CHECK(Checked({{"m.json", R"({"axes": [{"name": "X", "list": "sub\\x.lis"}], "cycle_time_us": 1000})"},
                 {"sub/x.lis", "kopf.achs_nr 1\n"}},
                "m.json")
            .found()
            .empty());
}
