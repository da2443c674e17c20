// JSON that is nested without end: whoever writes a file must not end the program.
#include "cli/program.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

namespace deep_json_test {

using namespace axisc::test;

TEST_CASE("JSON that is nested too deep is refused in every file") {
  std::string const deep = std::string(100'000, '[') + std::string(100'000, ']');
  TemporaryFolder const folder;
  folder.write("x.lis", "filter[0].enable 0\n");
  auto const refused = [&](std::vector<std::string> const& words, std::string const& expected) {
    INFO(words.front() << " " << words.back());
    auto const outcome = run_axisc(words, in_folder(folder.path()));
    CHECK(outcome.status > 0);
    CHECK_THAT(outcome.out + outcome.err, Catch::Matchers::Contains(expected));
  };
  std::string const limit = "JSON is read up to 64 nested brackets";
  folder.write("machine.json", R"({"axes": )" + deep + "}");
  refused({"lint", "machine.json"}, limit);
  refused({"lint", "."}, limit);
  folder.write("machine.json", deep);
  refused({"lint", "machine.json"}, limit);
  folder.write("schema.json", R"({"parameters": )" + deep + "}");
  refused({"lint", "x.lis", "--schema", "schema.json"}, limit);
  folder.write("known.json", R"({"version": )" + deep + R"(, "findings": []})");
  refused({"lint", "x.lis", "--baseline", "known.json"}, "\"version\" must be 2");
  folder.write("known.json", R"({"version": 2, "findings": [)" + deep + "]}");
  refused({"lint", "x.lis", "--baseline", "known.json"}, "entry 1");
  folder.write("axisc.json", R"({"paths": )" + deep + "}");
  refused({"lint", "x.lis"}, limit);
}

}  // namespace deep_json_test
