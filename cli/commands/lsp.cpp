#include "axisc/axisc.h"
#include "axisc/environment/failure.hpp"
#include "cli/commands/commands.hpp"
#include "cli/options/check_options.hpp"
#include "cli/options/command_line.hpp"
#include "diagnostics/utf8.hpp"
#include "editor/framing.hpp"
#include "system/file.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <nlohmann/json.hpp>

namespace axisc::cli::says {

constexpr Sentence no_frame{
    "standard input is not what an editor sends: a message of the language server protocol begins with "
    "Content-Length: BYTES (at most {most}) and an empty line; let the editor start axisc lsp",
    "die Standardeingabe ist nicht, was ein Editor schickt: eine Nachricht des Language-Server-Protokolls "
    "beginnt mit Content-Length: BYTES (höchstens {most}) und einer Leerzeile; axisc lsp vom Editor starten "
    "lassen"};

}  // namespace axisc::cli::says

namespace axisc::cli {

namespace {

using Json = nlohmann::ordered_json;

/// As axisc_message() takes messages. One that is not UTF-8 is no JSON either, and is refused as such.
std::string array_of(std::vector<std::string> const& messages) {
  auto array = Json::array();
  for (auto const& message : messages) {
    array.push_back(valid_utf8_prefix(message) == message.size() ? message : std::string());
  }
  return array.dump();
}

/// "[", the messages on a line each, "]"; or "[]".
std::vector<std::string> elements_of(std::string_view array) {
  std::vector<std::string> elements;
  auto rest = array.substr(std::min(array.size(), array.find('\n') + 1));
  for (auto end = rest.find('\n'); end != std::string_view::npos; end = rest.find('\n')) {
    auto const line = rest.substr(0, end);
    elements.emplace_back(line.substr(0, line.size() - (line.ends_with(',') ? 1 : 0)));
    rest.remove_prefix(end + 1);
  }
  return elements;
}

/// A conversation of axisc.h.
class Conversation {
 public:
  Conversation(CheckingOptions const& given, Language language) {
    Json options = {{"language", language == Language::german ? "de" : "en"}};
    auto const set = [&options](char const* key, std::optional<std::string> const& word) {
      if (word) options[key] = *word;
    };
    set("override_cycle_time", given.cycle_time);
    set("axis_type", given.axis_type);
    set("kind", given.kind);
    set("build", given.build);
    axisc_workspace* opened = nullptr;
    status_ =
        axisc_open(options.dump(-1, ' ', false, Json::error_handler_t::replace).c_str(), nullptr, &opened);
    workspace_.reset(opened);
  }

  /// AXISC_OK while the conversation goes on.
  [[nodiscard]] int status() const { return status_; }
  [[nodiscard]] std::string error() const { return axisc_error(workspace_.get()); }

  /// The messages to send.
  std::vector<std::string> take(std::vector<std::string> const& messages) {
    axisc_bytes replies{};
    status_ = axisc_message(workspace_.get(), array_of(messages).c_str(), &replies);
    std::unique_ptr<axisc_bytes, void (*)(axisc_bytes*)> const owner(&replies, axisc_free);
    return status_ < AXISC_OK ? std::vector<std::string>() : elements_of({replies.data, replies.size});
  }

 private:
  std::unique_ptr<axisc_workspace, void (*)(axisc_workspace*)> workspace_{nullptr, axisc_close};
  int status_ = AXISC_OK;
};

}  // namespace

ExitStatus lsp(Invocation const& invocation) {
  CommandLine command_line("lsp", invocation.language);
  CheckingOptions given;
  declare_control(command_line, given);
  if (command_line.answers(invocation)) return ExitStatus::success;
  auto const opened = system::File::standard_input();
  auto const* const input = std::get_if<system::File>(&opened);
  if (input == nullptr) return ExitStatus::failure;
  constexpr std::size_t block = 65536;
  std::array<char, block> buffer{};
  constexpr std::size_t most_waiting = 1000;
  editor::FrameReader frames;
  std::vector<std::string> waiting;
  Conversation conversation(given, invocation.language);
  for (bool has_input = true; has_input && conversation.status() == AXISC_OK && !frames.is_broken();) {
    auto const got = input->read(buffer);
    auto const* const size = std::get_if<std::size_t>(&got);
    has_input = size != nullptr && *size > 0;
    if (has_input) frames.add({buffer.data(), *size});
    while (auto message = frames.next()) waiting.push_back(std::move(*message));
    // What the client has said meanwhile counts: of several changes only the last is checked, and requests
    // may be cancelled already.
    bool const can_wait = has_input && !frames.is_broken() && waiting.size() < most_waiting;
    if (can_wait && input->is_ready()) continue;
    for (auto const& message : conversation.take(std::exchange(waiting, {}))) {
      invocation.streams.out.write(editor::framed(message));
    }
    invocation.streams.out.flush();
  }
  if (conversation.status() < AXISC_OK) {
    invocation.streams.err.write(conversation.error());
    return ExitStatus::failure;
  }
  if (frames.is_broken()) {
    throw Failure({says::no_frame, {{"most", std::to_string(editor::longest_message)}}});
  }
  return conversation.status() == AXISC_ENDED ? ExitStatus::success : ExitStatus::findings;
}

}  // namespace axisc::cli
