#include "diagnostics/writers/unified_diff.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace axisc {
namespace {

constexpr std::size_t context_lines = 3;
constexpr std::size_t farthest = 32;

enum class Step : std::uint8_t { keep, remove, add };

using DiffLines = std::vector<std::string_view>;

/// With their line ends.
DiffLines lines_for_diff(std::string_view text) {
  DiffLines lines;
  while (!text.empty()) {
    std::size_t const size = std::min(text.find('\n'), text.size() - 1) + 1;
    lines.push_back(text.substr(0, size));
    text.remove_prefix(size);
  }
  return lines;
}

class Comparison {
 public:
  Comparison(DiffLines const& before, DiffLines const& after) : before_(before), after_(after) {
    while (old_ < before.size() || new_ < after.size()) {
      if (equal(0, 0)) {
        step(Step::keep);
      } else {
        differ();
      }
    }
  }
  [[nodiscard]] std::vector<Step> const& steps() const { return steps_; }

 private:
  [[nodiscard]] bool equal(std::size_t skipped_old, std::size_t skipped_new) const {
    return old_ + skipped_old < before_.size() && new_ + skipped_new < after_.size() &&
           before_[old_ + skipped_old] == after_[new_ + skipped_new];
  }

  void step(Step step) {
    steps_.push_back(step);
    if (step != Step::add) ++old_;
    if (step != Step::remove) ++new_;
  }

  /// Goes to the nearest common line; if none is near, past one line on each side.
  void differ() {
    std::size_t removed = 1;
    std::size_t added = 1;
    if (before_.size() != after_.size()) find_common(removed, added);
    removed = std::min(removed, before_.size() - old_);
    added = std::min(added, after_.size() - new_);
    for (; removed > 0; --removed) step(Step::remove);
    for (; added > 0; --added) step(Step::add);
  }

  void find_common(std::size_t& removed, std::size_t& added) const {
    for (std::size_t both = 1; both <= farthest; ++both) {
      for (std::size_t first = 0; first <= both; ++first) {
        if (!equal(first, both - first)) continue;
        removed = first;
        added = both - first;
        return;
      }
    }
  }

  DiffLines const& before_;
  DiffLines const& after_;
  std::size_t old_ = 0;
  std::size_t new_ = 0;
  std::vector<Step> steps_;
};

/// Lines [begin, begin + count) of one side as a hunk names them; an empty range is the line before it.
std::string range(std::size_t begin, std::size_t count) {
  std::string const first = std::to_string(count == 0 ? begin : begin + 1);
  return count == 1 ? first : first + ',' + std::to_string(count);
}

class Writer {
 public:
  Writer(DiffLines const& before, DiffLines const& after) : before_(before), after_(after) {}

  void hunk(std::vector<Step> const& steps, std::size_t begin, std::size_t end) {
    auto const first = steps.begin() + static_cast<std::ptrdiff_t>(begin);
    auto const last = steps.begin() + static_cast<std::ptrdiff_t>(end);
    auto const without = [&](Step step) {
      return static_cast<std::size_t>((last - first) - std::count(first, last, step));
    };
    text_ += "@@ -" + range(old_, without(Step::add)) + " +" + range(new_, without(Step::remove)) + " @@\n";
    // Removed lines come before added ones, in whatever order they were found.
    for (auto step = first; step != last;) {
      auto const change_end = *step == Step::keep ? step + 1 : std::find(step, last, Step::keep);
      if (*step == Step::keep) {
        line(' ', before_[old_++]);
        ++new_;
      } else {
        for (auto i = std::count(step, change_end, Step::remove); i > 0; --i) line('-', before_[old_++]);
        for (auto i = std::count(step, change_end, Step::add); i > 0; --i) line('+', after_[new_++]);
      }
      step = change_end;
    }
  }
  void skip(std::size_t lines) {
    old_ += lines;
    new_ += lines;
  }
  std::string text() && { return std::move(text_); }

 private:
  void line(char mark, std::string_view content) {
    text_ += mark;
    text_ += content;
    if (content.back() != '\n') text_ += "\n\\ No newline at end of file\n";
  }

  DiffLines const& before_;
  DiffLines const& after_;
  std::size_t old_ = 0;
  std::size_t new_ = 0;
  std::string text_;
};

}  // namespace

std::string unified_diff(std::string_view name, std::string_view before, std::string_view after) {
  if (before == after) return {};
  DiffLines const old_lines = lines_for_diff(before);
  DiffLines const new_lines = lines_for_diff(after);
  Comparison const comparison(old_lines, new_lines);
  std::vector<Step> const& steps = comparison.steps();
  auto const is_change = [](Step step) { return step != Step::keep; };

  Writer writer(old_lines, new_lines);
  std::size_t done = 0;
  while (true) {
    auto const change =
        std::find_if(steps.begin() + static_cast<std::ptrdiff_t>(done), steps.end(), is_change);
    if (change == steps.end()) break;
    auto const at = static_cast<std::size_t>(change - steps.begin());
    std::size_t const begin = std::max(done, at - std::min(at, context_lines));
    // Changes whose contexts meet share a hunk.
    std::size_t end = at;
    for (std::size_t i = at; i < steps.size() && i <= end + 2 * context_lines; ++i) {
      if (is_change(steps[i])) end = i;
    }
    end = std::min(end + 1 + context_lines, steps.size());
    writer.skip(begin - done);
    writer.hunk(steps, begin, end);
    done = end;
  }
  std::string const file(name);
  return "--- " + file + "\n+++ " + file + "\n" + std::move(writer).text();
}

}  // namespace axisc
