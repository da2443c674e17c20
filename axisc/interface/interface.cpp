#include "axisc/asked/quantities.hpp"
#include "axisc/axisc.h"
#include "axisc/checking/checking_options.hpp"
#include "axisc/checking/compile_input.hpp"
#include "axisc/checking/fixing.hpp"
#include "axisc/checking/identity_paths.hpp"
#include "axisc/checking/path_machine.hpp"
#include "axisc/checking/report_format.hpp"
#include "axisc/interface/asked.hpp"
#include "axisc/interface/call.hpp"
#include "axisc/interface/json_findings.hpp"
#include "axisc/interface/questions.hpp"
#include "diagnostics/utf8.hpp"
#include "validator/loading/loader.hpp"

#include <array>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <nlohmann/json.hpp>

namespace axisc::says {

constexpr Sentence not_utf8{"a path is not UTF-8", "ein Pfad ist nicht UTF-8"};
constexpr Sentence image_number{
    R"("image_version" is a whole number from 0 to 4294967295, not "{value}")",
    R"("image_version" ist eine ganze Zahl von 0 bis 4294967295, nicht "{value}")"};

}  // namespace axisc::says

using namespace axisc;
using interface::Asked;
using interface::BadArgument;
using interface::call;
using interface::JsonFindings;
using interface::Now;
using interface::require;
using interface::Wanted;

namespace {

int give(std::string const& text, axisc_bytes* bytes) {
  if (axisc_copy(bytes, text.data(), text.size()) != AXISC_OK) throw std::bad_alloc();
  return AXISC_OK;
}

/// A name that findings and JSON can repeat.
std::string named(char const* path) {
  std::string name(path);
  if (valid_utf8_prefix(name) != name.size()) throw BadArgument({says::not_utf8});
  return name;
}

Inputs inputs_of(Now& now, std::string const& path) {
  Inputs inputs;
  if (now.workspace.files().is_file(path)) {
    inputs.paths = inputs.named = {path};
    inputs.first = path;
  } else {
    inputs = expand_inputs(
        {path}, [&](std::string const& file) { return now.workspace.settings().wants(file); },
        NamedFiles::literal);
  }
  now.workspace.take(inputs);
  now.workspace.judge_in_machines(inputs);
  return inputs;
}

constexpr std::array yes_or_no = {interface::no_or_yes[1], interface::no_or_yes[0]};

codegen::ImageOptions image_options(char const* json) {
  Asked const asked(json, "strip bounds image_version");
  codegen::ImageOptions options{.strip = asked.word("strip", interface::no_or_yes),
                                .bounds = asked.word("bounds", yes_or_no)};
  if (auto const version = asked.find("image_version")) {
    auto const number = parse_count(*version);
    bool const fits = number && *number <= std::numeric_limits<std::uint32_t>::max();
    if (!fits) throw BadArgument({says::image_number, {{"value", *version}}});
    options.image_version = static_cast<std::uint32_t>(*number);
  }
  return options;
}

/// None where it is empty, too.
std::optional<std::string> filled(Asked const& asked, std::string const& key) {
  auto text = asked.text(key);
  return text.empty() ? std::nullopt : std::optional(std::move(text));
}

int opened(axisc_workspace& object, char const* options, axisc_files const* files) {
  static constexpr std::array languages = {std::pair(std::string_view("en"), Language::english),
                                           std::pair(std::string_view("de"), Language::german)};
  Asked const asked(options, "language cycle_time override_cycle_time axis_type kind build");
  object.language = asked.word("language", languages);
  if (files != nullptr) {
    require(files->size == sizeof(axisc_files) && files->reserved == 0 && files->read != nullptr);
    object.from = *files;
  }
  CheckingOptions given;
  given.cycle_time = filled(asked, "override_cycle_time");
  given.axis_type = filled(asked, "axis_type");
  given.build = filled(asked, "build");
  given.kind = filled(asked, "kind");
  object.options = check_options(given);
  object.options.cycle_time_otherwise = asked_cycle_time(filled(asked, "cycle_time"));
  return AXISC_OK;
}

}  // namespace

uint32_t axisc_abi_version(void) {
  return AXISC_ABI_VERSION;
}

