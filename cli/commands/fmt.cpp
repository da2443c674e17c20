#include "axisc/checking/ordered_work.hpp"
#include "axisc/environment/codes.hpp"
#include "axisc/files/disk_files.hpp"
#include "axisc/files/output_file.hpp"
#include "axisc/files/path_identity.hpp"
#include "axisc/settings/settings.hpp"
#include "axisc/workspace/changeable_files.hpp"
#include "axisc/workspace/inputs.hpp"
#include "axisc/workspace/machine_outline.hpp"
#include "cli/commands/commands.hpp"
#include "cli/options/check_options.hpp"
#include "cli/options/command_line.hpp"
#include "cli/options/named_files.hpp"
#include "cli/options/sentences.hpp"
#include "configuration/project_file.hpp"
#include "configuration/xml/xml_names.hpp"
#include "diagnostics/ascii.hpp"
#include "diagnostics/writers/unified_diff.hpp"
#include "system/file.hpp"
#include "system/path.hpp"
#include "validator/list_layout.hpp"

#include <deque>
#include <unordered_set>
#include <utility>

namespace axisc::cli::says {

constexpr Sentence option_check{"write nothing; exit status 1 when a list would change",
                                "nichts schreiben; Rückgabewert 1, wenn sich eine Liste ändern würde"};
constexpr Sentence option_patch{"print a patch instead of writing", "einen Patch zeigen, statt zu schreiben"};
constexpr Sentence elsewhere{
    "{file} is not formatted: it is neither named nor below a named folder; name it as well",
    "{file} wird nicht formatiert: sie ist nicht genannt und liegt unter keinem genannten Ordner; sie "
    "ebenfalls nennen"};
constexpr Sentence ends_section{
    "{file} is not formatted: aligned, a line of a list would hold ]]>, which ends its CDATA section; "
    "rewrite the line",
    "{file} wird nicht formatiert: ausgerichtet enthielte eine Zeile einer Liste ]]>, was ihren "
    "CDATA-Abschnitt beendet; die Zeile umschreiben"};
constexpr Sentence would_change{"{file} would be formatted", "{file} würde formatiert"};

}  // namespace axisc::cli::says

