// What many open documents cost, counted in machines that are read, and whom an opened or closed document
// concerns.
#include "editor/reading/edited_text.hpp"
#include "editor/server.hpp"
#include "support/catch.hpp"
#include "support/map_files.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <random>
#include <string>
#include <string_view>
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

TEST_CASE("a text with many edits counts lines as one that is read anew") {
  std::mt19937 random(20240229);
  auto const below = [&random](std::size_t limit) {
    return std::uniform_int_distribution<std::size_t>(0, limit - 1)(random);
  };
  std::array<std::string, 7> const pieces = {"", "\n", "\r", "\r\n", "a", "x\ny\r", "\n\n\r\n"};
  constexpr auto encoding = editor::PositionEncoding::utf8;
  std::string text = "one\r\ntwo\n";
  editor::EditedText edited(text, encoding);
  for (int i = 0; i < 20'000; ++i) {
    auto const begin = below(text.size() + 1);
    auto const end = std::min(text.size(), begin + below(text.size() > 60 ? text.size() + 1 : 4));
    auto const& piece = pieces[below(pieces.size())];
    text.replace(begin, end - begin, piece);
    edited.replace(begin, end, piece);
    for (std::size_t line = 0; line < 12; ++line) {
      editor::TextPosition const position{.line = line, .character = below(5)};
      if (edited.offset(position) != editor::offset_of(text, position, encoding)) FAIL(i << " " << text);
    }
  }
  CHECK(std::move(edited).take() == text);
}
