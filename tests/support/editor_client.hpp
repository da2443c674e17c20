// A client of the language server that counts positions by itself.
#pragma once

#include "configuration/files.hpp"
#include "editor/server.hpp"

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <nlohmann/json.hpp>

namespace axisc::test {

using Json = nlohmann::json;

class NoFiles final : public axisc::configuration::Files {
 public:
  std::variant<std::string, axisc::configuration::FileError> read(std::string const& /*path*/) override {
    return axisc::configuration::FileError::not_found;
  }
};

class EditorClient {
 public:
  explicit EditorClient(std::string text) : text_(std::move(text)) {
    tell(R"({"jsonrpc": "2.0", "id": 1, "method": "initialize",
             "params": {"capabilities": {"general": {"positionEncodings": ["utf-16"]}}}})");
    tell(Json{{"jsonrpc", "2.0"},
              {"method", "textDocument/didOpen"},
              {"params", {{"textDocument", {{"uri", uri}, {"version", 0}, {"text", text_}}}}}}
             .dump());
  }

  [[nodiscard]] std::string const& text() const { return text_; }

  /// Replaces a piece of the text; positions are found by counting in this text, independently of the server.
  void edit(std::size_t begin, std::size_t end, std::string const& inserted) {
    Json const range = {{"start", position(begin)}, {"end", position(end)}};
    text_.replace(begin, end - begin, inserted);
    tell(Json{{"jsonrpc", "2.0"},
              {"method", "textDocument/didChange"},
              {"params",
               {{"textDocument", {{"uri", uri}, {"version", ++version_}}},
                {"contentChanges", {{{"range", range}, {"text", inserted}}}}}}}
             .dump());
  }
  /// Any message.
  std::vector<std::string> receive(std::string_view message) { return server_.receive(message); }
  /// What the server shows of the document.
  [[nodiscard]] Json shown() {
    Json found;
    for (auto const& message : server_.publish()) found = Json::parse(message)["params"]["diagnostics"];
    return found;
  }
  [[nodiscard]] Json ask(std::string const& method, Json params) {
    params["textDocument"]["uri"] = uri;
    auto const answers = server_.receive(
        Json{{"jsonrpc", "2.0"}, {"id", 2}, {"method", method}, {"params", std::move(params)}}.dump());
    return Json::parse(answers.at(0));
  }

 private:
  static constexpr auto uri = "file:///x.lis";

  void tell(std::string const& message) { (void)server_.receive(message); }
  [[nodiscard]] Json position(std::size_t offset) const {
    std::size_t line = 0;
    std::size_t units = 0;
    for (std::size_t i = 0; i < offset; ++i) {
      auto const byte = static_cast<unsigned char>(text_[i]);
      bool const ends = byte == '\n' || (byte == '\r' && (i + 1 == text_.size() || text_[i + 1] != '\n'));
      if (ends) {
        ++line;
        units = 0;
      } else if (byte == '\r') {
        continue;  // of CR LF
      } else if ((byte & 0xC0U) != 0x80U) {
        units += byte >= 0xF0 ? 2 : 1;
      }
    }
    return {{"line", line}, {"character", units}};
  }

  NoFiles files_;
  axisc::editor::Server server_{
      {.disk = files_, .options = [](std::string const&) { return axisc::validator::CheckOptions{}; }}};
  std::string text_;
  int version_ = 0;
};

/// What is typed and pasted.
inline constexpr std::array pieces = {"filter[0].type LOWPASS\n",
                                      "filter[1].fg_f0 42 ( Hz\n",
                                      "\xC3\xA4",
                                      "\xF0\x9F\x98\x80",
                                      "\r\n",
                                      "\n",
                                      "\r",
                                      " ",
                                      "0",
                                      "[",
                                      "# \xC3\xBC\n",
                                      "kopf.achs_nr 3\n",
                                      "filter[0].fg_f0 ",
                                      "1e9",
                                      "\"",
                                      "Ende\n",
                                      "\t",
                                      "P-AXIS-00212",
                                      ""};

/// No cut inside a character or between CR and LF: no editor makes one.
inline std::size_t boundary(std::string const& text, std::size_t at) {
  auto const is_inside = [&] {
    return at < text.size() && (((static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U) ||
                                (at > 0 && text[at - 1] == '\r' && text[at] == '\n'));
  };
  while (is_inside()) ++at;
  return at;
}

}  // namespace axisc::test