int axisc_open(char const* options, axisc_files const* files, axisc_workspace** workspace) {
  if (workspace == nullptr) return AXISC_BAD_ARGUMENT;
  *workspace = new (std::nothrow) axisc_workspace();
  if (*workspace == nullptr) return AXISC_NO_MEMORY;
  (*workspace)->is_usable = true;
  auto const status = call(*workspace, {}, nullptr, [&](axisc_workspace& object, std::optional<Now>&) {
    return opened(object, options, files);
  });
  // A cycle time is an option, not an input that cannot be used.
  (*workspace)->is_usable = status == AXISC_OK;
  return status == AXISC_UNUSABLE ? AXISC_BAD_ARGUMENT : status;
}

void axisc_close(axisc_workspace* workspace) {
  delete workspace;
}

int axisc_put(axisc_workspace* workspace, char const* path, void const* bytes, size_t size) {
  return call(workspace, {path}, nullptr, [&](axisc_workspace& object, std::optional<Now>&) -> int {
    require(bytes != nullptr || size == 0);
    auto const* const first = static_cast<char const*>(bytes);
    object.unsaved.insert_or_assign(validator::key_of(named(path)),
                                    size == 0 ? std::string() : std::string(first, size));
    return AXISC_OK;
  });
}

int axisc_drop(axisc_workspace* workspace, char const* path) {
  return call(workspace, {path}, nullptr, [&](axisc_workspace& object, std::optional<Now>&) -> int {
    object.unsaved.erase(validator::key_of(path));
    return AXISC_OK;
  });
}

int axisc_read(axisc_workspace* workspace, char const* path, axisc_bytes* bytes) {
  return call(workspace, {path, bytes}, bytes,
              [&](axisc_workspace& object, std::optional<Now>& opened_now) -> int {
                object.input = named(path);
                auto const read = opened_now.emplace(object).workspace.files().read(path);
                if (auto const* const error = std::get_if<configuration::FileError>(&read)) {
                  throw unreadable(path, *error);
                }
                return give(std::get<std::string>(read), bytes);
              });
}

int axisc_check(axisc_workspace* workspace, char const* path, axisc_bytes* findings) {
  return call(workspace, {path, findings}, findings,
              [&](axisc_workspace& object, std::optional<Now>& opened_now) -> int {
                object.input = named(path);
                auto& now = opened_now.emplace(object, Wanted::findings);
                auto const inputs = inputs_of(now, path);
                JsonFindings report(now, object, inputs.first);
                for (auto const& failure : inputs.failures) report.fail(failure);
                for (auto const& input : inputs.paths) {
                  now.files.stop_if_cancelled();
                  report.add(check_input(now.workspace, input, nullptr));
                }
                give(report.text(), findings);
                if (report.has_failed()) return now.has(path) ? AXISC_UNUSABLE : AXISC_NOT_FOUND;
                return report.has_errors() ? AXISC_FINDINGS : AXISC_OK;
              });
}

int axisc_fix(axisc_workspace* workspace, char const* path, int fixes, axisc_bytes* report) {
  return call(workspace, {path, report}, report,
              [&](axisc_workspace& object, std::optional<Now>& opened_now) -> int {
                require(fixes == AXISC_FIX_SAFE || fixes == AXISC_FIX_ALL);
                object.input = named(path);
                auto& now = opened_now.emplace(object, Wanted::findings);
                auto const inputs = inputs_of(now, path);
                IdentityPaths identity_paths(now.workspace.settings());
                auto const choice = fixes == AXISC_FIX_ALL ? FixChoice::all : FixChoice::safe;
                auto fixed = fix_inputs(now.workspace, inputs.paths, choice, {}, identity_paths,
                                        ChangeableFiles(inputs.named));
                if (!inputs.failures.empty()) throw Failure(inputs.failures.front());
                if (!fixed.failures.empty()) throw Failure(fixed.failures.front());
                std::erase_if(fixed.original, [&](auto const& original) {
                  return fixed.edited.at(original.first) == original.second;
                });
                auto files = nlohmann::json::array();
                for (auto const& [file, before] : fixed.original) files.push_back(file);
                nlohmann::ordered_json const answer{
                    {"version", 1}, {"files", std::move(files)}, {"fixed", fixed.facts.applied}};
                give(answer.dump(), report);
                for (auto const& [file, before] : fixed.original) {
                  object.unsaved[validator::key_of(file)] = fixed.edited.at(file);
                }
                return AXISC_OK;
              });
}

