#include "cli/failure_line.hpp"

#include "cli/codes.hpp"
#include "cli/failure.hpp"
#include "cli/sentences.hpp"
#include "configuration/files.hpp"

#include <exception>
#include <new>

namespace axisc::cli::says {

constexpr Sentence changed{
    "cannot read {file}: it changed while it was read; run the command again when no program is writing to "
    "it",
    "{file} ist nicht lesbar: sie wurde beim Lesen geändert; den Befehl wiederholen, wenn kein Programm mehr "
    "in sie schreibt"};
constexpr Sentence no_memory{
    "out of memory; close other programs or check fewer files at once",
    "kein Arbeitsspeicher mehr; andere Programme schließen oder weniger Dateien auf einmal prüfen"};

}  // namespace axisc::cli::says

namespace axisc::cli {

std::string failure_line(Language language) {
  try {
    throw;
  } catch (Failure const& failure) {
    return failure.line(language);
  } catch (configuration::SourceChanged const& changed) {
    return Failure({.sentence = cli::says::changed, .arguments = {{"file", changed.path()}}}, cannot_read)
        .line(language);
  } catch (std::bad_alloc const&) {
    return Failure({.sentence = cli::says::no_memory, .arguments = {}}).line(language);
  } catch (std::exception const& error) {
    return Failure({.sentence = cli::says::unexpected, .arguments = {{"reason", error.what()}}})
        .line(language);
  }
}

}  // namespace axisc::cli
