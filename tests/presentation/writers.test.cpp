#include "presentation/writers.hpp"

#include "presentation/example_document.hpp"
#include "presentation/text_layout.hpp"
#include "support/catch.hpp"
#include "support/golden.hpp"

#include <sstream>

#include <nlohmann/json.hpp>

using namespace axisc;
using namespace axisc::presentation;

namespace {

std::string written(Format format, Language language = Language::english, std::size_t width = 80) {
  return write(test::example_document(), format, {.language = language, .width = width});
}

}  // namespace

TEST_CASE("a document is written in every format and both languages") {
  for (auto const& [format, name] : {std::pair(Format::text, "text"),
                                     {Format::json, "json"},
                                     {Format::csv, "csv"},
                                     {Format::markdown, "md"},
                                     {Format::html, "html"}}) {
    for (auto const& [language, code] : {std::pair(Language::english, "en"), {Language::german, "de"}}) {
      test::check_golden(std::string("tests/presentation/data/example.") + code + "." + name,
                         written(format, language));
    }
  }
}

TEST_CASE("JSON has the values as they were computed, in every language") {
  auto json = nlohmann::json::parse(written(Format::json, Language::german));
  auto english = nlohmann::json::parse(written(Format::json));
  CHECK(english["filter"] == "low-pass");
  english["filter"] = "Tiefpass";
  // Sentences are in the reader's language.
  for (auto& filter : json["chain"]["filters"]) filter["remark"] = english["chain"]["filters"][0]["remark"];
  json["chain"]["page"] = english["chain"]["page"];
  CHECK(json == english);
  CHECK(json["version"] == 2);
  CHECK(json["axes"][0] == "X");
  CHECK(json["type"] == "R");
  CHECK(json["synchronous"] == false);
  CHECK(json["groups"][0]["group"] == "K1");
  CHECK(json["groups"][0]["table"][0]["axis_error_um"]["X"] == 191.58149999);
  CHECK(json["groups"][0]["table"][1]["axis_error_um"]["X"].is_null());
  CHECK(json["groups"][0]["table"][1]["axis_error_um"].size() == 2);
  CHECK(json["gantries"].is_array());
  CHECK(json["chain"]["filters"][1]["zeros_hz"].size() == 8);
  CHECK(json["chain"]["filters"][1]["unused"].is_null());
  CHECK(json["chain"]["filters"][1]["sections"][0]["a1"] == -0.5);
  CHECK(json["remaining_vibration"] == 0.2468);
  CHECK(json["readings"][0] == nlohmann::json{"a", "b"});
  CHECK(json["readings"][1].empty());
  CHECK(json["largest"]["X"] == 12.345);
  CHECK(json["largest"].size() == 2);
  CHECK(json["first"]["cycle"] == 3);
}

TEST_CASE("CSV begins with what tells the sections apart, and every row has all columns") {
  std::istringstream lines(written(Format::csv));
  std::string header;
  std::getline(lines, header);
  CHECK(header.starts_with("group,feed_mm_per_min,contour,axis_error_um.X,"));
  std::string first;
  std::getline(lines, first);
  CHECK(first == "K1,4000,corner,191.58149999,-0.0004");
}

TEST_CASE("CSV has sections of an array as rows, and a table that only people see elsewhere") {
  auto document = test::example_document();
  Sections rules{.key = "rules", .items = {}};
  for (std::string const code : {"AX1001", "AX1002"}) {
    rules.items.push_back({.key = {},
                           .title = as_given(code),
                           .blocks = {Facts{{data("page", code + ", a page"), shown(as_given("x"), 1)}},
                                      data_section("limit", {data("open", true)})},
                           .identity = {data("code", code)}});
  }
  document.blocks.emplace_back(std::move(rules));
  Table people{.key = "people", .columns = {}, .rows = {}, .audience = Audience::people};
  add_row(people, {{"axis", as_given("axis"), "X"}});
  document.blocks.emplace_back(std::move(people));
  auto const csv = [&](std::string table) {
    document.csv_table = std::move(table);
    return write(document, Format::csv, {.language = Language::english});
  };
  CHECK(csv("rules") ==
        "code,page,limit.open\nAX1001,\"AX1001, a page\",true\nAX1002,\"AX1002, a page\",true\n");
  CHECK(csv("people") == "axis\nX\n");
}

TEST_CASE("JSON without a version is a file of another kind") {
  Document const file{.version = 0, .title = as_given("x"), .blocks = {Facts{{data("machine", "m")}}}};
  CHECK(write(file, Format::json, {.language = Language::english}) == "{\n  \"machine\": \"m\"\n}\n");
}

TEST_CASE("names stay readable in Markdown") {
  Facts const facts{{{"a", as_given("a"), "filter[0].fg_f0"}, {"b", as_given("b"), "_x_ [y](z)"}}};
  Document const names{.version = 1, .title = as_given("x"), .blocks = {facts}};
  CHECK(write(names, Format::markdown, {.language = Language::english}) ==
        "# x\n\n- a: filter[0].fg_f0\n- b: \\_x\\_ [y\\](z)\n");
}

TEST_CASE("text fits the width") {
  for (std::size_t const width : {64U, 80U, 120U}) {
    for (auto const language : {Language::english, Language::german}) {
      std::istringstream lines(written(Format::text, language, width));
      for (std::string line; std::getline(lines, line);) {
        INFO(line);
        CHECK(display_width(line) <= width);
      }
    }
  }
}

TEST_CASE("a number stays with its unit") {
  CHECK(wrapped("at most 0.1 mm, or 20 %", 12) == "at most\n0.1 mm, or\n20 %\n");
  CHECK(wrapped("in 1 2 3 4", 4) == "in\n1 2\n3 4\n");
}

TEST_CASE("foreign text in code of Markdown needs no escape, and does not end it") {
  static constexpr Sentence form{"write `{form}`, not {form}", "`{form}` schreiben, nicht {form}"};
  Document document{.title = as_given("#SLOPE"), .blocks = {}};
  document.blocks = {Paragraph{Words(form, {{"form", "*a`"}})}};
  auto const text = write(document, Format::markdown, {.language = Language::english});
  CHECK(text.find("write `*a'`, not ") != std::string::npos);
  CHECK(text.starts_with("# #SLOPE\n"));
}

TEST_CASE("foreign text stays text") {
  CHECK(written(Format::text).find('\x1b') == std::string::npos);
  CHECK(written(Format::html).find("<b>") == std::string::npos);
  CHECK(written(Format::markdown).find("\n| 12.5 | \\<b\\>a\\|b\"c,") != std::string::npos);
}
