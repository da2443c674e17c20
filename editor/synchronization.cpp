#include "axisc/workspace/uri.hpp"
#include "editor/capabilities/diagnostics.hpp"
#include "editor/reading/edited_text.hpp"
#include "editor/server.hpp"
#include "validator/loading/loader.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include <nlohmann/json.hpp>

namespace axisc::editor {

namespace {

std::optional<std::int64_t> version_of(Json const& item) {
  auto const found = item.find("version");
  if (found == item.end() || !found->is_number_integer()) return std::nullopt;
  return found->get<std::int64_t>();
}

}  // namespace

Json Server::open(Json const& params) {
  auto const& item = params.at("textDocument");
  auto const uri = item.at("uri").get<std::string>();
  // Read completely before anything changes.
  OpenDocument document{.uri = uri,
                        .path = validator::key_of(path_of(uri)),
                        .text = item.at("text").get<std::string>(),
                        .version = version_of(item)};
  closed_.erase(uri);
  changed_.merge(machines_.open(std::move(document)));
  return nullptr;
}

Json Server::change(Json const& params) {
  auto const& asked = machines_.asked(params);
  EditedText text(asked.text, machines_.encoding());
  for (auto const& edit : params.at("contentChanges")) {
    auto const& inserted = edit.at("text").get_ref<std::string const&>();
    if (!edit.contains("range") || edit["range"].is_null()) {
      text = EditedText(inserted, machines_.encoding());
      continue;
    }
    auto const begin = text.offset(position_in(edit["range"].at("start")));
    auto const end = text.offset(position_in(edit["range"].at("end")));
    text.replace(begin, std::max(begin, end), inserted);
  }
  changed_.merge(machines_.replace(asked, std::move(text).take(), version_of(params.at("textDocument"))));
  return nullptr;
}

Json Server::close(Json const& params) {
  auto const uri = params.at("textDocument").at("uri").get<std::string>();
  bool const was_open = machines_.documents().contains(uri);
  changed_.merge(machines_.close(uri));
  changed_.erase(uri);
  published_.erase(uri);
  if (was_open) closed_.insert(uri);
  return nullptr;
}

Json Server::check_all(Json const& /*params*/) {
  changed_.merge(machines_.forget());
  return nullptr;
}

std::vector<std::string> Server::publish() {
  std::vector<std::string> messages;
  auto const add = [&messages](std::string const& uri, std::string const& shown,
                               std::optional<std::int64_t> version) {
    messages.push_back(
        R"({"jsonrpc":"2.0","method":"textDocument/publishDiagnostics","params":{"diagnostics":)" + shown +
        R"(,"uri":)" + dump(uri) + (version ? R"(,"version":)" + std::to_string(*version) : "") + "}}");
  };
  for (auto const& uri : std::exchange(closed_, {})) add(uri, "[]", std::nullopt);
  if (changed_.empty()) return messages;
  std::map<std::string, std::vector<OpenDocument const*>> documents_of;
  auto const changed = std::exchange(changed_, {});
  for (auto const& uri : changed) documents_of.try_emplace(machines_.machine_of(machines_.document(uri)));
  for (auto const& [uri, document] : machines_.documents()) {
    auto const found = documents_of.find(machines_.machine_of(document));
    if (found != documents_of.end()) found->second.push_back(&document);
  }
  for (auto const& [machine, documents] : documents_of) {
    for (auto const* const document : documents) {
      auto shown = dump(diagnostics(machines_, *document));
      auto& before = published_[document->uri];
      bool const is_news = before != shown || changed.contains(document->uri);
      before = std::move(shown);
      if (is_news) add(document->uri, before, document->version);
    }
  }
  return messages;
}

}  // namespace axisc::editor
