#include "configuration/json_nesting.hpp"
#include "configuration/located_json.hpp"
#include "editor/capabilities/capability_table.hpp"
#include "editor/server.hpp"

#include <array>
#include <exception>
#include <map>
#include <stdexcept>
#include <utility>

#include <nlohmann/json.hpp>

namespace axisc::editor {

namespace {

enum class ErrorCode : int {
  parse_error = -32700,
  invalid_request = -32600,
  method_not_found = -32601,
  invalid_params = -32602,
  internal_error = -32603,
  request_failed = -32803,
  request_cancelled = -32800,
  not_initialized = -32002,
};

std::string error(Json const& id, ErrorCode code, std::string_view reason) {
  return dump(
      {{"jsonrpc", "2.0"}, {"id", id}, {"error", {{"code", static_cast<int>(code)}, {"message", reason}}}});
}

struct Received {
  Json message;
  bool is_too_deep = false;  ///< copying or writing it recursively could exhaust the stack
};

Received received(std::string_view text) {
  return {.message = Json::parse(text, nullptr, false),
          .is_too_deep = configuration::json_nesting(text) > configuration::deepest_json};
}

std::string refusal_of_deep(Json const& message) {
  bool const is_request = message.is_object() && message.contains("method") && message.contains("id") &&
                          !message["id"].is_structured();
  return error(
      is_request ? message["id"] : Json(), ErrorCode::invalid_request,
      "the message is nested deeper than " + std::to_string(configuration::deepest_json) + " levels");
}

/// The index of the last cancellation of each request, by its id.
std::map<std::string, std::size_t> cancellations(std::vector<Received> const& messages) {
  static Json::json_pointer const id("/params/id");
  std::map<std::string, std::size_t> found;
  for (std::size_t i = 0; i < messages.size(); ++i) {
    auto const& message = messages[i].message;
    if (messages[i].is_too_deep || !message.is_object() ||
        message.value("method", Json()) != "$/cancelRequest")
      continue;
    if (message.contains(id)) found[dump(message[id])] = i;
  }
  return found;
}

}  // namespace

std::string error_message(std::string_view sentence) {
  constexpr int error = 1;
  return dump({{"jsonrpc", "2.0"},
               {"method", "window/showMessage"},
               {"params", {{"type", error}, {"message", sentence}}}});
}

std::vector<std::string> Server::receive(std::string_view message) {
  std::array const one = {std::string(message)};
  return receive(one);
}

std::vector<std::string> Server::receive(std::span<std::string const> messages) {
  std::vector<Received> parsed;
  parsed.reserve(messages.size());
  for (auto const& message : messages) parsed.push_back(received(message));
  std::vector<std::string> answers;
  auto const cancelled = cancellations(parsed);
  auto const is_cancelled = [&](std::size_t at) {
    auto const& request = parsed[at].message;
    if (cancelled.empty() || !request.is_object() || !request.contains("id")) return false;
    auto const found = cancelled.find(dump(request["id"]));
    return request.contains("method") && found != cancelled.end() && found->second > at;
  };
  for (std::size_t i = 0; i < parsed.size() && !has_ended(); ++i) {
    auto const& message = parsed[i].message;
    if (parsed[i].is_too_deep) {
      answers.push_back(refusal_of_deep(message));
      continue;
    }
    if (is_cancelled(i)) {
      answers.push_back(error(message["id"], ErrorCode::request_cancelled, "cancelled"));
      continue;
    }
    for (auto& answer : take(message)) answers.push_back(std::move(answer));
  }
  return answers;
}

std::vector<std::string> Server::take(Json const& message) {
  if (message.is_discarded()) return {error(nullptr, ErrorCode::parse_error, "not JSON")};
  if (!message.is_object()) return {error(nullptr, ErrorCode::invalid_request, "not a message")};
  // A response from the client.
  if (!message.contains("method") && (message.contains("result") || message.contains("error"))) {
    if (message.contains("result")) take_answer(message.value("id", Json()), message["result"]);
    return {};
  }
  bool const is_request = message.contains("id");
  auto const id = is_request ? message["id"] : Json();
  if (id.is_structured()) {
    return {error(nullptr, ErrorCode::invalid_request, "the id is not a number or text")};
  }
  if (!message.contains("method") || !message["method"].is_string()) {
    return {error(id, ErrorCode::invalid_request, "no method")};
  }
  auto const name = message["method"].get<std::string>();
  auto const refuse = [&](ErrorCode code, std::string_view reason) {
    return is_request ? std::vector{error(id, code, reason)} : std::vector<std::string>();
  };
  if (phase_ == Phase::before_initialize && name != "initialize" && name != "exit") {
    return refuse(ErrorCode::not_initialized, "initialize comes first");
  }
  bool const is_again = phase_ != Phase::before_initialize && name == "initialize";
  if (is_again || (phase_ == Phase::shut_down && name != "exit")) {
    return refuse(ErrorCode::invalid_request, name + " is not possible now");
  }
  auto const handler = find(name);
  auto const capability = find_capability(name);
  if (handler == nullptr && capability == nullptr) {
    return refuse(ErrorCode::method_not_found, "unknown method " + name);
  }
  try {
    auto const params = message.contains("params") ? message["params"] : Json();
    auto const result = handler != nullptr ? (this->*handler)(params) : capability(machines_, params);
    // Pending messages are flushed before the shutdown reply.
    auto messages = std::exchange(pending_, {});
    if (phase_ == Phase::shut_down) {
      for (auto& pending : publish()) messages.push_back(std::move(pending));
    }
    // The result may be large: it is not copied into another object.
    if (is_request) {
      messages.push_back(R"({"id":)" + dump(id) + R"(,"jsonrpc":"2.0","result":)" + dump(result) + "}");
    }
    return messages;
  } catch (Json::exception const& exception) {
    return refuse(ErrorCode::invalid_params, exception.what());
  } catch (RequestRefused const& reason) {
    return refuse(ErrorCode::request_failed, reason.what());
  } catch (std::invalid_argument const& reason) {
    return refuse(ErrorCode::invalid_params, reason.what());
  } catch (std::out_of_range const&) {
    return refuse(ErrorCode::invalid_params, "the document is not open");
  } catch (std::exception const& exception) {
    return refuse(ErrorCode::internal_error, exception.what());
  }
}

}  // namespace axisc::editor
