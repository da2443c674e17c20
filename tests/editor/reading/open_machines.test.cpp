// The cost of many open documents, counted in machines that are read, and the documents that a change
// affects.
#include "editor/reading/open_machines.hpp"

#include "editor/capabilities/folding.hpp"
#include "editor/capabilities/hover.hpp"
#include "editor/server.hpp"
#include "support/catch.hpp"
#include "support/map_files.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace {

using namespace axisc;
using Json = nlohmann::json;

/// A server whose client tells it one thing after the other.
class Desk {
 public:
  explicit Desk(std::map<std::string, std::string> disk)
      : disk_(std::move(disk)), server_({.disk = disk_, .options = [this](std::string const&) {
                                           ++read;
                                           validator::CheckOptions options;
                                           options.cycle_time = design::CycleTime{1'000'000};
                                           return options;
                                         }}) {
    tell({{"id", 1}, {"method", "initialize"}, {"params", Json::object()}});
  }

  void open(std::string const& path, std::string const& text) {
    tell({{"method", "textDocument/didOpen"},
          {"params", {{"textDocument", {{"uri", "file://" + path}, {"version", 1}, {"text", text}}}}}});
  }
  void close(std::string const& path) {
    tell({{"method", "textDocument/didClose"}, {"params", {{"textDocument", {{"uri", "file://" + path}}}}}});
  }
  /// The codes that the client shows of a document.
  std::vector<std::string> const& shown(std::string const& path) { return shown_["file://" + path]; }

  std::size_t read = 0;  ///< machines, and lists that stand for one

 private:
  void tell(Json message) {
    message["jsonrpc"] = "2.0";
    static_cast<void>(server_.receive(message.dump()));
    for (auto const& answer : server_.publish()) {
      auto const params = Json::parse(answer)["params"];
      auto& codes = shown_[params["uri"].get<std::string>()];
      codes.clear();
      for (auto const& finding : params["diagnostics"]) codes.push_back(finding["code"].get<std::string>());
    }
  }

  tests::MapFiles disk_;
  editor::Server server_;
  std::map<std::string, std::vector<std::string>> shown_;
};

std::size_t read_for(std::size_t documents) {
  Desk desk({});
  auto const path = [](std::size_t i) { return "/lists/d" + std::to_string(i) + ".lis"; };
  for (std::size_t i = 0; i < documents; ++i) desk.open(path(i), "kopx.achs_nr 1\n");
  for (std::size_t i = 0; i < documents; ++i)
    CHECK(desk.shown(path(i)) == std::vector<std::string>{"AX2001"});
  for (std::size_t i = 0; i < documents; ++i) desk.close(path(i));
  return desk.read;
}

}  // namespace

TEST_CASE("each list that is opened and closed is read as often as if it were alone") {
  auto const few = read_for(20);
  CHECK(read_for(40) == 2 * few);
}

TEST_CASE("a list that a machine misses concerns the machine") {
  std::string const machine =
      R"({"cycle_time_us": 1000, "default_list": "default.lis", "axes": [{"name": "X", "list": "x.lis"}]})";
  Desk desk({{"/m/machine.json", machine}, {"/m/x.lis", "kopf.achs_nr 1\n"}});
  auto const misses = [&desk] {
    auto const& codes = desk.shown("/m/machine.json");
    return std::find(codes.begin(), codes.end(), "AX4020") != codes.end();
  };
  desk.open("/m/machine.json", machine);
  desk.open("/m/x.lis", "kopf.achs_nr 1\n");
  CHECK(misses());
  desk.open("/m/default.lis", "kopf.achs_nr 0\n");
  CHECK_FALSE(misses());
  desk.open("/m/other.lis", "kopf.achs_nr 1\n");
  CHECK_FALSE(misses());
  desk.close("/m/other.lis");
  CHECK_FALSE(misses());
  desk.close("/m/default.lis");
  CHECK(misses());
}

TEST_CASE("open machines tell which documents a change affects") {
  std::string const machine =
      R"({"cycle_time_us": 1000, "default_list": "all.lis", "axes": [{"name": "X", "list": "x.lis"}]})";
  tests::MapFiles disk({{"/m/machine.json", machine}, {"/m/all.lis", "kopf.achs_nr 0\n"}});
  editor::OpenMachines machines(
      disk, [](std::string const&) { return validator::CheckOptions{}; }, Language::english);
  using Uris = editor::OpenMachines::Uris;
  auto const open = [&](std::string const& name, std::string const& text) {
    return machines.open({.uri = "file://" + name, .path = name, .text = text});
  };
  CHECK(open("/m/all.lis", "kopf.achs_nr 0\n") == Uris{"file:///m/all.lis"});
  CHECK(machines.machine_of(machines.document("file:///m/all.lis")) == "/m/machine.json");
  CHECK(open("/other/y.lis", "") == Uris{"file:///other/y.lis"});
  CHECK(machines.machine_of(machines.document("file:///other/y.lis")) == "/other/y.lis");
  auto const& other = machines.document("file:///other/y.lis");
  CHECK(machines.replace(other, "kopf.achs_nr 1\n", 2) == Uris{"file:///other/y.lis"});
  CHECK(other.text == "kopf.achs_nr 1\n");
  Uris const all = {"file:///m/all.lis", "file:///other/y.lis", "file:///m/machine.json"};
  CHECK(open("/m/machine.json", machine) == all);
  CHECK(machines.replace(machines.document("file:///m/machine.json"), "{}", 2) == all);
  CHECK(machines.close("file:///other/y.lis").empty());
  CHECK(machines.forget() == Uris{"file:///m/all.lis", "file:///m/machine.json"});
  CHECK_THROWS_AS(machines.document("file:///other/y.lis"), std::out_of_range);
}

TEST_CASE("a capability answers without a server") {
  tests::MapFiles disk({});
  editor::OpenMachines machines(
      disk, [](std::string const&) { return validator::CheckOptions{}; }, Language::german);
  CHECK(
      machines.open({.uri = "file:///x.lis", .path = "/x.lis", .text = "# a\nfilter[0].order 2\n"}).size() ==
      1);
  Json const document = {{"uri", "file:///x.lis"}};
  CHECK(editor::fold(machines, {{"textDocument", document}}) ==
        Json::array({{{"startLine", 0}, {"endLine", 1}, {"kind", "region"}}}));
  auto const shown =
      editor::hover(machines, {{"textDocument", document}, {"position", {{"line", 1U}, {"character", 1U}}}});
  CHECK(shown["contents"]["value"].get<std::string>().find("Ordnung") != std::string::npos);
  CHECK_THROWS_AS(editor::hover(machines, {{"textDocument", {{"uri", "file:///y.lis"}}}}), std::out_of_range);
  CHECK_THROWS_AS(editor::hover(machines, Json::object()), Json::exception);
}
