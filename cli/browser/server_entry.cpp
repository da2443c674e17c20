#include "cli/browser/server_entry.hpp"

#include "axisc/environment/failure_line.hpp"
#include "cli/commands/lsp.hpp"
#include "cli/options/environment.hpp"
#include "system/process.hpp"

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace {

using namespace axisc;
using namespace axisc::cli;

std::unique_ptr<editor::Session> session;
std::string answer;

/// Messages are JSON already.
std::string as_array(std::vector<std::string> const& messages) {
  std::string text = "[";
  for (auto const& message : messages) {
    if (text.size() > 1) text += ',';
    text += message;
  }
  return text + "]";
}

}  // namespace

int axisc_server_begin(char const* arguments_json) {
  auto language = Language::english;
  session.reset();
  try {
    auto const arguments = nlohmann::json::parse(arguments_json).get<std::vector<std::string>>();
    language = choose_language(arguments);
    Streams streams;
    session = editor_session({.arguments = arguments, .language = language, .streams = streams});
    streams.out.flush();
    return session == nullptr ? 1 : 0;
  } catch (...) {
    static_cast<void>(system::write(system::Stream::error, failure_line(language)));
    return 2;
  }
}

char const* axisc_server_take(char const* messages_json) {
  answer = "[]";
  if (session == nullptr || session->has_ended()) return answer.c_str();
  auto messages = session->take(nlohmann::json::parse(messages_json).get<std::vector<std::string>>());
  if (!session->has_ended()) {
    for (auto& message : session->publish()) messages.push_back(std::move(message));
  }
  answer = as_array(messages);
  return answer.c_str();
}
