#include "editor/server.hpp"

#include "editor/uri.hpp"
#include "validator/list_layout.hpp"

#include <algorithm>
#include <array>
#include <limits>
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
  not_initialized = -32002,
};

std::string dump(Json const& message) {
  return message.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string error(Json const& id, ErrorCode code, std::string_view reason) {
  return dump(
      {{"jsonrpc", "2.0"}, {"id", id}, {"error", {{"code", static_cast<int>(code)}, {"message", reason}}}});
}

TextPosition position(Json const& json) {
  return {.line = json.at("line").get<std::size_t>(), .character = json.at("character").get<std::size_t>()};
}

}  // namespace

struct Server::Method {
  std::string_view name;
  Json (Server::*handler)(Json const&);
};

Server::Method const* Server::find(std::string_view name) {
  static constexpr std::array<Method, 13> methods = {{{"initialize", &Server::initialize},
                                                      {"initialized", &Server::ignore},
                                                      {"shutdown", &Server::shut_down},
                                                      {"exit", &Server::exit},
                                                      {"$/cancelRequest", &Server::ignore},
                                                      {"$/setTrace", &Server::ignore},
                                                      {"textDocument/didOpen", &Server::open},
                                                      {"textDocument/didChange", &Server::change},
                                                      {"textDocument/didClose", &Server::close},
                                                      {"textDocument/didSave", &Server::check_all},
                                                      {"workspace/didChangeWatchedFiles", &Server::check_all},
                                                      {"textDocument/diagnostic", &Server::pull},
                                                      {"textDocument/formatting", &Server::format}}};
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
    if (!is_request) return {};
    return {dump({{"jsonrpc", "2.0"}, {"id", id}, {"result", result}})};
  } catch (Json::exception const& exception) {
    return refuse(ErrorCode::invalid_params, exception.what());
  } catch (std::out_of_range const&) {
    return refuse(ErrorCode::invalid_params, "the document is not open");
  }
}

std::optional<std::string> Server::text(std::string const& uri) const {
  auto const found = documents_.find(uri);
  return found == documents_.end() ? std::nullopt : std::optional(found->second.text);
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
  phase_ = Phase::running;
  return {{"serverInfo", {{"name", "axisc"}}},
          {"capabilities",
           {{"positionEncoding", encoding},
            {"textDocumentSync", {{"openClose", true}, {"change", 2}, {"save", true}}},
            {"documentFormattingProvider", true},
            {"diagnosticProvider", {{"interFileDependencies", true}, {"workspaceDiagnostics", false}}}}}};
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

Json Server::ignore(Json const& /*params*/) {
  return nullptr;
}

Document& Server::document(Json const& params) {
  return documents_.at(params.at("textDocument").at("uri").get<std::string>());
}

Json Server::open(Json const& params) {
  auto const& item = params.at("textDocument");
  auto const uri = item.at("uri").get<std::string>();
  Document opened{.path = path_of(uri), .text = item.at("text").get<std::string>(), .version = {}};
  if (item.contains("version")) opened.version = item["version"].get<std::int64_t>();
  documents_[uri] = std::move(opened);
  return check_all(params);
}

Json Server::change(Json const& params) {
  auto& changed = document(params);
  auto text = changed.text;
  for (auto const& edit : params.at("contentChanges")) {
    auto const& inserted = edit.at("text").get_ref<std::string const&>();
    if (!edit.contains("range") || edit["range"].is_null()) {
      text = inserted;
      continue;
    }
    auto const begin = offset_of(text, position(edit["range"].at("start")), encoding_);
    auto const end = offset_of(text, position(edit["range"].at("end")), encoding_);
    text.replace(begin, std::max(begin, end) - begin, inserted);
  }
  changed.text = std::move(text);
  auto const& item = params.at("textDocument");
  changed.version.reset();
  if (item.contains("version") && item["version"].is_number()) changed.version = item["version"];
  return check_all(params);
}

Json Server::close(Json const& params) {
  auto const uri = params.at("textDocument").at("uri").get<std::string>();
  if (documents_.erase(uri) == 0) return nullptr;
  check_all(params);
  changed_[uri] = false;
  return nullptr;
}

Json Server::check_all(Json const& /*params*/) {
  for (auto const& [uri, document] : documents_) changed_[uri] = true;
  return nullptr;
}

Json Server::format(Json const& params) {
  auto const& unaligned = document(params);
  auto const options = surroundings_.options(unaligned.path);
  auto aligned = validator::aligned_list(SourceText(unaligned.path, unaligned.text), options.catalogue);
  auto edits = Json::array();
  if (aligned == unaligned.text) return edits;
  constexpr auto last = std::numeric_limits<std::int32_t>::max();
  edits.push_back(
      {{"range", {{"start", {{"line", 0}, {"character", 0}}}, {"end", {{"line", last}, {"character", 0}}}}},
       {"newText", std::move(aligned)}});
  return edits;
}

}  // namespace axisc::editor
