// The options of one command, declared one by one and then read. The parser (CLI11) is hidden behind this
// interface. Only the options that the arguments may name are declared to it: it compares each with all
// others, and declaring all options of a command would take longer than reading a list.
#pragma once

#include "cli/options/environment.hpp"
#include "diagnostics/message.hpp"

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace axisc::cli {

struct Invocation;

class CommandLine {
 public:
  /// Declares --help, --version, --lang and --color; the prose of the help is in cli/help/COMMAND.
  CommandLine(std::string_view command, Language language);
  CommandLine(CommandLine const&) = delete;
  CommandLine& operator=(CommandLine const&) = delete;
  ~CommandLine();

  // Targets must live until read() returns; the target of an option that is not given is unchanged.

  /// An argument without an option, at most one. `values` are those of a placeholder.
  void argument(std::string_view shown, std::optional<std::string>& target, SentenceRef meaning,
                std::vector<std::string> values = {});
  /// Arguments without an option, any number of them.
  void arguments(std::string_view shown, std::vector<std::string>& target, SentenceRef meaning);
  /// `names` are separated by commas: "-o,--output". `shown` is the placeholder of the value in the help, in
  /// English, or the only values: "csv|text".
  void flag(std::string_view names, bool& target, SentenceRef meaning);
  void value(std::string_view names, std::string_view shown, std::optional<std::string>& target,
             SentenceRef meaning, std::vector<std::string> values = {});
  /// A flag that may have a value, only after "=": `--fix` gives "", `--fix=all` gives "all". `shown`:
  /// "[=all]".
  void flag_with_value(std::string_view names, std::string_view shown, std::optional<std::string>& target,
                       SentenceRef meaning);
  /// An option that may be repeated.
  void values(std::string_view names, std::string_view shown, std::vector<std::string>& target,
              SentenceRef meaning);
  /// An option whose value is one of a few keywords.
  template <class Enumeration>
  void choice(std::string_view names, std::initializer_list<std::pair<std::string_view, Enumeration>> words,
              Enumeration& target, SentenceRef meaning) {
    std::vector<std::string_view> keys;
    std::vector<Enumeration> meanings;
    for (auto const& [word, value] : words) {
      keys.push_back(word);
      meanings.push_back(value);
    }
    choice_of(
        names, std::move(keys), [&target, meanings](std::size_t chosen) { target = meanings[chosen]; },
        meaning);
  }

  /// What is declared next means something only with these values of --kind, "path, plant"; empty: with all.
  void only_for(std::string_view kinds) { only_for_ = kinds; }
  /// What is declared next is refused where that option is missing, or where it is given; empty: never.
  void only_with(std::string_view option) { only_with_ = option; }
  void not_with(std::string_view option) { not_with_ = option; }
  /// Failure for an option that was given and means nothing with this kind.
  void refuse_others(std::string_view kind) const;

  /// The text to print instead of executing the command (--help, --version), or none. Failure for an invalid
  /// command line.
  [[nodiscard]] std::optional<std::string> read(std::span<std::string const> arguments);

  /// Reads the invocation's arguments; every command begins so. True if the command is done: --help or
  /// --version was printed, or the command was only to be described.
  [[nodiscard]] bool answers(Invocation const& invocation);
  /// Failure that names `argument` and the command if it was not given.
  void require(bool given, std::string_view argument) const;

  [[nodiscard]] std::string help() const;
  [[nodiscard]] ColorChoice color() const { return color_; }

 private:
  struct Parser;
  struct Declared;
  enum class Takes : std::uint8_t;

  void choice_of(std::string_view names, std::vector<std::string_view> words,
                 std::function<void(std::size_t)> take, SentenceRef meaning);
  Declared& declare(Takes takes, std::string_view names, std::string_view shown, SentenceRef meaning);
  void build(Declared& row);
  void refuse_unknown() const;
  void refuse_mixture() const;
  /// The parser's message begins with the option's name.
  [[noreturn]] void refuse_value(std::string_view complaint) const;

  std::string command_;
  std::string_view only_for_, only_with_, not_with_;
  Language language_;
  ColorChoice color_ = ColorChoice::automatic;
  bool wants_help_ = false;
  bool wants_version_ = false;
  std::unique_ptr<Parser> parser_;
};

}  // namespace axisc::cli
