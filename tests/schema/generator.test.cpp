// The generator turns good data into tables and refuses bad data with a line that says what is wrong.
#include "support/catch.hpp"
#include "support/file_contents.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace generator_test {

namespace {

std::filesystem::path working_folder() {
  auto folder = std::filesystem::path(AXISC_BINARY_DIR) / "test_schema_generator";
  std::filesystem::create_directories(folder);
  return folder;
}

bool contains(std::string const& text, std::string const& part) {
  return text.find(part) != std::string::npos;
}

struct Outcome {
  bool accepted = false;
  std::string message;
  std::string tables;
};

/// Describes all parameters that the tests invent.
std::string const any_descriptions =
    R"({"parameters": [], "families": [{"prefix": "", "what": {"en": "e", "de": "d"}}]})";

std::string const no_messages = R"({"messages": []})";
std::string const no_words =
    R"("fillers": [], "units": [], "prepositions": [], "for_messages": [], "faults": [], "degrees": [], "actions": [], "same": [])";
std::string const no_lookup = R"({"topics": [], "synonyms": [], )" + no_words + "}";

Outcome generate(std::string const& data, std::string const& descriptions = any_descriptions,
                 std::string const& messages = no_messages, std::string const& lookup = no_lookup) {
  auto const folder = working_folder();
  std::ofstream(folder / "messages.json", std::ios::binary) << messages;
  std::ofstream(folder / "lookup.json", std::ios::binary) << lookup;
  std::ofstream(folder / "descriptions.json", std::ios::binary) << descriptions;
  std::ofstream(folder / "data.json", std::ios::binary) << data;
  std::filesystem::remove(folder / "tables.inc");
  std::string const quote = "\"";
  std::string const command =
      quote + AXISC_SCHEMA_GENERATOR + "\" \"" + (folder / "data.json").string() + "\" \"" +
      (folder / "descriptions.json").string() + "\" \"" + AXISC_SOURCE_DIR + "/schema/other-lists.json\" \"" +
      (folder / "messages.json").string() + "\" \"" + (folder / "lookup.json").string() + "\" \"" +
      (folder / "tables.inc").string() + "\" \"" + (folder / "vocabulary.inc").string() + "\" \"" +
      (folder / "description_tables.inc").string() + "\" \"" + (folder / "kind_tables.inc").string() +
      "\" \"" + (folder / "lookup_tables.inc").string() + "\" 2> \"" + (folder / "message").string() + quote;
  bool const accepted = std::system(command.c_str()) == 0;  // NOLINT(cert-env33-c,concurrency-mt-unsafe)
  auto const tables = folder / "tables.inc";
  return {accepted, axisc::test::file_contents(folder / "message"),
          std::filesystem::exists(tables) ? axisc::test::file_contents(tables) : std::string()};
}

std::string document(std::string const& rows) {
  return R"({"version": 1, "parameters": [)" + rows + "]}";
}

void refuses(std::string const& data, std::string const& reason) {
  Outcome const outcome = generate(data);
  INFO(data);
  CHECK_FALSE(outcome.accepted);
  CHECK(contains(outcome.message, reason));
  CHECK(outcome.tables.empty());
}

TEST_CASE("good data becomes tables, equal data equal tables") {
  std::string const data =
      document(R"({"id": "P-AXIS-00001", "name": "a[].b", "type": "UNS08", "array": [2], "default": "1"},
    {"name": "a.c", "type": "STRING", "symbols": {"ONE": 1, "TWO": null}, "default": "TWO"},
    {"name": "x", "type": "UNS32", "minimum": 1, "exclusive_maximum": "P-AXIS-00001", "default": "0x10"})");
  Outcome const first = generate(data);
  CHECK(first.message.empty());
  CHECK(first.accepted);
  CHECK(contains(first.tables, "// a[1].b\n"));
  CHECK(contains(first.tables, "{\"TWO\", std::nullopt}"));
  CHECK(generate(data).tables == first.tables);
}

TEST_CASE("what is no JSON") {
  refuses("", "parse error");
  refuses(R"({"version": 1, "parameters": [})", "line 1");
}

TEST_CASE("what contradicts itself") {
  refuses(document(""), "parameters");
  refuses(document(R"({"name": "a"})"), "type");
  refuses(document(R"({"name": "a", "type": "UNS08"}, {"name": "a", "type": "UNS08"})"),
          "a: name appears twice");
  refuses(document(R"({"name": "a[]", "type": "UNS08"})"), "array sizes");
  refuses(document(R"({"name": "a", "type": "UNS08", "array": [2]})"), "array sizes");
  refuses(document(R"({"name": "a", "type": "UNS08", "maximum": "P-AXIS-00002"})"), "names no parameter");
  refuses(document(R"({"name": "a", "type": "UNS08", "minimum": 3, "maximum": 2})"), "above the maximum");
  refuses(document(R"({"name": "a", "type": "STRING", "minimum": 3})"), "limits are for numbers");
  refuses(document(R"({"name": "a", "type": "STRING", "symbols": {"X": 1}, "default": "Y"})"),
          "is not a value");
  refuses(document(R"({"name": "a", "type": "BOOLEAN", "default": "2"})"), "is not a value");
  refuses(document(R"({"name": "a", "type": "BOOLEAN", "symbols": {"TRUE": 1}})"), "TRUE appears twice");
  refuses(document(R"({"name": "a", "type": "UNS08", "default": "-1"})"), "is not a value");
  refuses(document(R"({"name": "a", "type": "UNS08", "default": "1.5"})"), "is not a value");
  refuses(document(R"({"name": "a", "type": "UNS08", "default": "P-AXIS-00009"})"), "names no parameter");
  refuses(document(R"({"name": "a", "type": "UNS08", "symbols": {"X": 1}})"), "symbols are for");
  refuses(document(R"({"name": "a", "type": "UNS08", "max_length": 3})"), "max_length");
}

TEST_CASE("all mistakes are named in one run") {
  Outcome const outcome = generate(
      document(R"({"name": "a[]", "type": "UNS08"}, {"name": "b", "type": "UNS08", "max_length": 3})"));
  CHECK(contains(outcome.message, "a[]: "));
  CHECK(contains(outcome.message, "b: "));
}

TEST_CASE("a description needs a parameter, a parameter a description, both in two languages") {
  auto const described = [](std::string const& parameters) {
    return generate(document(R"({"name": "a", "type": "UNS08"})"),
                    R"({"families": [], "parameters": [)" + parameters + "]}");
  };
  std::string const good = R"({"name": "a", "what": {"en": "e", "de": "d"}})";
  CHECK(described(good).accepted);
  CHECK(contains(described("").message, "a: neither it nor its family is described"));
  CHECK(contains(described(good + "," + good).message, "a: is described twice"));
  CHECK(
      contains(described(R"({"name": "b", "what": {"en": "e", "de": "d"}})").message, "b: there is no such"));
  CHECK(contains(described(R"({"name": "a", "what": {"en": "e"}})").message, "a: a text is missing"));
  CHECK(contains(described(R"({"name": "a"})").message, "descriptions: "));
}

TEST_CASE("messages and topics name what exists, once, in both languages") {
  auto const data = document(R"({"name": "a.b", "type": "UNS08"})");
  auto const messages = [&](std::string const& rows) {
    return generate(data, any_descriptions, R"({"messages": [)" + rows + "]}").message;
  };
  std::string const good = R"({"numbers": [1], "meaning": {"en": "e", "de": "d"}, "parameters": ["a.b"]})";
  CHECK(messages(good).empty());
  CHECK(contains(messages(good + "," + good), "1: this message is there twice"));
  CHECK(contains(messages(R"({"numbers": [1], "meaning": {"en": "e"}})"), "1: a text is missing"));
  CHECK(contains(messages(R"({"numbers": [1], "meaning": {"en": "e", "de": "d"}, "parameters": ["c"]})"),
                 "1: there is no parameter c"));
  auto const synonyms = [&](std::string const& rows) {
    return generate(data, any_descriptions, no_messages,
                    R"({"topics": [], "synonyms": [)" + rows + "], " + no_words + "}")
        .message;
  };
  std::string const words = R"({"of": "a.b", "words": {"en": ["x"], "de": ["x", "y"]}})";
  CHECK(synonyms(words).empty());
  CHECK(contains(synonyms(words + "," + words), "a.b: its words are there twice"));
  CHECK(contains(synonyms(R"({"of": "a.c", "words": {"en": [], "de": []}})"), "a.c: there is no such"));
  CHECK(
      contains(synonyms(R"({"of": "a.b", "words": {"en": ["x", "x"], "de": []}})"), "\"x\" is there twice"));
  auto const groups = [&](std::string const& faults, std::string const& same) {
    return generate(
               data, any_descriptions, no_messages,
               R"({"topics": [], "synonyms": [], "fillers": ["a"], "units": [], "prepositions": [], "for_messages": [],)"
               R"("degrees": [], "actions": [], "faults": [)" +
                   faults + R"(], "same": [)" + same + "]}")
        .message;
  };
  CHECK(groups(R"(["no", "ohne"])", R"(["speed", "velocity"])").empty());
  CHECK(contains(groups(R"(["no", "ohne"])", R"(["speed", "ohne"])"), "same: \"ohne\" is there twice"));
}

}  // namespace

}  // namespace generator_test
