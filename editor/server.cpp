#include "editor/server.hpp"

#include <algorithm>
#include <array>
#include <exception>
#include <stdexcept>

#include <nlohmann/json.hpp>

namespace axisc::editor {

namespace {

using Json = nlohmann::json;

enum class ErrorCode : int {
  parse_error = -32700,
  invalid_request = -32600,
  method_not_found = -32601,
  invalid_params = -32602,
  internal_error = -32603,
  request_failed = -32803,
  not_initialized = -32002,
};

std::string dump(Json const& message) {
  return message.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string error(Json const& id, ErrorCode code, std::string_view reason) {
  return dump(
      {{"jsonrpc", "2.0"}, {"id", id}, {"error", {{"code", static_cast<int>(code)}, {"message", reason}}}});
}

}  // namespace

std::string error_message(std::string_view sentence) {
  constexpr int error = 1;
  return dump({{"jsonrpc", "2.0"},
               {"method", "window/showMessage"},
               {"params", {{"type", error}, {"message", sentence}}}});
}

struct Server::Method {
  std::string_view name;
  Json (Server::*handler)(Json const&);
};

Server::Method const* Server::find(std::string_view name) {
  static constexpr std::array methods = {
      Method{"initialize", &Server::initialize},
      Method{"initialized", &Server::ignore},
      Method{"shutdown", &Server::shut_down},
      Method{"exit", &Server::exit},
      Method{"$/cancelRequest", &Server::ignore},
      Method{"$/setTrace", &Server::ignore},
      Method{"textDocument/didOpen", &Server::open},
      Method{"textDocument/didChange", &Server::change},
      Method{"textDocument/didClose", &Server::close},
      Method{"textDocument/didSave", &Server::check_all},
      Method{"workspace/didChangeWatchedFiles", &Server::check_all},
      Method{"workspace/didChangeConfiguration", &Server::check_all},
      Method{"textDocument/diagnostic", &Server::pull},
      Method{"textDocument/formatting", &Server::format},
      Method{"textDocument/rangeFormatting", &Server::format_range},
      Method{"textDocument/codeAction", &Server::code_actions},
      Method{"textDocument/hover", &Server::hover},
      Method{"textDocument/completion", &Server::complete},
      Method{"textDocument/definition", &Server::define},
      Method{"textDocument/references", &Server::refer},
      Method{"textDocument/rename", &Server::rename},
      Method{"workspace/symbol", &Server::workspace_symbols},
      Method{"textDocument/foldingRange", &Server::fold},
      Method{"textDocument/inlayHint", &Server::hints},
      Method{"textDocument/semanticTokens/full", &Server::tokens},
      Method{"textDocument/codeLens", &Server::lenses},
      Method{"codeLens/resolve", &Server::resolve_lens},
      Method{"workspace/executeCommand", &Server::execute},
      Method{"textDocument/documentLink", &Server::links},
      Method{"textDocument/documentSymbol", &Server::symbols},
  };
  auto const* const found = std::find_if(methods.begin(), methods.end(),
                                         [name](Method const& method) { return method.name == name; });
  return found == methods.end() ? nullptr : found;
}

std::vector<std::string> Server::receive(std::string_view message) {
  auto const json = Json::parse(message, nullptr, false);
  if (json.is_discarded()) return {error(nullptr, ErrorCode::parse_error, "not JSON")};
  if (!json.is_object()) return {error(nullptr, ErrorCode::invalid_request, "not a message")};
  // An answer of the client.
  if (!json.contains("method") && (json.contains("result") || json.contains("error"))) return {};
  bool const is_request = json.contains("id");
  auto const id = is_request ? json["id"] : Json();
  if (id.is_structured()) {
    return {error(nullptr, ErrorCode::invalid_request, "the id is not a number or text")};
  }
  if (!json.contains("method") || !json["method"].is_string()) {
    return {error(id, ErrorCode::invalid_request, "no method")};
  }
  auto const name = json["method"].get<std::string>();
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
  auto const* const method = find(name);
  if (method == nullptr) return refuse(ErrorCode::method_not_found, "unknown method " + name);
  try {
    auto const result = (this->*method->handler)(json.contains("params") ? json["params"] : Json());
    // What is due is said before the farewell.
    auto messages = phase_ == Phase::shut_down ? publish() : std::vector<std::string>();
    // Around the result, which may be large: no copy of it is made.
    if (is_request) {
      messages.push_back(R"({"id":)" + dump(id) + R"(,"jsonrpc":"2.0","result":)" + dump(result) + "}");
    }
    return messages;
  } catch (Json::exception const& exception) {
    return refuse(ErrorCode::invalid_params, exception.what());
  } catch (NoPage const& reason) {
    return refuse(ErrorCode::request_failed, reason.what());
  } catch (std::invalid_argument const& reason) {
    return refuse(ErrorCode::invalid_params, reason.what());
  } catch (std::out_of_range const&) {
    return refuse(ErrorCode::invalid_params, "the document is not open");
  } catch (std::exception const& exception) {
    return refuse(ErrorCode::internal_error, exception.what());
  }
}

Json Server::initialize(Json const& params) {
  std::string encoding = "utf-16";
  auto const path = Json::json_pointer("/capabilities/general/positionEncodings");
  if (params.is_object() && params.contains(path) && params[path].is_array()) {
    for (auto const& offered : params[path]) {
      if (offered == "utf-8") encoding_ = PositionEncoding::utf8;
      if (offered == "utf-32") encoding_ = PositionEncoding::utf32;
      if (offered != "utf-8" && offered != "utf-16" && offered != "utf-32") continue;
      encoding = offered.get<std::string>();
      break;
    }
  }
  auto const formats = Json::json_pointer("/capabilities/textDocument/hover/contentFormat");
  if (params.is_object() && params.contains(formats) && params[formats].is_array()) {
    markdown_ =
        std::find(params[formats].begin(), params[formats].end(), "markdown") != params[formats].end();
  }
  phase_ = Phase::running;
  Json answer = {
      {"serverInfo", {{"name", "axisc"}}},
      {"capabilities",
       {{"positionEncoding", encoding},
        {"textDocumentSync", {{"openClose", true}, {"change", 2}, {"save", true}}},
        {"documentFormattingProvider", true},
        {"documentRangeFormattingProvider", true},
        {"hoverProvider", true},
        {"completionProvider", {{"triggerCharacters", {".", "#", "["}}}},
        {"definitionProvider", true},
        {"referencesProvider", true},
        {"foldingRangeProvider", true},
        {"inlayHintProvider", true},
        {"semanticTokensProvider", {{"legend", token_legend()}, {"full", true}}},
        {"codeLensProvider", {{"resolveProvider", true}}},
        {"documentLinkProvider", {{"resolveProvider", false}}},
        {"documentSymbolProvider", true},
        {"workspaceSymbolProvider", true},
        {"codeActionProvider",
         {{"codeActionKinds", {"quickfix", "refactor.rewrite", "source.fixAll.axisc"}}}},
        {"diagnosticProvider", {{"interFileDependencies", true}, {"workspaceDiagnostics", false}}}}}};
  Json names = Json::array();
  for (auto const& command : surroundings_.pages.commands) names.push_back(command.name);
  answer["capabilities"]["executeCommandProvider"] = {{"commands", std::move(names)}};
  // Who is told and asks as well shows each finding twice.
  auto const takes_pushed = Json::json_pointer("/capabilities/textDocument/publishDiagnostics");
  if (params.is_object() && params.contains(takes_pushed)) answer["capabilities"].erase("diagnosticProvider");
  return answer;
}

Json Server::shut_down(Json const& /*params*/) {
  phase_ = Phase::shut_down;
  was_shut_down_ = true;
  return nullptr;
}

Json Server::exit(Json const& /*params*/) {
  phase_ = Phase::ended;
  return nullptr;
}

// A row of the table holds a member. NOLINTNEXTLINE(readability-convert-member-functions-to-static)
Json Server::ignore(Json const& /*params*/) {
  return nullptr;
}

Document& Server::document(Json const& params) {
  return documents_.at(params.at("textDocument").at("uri").get<std::string>());
}

}  // namespace axisc::editor
