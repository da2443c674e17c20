#include "diagnostics/writers/json_stream.hpp"

#include "support/catch.hpp"

#include <random>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

using namespace axisc;

namespace {

std::string as_the_library_writes(nlohmann::ordered_json const& value) {
  return escape_invisible(value.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
}

}  // namespace

TEST_CASE("invisible characters are escaped, the others are not") {
  CHECK(escape_invisible("{\n  \"a\": \"\u009b\u202e\u200b\x7f€\U000e0041\"\n}") ==
        "{\n  \"a\": \"\\u009b\\u202e\\u200b\\u007f€\\udb40\\udc41\"\n}");
  std::string text;
  JsonStream(text, 0).string("a\u009bb");
  CHECK(text == "\"a\\u009bb\"");
}

TEST_CASE("a stream writes what the library writes") {
  std::string text;
  JsonStream out(text, 0);
  out.begin_object();
  out.member("name", "a \"b\"\n");
  out.member("number", 18446744073709551615U);
  out.key("empty");
  out.begin_array();
  out.end_array();
  out.key("nothing");
  out.begin_object();
  out.end_object();
  out.key("values");
  out.begin_array();
  out.string_or_null("");
  out.boolean(true);
  out.begin_object();
  out.member("deep", "x");
  out.end_object();
  out.string("last");
  out.end_array();
  out.end_object();
  nlohmann::ordered_json const same = {
      {"name", "a \"b\"\n"},
      {"number", 18446744073709551615U},
      {"empty", nlohmann::ordered_json::array()},
      {"nothing", nlohmann::ordered_json::object()},
      {"values", {nullptr, true, {{"deep", "x"}}, "last"}},
  };
  CHECK(text == as_the_library_writes(same));
}

TEST_CASE("deep values stand behind many blanks") {
  std::string text;
  JsonStream out(text, 0);
  nlohmann::ordered_json same = "x";
  for (int depth = 0; depth < 20; ++depth) {
    out.begin_array();
    same = nlohmann::ordered_json::array({same});
  }
  out.string("x");
  for (int depth = 0; depth < 20; ++depth) out.end_array();
  CHECK(text == as_the_library_writes(same));
}

TEST_CASE("characters of every size stay what they are") {
  std::mt19937 random(7);
  std::vector<std::string> const pieces = {"ü", "€",  "😀",    "\x7F", "\xED\xA0\x80",
                                           "a", "\"", "\x1F", "\xC3", "\n"};
  for (int round = 0; round < 2000; ++round) {
    std::string bytes;
    for (std::size_t size = random() % 4; size > 0; --size) bytes += pieces[random() % pieces.size()];
    std::string text;
    JsonStream(text, 0).string(bytes);
    REQUIRE(text == as_the_library_writes(bytes));
  }
}

TEST_CASE("any bytes become the string that the library makes of them") {
  std::mt19937 random(3);
  for (int round = 0; round < 5000; ++round) {
    std::string bytes;
    for (std::size_t size = random() % 12; size > 0; --size) {
      // Every second one from where the lead and continuation bytes are.
      bytes += static_cast<char>(random() % 2 == 0 ? random() % 128 : 0x80 + random() % 128);
    }
    std::string text;
    JsonStream(text, 0).string(bytes);
    REQUIRE(text == as_the_library_writes(bytes));
  }
}
