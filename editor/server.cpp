#include "editor/server.hpp"

#include <algorithm>
#include <array>

#include <nlohmann/json.hpp>

namespace axisc::editor {

using Json = nlohmann::json;

Server::Handler Server::find(std::string_view name) {
  struct Method {
    std::string_view name;
    Handler handler;
  };
  static constexpr std::array methods = {
      Method{"initialize", &Server::initialize},
      Method{"initialized", &Server::begin_conversation},
      Method{"shutdown", &Server::shut_down},
      Method{"exit", &Server::exit},
      Method{"$/cancelRequest", &Server::ignore},
      Method{"$/setTrace", &Server::ignore},
      Method{"textDocument/didOpen", &Server::open},
      Method{"textDocument/didChange", &Server::change},
      Method{"textDocument/didClose", &Server::close},
      Method{"textDocument/didSave", &Server::check_all},
      Method{"workspace/didChangeWatchedFiles", &Server::check_all},
      Method{"workspace/didChangeConfiguration", &Server::configure},
      Method{"textDocument/diagnostic", &Server::pull},
      Method{"textDocument/formatting", &Server::format},
      Method{"textDocument/rangeFormatting", &Server::format_range},
      Method{"textDocument/codeAction", &Server::code_actions},
      Method{"textDocument/hover", &Server::hover},
      Method{"textDocument/completion", &Server::complete},
      Method{"completionItem/resolve", &Server::resolve_completion},
      Method{"textDocument/prepareTypeHierarchy", &Server::prepare_hierarchy},
      Method{"typeHierarchy/supertypes", &Server::supertypes},
      Method{"typeHierarchy/subtypes", &Server::subtypes},
      Method{"textDocument/definition", &Server::define},
      Method{"textDocument/references", &Server::refer},
      Method{"textDocument/prepareRename", &Server::refuse_renaming},
      Method{"textDocument/rename", &Server::refuse_renaming},
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
  return found == methods.end() ? nullptr : found->handler;
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
  auto const is_set = [&params](char const* pointer) {
    auto const at = Json::json_pointer(pointer);
    return params.is_object() && params.contains(at) && params[at] == true;
  };
  gives_settings_ = is_set("/capabilities/workspace/configuration");
  registers_settings_ = is_set("/capabilities/workspace/didChangeConfiguration/dynamicRegistration");
  watches_files_ = is_set("/capabilities/workspace/didChangeWatchedFiles/dynamicRegistration");
  auto const lists = [&params](char const* pointer, std::string_view word) {
    auto const at =
        Json::json_pointer(std::string("/capabilities/textDocument/completion/completionItem/") + pointer);
    if (!params.is_object() || !params.contains(at) || !params[at].is_array()) return false;
    return std::find(params[at].begin(), params[at].end(), word) != params[at].end();
  };
  documents_lazily_ = lists("resolveSupport/properties", "documentation");
  markdown_in_completion_ = lists("documentationFormat", "markdown");
  takes_pushed_ = params.is_object() &&
                  params.contains(Json::json_pointer("/capabilities/textDocument/publishDiagnostics"));
  if (params.is_object() && params.contains("initializationOptions")) {
    auto const& options = params["initializationOptions"];
    apply(client_settings(options).value_or(settings_of_section(options)));
  }
  phase_ = Phase::running;
  return {{"serverInfo", {{"name", "axisc"}}}, {"capabilities", capabilities(encoding)}};
}

Json Server::capabilities(std::string const& encoding) const {
  Json names = Json::array();
  for (auto const& command : page_commands()) names.push_back(command.name);
  Json all = {
      {"positionEncoding", encoding},
      {"textDocumentSync", {{"openClose", true}, {"change", 2}, {"save", true}}},
      {"documentFormattingProvider", true},
      {"documentRangeFormattingProvider", true},
      {"hoverProvider", true},
      {"completionProvider", {{"triggerCharacters", {".", "#", "["}}, {"resolveProvider", true}}},
      {"definitionProvider", true},
      {"referencesProvider", true},
      {"renameProvider", {{"prepareProvider", true}}},
      {"typeHierarchyProvider", true},
      {"foldingRangeProvider", true},
      {"inlayHintProvider", true},
      {"semanticTokensProvider", {{"legend", token_legend()}, {"full", true}}},
      {"codeLensProvider", {{"resolveProvider", true}}},
      {"documentLinkProvider", {{"resolveProvider", false}}},
      {"documentSymbolProvider", true},
      {"workspaceSymbolProvider", true},
      {"executeCommandProvider", {{"commands", std::move(names)}}},
      {"codeActionProvider", {{"codeActionKinds", {"quickfix", "refactor.rewrite", "source.fixAll.axisc"}}}}};
  // Clients that both pull and receive pushes show findings twice.
  if (!takes_pushed_) {
    all["diagnosticProvider"] = {{"interFileDependencies", true}, {"workspaceDiagnostics", false}};
  }
  return all;
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
