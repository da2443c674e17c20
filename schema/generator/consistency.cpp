#include "schema/generator/consistency.hpp"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace axisc::schema::generator {
namespace {

constexpr std::string_view reference_prefix = "P-AXIS-";

std::size_t index_count(std::string_view name) {
  return static_cast<std::size_t>(std::count(name.begin(), name.end(), '['));
}

bool is_integer(std::string_view text, bool is_signed) {
  if (is_signed && text.starts_with("-")) text.remove_prefix(1);
  int const base = text.starts_with("0x") ? 16 : 10;
  if (base == 16) text.remove_prefix(2);
  std::uint64_t value = 0;
  auto const [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
  return error == std::errc{} && stop == text.data() + text.size();
}

bool is_real(std::string_view text) {
  double value = 0;
  auto const [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && stop == text.data() + text.size();
}

class Checker {
 public:
  explicit Checker(std::vector<ParameterData> const& parameters) : parameters_(parameters) {
    for (ParameterData const& parameter : parameters) {
      if (parameter.p_axis != 0) numbers_.insert(parameter.p_axis);
    }
  }

  std::string check() && {
    for (ParameterData const& parameter : parameters_) {
      current_ = &parameter;
      if (!names_.insert(parameter.name).second) complain("name stands twice");
      if (index_count(parameter.name) != parameter.array.size()) {
        complain("array sizes do not match the [] of the name");
      }
      check_limits();
      check_symbols();
      if (parameter.default_text) check_default(*parameter.default_text);
      if (parameter.max_length != 0 && parameter.type != "STRING") complain("max_length is for strings");
    }
    return std::move(complaints_);
  }

 private:
  void complain(std::string const& what) { complaints_ += current_->name + ": " + what + "\n"; }

  void check_limits() {
    auto const& minimum = current_->minimum;
    auto const& maximum = current_->maximum;
    if ((minimum || maximum) && (current_->type == "STRING" || current_->type == "BOOLEAN")) {
      complain("limits are for numbers");
    }
    for (auto const* limit : {&minimum, &maximum}) {
      if (*limit && !(*limit)->number && !numbers_.contains((*limit)->p_axis)) {
        complain("a limit names no parameter");
      }
    }
    if (minimum && maximum && minimum->number && maximum->number && *minimum->number > *maximum->number) {
      complain("the minimum is above the maximum");
    }
  }

  void check_symbols() {
    if (!current_->symbols.empty() && current_->type != "STRING" && current_->type != "BOOLEAN") {
      complain("symbols are for strings and booleans");
    }
    std::set<std::string> words;
    for (SymbolData const& symbol : current_->symbols) {
      if (!words.insert(symbol.word).second) complain("the symbol " + symbol.word + " stands twice");
    }
  }

  void check_default(std::string const& text) {
    if (text.starts_with(reference_prefix)) {
      std::uint16_t number = 0;
      std::from_chars(text.data() + reference_prefix.size(), text.data() + text.size(), number);
      if (!numbers_.contains(number)) complain("the default names no parameter");
      return;
    }
    if (!is_value_of_type(text)) complain("the default \"" + text + "\" is no value of the type");
  }

  [[nodiscard]] bool is_value_of_type(std::string const& text) const {
    if (!current_->symbols.empty()) {
      auto const is_text = [&text](SymbolData const& symbol) { return symbol.word == text; };
      bool const known = std::any_of(current_->symbols.begin(), current_->symbols.end(), is_text);
      // A set of flags has "none" as its default, which is a number and no word.
      return known || (current_->type == "STRING" && is_integer(text, false));
    }
    if (current_->type == "STRING") return true;
    return current_->type == "REAL64" ? is_real(text) : is_integer(text, current_->type.starts_with("SGN"));
  }

  std::vector<ParameterData> const& parameters_;
  ParameterData const* current_ = nullptr;
  std::set<std::uint16_t> numbers_;
  std::set<std::string> names_;
  std::string complaints_;
};

}  // namespace

void check_consistency(std::vector<ParameterData> const& parameters) {
  std::string const complaints = Checker(parameters).check();
  if (!complaints.empty()) throw DataError(complaints);
}

}  // namespace axisc::schema::generator
