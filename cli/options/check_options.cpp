#include "cli/options/check_options.hpp"

#include "cli/options/sentences.hpp"
#include "schema/list_kind.hpp"

namespace axisc::cli::says {

constexpr Sentence option_axis_type{
    "translatory, rotary or spindle, overriding the list (kenngr.achs_typ)",
    "translatorisch, rotatorisch oder Spindel, statt der Angabe in der Liste (kenngr.achs_typ)"};
constexpr Sentence option_kind{
    "kind of the lists, whatever they say themselves: axis, startup, channel, real_time, tool and others",
    "Art der Listen, gleich was sie selbst sagen: axis, startup, channel, real_time, tool und weitere"};
constexpr Sentence option_build{
    "build of the control, such as V3.1.3075.04; warns about what needs a newer one",
    "Stand der Steuerung, etwa V3.1.3075.04; warnt vor allem, was einen neueren braucht"};
constexpr Sentence option_finding_format{"format of the findings (default: text)",
                                         "Format der Befunde (Standardwert: text)"};
constexpr Sentence option_werror{"warnings lead to exit status 1 as well",
                                 "auch Warnungen führen zum Rückgabewert 1"};
constexpr Sentence option_disable{
    "leave these codes out, by code, name or beginning (AX1*); may be repeated",
    "diese Codes weglassen, als Code, Name oder Anfang (AX1*); mehrmals möglich"};
constexpr Sentence option_pedantic{"print notes as well", "auch Hinweise zeigen"};
constexpr Sentence option_jobs{
    "threads (default: one per core); the output is the same for every number",
    "Threads (Standardwert: einer je Kern); die Ausgabe ist für jede Anzahl gleich"};
constexpr Sentence option_quiet{"no notes and no summary", "keine Hinweise und keine Zusammenfassung"};

constexpr Sentence option_alone{"judge a list by itself, not in the machine that names it",
                                "eine Liste für sich beurteilen, nicht in der Maschine, die sie nennt"};
constexpr Sentence option_schema{
    "add the parameters of FILE to those that are known, or override them (repeatable)",
    "die Parameter aus DATEI zu den bekannten hinzufügen oder diese damit überschreiben (wiederholbar)"};

}  // namespace axisc::cli::says

namespace axisc::cli {

void declare_control(CommandLine& command_line, CheckingOptions& options) {
  command_line.value("--cycle-time", "TIME", options.cycle_time, says::option_cycle_time);
  command_line.value("--axis-type", "T|R|S", options.axis_type, says::option_axis_type);
  std::vector<std::string> kinds;
  kinds.reserve(std::size(schema::list_kind_rows));
  for (auto const& row : schema::list_kind_rows) kinds.emplace_back(row.word);
  command_line.value("--kind", "KIND", options.kind, says::option_kind, std::move(kinds));
  command_line.value("--build", "VERSION", options.build, says::option_build);
}

void declare_checking(CommandLine& command_line, CheckingOptions& options) {
  declare_control(command_line, options);
  command_line.choice("--format",
                      {{"text", FindingFormat::text},
                       {"json", FindingFormat::json},
                       {"jsonl", FindingFormat::jsonl},
                       {"sarif", FindingFormat::sarif},
                       {"github", FindingFormat::github},
                       {"gitlab", FindingFormat::gitlab},
                       {"junit", FindingFormat::junit}},
                      options.format, says::option_finding_format);
  command_line.flag("--werror", options.werror, says::option_werror);
  command_line.values("--disable", "CODE[,CODE]", options.disabled, says::option_disable);
  declare_schema(command_line, options.schema_files);
  command_line.flag("--pedantic", options.pedantic, says::option_pedantic);
  declare_threads(command_line, options.threads);
  command_line.flag("-q,--quiet", options.quiet, says::option_quiet);
}

void declare_alone(CommandLine& command_line, bool& alone) {
  command_line.flag("--alone", alone, says::option_alone);
}

void declare_schema(CommandLine& command_line, std::vector<std::string>& files) {
  command_line.values("--schema", "FILE", files, says::option_schema);
}

void declare_threads(CommandLine& command_line, std::optional<std::string>& threads) {
  command_line.value("-j,--jobs", "N", threads, says::option_jobs);
}

}  // namespace axisc::cli
