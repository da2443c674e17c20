#include "axisc/checking/checking_options.hpp"
#include "axisc/checking/compile_input.hpp"
#include "axisc/checking/fixing.hpp"
#include "axisc/checking/identity_paths.hpp"
#include "axisc/checking/path_machine.hpp"
#include "axisc/checking/report_context.hpp"
#include "axisc/checking/report_format.hpp"
#include "axisc/checking/report_stream.hpp"
#include "axisc/environment/failure.hpp"
#include "axisc/environment/failure_line.hpp"
#include "axisc/files/disk_files.hpp"
#include "editor/session.hpp"
#include "web/interface/asked.hpp"
#include "web/interface/axisc.h"
#include "web/interface/questions.hpp"

#include <array>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <nlohmann/json.hpp>

using namespace axisc;

struct axisc_workspace {
  Language language = Language::english;
  std::optional<std::string> cycle_time;
  EditedBytes unsaved;
  std::unique_ptr<editor::Session> session;
  std::string error;

  enum class Wanted : std::uint8_t { findings, machine };

  /// Files and settings as they are now.
  [[nodiscard]] std::unique_ptr<Workspace> now(Wanted wanted = Wanted::machine) const {
    Overrides overrides;
    overrides.options.machine = wanted == Wanted::machine;
    overrides.options.cycle_time_otherwise = asked_cycle_time(cycle_time);
    auto made = std::make_unique<Workspace>(std::move(overrides));
    made->put_all(unsaved);
    return made;
  }

  [[nodiscard]] ErrorSink errors() {
    return {.language = language,
            .take = [this](std::vector<Finding> const& found, SourceSet const& sources) {
              error += texts_of(found, sources, {.language = language});
            }};
  }
};

namespace {

int give(std::string const& text, axisc_bytes* bytes) {
  bytes->data = static_cast<char*>(std::malloc(text.size() + 1));
  if (bytes->data == nullptr) throw std::bad_alloc();
  std::memcpy(bytes->data, text.c_str(), text.size() + 1);
  bytes->size = text.size();
  return AXISC_OK;
}

/// No exception leaves the library.
template <typename Work>
int call(axisc_workspace& workspace, axisc_bytes* result, Work const& work) {
  if (result != nullptr) *result = {.data = nullptr, .size = 0};
  workspace.error.clear();
  try {
    return work();
  } catch (...) {
    workspace.error += failure_line(workspace.language);
    return AXISC_FAILED;
  }
}

Inputs inputs_of(Workspace& workspace, std::string const& path) {
  Inputs inputs;
  if (workspace.unsaved().contains(path)) {
    inputs.paths = inputs.named = {path};
    inputs.first = path;
  } else {
    inputs = expand_inputs(
        {path}, [&](std::string const& file) { return workspace.settings().wants(file); },
        NamedFiles::literal);
  }
  workspace.take(inputs);
  workspace.judge_in_machines(inputs);
  return inputs;
}

std::string as_json(std::vector<std::string> const& messages) {
  std::string text = "[";
  for (auto const& message : messages) text.append(text.size() > 1 ? "," : "").append(message);
  return text + "]";
}

}  // namespace

int axisc_open(char const* options, axisc_workspace** workspace) {
  *workspace = new (std::nothrow) axisc_workspace();
  if (*workspace == nullptr) return AXISC_FAILED;
  auto& opened = **workspace;
  return call(opened, nullptr, [&]() -> int {
    if (options == nullptr) return AXISC_OK;
    static constexpr std::array languages = {std::pair(std::string_view("en"), Language::english),
                                             std::pair(std::string_view("de"), Language::german)};
    web::Asked const asked(options);
    asked.refuse_others("language cycle_time");
    opened.language = asked.word("language", languages);
    if (auto const time = asked.text("cycle_time"); !time.empty()) opened.cycle_time = time;
    static_cast<void>(asked_cycle_time(opened.cycle_time));
    return AXISC_OK;
  });
}

void axisc_close(axisc_workspace* workspace) {
  delete workspace;
}

int axisc_put(axisc_workspace* workspace, char const* path, char const* bytes, size_t size) {
  return call(*workspace, nullptr, [&]() -> int {
    workspace->unsaved.insert_or_assign(path, std::string(bytes, size));
    return AXISC_OK;
  });
}

int axisc_drop(axisc_workspace* workspace, char const* path) {
  return call(*workspace, nullptr, [&]() -> int {
    workspace->unsaved.erase(path);
    return AXISC_OK;
  });
}

