#include "cli/checking/baseline.hpp"
#include "cli/codes.hpp"
#include "cli/commands/commands.hpp"
#include "cli/files/output_file.hpp"
#include "cli/files/protected_files.hpp"
#include "cli/fleet/shard_document.hpp"
#include "cli/options/command_line.hpp"
#include "cli/options/response_file.hpp"
#include "cli/report/report_context.hpp"
#include "cli/report/report_stream.hpp"
#include "cli/sentences.hpp"

#include <algorithm>
#include <deque>
#include <tuple>
#include <utility>

namespace axisc::cli::says {

constexpr Sentence option_output{"where the result goes (default: standard output)",
                                 "wohin das Ergebnis geht (Standardwert: Standardausgabe)"};
constexpr Sentence argument_shards{
    "the results of all shards of one run (--format json or sarif), in any order, or @FILE with their names",
    "die Ergebnisse aller Teile eines Laufs (--format json oder sarif), in beliebiger Reihenfolge, oder "
    "@DATEI mit ihren Namen"};
constexpr Sentence purpose{
    R"(Combines the results of `axisc lint --shard I/N`. The output is what one run without --shard would have written,
byte for byte.)",
    R"(Führt die Ergebnisse von `axisc lint --shard I/N` zusammen. Die Ausgabe ist, was ein Lauf ohne --shard geschrieben
hätte, Byte für Byte.)"};
constexpr Sentence examples{R"(Examples:
  axisc lint . --format json --shard 1/2 > 1.json
  axisc lint . --format json --shard 2/2 > 2.json
  axisc merge 1.json 2.json > all.json
  axisc merge 1.json 2.json --baseline known.json

Exit status: that of the whole run: 0 no errors, 1 errors (or warnings, where the shards ran with --werror),
2 something could not be read, here or by a shard.)",
                            R"(Beispiele:
  axisc lint . --format json --shard 1/2 > 1.json
  axisc lint . --format json --shard 2/2 > 2.json
  axisc merge 1.json 2.json > alle.json
  axisc merge 1.json 2.json --baseline bekannt.json

Rückgabewert: der des ganzen Laufs: 0 keine Fehler, 1 Fehler (auch Warnungen, wo die Teile mit --werror liefen),
2 etwas war nicht lesbar, hier oder für einen Teil.)"};
constexpr Sentence mixed{
    "{file} and {first} are from different runs: format, program, options, inputs or number of shards differ",
    "{file} und {first} stammen aus verschiedenen Läufen: Format, Programm, Optionen, Eingaben oder Anzahl "
    "der Teile unterscheiden sich"};
constexpr Sentence twice{"{file} and {first} are both shard {shard}",
                         "{file} und {first} sind beide Teil {shard}"};
constexpr Sentence missing{"shard {shard} is missing; all shards of a run belong together",
                           "Teil {shard} fehlt; alle Teile eines Laufs gehören zusammen"};

}  // namespace axisc::cli::says

