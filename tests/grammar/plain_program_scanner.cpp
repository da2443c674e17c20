#include "grammar/plain_program_scanner.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace axisc::test {
namespace {

using namespace grammar;

bool is_digit(char c) {
  return '0' <= c && c <= '9';
}
bool is_letter(char c) {
  return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || c == '_';
}
bool is_word(char c) {
  return is_digit(c) || is_letter(c);
}

/// One byte of a block; comments have become blanks that remember it.
struct Character {
  char byte = ' ';
  bool comment = false;
  bool text = false;  ///< inside quotes, the opening one included
  std::uint32_t offset = 0;
  std::uint32_t line = 0;
};

using Characters = std::vector<Character>;

/// The line with its comments turned to blanks, their spans in `comments`.
Characters characters_of(std::string_view bytes, std::size_t begin, std::size_t end, std::uint32_t line,
                         std::vector<Span>& comments) {
  Characters result;
  int depth = 0;
  bool semicolon = false;
  bool quoted = false;
  for (std::size_t i = begin; i < end; ++i) {
    char const byte = bytes[i];
    Character one{.byte = byte, .offset = static_cast<std::uint32_t>(i), .line = line};
    bool const in_comment = semicolon || depth > 0;
    if (!in_comment && byte == '"') {
      quoted = !quoted;
      one.text = quoted;
    } else if (!in_comment && quoted) {
      one.text = true;
    } else if (in_comment || byte == '(' || byte == ';') {
      if (!in_comment) comments.push_back({.begin = one.offset, .end = one.offset});
      if (!in_comment && byte == ';') semicolon = true;
      if (!semicolon && byte == '(') ++depth;
      if (!semicolon && byte == ')') --depth;
      comments.back().end = one.offset + 1;
      one.byte = ' ';
      one.comment = true;
    }
    result.push_back(one);
  }
  return result;
}

class BlockScanner {
 public:
  BlockScanner(Characters const& block, std::string_view bytes, ProgramListener& listener)
      : block_(block), bytes_(bytes), listener_(listener) {}

  void scan() {
    bool at_start = true;
    for (skip_gap(); position_ < block_.size(); skip_gap()) {
      if (at(position_) == '#') {
        command();
        at_start = false;
        continue;
      }
      std::size_t const begin = position_;
      WordKind const kind = word(at_start);
      at_start = kind == WordKind::skip;
      listener_.word({.kind = kind, .span = span(begin, position_), .line = block_[begin].line});
    }
  }

 private:
  /// 0 behind the end.
  [[nodiscard]] char at(std::size_t index) const { return index < block_.size() ? block_[index].byte : '\0'; }
  [[nodiscard]] static bool is_gap(char c) { return c == ' ' || c == '\t' || c == '\n'; }
  [[nodiscard]] bool ends_value(std::size_t index) const {
    return index >= block_.size() || is_gap(at(index)) ||
           std::string_view("[]=\"").find(at(index)) != std::string_view::npos;
  }

  void skip_gap() {
    while (position_ < block_.size() && is_gap(at(position_))) ++position_;
  }

  [[nodiscard]] Span span(std::size_t begin, std::size_t end) const {
    std::uint32_t const first = begin < block_.size() ? block_[begin].offset : block_.back().offset + 1;
    return {.begin = first, .end = end == begin ? first : block_[end - 1].offset + 1};
  }
  [[nodiscard]] std::string_view view(Span span) const { return bytes_.substr(span.begin, span.size()); }

  [[nodiscard]] std::size_t digits(std::size_t index) const {
    while (is_digit(at(index))) ++index;
    return index;
  }
  [[nodiscard]] std::size_t identifier(std::size_t index) const {
    if (!is_letter(at(index))) return index;
    while (is_word(at(index))) ++index;
    return index;
  }
  /// Behind `-1.5`, `.5`, `5.`; `index` where there is none.
  [[nodiscard]] std::size_t coordinate(std::size_t index) const {
    std::size_t const begin = at(index) == '+' || at(index) == '-' ? index + 1 : index;
    std::size_t const whole = digits(begin);
    if (at(whole) == '.') {
      std::size_t const fraction = digits(whole + 1);
      if (whole > begin || fraction > whole + 1) return fraction;
    }
    return whole > begin ? whole : index;
  }

