#include "editor/session.hpp"

#include "axisc/checking/checking_options.hpp"
#include "axisc/environment/failure.hpp"

#include <utility>

namespace axisc::editor::says {

constexpr Sentence unknown_language{"\"{value}\" is not a language of axisc: auto, en or de",
                                    "\"{value}\" ist keine Sprache von axisc: auto, en oder de"};

}  // namespace axisc::editor::says

namespace axisc::editor {

Session::Session(validator::CheckOptions asked, Language language)
    : started_(asked),
      asked_(std::move(asked)),
      own_language_(language),
      language_(language),
      options_([this](std::string const& path) { return options_of(path); }),
      server_({.disk = disk_,
               .options = options_,
               .language = language,
               .configure = [this](ClientSettings const& settings) { return configure(settings); }}) {}

Language Session::configure(ClientSettings const& settings) {
  asked_ = started_;
  bool const is_language = settings.language == "de" || settings.language == "en";
  language_ = !is_language ? own_language_ : settings.language == "de" ? Language::german : Language::english;
  auto const take = [this](std::string_view name, std::string const& value, auto CheckingOptions::*option,
                           auto validator::CheckOptions::*member) {
    if (value.empty()) return;
    CheckingOptions given;
    given.*option = value;
    try {
      asked_.*member = check_options(given).*member;
    } catch (Failure const& mistake) {
      mistakes_.push_back(std::string(name) + ": " + mistake.sentence(language_));
    }
  };
  using Options = validator::CheckOptions;
  take("axisc.cycleTime", settings.cycle_time, &CheckingOptions::cycle_time, &Options::cycle_time);
  take("axisc.build", settings.build, &CheckingOptions::build, &Options::build);
  take("axisc.kind", settings.kind, &CheckingOptions::kind, &Options::kind);
  if (!is_language && !settings.language.empty() && settings.language != "auto") {
    mistakes_.push_back("axisc.language: " +
                        say(says::unknown_language, language_, {{"value", settings.language}}));
  }
  return language_;
}

std::vector<std::string> Session::take(std::span<std::string const> messages) {
  return with_failure(server_.receive(messages));
}

std::vector<std::string> Session::publish() {
  return with_failure(server_.publish());
}

validator::CheckOptions Session::options_of(std::string const& path) {
  auto options = asked_;
  options.machine = false;
  workspace_.emplace(disk_, Overrides{.options = options});
  try {
    return workspace_->options_of(path);
  } catch (Failure const& mistake) {
    failure_ = mistake.sentence(language_);
    return options;
  }
}

std::vector<std::string> Session::with_failure(std::vector<std::string> messages) {
  if (!failure_.empty() && told_.insert(failure_).second) {
    messages.push_back(error_message(failure_));
  }
  failure_.clear();
  for (auto const& mistake : std::exchange(mistakes_, {})) messages.push_back(error_message(mistake));
  return messages;
}

}  // namespace axisc::editor
