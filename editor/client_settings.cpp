#include "editor/client_settings.hpp"

#include "diagnostics/ascii.hpp"
#include "editor/server.hpp"

#include <array>

#include <nlohmann/json.hpp>

namespace axisc::editor {

namespace {

constexpr std::string_view section_name = "axisc";

/// The id of the request for the client's settings.
constexpr std::string_view settings_request = "axisc.settings";

/// All files that a machine consists of. Not every client understands braces and brackets in patterns.
constexpr std::array read_files = {"**/*.lis", "**/*.LIS", "**/*.json",   "**/*.nc",
                                   "**/*.NC",  "**/*.xml", "**/*.tsproj", "**/*.xti"};

std::string text_of(Json const& section, char const* name) {
  auto const found = section.find(name);
  if (found == section.end() || !found->is_string()) return {};
  return std::string(ascii::trimmed(found->get_ref<std::string const&>()));
}

std::string request(Json const& id, std::string_view method, Json params) {
  return Json{{"jsonrpc", "2.0"}, {"id", id}, {"method", method}, {"params", std::move(params)}}.dump();
}

}  // namespace

ClientSettings settings_of_section(Json const& section) {
  if (!section.is_object()) return {};
  return {.cycle_time = text_of(section, "cycleTime"),
          .build = text_of(section, "build"),
          .kind = text_of(section, "kind"),
          .language = text_of(section, "language"),
          .finding_page = text_of(section, "findingPage")};
}

std::optional<ClientSettings> client_settings(Json const& all) {
  if (!all.is_object() || !all.contains(section_name)) return std::nullopt;
  return settings_of_section(all[std::string(section_name)]);
}

Json Server::begin_conversation(Json const& /*params*/) {
  ask_for_notifications();
  ask_for_settings();
  return nullptr;
}

void Server::ask_for_notifications() {
  auto registrations = Json::array();
  if (registers_settings_) {
    registrations.push_back({{"id", settings_request},
                             {"method", "workspace/didChangeConfiguration"},
                             {"registerOptions", {{"section", section_name}}}});
  }
  if (watches_files_) {
    auto watchers = Json::array();
    for (auto const* pattern : read_files) watchers.push_back({{"globPattern", pattern}});
    registrations.push_back({{"id", "axisc.files"},
                             {"method", "workspace/didChangeWatchedFiles"},
                             {"registerOptions", {{"watchers", std::move(watchers)}}}});
  }
  if (registrations.empty()) return;
  pending_.push_back(request("axisc.registration", "client/registerCapability",
                             {{"registrations", std::move(registrations)}}));
}

void Server::ask_for_settings() {
  if (!gives_settings_) return;
  pending_.push_back(request(settings_request, "workspace/configuration",
                             {{"items", Json::array({{{"section", section_name}}})}}));
}

// Clients that support workspace/configuration may push partial settings.
Json Server::configure(Json const& params) {
  ask_for_settings();
  auto const told = params.is_object() ? client_settings(params.value("settings", Json())) : std::nullopt;
  if (told && !gives_settings_) apply(*told);
  return check_all(params);
}

void Server::take_answer(Json const& id, Json const& result) {
  if (id != settings_request) return;
  apply(result.is_array() && !result.empty() ? settings_of_section(result[0]) : ClientSettings{});
}

void Server::apply(ClientSettings const& settings) {
  if (settings == settings_ || !configure_) return;
  settings_ = settings;
  machines_.client().language = configure_(settings);
  machines_.client().finding_page = settings.finding_page;
  check_all(nullptr);
}

}  // namespace axisc::editor