  WordKind word(bool at_start) {
    char const first = at(position_);
    if (at_start && first == '/') {
      position_ = digits(position_ + 1);
      return WordKind::skip;
    }
    if (at_start && first == 'N' && is_digit(at(position_ + 1))) {
      position_ = digits(position_ + 1);
      return WordKind::block_number;
    }
    if (is_letter(first)) return address_or_name();
    if (std::size_t const end = coordinate(position_); end > position_) {
      position_ = end;
      return WordKind::number;
    }
    if (first == '"') {
      ++position_;
      while (position_ < block_.size() && block_[position_].text) ++position_;
      if (at(position_) == '"') ++position_;
      return WordKind::text;
    }
    if (first == '%') return title();
    if (first == '$' && is_letter(at(position_ + 1))) {
      position_ = identifier(position_ + 1);
      return WordKind::control;
    }
    ++position_;
    return WordKind::other;
  }

  WordKind address_or_name() {
    std::size_t const number = coordinate(position_ + 1);
    if (number > position_ + 1 && at(number) != '=') {
      position_ = number;
      return WordKind::address;
    }
    position_ = identifier(position_);
    while (at(position_) == '.' && is_letter(at(position_ + 1))) position_ = identifier(position_ + 1);
    return WordKind::name;
  }

  WordKind title() {
    std::size_t end = ++position_;
    for (std::size_t i = position_; i < block_.size(); ++i) {
      if (block_[i].comment || at(i) == '\n' || at(i) == '"') break;
      if (at(i) != ' ' && at(i) != '\t') end = i + 1;
    }
    position_ = end;
    return WordKind::program;
  }

  /// Behind the word, in any letter case; `index` where it does not stand there.
  [[nodiscard]] std::size_t spelled(std::size_t index, std::string_view word, bool any_case) const {
    std::size_t i = index;
    for (char const c : word) {
      char const lower = static_cast<char>(c - 'A' + 'a');
      if (at(i) != c && !(any_case && at(i) == lower)) return index;
      ++i;
    }
    return i;
  }
  /// The same for `first blanks second`, as whole words; a comment is no blank here.
  [[nodiscard]] std::size_t spelled(std::size_t index, std::string_view first, std::string_view second,
                                    bool any_case) const {
    std::size_t const gap = spelled(index, first, any_case);
    if (gap == index) return index;
    std::size_t i = gap;
    while (is_gap(at(i)) && !block_[i].comment) ++i;
    std::size_t const end = spelled(i, second, any_case);
    return i == gap || end == i || is_word(at(end)) ? index : end;
  }

  void command() {
    std::size_t const begin = position_++;
    NcCommand command;
    command.line = block_[begin].line;
    std::size_t end = spelled(position_, "FILTER", true);
    if (end > position_ && !is_word(at(end))) {
      command.kind = CommandKind::filter;
    } else if (end = spelled(position_, "VIB", "GUARD", true); end > position_) {
      command.kind = CommandKind::vibration_guard;
    } else if (end = exchange(); end > position_) {
      command.kind = CommandKind::axis_exchange;
    } else {
      end = position_;
      while (is_word(at(end))) ++end;
    }
    position_ = end;
    command.name = span(begin, end);
    if (command.kind == CommandKind::filter || command.kind == CommandKind::vibration_guard) {
      for (char const c : view(command.name)) {
        if ('a' <= c && c <= 'z') problem(command, CommandProblemKind::letter_case, command.name);
      }
      body(command);
    }
    listener_.command(std::move(command));
  }

  [[nodiscard]] std::size_t exchange() const {
    for (std::string_view const verb : {"CALL", "PUT", "SET"}) {
      std::size_t const end = spelled(position_, verb, "AX", false);
      if (end == position_) continue;
      std::size_t link = end;
      while (is_gap(at(link))) ++link;
      std::size_t const behind = spelled(link, "LINK", false);
      return behind > link && !is_word(at(behind)) ? position_ : end;
    }
    return position_;
  }

