// Reading and judging lists, in one thread and without any file: bench/README.md.
//
//   bench_lists [--lists N] [--rounds N]         the comparison
//   bench_lists --only WORDS                     those whose name contains the words, for a profiler
//   bench_lists --write FOLDER --lists N         the lists as files, for bench/process.py
#include "grammar/axis_list.hpp"
#include "lists/generator.hpp"
#include "lists/readers.hpp"
#include "lists/rounds.hpp"
#include "validator/check.hpp"
#include "validator/engine/rule.hpp"
#include "validator/values/line_value.hpp"
#include "validator/values/list_reader.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace axisc::bench {
namespace {

struct Fleet {
  std::vector<GeneratedList> lists;
  std::vector<std::string> json, ini, mistakes;
  std::size_t pairs = 0;
};

Fleet make_fleet(std::size_t count) {
  Fleet fleet{.lists = generate_lists(count), .json = {}, .ini = {}, .mistakes = {}, .pairs = 0};
  for (GeneratedList const& list : fleet.lists) {
    // With room behind it, as simdjson wants it.
    std::string& json = fleet.json.emplace_back(as_json(list));
    json.reserve(json.size() + 64);
    fleet.ini.push_back(as_ini(list));
    fleet.mistakes.push_back(with_mistakes(list));
    fleet.pairs += list.entries.size();
  }
  return fleet;
}

template <class Texts>
std::size_t size_of(Texts const& texts) {
  std::size_t size = 0;
  for (std::string const& text : texts) size += text.size();
  return size;
}

validator::CheckOptions all_rules() {
  validator::CheckOptions options;
  options.cycle_time = design::CycleTime{};
  options.machine = false;
  return options;
}

/// Text, syntax and single parameters: what the other readers do as well.
validator::CheckOptions single_parameters() {
  validator::CheckOptions options = all_rules();
  for (validator::Rule const& rule : validator::rules()) {
    if (static_cast<std::uint16_t>(rule.code) >= 3000) options.disabled.push_back(rule.code);
  }
  return options;
}

/// A file that was read already, as the texts of the other readers were: it is handed over and not copied.
class ReadFile final : public configuration::Files {
 public:
  explicit ReadFile(std::string& content) : content_(content) {}
  std::variant<std::string, configuration::FileError> read(std::string const& /*path*/) override {
    return std::move(content_);
  }

 private:
  std::string& content_;
};

/// As commands do: each finding is put into words and gone before the next. `text` is moved to `sources`.
template <typename Take>
void check(std::string& text, validator::CheckOptions const& options, SourceSet& sources, Take take) {
  static std::string const path("x.lis");
  ReadFile file(text);
  (void)validator::check(file, path, options, sources, take);
}

std::size_t findings = 0;  ///< so that nothing is optimised away

/// Texts that a check moves out of, and where it moves them: copied before it and freed behind it, for other
/// readers find and leave theirs as well.
struct ReadFiles {
  std::vector<std::string> files;
  std::deque<SourceSet> sources;

  void read(std::vector<std::string> const& texts) {
    sources.clear();
    files = texts;
  }
  void check_all(validator::CheckOptions const& options) {
    for (std::string& file : files) {
      check(file, options, sources.emplace_back(),
            [](Finding const& finding) { findings += finding.message.arguments.size(); });
    }
  }
};

/// How often each code is found: a made-up fleet should be sound.
void print_codes(char const* title, std::vector<std::string> texts) {
  std::map<Code, std::size_t> counts;
  SourceSet sources;
  for (std::string& text : texts) {
    check(text, all_rules(), sources, [&counts](Finding const& finding) { ++counts[finding.code]; });
  }
  std::printf("%s:", title);
  for (auto const& [code, count] : counts) std::printf(" %s %zu", code_text(code).c_str(), count);
  std::printf("\n");
}

/// The readers agree about every pair.
bool agree(Fleet const& fleet, std::vector<std::string> const& texts) {
  EntryTable by_hand, other;
  Simdjson simdjson;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    read_by_hand(texts[i], by_hand);
    for (CheckedEntry const& entry : by_hand.entries()) {
      if (entry.verdict != Verdict::good) return false;
    }
    simdjson.read_on_demand(fleet.json[i], other);
    auto const same = [](CheckedEntry const& a, CheckedEntry const& b) {
      return a.slot == b.slot && a.number == b.number && a.verdict == b.verdict;
    };
    if (!std::equal(by_hand.entries().begin(), by_hand.entries().end(), other.entries().begin(),
                    other.entries().end(), same)) {
      return false;
    }
  }
  return true;
}

