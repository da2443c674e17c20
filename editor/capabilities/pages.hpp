// The pages about a machine that a client shows, and the line above each cascade of filters.
#pragma once

#include "axisc/workspace/machine_search.hpp"
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
  /// Of its inline scripts, for a content security policy. They come from the program, not from the document: a script
  /// that got into it from a list has none.
  std::vector<std::string> script_digests = {};
};

/// The subject of a page.
struct PageSubject {
  configuration::Files& files;      ///< unsaved documents count
  std::string machine;              ///< the input
  std::optional<std::string> axis;  ///< of the document
  std::vector<std::string> words;   ///< that the client adds
  Language language = Language::english;
  OptionsOf const& options;
};

struct PageCommand {
  std::string_view name;
  Page (*page)(PageSubject const&);
};

/// `axisc.report`, `axisc.plot KIND`, `axisc.machine` and `axisc.explain CODE`. RequestRefused where there is no page.
[[nodiscard]] std::span<PageCommand const> page_commands();

/// "delay 12.4 ms, 0.35 mm at a corner at 60000 mm/min" of the axis, of each axis where none is named, or the reason
/// why there is no figure.
[[nodiscard]] std::string cascade_line(PageSubject const& subject);

}  // namespace axisc::editor
