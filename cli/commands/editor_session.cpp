#include "cli/commands/editor_session.hpp"

#include "cli/checking/check_input.hpp"
#include "cli/commands/lsp_pages.hpp"
#include "cli/failure.hpp"
#include "cli/formats/explain_formats.hpp"

#include <utility>

namespace axisc::cli {

EditorSession::EditorSession(validator::CheckOptions asked, Language language)
    : asked_(std::move(asked)),
      language_(language),
      options_([this](std::string const& path) { return options_of(path); }),
      server_({.disk = disk_,
               .options = options_,
               .explain =
                   [language](schema::Catalogue const& catalogue, schema::Parameter const& parameter) {
                     return explain_parameter(catalogue, parameter, language);
                   },
               .pages = editor_pages(options_, language),
               .language = language}) {}

std::vector<std::string> EditorSession::take(std::string_view message) {
  return with_failure(server_.receive(message));
}

std::vector<std::string> EditorSession::publish() {
  return with_failure(server_.publish());
}

validator::CheckOptions EditorSession::options_of(std::string const& path) {
  settings_.emplace();
  CheckJob job;
  job.options = asked_;
  job.options.machine = false;
  job.settings = &*settings_;
  try {
    return options_for(job, path);
  } catch (Failure const& mistake) {
    failure_ = mistake.sentence(language_);
    return job.options;
  }
}

std::vector<std::string> EditorSession::with_failure(std::vector<std::string> messages) {
  if (!failure_.empty() && told_.insert(failure_).second) {
    messages.push_back(editor::error_message(failure_));
  }
  failure_.clear();
  return messages;
}

}  // namespace axisc::cli