  static void problem(NcCommand& command, CommandProblemKind kind, Span span) {
    if (!command.problem) command.problem = CommandProblem{.kind = kind, .span = span};
  }

  [[nodiscard]] Span token(std::size_t begin) const {
    std::size_t end = begin + 1;
    if (at(begin) == '"') {
      while (end < block_.size() && block_[end].text) ++end;
      if (at(end) == '"') ++end;
    } else {
      while (!ends_value(end)) ++end;
    }
    return span(begin, end);
  }

  void body(NcCommand& command) {
    skip_gap();
    for (auto const& [name, value] :
         {std::pair("ON", CommandSwitch::on), std::pair("OFF", CommandSwitch::off)}) {
      std::size_t const end = spelled(position_, name, false);
      if (end == position_ || is_word(at(end))) continue;
      command.command_switch = value;
      position_ = end;
      break;
    }
    skip_gap();
    if (at(position_) == '[' && !brackets(command)) return;
    skip_gap();
    if (position_ < block_.size()) {
      problem(command, CommandProblemKind::unexpected_text, token(position_));
    }
  }

  bool brackets(NcCommand& command) {
    std::size_t const opening = position_++;
    skip_gap();
    while (is_letter(at(position_))) {
      Keyword keyword;
      std::size_t const begin = position_;
      position_ = identifier(position_);
      keyword.name = span(begin, position_);
      skip_gap();
      if (at(position_) == '=') {
        ++position_;
        skip_gap();
        value(keyword);
      }
      command.keywords.push_back(keyword);
      skip_gap();
    }
    if (at(position_) == ']') {
      ++position_;
      return true;
    }
    if (position_ < block_.size()) {
      problem(command, CommandProblemKind::expected_keyword, token(position_));
    } else {
      problem(command, CommandProblemKind::unclosed_bracket, span(opening, opening + 1));
    }
    return false;
  }

  void value(Keyword& keyword) {
    std::size_t const begin = position_;
    std::size_t next = identifier(begin);
    bool const is_name = next > begin;
    while (is_gap(at(next)) && next < block_.size()) ++next;
    std::size_t end = begin;
    if ((is_name && at(next) == '=') || ends_value(begin)) {
      keyword.kind = KeywordValue::missing;
    } else if (std::size_t const variable = variable_end(begin); variable > begin) {
      keyword.kind = KeywordValue::variable;
      end = variable;
    } else {
      while (!ends_value(end)) ++end;
      keyword.kind = number_kind(begin, end);
    }
    keyword.value = span(begin, end);
    position_ = end;
  }

  [[nodiscard]] KeywordValue number_kind(std::size_t begin, std::size_t end) const {
    std::size_t const number = coordinate(begin);
    if (number == begin) return KeywordValue::malformed;
    bool has_point = false;
    for (std::size_t i = begin; i < number; ++i) has_point = has_point || at(i) == '.';
    if (number == end) return has_point ? KeywordValue::real : KeywordValue::integer;
    if (at(number) != 'e' && at(number) != 'E') return KeywordValue::malformed;
    std::size_t const sign = at(number + 1) == '+' || at(number + 1) == '-' ? number + 2 : number + 1;
    return digits(sign) == end && sign < end ? KeywordValue::real : KeywordValue::malformed;
  }

  /// Behind `P10` or `V.P.A[2]` that ends like a value; `begin` for anything else.
  [[nodiscard]] std::size_t variable_end(std::size_t begin) const {
    std::size_t end = begin;
    if (at(begin) == 'P' && is_digit(at(begin + 1))) {
      end = digits(begin + 1);
    } else if (at(begin) == 'V' && at(begin + 1) == '.' && is_letter(at(begin + 2))) {
      end = begin + 1;
      while (at(end) == '.' && is_letter(at(end + 1))) {
        end = identifier(end + 1);
        while (at(end) == '[' && is_digit(at(end + 1)) && at(digits(end + 1)) == ']')
          end = digits(end + 1) + 1;
      }
    }
    return ends_value(end) ? end : begin;
  }

