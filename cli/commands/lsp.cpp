#include "axisc/environment/failure.hpp"
#include "cli/commands/commands.hpp"
#include "cli/options/check_options.hpp"
#include "cli/options/command_line.hpp"
#include "editor/framing.hpp"
#include "editor/session.hpp"
#include "system/file.hpp"

#include <array>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace axisc::cli::says {

constexpr Sentence no_frame{
    "standard input is not what an editor sends: a message of the language server protocol begins with "
    "Content-Length: BYTES (at most {most}) and an empty line; let the editor start axisc lsp",
    "die Standardeingabe ist nicht, was ein Editor schickt: eine Nachricht des Language-Server-Protokolls "
    "beginnt mit Content-Length: BYTES (höchstens {most}) und einer Leerzeile; axisc lsp vom Editor starten "
    "lassen"};

}  // namespace axisc::cli::says

namespace axisc::cli {

ExitStatus lsp(Invocation const& invocation) {
  CommandLine command_line("lsp", invocation.language);
  CheckingOptions given;
  declare_control(command_line, given);
  if (command_line.answers(invocation)) return ExitStatus::success;
  editor::Session session(check_options(given), invocation.language);
  auto const opened = system::File::standard_input();
  auto const* const input = std::get_if<system::File>(&opened);
  if (input == nullptr) return ExitStatus::failure;
  auto const send = [&](std::vector<std::string> const& messages) {
    for (auto const& message : messages) invocation.streams.out.write(editor::framed(message));
  };
  constexpr std::size_t block = 65536;
  std::array<char, block> buffer{};
  constexpr std::size_t most_waiting = 1000;
  editor::FrameReader frames;
  std::vector<std::string> waiting;
  for (bool has_input = true; has_input && !session.has_ended() && !frames.is_broken();) {
    auto const got = input->read(buffer);
    auto const* const size = std::get_if<std::size_t>(&got);
    has_input = size != nullptr && *size > 0;
    if (has_input) frames.add({buffer.data(), *size});
    while (auto message = frames.next()) waiting.push_back(std::move(*message));
    // What the client has said meanwhile counts: of several changes only the last is checked, and requests
    // may be cancelled already.
    bool const can_wait = has_input && !frames.is_broken() && waiting.size() < most_waiting;
    if (can_wait && input->is_ready()) continue;
    send(session.take(std::exchange(waiting, {})));
    if (!session.has_ended()) send(session.publish());
    invocation.streams.out.flush();
  }
  if (frames.is_broken()) {
    throw Failure({says::no_frame, {{"most", std::to_string(editor::longest_message)}}});
  }
  return session.ended_properly() ? ExitStatus::success : ExitStatus::findings;
}

}  // namespace axisc::cli
