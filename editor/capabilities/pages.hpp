// The pages about a machine that a client shows, and the line above each cascade of filters.
#pragma once

#include "axisc/workspace/workspace.hpp"
#include "configuration/files.hpp"
#include "diagnostics/message.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace axisc::editor {

struct Page {
  std::string title;
  std::string html;  ///< a whole document
  /// Digests of inline scripts for a content security policy. They are computed from the program, not from
  /// the document: a script that a list smuggled in has none.
  std::vector<std::string> script_digests = {};
};

struct PageSubject {
  configuration::Files& files;      ///< with unsaved documents
  std::string machine;              ///< the input
  std::optional<std::string> axis;  ///< that the document configures
  std::vector<std::string> words;   ///< further arguments of the command
  Language language = Language::english;
  OptionsOf const& options;
};

struct PageCommand {
  std::string_view name;
  Page (*page)(PageSubject const&);
};

/// `axisc.report`, `axisc.plot KIND`, `axisc.machine` and `axisc.explain CODE`. They throw RequestRefused if
/// there is no page.
[[nodiscard]] std::span<PageCommand const> page_commands();

/// "delay 12.4 ms, 0.35 mm at a corner at 60000 mm/min" for the axis, or for each axis if none is named; or
/// the reason why there are no figures.
[[nodiscard]] std::string cascade_line(PageSubject const& subject);

}  // namespace axisc::editor