  Characters const& block_;
  std::string_view bytes_;
  ProgramListener& listener_;
  std::size_t position_ = 0;
};

/// Blanks, and at most one block number.
std::size_t behind_number(Characters const& line) {
  std::size_t i = 0;
  auto const skip = [&] {
    while (i < line.size() && (line[i].byte == ' ' || line[i].byte == '\t')) ++i;
  };
  skip();
  if (i + 1 < line.size() && line[i].byte == 'N' && is_digit(line[i + 1].byte)) {
    ++i;
    while (i < line.size() && is_digit(line[i].byte)) ++i;
    skip();
  }
  return i;
}

/// `#COMMENT BEGIN` or `#COMMENT END` behind the number.
bool is_comment_command(Characters const& line, std::string_view which) {
  std::size_t i = behind_number(line);
  std::string rest;
  for (; i < line.size(); ++i) rest += line[i].comment ? '\1' : line[i].byte;
  constexpr std::string_view head = "#COMMENT";
  if (rest.substr(0, head.size()) != head) return false;
  std::size_t const word = rest.find_first_not_of(" \t", head.size());
  if (word == std::string::npos || word == head.size()) return false;
  return rest.substr(word, which.size()) == which &&
         (word + which.size() == rest.size() || !is_word(rest[word + which.size()]));
}

class ProgramScanner {
 public:
  ProgramScanner(std::string_view bytes, ProgramListener& listener) : bytes_(bytes), listener_(listener) {}

  void scan() {
    for (std::size_t begin = 0; begin < bytes_.size();) {
      std::size_t end = bytes_.find('\n', begin);
      std::size_t const next = end == std::string_view::npos ? bytes_.size() : end + 1;
      if (end == std::string_view::npos) end = bytes_.size();
      if (end > begin && bytes_[end - 1] == '\r') --end;
      ++number_;
      scan_line(begin, end);
      begin = next;
    }
    finish();
  }

 private:
  void scan_line(std::size_t begin, std::size_t end) {
    std::vector<Span> comments;
    Characters line = characters_of(bytes_, begin, end, number_, comments);
    if (in_comment_) {
      in_comment_ = !is_comment_command(line, "END");
      return;
    }
    bool const says_nothing = behind_number(line) == line.size();
    for (Span const comment : comments) {
      if (bytes_.substr(comment.begin, comment.size()).find("axisc:") == std::string_view::npos) continue;
      listener_.directive({.comment = comment, .whole_line = says_nothing, .line = number_});
    }
    if (is_comment_command(line, "BEGIN")) {
      finish();
      in_comment_ = true;
      return;
    }
    std::size_t last = line.size();
    while (last > 0 && (bytes_[begin + last - 1] == ' ' || bytes_[begin + last - 1] == '\t')) --last;
    bool const goes_on = last > 0 && line[last - 1].byte == '\\' && !line[last - 1].text;
    if (goes_on) line.resize(last - 1);
    bool const stays_open = goes_on || (open_ && says_nothing);
    if (open_)
      block_.push_back({.byte = '\n', .offset = static_cast<std::uint32_t>(begin - 1), .line = number_ - 1});
    block_.insert(block_.end(), line.begin(), line.end());
    open_ = stays_open;
    if (!open_) finish();
  }

  void finish() {
    if (!block_.empty()) BlockScanner(block_, bytes_, listener_).scan();
    block_.clear();
    open_ = false;
  }

  std::string_view bytes_;
  ProgramListener& listener_;
  Characters block_;
  std::uint32_t number_ = 0;
  bool open_ = false;
  bool in_comment_ = false;
};

}  // namespace

void scan_nc_program(std::string_view bytes, ProgramListener& listener) {
  ProgramScanner(bytes, listener).scan();
}

}  // namespace axisc::test