namespace axisc::cli {

namespace {

struct MergeOptions {
  std::vector<std::string> files;
  std::optional<std::string> baseline;
  std::optional<std::string> output;
};

using Documents = std::deque<ShardDocument>;

std::string as_text(Shard const& shard) {
  return std::to_string(shard.index) + "/" + std::to_string(shard.count);
}

/// Failure unless the documents are all shards of one run, each once.
void require_whole_run(Documents const& documents) {
  auto const& first = documents.front();
  std::vector<ShardDocument const*> by_index(first.record().shard.count, nullptr);
  for (auto const& document : documents) {
    auto const facts = [](ShardDocument const& each) {
      return std::tuple(each.format(), each.record().run, each.record().shard.count,
                        std::string_view(each.record().version));
    };
    bool const same_version = document.record().version == AXISC_VERSION;
    if (facts(document) != facts(first) || !same_version) {
      throw Failure({.sentence = says::mixed,
                     .arguments = {{"file", document.file()},
                                   {"first", same_version ? first.file() : "axisc " AXISC_VERSION}}});
    }
    auto const& shard = document.record().shard;
    auto const*& place = by_index[shard.index - 1];
    if (place != nullptr) {
      throw Failure(
          {.sentence = says::twice,
           .arguments = {{"file", document.file()}, {"first", place->file()}, {"shard", as_text(shard)}}});
    }
    place = &document;
  }
  for (std::uint32_t i = 0; i < by_index.size(); ++i) {
    if (by_index[i] != nullptr) continue;
    throw Failure({.sentence = says::missing,
                   .arguments = {{"shard", as_text({.index = i + 1, .count = first.record().shard.count})}}});
  }
}

std::vector<ShardFailure> failures_of(Documents const& documents) {
  std::vector<ShardFailure> failures;
  for (auto const& document : documents) {
    auto const& more = document.record().failures;
    failures.insert(failures.end(), more.begin(), more.end());
  }
  std::stable_sort(failures.begin(), failures.end(), [](ShardFailure const& left, ShardFailure const& right) {
    return left.order < right.order;
  });
  return failures;
}

ReportPlan plan_of(Documents const& documents, MergeOptions const& options, IdentityPaths& identity_paths) {
  auto const& first = documents.front();
  ReportPlan plan{.report_format = {.format = first.format(),
                                    .write = {.language = first.language()},
                                    .context = report_context({})},
                  .statistics = first.has_statistics(),
                  .baseline = {},
                  .shard = {},
                  .identity_paths = &identity_paths};
  if (options.baseline) plan.baseline = Baseline::read(*options.baseline);
  // Names are relative to the repository already; an invented folder keeps them so.
  plan.report_format.context.paths = {.root = "/repository", .folder = "/repository"};
  for (auto const& failure : failures_of(documents)) {
    plan.report_format.context.failures.push_back(failure.sentence);
  }
  return plan;
}

/// Inputs of all shards in the order of the whole run.
void add_inputs(Documents& documents, ReportStream& report) {
  struct Next {
    std::size_t number = 0;
    ShardDocument* document = nullptr;
    std::size_t index = 0;
  };
  std::vector<Next> inputs;
  for (auto& document : documents) {
    for (std::size_t i = 0; i < document.record().inputs.size(); ++i) {
      inputs.push_back({document.record().inputs[i].number, &document, i});
    }
    CheckedInput files;
    files.files = document.record().files;
    report.add(0, files);
  }
  std::sort(inputs.begin(), inputs.end(),
            [](Next const& left, Next const& right) { return left.number < right.number; });
  for (auto const& next : inputs) report.add(next.number, next.document->next_input(next.index));
}

ExitStatus status_of(Documents const& documents, FindingCounts const& counts) {
  auto const& first = documents.front().record();
  int worst = counts.errors > 0 || (first.werror && counts.warnings > 0) ? 1 : 0;
  for (auto const& document : documents) {
    if (document.record().status == static_cast<int>(ExitStatus::failure)) worst = document.record().status;
  }
  return static_cast<ExitStatus>(worst);
}

void protect_inputs(std::vector<NamedInput> const& inputs, MergeOptions const& options) {
  if (!options.output) return;
  std::vector<std::string> sources;
  sources.reserve(inputs.size());
  for (auto const& input : inputs) sources.push_back(input.path);
  for (auto const& word : options.files) {
    if (word.starts_with('@')) sources.push_back(word.substr(1));
  }
  if (options.baseline) sources.push_back(*options.baseline);
  refuse_overwriting({*options.output}, sources);
}

ExitStatus print(Documents& documents, MergeOptions const& options, Console& out) {
  SettingsFinder settings;
  IdentityPaths identity_paths(settings, FileNames::of_identities);
  ReportStream report(plan_of(documents, options, identity_paths), out);
  add_inputs(documents, report);
  auto const status = status_of(documents, report.counts());
  auto const& unjudged = documents.front().record().unjudged;
  auto const judged = [&unjudged](Code code) {
    return std::find(unjudged.begin(), unjudged.end(), static_cast<unsigned>(code)) == unjudged.end();
  };
  report.finish({}, judged, static_cast<int>(status));
  return status;
}

}  // namespace

ExitStatus merge(Invocation const& invocation) {
  MergeOptions options;
  CommandLine command_line("merge", says::purpose, says::examples, invocation.language);
  command_line.arguments("FILE...", options.files, says::argument_shards);
  command_line.value("--baseline", "FILE", options.baseline, says::option_baseline);
  command_line.value("-o,--output", "FILE", options.output, says::option_output);
  if (command_line.answers(invocation)) return ExitStatus::success;
  command_line.require(!options.files.empty(), "FILE");
  auto const inputs = read_response_files(options.files);
  protect_inputs(inputs, options);
  Documents documents;
  for (auto const& file : inputs) documents.emplace_back(file.path);
  require_whole_run(documents);
  for (auto const& failure : failures_of(documents)) invocation.streams.err.write(failure.line);
  if (!options.output) return print(documents, options, invocation.streams.out);
  OutputFile file(*options.output);
  Console out(file);
  auto const status = print(documents, options, out);
  out.flush();
  file.commit();
  return status;
}

}  // namespace axisc::cli
