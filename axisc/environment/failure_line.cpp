#include "axisc/environment/failure_line.hpp"

#include "axisc/environment/codes.hpp"
#include "axisc/environment/failure.hpp"
#include "axisc/environment/sentences.hpp"
#include "configuration/files.hpp"

#include <exception>
#include <new>

namespace axisc::says {

constexpr Sentence changed{
    "cannot read {file}: it changed while it was read; run the command again when no program is writing to "
    "it",
    "{file} ist nicht lesbar: sie wurde beim Lesen geändert; den Befehl wiederholen, wenn kein Programm mehr "
    "in sie schreibt"};
constexpr Sentence no_memory{
    "out of memory; close other programs or check fewer files at once",
    "kein Arbeitsspeicher mehr; andere Programme schließen oder weniger Dateien auf einmal prüfen"};

}  // namespace axisc::says

namespace axisc {

std::string failure_line(Language language) {
  try {
    throw;
  } catch (Failure const& failure) {
    return failure.line(language);
  } catch (configuration::SourceChanged const& changed) {
    return Failure({says::changed, {{"file", changed.path()}}}, cannot_read).line(language);
  } catch (std::bad_alloc const&) {
    return Failure({says::no_memory}).line(language);
  } catch (std::exception const& error) {
    return Failure({says::unexpected, {{"reason", error.what()}}}).line(language);
  }
}

}  // namespace axisc