namespace axisc::cli {

namespace {

/// NC programs are not lists, and XML is not aligned: their layout is up to their author.
bool keeps_layout(std::string const& path) {
  return ascii::has_extension(path, ".nc") || configuration::is_xml_name(path);
}

struct FmtOptions {
  std::vector<std::string> named;
  std::vector<std::string> schema_files;
  std::optional<std::string> threads;
  std::optional<std::string> stdin_filename;
  bool hook = false;
  bool check = false;
  bool diff = false;
};

/// The lists to format: a machine file is replaced by the lists that it names.
std::vector<std::string> lists_of(std::vector<std::string> const& inputs) {
  std::vector<std::string> lists;
  PathIdentities identities;
  std::unordered_set<std::string> known;
  auto const add = [&](std::string list) {
    if (known.insert(identities.of(list)).second) lists.push_back(std::move(list));
  };
  for (auto const& input : inputs) {
    if (ascii::has_extension(input, ".nc")) continue;
    auto const outline = outline_of(input);
    if (!outline.is_machine || configuration::is_project_name(input)) {
      add(input);
      continue;
    }
    auto const folder = system::path_of(input).parent_path();
    for (auto const& named : outline.lists) {
      if (keeps_layout(named) || ascii::has_extension(named, ".json")) continue;
      add(system::name_of(folder / system::path_of(named)));
    }
  }
  return lists;
}

void require_changeable(std::string const& path, ChangeableFiles const& changeable) {
  if (path == "-" || changeable.contains(path)) return;
  // A missing file is reported when it is read.
  if (!system::kind_of(path)) return;
  throw Failure({says::elsewhere, {{"file", path}}}, cannot_write);
}

std::string read_list(std::string const& path) {
  DiskFiles files(path == "-");
  auto bytes = files.read(path);
  if (auto const* const error = std::get_if<configuration::FileError>(&bytes)) throw unreadable(path, *error);
  auto& text = std::get<std::string>(bytes);
  auto const problem = configuration::check_text(text);
  if (auto const* const error = std::get_if<configuration::FileError>(&problem)) {
    throw unreadable(path, *error);
  }
  return std::move(text);
}

/// With its axis lists aligned; everything else stays as it is.
std::string aligned_project(std::string const& name, std::string const& before,
                            schema::Catalogue const& catalogue) {
  SourceSet sources;
  auto const source = sources.add(SourceText(name, before));
  std::deque<Finding> mistakes;
  auto const project = configuration::read_project(sources, source, mistakes);
  if (!mistakes.empty()) {
    auto const at = sources[source].position(mistakes.front().place->span.begin);
    throw Failure(name + ":" + std::to_string(at.line) + ":" + std::to_string(at.column),
                  {mistakes.front().message}, cannot_read);
  }
  std::string after;
  std::size_t copied = 0;
  for (auto const& list : project.lists) {
    if (list.kind != configuration::ListKind::axis) continue;
    auto const aligned = validator::aligned_list(
        SourceText(name, before.substr(list.span.begin, list.span.size())), catalogue);
    if (aligned.find("]]>") != std::string::npos) {
      throw Failure({says::ends_section, {{"file", name}}}, cannot_write);
    }
    after.append(before, copied, list.span.begin - copied).append(aligned);
    copied = list.span.end;
  }
  return after.append(before, copied);
}

std::string aligned_text(std::string const& name, std::string const& before,
                         schema::Catalogue const& catalogue, validator::AlignedKinds kinds) {
  if (keeps_layout(name)) return before;
  if (configuration::is_project_name(name)) return aligned_project(name, before, catalogue);
  return validator::aligned_list(SourceText(name, before), catalogue, kinds);
}

struct Formatted {
  bool changed = false;  ///< the list was, or is to be, written differently
  std::string out;       ///< for standard output
  std::optional<Failure> failure;
};

/// Lists of other kinds are only changed where somebody asks for it.
validator::AlignedKinds kinds_for(std::string const& path, Inputs const& inputs) {
  using validator::AlignedKinds;
  if (inputs.found.contains(path)) return AlignedKinds::axis;
  bool const is_named = std::find(inputs.named.begin(), inputs.named.end(), path) != inputs.named.end();
  return is_named ? AlignedKinds::all : AlignedKinds::axis_or_unknown;
}

/// `name` is that of messages and settings. May be called by several threads, for different lists.
Formatted format_list(std::string const& path, std::string const& name, FmtOptions const& options,
                      schema::Catalogue const& catalogue, validator::AlignedKinds kinds, Language language) {
  Formatted result;
  auto const before = read_list(path);
  auto const after = aligned_text(name, before, catalogue, kinds);
  if (path == "-" && !options.check && !options.diff) result.out += after;
  if (after == before) return result;
  result.changed = true;
  if (options.diff) result.out += unified_diff(name, before, after);
  if (options.check && !options.diff) {
    result.out += render({says::would_change, {{"file", name}}}, language) + "\n";
  }
  if (path != "-" && !options.check && !options.diff) {
    replace_content(path, before, after);
  }
  return result;
}

}  // namespace

ExitStatus fmt(Invocation const& invocation) {
  FmtOptions options;
  CommandLine command_line("fmt", invocation.language);
  command_line.arguments("INPUT...", options.named, says::argument_inputs);
  command_line.value("--stdin-filename", "NAME", options.stdin_filename, says::option_stdin_filename);
  declare_hook(command_line, options.hook);
  command_line.flag("--check", options.check, says::option_check);
  command_line.flag("--diff", options.diff, says::option_patch);
  declare_schema(command_line, options.schema_files);
  declare_threads(command_line, options.threads);
  if (command_line.answers(invocation)) return ExitStatus::success;
  command_line.require(!options.named.empty(), "INPUT");
  auto const asked = asked_threads(options.threads);
  SettingsFinder settings(options.schema_files);
  auto inputs = expand_inputs(
      options.named, [&settings](std::string const& path) { return settings.wants(path); },
      options.hook ? NamedFiles::of_hook : NamedFiles::usual);
  invocation.streams.err.write(note_lines(inputs.notes, invocation.language));
  ChangeableFiles const changeable(inputs.named);
  bool changed = false;
  auto const lists = lists_of(inputs.paths);
  auto const format = [&](std::size_t i) {
    try {
      require_changeable(lists[i], changeable);
      auto const& name = lists[i] == "-" ? options.stdin_filename.value_or("-") : lists[i];
      return format_list(lists[i], name, options, settings.catalogue(name), kinds_for(lists[i], inputs),
                         invocation.language);
    } catch (Failure const& failure) {
      // The other lists are still formatted.
      return Formatted{.changed = false, .out = {}, .failure = failure};
    }
  };
  auto const take = [&](std::size_t, Formatted&& formatted) {
    changed = changed || formatted.changed;
    invocation.streams.out.write(formatted.out);
    if (formatted.failure) inputs.failures.push_back(*std::move(formatted.failure));
  };
  in_order<Formatted>({.count = lists.size(),
                       .work = format,
                       .take = take,
                       .weight = [](Formatted const& formatted) { return formatted.out.size(); }},
                      thread_count(asked, lists.size()));
  for (auto const& failure : inputs.failures) invocation.streams.err.write(failure.line(invocation.language));
  if (!inputs.failures.empty()) return ExitStatus::failure;
  return options.check && changed ? ExitStatus::findings : ExitStatus::success;
}

}  // namespace axisc::cli