int axisc_compile(axisc_workspace* workspace, char const* path, char const* options, axisc_bytes* image,
                  axisc_bytes* findings) {
  if (findings != nullptr) *findings = {.data = nullptr, .size = 0};
  return call(workspace, {path, image}, image,
              [&](axisc_workspace& object, std::optional<Now>& opened_now) -> int {
                auto const wanted = image_options(options);
                object.input = named(path);
                auto& now = opened_now.emplace(object);
                auto const machine = machine_of_input(now.workspace, {.input = path}).machine;
                codegen::KnownDesigns designs;
                CheckingOptions const checking;
                auto const compiled = compile_input({.workspace = now.workspace,
                                                     .checking = checking,
                                                     .image = wanted,
                                                     .language = object.language,
                                                     .designs = designs},
                                                    machine);
                if (findings != nullptr) {
                  JsonFindings report(now, object, machine);
                  report.add(compiled.checked);
                  give(report.text(), findings);
                  object.error.clear();
                }
                if (compiled.image) return give(compiled.image->bytes, image);
                object.error = texts_of({compiled.checked.findings.begin(), compiled.checked.findings.end()},
                                        compiled.checked.sources, {.language = object.language});
                if (compiled.checked.failure) throw Failure(*compiled.checked.failure);
                return AXISC_FINDINGS;
              });
}

int axisc_answer(axisc_workspace* workspace, char const* question, axisc_bytes* answer) {
  return call(workspace, {question, answer}, answer,
              [&](axisc_workspace& object, std::optional<Now>& opened_now) -> int {
                Asked const asked(question);
                object.input = asked.text("input");
                auto& now = opened_now.emplace(object);
                auto const found = interface::answer(
                    now.workspace, asked,
                    {.language = object.language,
                     .take = [&object](std::vector<Finding> const& found_first, SourceSet const& sources) {
                       object.error += texts_of(found_first, sources, {.language = object.language});
                     }});
                return found ? give(*found, answer) : AXISC_FINDINGS;
              });
}

int axisc_message(axisc_workspace* workspace, char const* messages, axisc_bytes* replies) {
  return call(workspace, {messages, replies}, replies,
              [&](axisc_workspace& object, std::optional<Now>&) -> int {
                auto const arrived = interface::asked_texts(messages);
                auto& session = object.session;
                if (session == nullptr) {
                  session = std::make_unique<editor::Session>(object.options, object.language);
                }
                std::string text = "[";
                auto const send = [&](std::vector<std::string> const& sent) {
                  for (auto const& message : sent) {
                    text.append(text.size() > 1 ? ",\n" : "\n").append(message);
                  }
                };
                if (!session->has_ended()) send(session->take(arrived));
                if (!session->has_ended()) send(session->publish());
                give(text.append(text.size() > 1 ? "\n]" : "]"), replies);
                if (!session->has_ended()) return AXISC_OK;
                return session->ended_properly() ? AXISC_ENDED : AXISC_BROKEN_OFF;
              });
}

void axisc_cancel(axisc_workspace* workspace) {
  if (workspace != nullptr) workspace->is_cancelled = true;
}

char const* axisc_error(axisc_workspace const* workspace) {
  return workspace == nullptr ? "" : workspace->error.c_str();
}

int axisc_copy(axisc_bytes* bytes, void const* data, size_t size) {
  if (bytes == nullptr || (data == nullptr && size > 0)) return AXISC_BAD_ARGUMENT;
  auto* const copy = size == SIZE_MAX ? nullptr : static_cast<char*>(std::malloc(size + 1));
  if (copy == nullptr) return AXISC_NO_MEMORY;
  if (size > 0) std::memcpy(copy, data, size);
  copy[size] = '\0';
  axisc_free(bytes);
  *bytes = {.data = copy, .size = size};
  return AXISC_OK;
}

void axisc_free(axisc_bytes* bytes) {
  if (bytes == nullptr) return;
  std::free(bytes->data);
  *bytes = {.data = nullptr, .size = 0};
}
