// The language server: anything on its input, and edits in any order.
#include "editor/framing.hpp"
#include "support/editor_client.hpp"

#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace {

using namespace axisc::test;

/// Bytes in pieces of any size; whatever comes out of the frames goes to a server.
void read_frames(std::string_view bytes) {
  if (bytes.empty()) return;
  NoFiles files;
  axisc::editor::Server server(
      {.disk = files,
       .options = [](std::string const&) { return axisc::validator::CheckOptions{}; },
       .configure = [](axisc::editor::ClientSettings const&) { return axisc::Language::german; }});
  std::size_t const piece = static_cast<unsigned char>(bytes.front()) + 1U;
  bytes.remove_prefix(1);
  axisc::editor::FrameReader frames;
  while (!bytes.empty() && !frames.is_broken()) {
    frames.add(bytes.substr(0, piece));
    bytes.remove_prefix(std::min(piece, bytes.size()));
    std::vector<std::string> waiting;
    while (auto message = frames.next()) waiting.push_back(std::move(*message));
    (void)server.receive(waiting);
    (void)server.publish();
  }
}

/// A message by itself, after the greeting.
void receive(std::string_view message) {
  EditorClient client("filter[0].order 2\n");
  (void)client.receive(message);
  (void)client.shown();
}

/// What looks at the text around a place: each must be answered, whatever the text is.
void ask(EditorClient& client) {
  Json const at = {{"line", 0}, {"character", 3}};
  Json const position = {{"position", at}};
  for (auto const* const method : {"textDocument/hover", "textDocument/completion", "textDocument/definition",
                                   "textDocument/references", "textDocument/documentSymbol"}) {
    if (!client.ask(method, position).contains("result")) std::abort();
  }
  Json const whole = {{"start", {{"line", 0}, {"character", 0}}},
                      {"end", {{"line", 9999}, {"character", 0}}}};
  auto const actions = client.ask("textDocument/codeAction", {{"range", whole}, {"context", Json::object()}});
  if (!actions.contains("result")) std::abort();
  auto const items = client.ask("textDocument/prepareTypeHierarchy", position).at("result");
  for (auto const& item : items) {
    for (auto const* const method : {"typeHierarchy/supertypes", "typeHierarchy/subtypes"}) {
      if (!client.ask(method, {{"item", item}}).at("result").is_array()) std::abort();
    }
  }
}

/// Three bytes an edit: where, how much is replaced, by what.
void edit(std::string_view bytes) {
  EditorClient client("kopf.achs_nr 1\r\nfilter[0].order 2\n");
  constexpr std::size_t longest = 3000;
  for (; bytes.size() >= 3 && client.text().size() < longest; bytes.remove_prefix(3)) {
    auto const number = [&](std::size_t i) {
      return static_cast<std::size_t>(static_cast<unsigned char>(bytes[i]));
    };
    auto const& text = client.text();
    auto const begin = boundary(text, number(0) * text.size() / 255);
    auto const end = boundary(text, std::min(text.size(), begin + number(1) % 16));
    client.edit(begin, end, pieces[number(2) % pieces.size()]);
  }
  EditorClient fresh(client.text());
  if (client.shown() != fresh.shown()) std::abort();
  ask(client);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  std::string_view bytes(reinterpret_cast<char const*>(data), size);
  if (bytes.empty()) return 0;
  auto const way = static_cast<unsigned char>(bytes.front()) % 3U;
  bytes.remove_prefix(1);
  if (way == 0) read_frames(bytes);
  if (way == 1) receive(bytes);
  if (way == 2) edit(bytes);
  return 0;
}
