#include "editor/capabilities/capability_table.hpp"

#include "editor/capabilities/actions.hpp"
#include "editor/capabilities/completion.hpp"
#include "editor/capabilities/diagnostics.hpp"
#include "editor/capabilities/folding.hpp"
#include "editor/capabilities/formatting.hpp"
#include "editor/capabilities/hierarchy.hpp"
#include "editor/capabilities/hints.hpp"
#include "editor/capabilities/hover.hpp"
#include "editor/capabilities/lenses.hpp"
#include "editor/capabilities/navigation.hpp"
#include "editor/capabilities/pages.hpp"
#include "editor/capabilities/symbols.hpp"
#include "editor/capabilities/tokens.hpp"

#include <algorithm>
#include <array>

#include <nlohmann/json.hpp>

namespace axisc::editor {

Capability find_capability(std::string_view method) {
  struct Row {
    std::string_view method;
    Capability capability;
  };
  static constexpr std::array rows = {
      Row{"textDocument/diagnostic", pull},
      Row{"textDocument/hover", hover},
      Row{"textDocument/completion", complete},
      Row{"completionItem/resolve", resolve_completion},
      Row{"textDocument/definition", define},
      Row{"textDocument/references", refer},
      Row{"textDocument/documentLink", links},
      Row{"textDocument/prepareRename", refuse_renaming},
      Row{"textDocument/rename", refuse_renaming},
      Row{"textDocument/prepareTypeHierarchy", prepare_hierarchy},
      Row{"typeHierarchy/supertypes", supertypes},
      Row{"typeHierarchy/subtypes", subtypes},
      Row{"textDocument/documentSymbol", symbols},
      Row{"workspace/symbol", workspace_symbols},
      Row{"textDocument/foldingRange", fold},
      Row{"textDocument/inlayHint", hints},
      Row{"textDocument/semanticTokens/full", tokens},
      Row{"textDocument/codeAction", code_actions},
      Row{"textDocument/formatting", format},
      Row{"textDocument/rangeFormatting", format_range},
      Row{"textDocument/codeLens", lenses},
      Row{"codeLens/resolve", resolve_lens},
      Row{"workspace/executeCommand", execute},
  };
  auto const* const found =
      std::find_if(rows.begin(), rows.end(), [method](Row const& row) { return row.method == method; });
  return found == rows.end() ? nullptr : found->capability;
}

Json announced_capabilities() {
  Json commands = Json::array();
  for (auto const& command : page_commands()) commands.push_back(command.name);
  return {
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
      {"executeCommandProvider", {{"commands", std::move(commands)}}},
      {"codeActionProvider", {{"codeActionKinds", {"quickfix", "refactor.rewrite", "source.fixAll.axisc"}}}}};
}

}  // namespace axisc::editor