void compare(std::size_t count, std::size_t rounds, std::string_view only) {
  Fleet const fleet = make_fleet(count);
  std::vector<std::string> texts;
  for (GeneratedList const& list : fleet.lists) texts.push_back(list.text);
  std::printf("%zu lists, %zu bytes, %zu pairs\n", count, size_of(texts), fleet.pairs);
  if (only.empty()) print_codes("sound lists", texts);
  if (!agree(fleet, texts)) std::printf("the readers do not agree\n");

  EntryTable table;
  Simdjson simdjson;
  auto const ranges = single_parameters();
  auto const all = all_rules();
  auto const reading = [&](char const* name, std::vector<std::string> const& inputs, auto read) {
    auto const run = [&inputs, read] {
      for (std::string const& input : inputs) read(input);
    };
    return Contender{name, size_of(inputs), fleet.pairs, run};
  };
  auto const parse = [](std::string const& text) {
    findings += grammar::parse_axis_list(text, 0, false).lines;
  };
  std::vector<SourceText> sources;
  for (std::string const& text : texts) sources.emplace_back("x.lis", text);
  auto const values = [&](char const* name, auto read) {
    auto const run = [&sources, read] {
      for (SourceText const& source : sources) findings += read(source).tree.lines;
    };
    return Contender{name, size_of(texts), fleet.pairs, run};
  };
  ReadFiles files;
  auto const whole_check = [&](char const* name, std::vector<std::string> const& inputs,
                               validator::CheckOptions const& options) {
    return Contender{name, size_of(inputs), fleet.pairs, [&] { files.check_all(options); },
                     [&] { files.read(inputs); }};
  };
  std::vector<Contender> contenders = {
      reading("scanner by hand", texts, [&](std::string const& file) { read_by_hand(file, table); }),
      reading("axisc, grammar alone", texts, parse),
      values("axisc, values, by the grammar",
             [](SourceText const& source) {
               return validator::judge_list(source, grammar::parse_axis_list(source));
             }),
      values("axisc, values", [](SourceText const& source) { return validator::read_list(source); }),
      whole_check("axisc, single parameters", texts, ranges),
      whole_check("axisc, all rules", texts, all),
      reading("inih", fleet.ini, [&](std::string const& file) { read_with_inih(file, table); }),
      reading("nlohmann-json", fleet.json, [&](std::string const& file) { read_with_nlohmann(file, table); }),
      reading("simdjson, document", fleet.json,
              [&](std::string const& file) { simdjson.read_document(file, table); }),
      reading("simdjson, on demand", fleet.json,
              [&](std::string const& file) { simdjson.read_on_demand(file, table); }),
  };
  std::erase_if(contenders, [only](Contender const& contender) {
    return std::string_view(contender.name).find(only) == std::string_view::npos;
  });
  if (!contenders.empty()) measure(contenders, 0, rounds, "pairs/s");

  if (only.empty() || only == "mistakes") print_codes("a mistake in every line", fleet.mistakes);
  std::vector<Contender> const storm = {
      whole_check("axisc, all rules, sound", texts, all),
      whole_check("axisc, all rules, mistakes", fleet.mistakes, all),
  };
  if (only.empty() || only == "mistakes") measure(storm, 0, rounds, "lines/s");
}

void write_file(std::filesystem::path const& path, std::string const& text) {
  std::ofstream(path, std::ios::binary) << text;
}

void write_fleet(std::filesystem::path const& folder, std::size_t count) {
  for (char const* const kind : {"lists", "trees", "mistakes"}) {
    std::filesystem::create_directories(folder / kind);
  }
  for (std::size_t number = 0; number < count; ++number) {
    GeneratedList const list = generate_list(number);
    std::string const name = std::to_string(number);
    write_file((folder / "lists" / name) += ".lis", list.text);
    write_file((folder / "trees" / name) += ".dts", as_device_tree(list));
    write_file((folder / "mistakes" / name) += ".lis", with_mistakes(list));
  }
}

}  // namespace
}  // namespace axisc::bench

int main(int argc, char** argv) {
  using namespace axisc::bench;
#if defined(__GLIBC__)
  // As the program does: memory that one list needed waits for the next one.
  mallopt(M_TRIM_THRESHOLD, 1 << 26);
  mallopt(M_MMAP_THRESHOLD, 1 << 26);
#endif
  std::size_t lists = 200, rounds = 9;
  char const* folder = nullptr;
  std::string_view only;
  for (int i = 1; i + 1 < argc; i += 2) {
    std::string_view const option = argv[i];
    if (option == "--lists") lists = std::strtoul(argv[i + 1], nullptr, 10);
    if (option == "--rounds") rounds = std::strtoul(argv[i + 1], nullptr, 10);
    if (option == "--only") only = argv[i + 1];
    if (option == "--write") folder = argv[i + 1];
  }
  if (folder == nullptr) {
    compare(lists, rounds, only);
  } else {
    write_fleet(folder, lists);
  }
  return 0;
}