int axisc_read(axisc_workspace* workspace, char const* path, axisc_bytes* bytes) {
  return call(*workspace, bytes, [&]() -> int {
    auto const read = workspace->now()->files().read(path);
    if (auto const* const error = std::get_if<configuration::FileError>(&read)) {
      throw unreadable(path, *error);
    }
    return give(std::get<std::string>(read), bytes);
  });
}

int axisc_check(axisc_workspace* workspace, char const* path, axisc_bytes* findings) {
  return call(*workspace, findings, [&]() -> int {
    auto const now = workspace->now(axisc_workspace::Wanted::findings);
    auto const inputs = inputs_of(*now, path);
    IdentityPaths identity_paths(now->settings());
    std::string text;
    ReportPlan plan{.report_format = {.format = FindingFormat::json,
                                      .write = {.language = workspace->language},
                                      .context = report_context(inputs.first)},
                    .baseline = {},
                    .identity_paths = &identity_paths};
    ReportStream report(std::move(plan), [&text](std::string_view piece) { text += piece; });
    bool has_failed = false;
    auto const fail = [&](Failure const& failure) {
      has_failed = true;
      workspace->error += failure.line(workspace->language);
      report.fail(failure);
    };
    for (auto const& failure : inputs.failures) fail(failure);
    for (auto const& input : inputs.paths) {
      auto const checked = check_input(*now, input, nullptr);
      if (checked.failure) fail(*checked.failure);
      report.add(checked);
    }
    report.finish({}, [](Code) { return true; });
    give(text, findings);
    if (has_failed) return AXISC_FAILED;
    return report.counts().errors > 0 ? AXISC_FINDINGS : AXISC_OK;
  });
}

int axisc_fix(axisc_workspace* workspace, char const* path, axisc_bytes* changed) {
  return call(*workspace, changed, [&]() -> int {
    auto const now = workspace->now(axisc_workspace::Wanted::findings);
    auto const inputs = inputs_of(*now, path);
    IdentityPaths identity_paths(now->settings());
    auto const fixed =
        fix_inputs(*now, inputs.paths, FixChoice::safe, {}, identity_paths, ChangeableFiles(inputs.named));
    if (!inputs.failures.empty()) throw Failure(inputs.failures.front());
    if (!fixed.failures.empty()) throw Failure(fixed.failures.front());
    auto paths = nlohmann::json::array();
    for (auto const& [file, before] : fixed.original) {
      auto const& after = fixed.edited.at(file);
      if (after == before) continue;
      workspace->unsaved.insert_or_assign(file, after);
      paths.push_back(file);
    }
    return give(paths.dump(), changed);
  });
}

int axisc_compile(axisc_workspace* workspace, char const* path, axisc_bytes* image) {
  return call(*workspace, image, [&]() -> int {
    auto const now = workspace->now();
    auto const machine = machine_of_input(*now, {.input = path}).machine;
    codegen::KnownDesigns designs;
    CheckingOptions const checking;
    auto const compiled = compile_input({.workspace = *now,
                                         .checking = checking,
                                         .image = {.bounds = true},
                                         .language = workspace->language,
                                         .designs = designs},
                                        machine);
    workspace->error += texts_of({compiled.checked.findings.begin(), compiled.checked.findings.end()},
                                 compiled.checked.sources, {.language = workspace->language});
    if (compiled.checked.failure) throw Failure(*compiled.checked.failure);
    if (!compiled.image) return AXISC_FINDINGS;
    workspace->error.clear();
    return give(compiled.image->bytes, image);
  });
}

int axisc_answer(axisc_workspace* workspace, char const* question, axisc_bytes* answer) {
  return call(*workspace, answer, [&]() -> int {
    auto const now = workspace->now();
    auto const found = web::answer(*now, question, workspace->errors());
    return found ? give(*found, answer) : AXISC_FINDINGS;
  });
}

int axisc_message(axisc_workspace* workspace, char const* messages, axisc_bytes* replies) {
  return call(*workspace, replies, [&]() -> int {
    auto& session = workspace->session;
    if (session == nullptr) {
      validator::CheckOptions options;
      options.cycle_time_otherwise = asked_cycle_time(workspace->cycle_time);
      session = std::make_unique<editor::Session>(std::move(options), workspace->language);
    }
    if (session->has_ended()) return give("[]", replies);
    auto sent = session->take(nlohmann::json::parse(messages).get<std::vector<std::string>>());
    if (!session->has_ended()) {
      for (auto& message : session->publish()) sent.push_back(std::move(message));
    }
    return give(as_json(sent), replies);
  });
}

char const* axisc_error(axisc_workspace const* workspace) {
  return workspace->error.c_str();
}

void axisc_free(axisc_bytes* bytes) {
  std::free(bytes->data);
  *bytes = {.data = nullptr, .size = 0};
}
