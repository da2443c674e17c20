#include "diagnostics/writers/writers.hpp"
#include "support/catch.hpp"

using namespace axisc;

TEST_CASE("the summary counts files and findings") {
  auto const english = [](std::size_t files, FindingCounts const& counts) {
    return write_text_summary(files, counts, {.language = Language::english});
  };
  CHECK(english(2, {.errors = 3, .warnings = 1}) == "2 files: 3 errors, 1 warning\n");
  CHECK(english(1, {.errors = 1, .warnings = 2, .notes = 1}) == "1 file: 1 error, 2 warnings, 1 note\n");
  CHECK(english(1, {.notes = 5}) == "1 file: 5 notes\n");
  CHECK(english(1, {}) == "1 file: no findings\n");
  CHECK(english(0, {}) == "0 files: no findings\n");
  CHECK(write_text_summary(2, {}, {}, 1) == "2 files: 1 input could not be checked\n");
  CHECK(write_text_summary(2, {.errors = 1}, {.language = Language::german}, 3) ==
        "2 Dateien: 1 Fehler, 3 Eingaben waren nicht prüfbar\n");
}

TEST_CASE("the summary in German") {
  auto const german = [](std::size_t files, FindingCounts const& counts) {
    return write_text_summary(files, counts, {.language = Language::german});
  };
  CHECK(german(2, {.errors = 3, .warnings = 1}) == "2 Dateien: 3 Fehler, 1 Warnung\n");
  CHECK(german(1, {.errors = 1, .warnings = 2, .notes = 1}) == "1 Datei: 1 Fehler, 2 Warnungen, 1 Hinweis\n");
  CHECK(german(1, {.notes = 2}) == "1 Datei: 2 Hinweise\n");
  CHECK(german(7, {}) == "7 Dateien: keine Befunde\n");
}

TEST_CASE("the summary in colour") {
  CHECK(write_text_summary(1, {.errors = 1, .warnings = 1}, {.color = true}) ==
        "1 file: \x1b[1;31m1 error\x1b[0m, \x1b[1;33m1 warning\x1b[0m\n");
}
