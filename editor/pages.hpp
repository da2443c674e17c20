// What the program shows of a machine besides findings: pages for a preview, and a line above each cascade of filters.
#pragma once

#include "configuration/files.hpp"
#include "diagnostics/message.hpp"

#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace axisc::editor {

struct Page {
  std::string title;
  std::string html;  ///< a whole document
  /// Of its inline scripts, as a content security policy names them. They come from the program, not from the document:
  /// a script that got into it from a list has none.
  std::vector<std::string> script_digests = {};
};

/// What a page is about.
struct PageSubject {
  configuration::Files& files;      ///< unsaved documents count
  std::string machine;              ///< the input
  std::optional<std::string> axis;  ///< of the document
  std::vector<std::string> words;   ///< that the client adds
  Language language = Language::english;
};

/// Why there is no page, in the user's language.
class NoPage : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct Command {
  std::string name;  ///< `axisc.report`
  std::function<Page(PageSubject const&)> page;
};

struct Pages {
  std::vector<Command> commands;
  /// "delay 12.4 ms, 0.35 mm at a corner at 60000 mm/min" of the axis, of each where none is named, or why there is no figure.
  std::function<std::string(PageSubject const&)> cascade;
};

}  // namespace axisc::editor
