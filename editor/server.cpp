#include "editor/server.hpp"

#include "editor/capabilities/capability_table.hpp"

#include <algorithm>
#include <array>

#include <nlohmann/json.hpp>

namespace axisc::editor {

namespace {

/// A member of the parameters by its path; null if it is missing.
Json member(Json const& params, std::string const& path) {
  Json::json_pointer const at(path);
  return params.is_object() && params.contains(at) ? params[at] : Json();
}

bool lists(Json const& texts, std::string_view text) {
  return texts.is_array() && std::find(texts.begin(), texts.end(), text) != texts.end();
}

struct EncodingName {
  std::string_view name;
  PositionEncoding encoding;
};

/// The first known encoding that the client offers.
EncodingName chosen_encoding(Json const& offered) {
  static constexpr std::array known = {EncodingName{"utf-16", PositionEncoding::utf16},
                                       EncodingName{"utf-8", PositionEncoding::utf8},
                                       EncodingName{"utf-32", PositionEncoding::utf32}};
  for (auto const& name : offered.is_array() ? offered : Json::array()) {
    for (auto const& each : known) {
      if (name == each.name) return each;
    }
  }
  return known.front();
}

}  // namespace

Server::Handler Server::find(std::string_view method) {
  struct Row {
    std::string_view method;
    Handler handler;
  };
  static constexpr std::array rows = {
      Row{"initialize", &Server::initialize},
      Row{"initialized", &Server::begin_conversation},
      Row{"shutdown", &Server::shut_down},
      Row{"exit", &Server::exit},
      Row{"$/cancelRequest", &Server::ignore},
      Row{"$/setTrace", &Server::ignore},
      Row{"textDocument/didOpen", &Server::open},
      Row{"textDocument/didChange", &Server::change},
      Row{"textDocument/didClose", &Server::close},
      Row{"textDocument/didSave", &Server::check_all},
      Row{"workspace/didChangeWatchedFiles", &Server::check_all},
      Row{"workspace/didChangeConfiguration", &Server::configure},
  };
  auto const* const found =
      std::find_if(rows.begin(), rows.end(), [method](Row const& row) { return row.method == method; });
  return found == rows.end() ? nullptr : found->handler;
}

Json Server::initialize(Json const& params) {
  auto const encoding = chosen_encoding(member(params, "/capabilities/general/positionEncodings"));
  auto const formats = member(params, "/capabilities/textDocument/hover/contentFormat");
  auto const item = [&](std::string const& path) {
    return member(params, "/capabilities/textDocument/completion/completionItem/" + path);
  };
  auto& client = machines_.client();
  client.encoding = encoding.encoding;
  client.markdown = !formats.is_array() || lists(formats, "markdown");
  client.markdown_in_completion = lists(item("documentationFormat"), "markdown");
  client.documents_lazily = lists(item("resolveSupport/properties"), "documentation");
  auto const is_able = [&](std::string const& path) {
    return member(params, "/capabilities/workspace/" + path) == true;
  };
  gives_settings_ = is_able("configuration");
  registers_settings_ = is_able("didChangeConfiguration/dynamicRegistration");
  watches_files_ = is_able("didChangeWatchedFiles/dynamicRegistration");
  auto const options = member(params, "/initializationOptions");
  apply(client_settings(options).value_or(settings_of_section(options)));
  phase_ = Phase::running;
  auto capabilities = announced_capabilities();
  capabilities["positionEncoding"] = encoding.name;
  capabilities["textDocumentSync"] = {{"openClose", true}, {"change", 2}, {"save", true}};
  // Clients that both pull and receive pushes show findings twice.
  static Json::json_pointer const pushed("/capabilities/textDocument/publishDiagnostics");
  if (!params.is_object() || !params.contains(pushed)) {
    capabilities["diagnosticProvider"] = {{"interFileDependencies", true}, {"workspaceDiagnostics", false}};
  }
  return {{"serverInfo", {{"name", "axisc"}}}, {"capabilities", std::move(capabilities)}};
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

}  // namespace axisc::editor
