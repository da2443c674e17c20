#include "cli/formats/parameter_facts.hpp"

#include "cli/options/quantities.hpp"
#include "diagnostics/format_number.hpp"
#include "validator/engine/rule.hpp"

#include <array>
#include <utility>

namespace axisc::cli::says {

constexpr Sentence explain_manual_filter{"Axis filters, section 3.2", "Achsfilter, Abschnitt 3.2"};
constexpr Sentence explain_manual_interface{"Axis filters, section 3.3", "Achsfilter, Abschnitt 3.3"};
constexpr Sentence explain_manual_fir{"FIR filters, section 6.2", "FIR-Filter, Abschnitt 6.2"};
constexpr Sentence explain_manual_position_control{"Improved Position Control, section 4.2",
                                                   "Optimierte Lageregelung, Abschnitt 4.2"};

}  // namespace axisc::cli::says

namespace axisc::cli {

namespace {

/// Parameters by the beginning of their names; the first that fits counts.
constexpr std::array<std::pair<std::string_view, SentenceRef>, 7> manuals = {{
    {"filter_fir.", says::explain_manual_fir},
    {"filter[", says::explain_manual_filter},
    {"lr_param.add_interface.", says::explain_manual_interface},
    {"lr_param.improved_position_control.", says::explain_manual_position_control},
    {"antr.v_reso_", says::explain_manual_position_control},
    {"antr.v_time_base", says::explain_manual_position_control},
    {"getriebe[].multi_gain_", says::explain_manual_position_control},
}};

/// `filter[0].order` and `filter[i].order` become `filter[].order`.
std::string without_indices(std::string_view text) {
  std::string result;
  bool inside = false;
  for (char const character : text) {
    inside = inside && character != ']';
    if (!inside) result += character;
    inside = inside || character == '[';
  }
  return result;
}

/// The page names the parameter itself, not a longer name that it is part of.
bool names(std::string_view text, std::string_view name) {
  constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_.[]-";
  for (auto at = text.find(name); at != std::string_view::npos; at = text.find(name, at + 1)) {
    bool const begins = at == 0 || letters.find(text[at - 1]) == std::string_view::npos;
    auto const behind = text.substr(at + name.size(), 2);
    bool const full_stop =
        behind.size() == 2 && behind[0] == '.' && letters.find(behind[1]) == std::string_view::npos;
    bool const ends = behind.empty() || full_stop || letters.find(behind[0]) == std::string_view::npos;
    if (begins && ends) return true;
  }
  return false;
}

struct RulePage {
  Code code{};
  std::string text;
};

std::vector<RulePage> read_pages() {
  std::vector<RulePage> pages;
  for (auto const& rule : validator::rules()) {
    pages.push_back({.code = rule.code, .text = without_indices(page(rule).in(Language::english))});
  }
  return pages;
}

}  // namespace

std::vector<std::string> rules_about(schema::Parameter const& parameter) {
  std::vector<std::string> codes;
  auto const number = schema::p_axis_text(parameter.p_axis);
  bool const numeric = parameter.type != schema::DataType::string && !parameter.is_enumeration();
  bool const limited = parameter.minimum.kind == schema::Limit::Kind::number ||
                       parameter.maximum.kind == schema::Limit::Kind::number;
  bool const limited_by_parameter = parameter.minimum.kind == schema::Limit::Kind::parameter ||
                                    parameter.maximum.kind == schema::Limit::Kind::parameter;
  static std::vector<RulePage> const pages = read_pages();
  for (auto const& [code, text] : pages) {
    bool about = names(text, parameter.name) || (parameter.p_axis != 0 && names(text, number));
    switch (static_cast<unsigned>(code)) {
      case 2002:
      case 2003:
        about = true;
        break;
      case 2004:
        about = schema::is_integer(parameter.type);
        break;
      case 2005:
        about = numeric && limited;
        break;
      case 2007:
        about = parameter.is_enumeration();
        break;
      case 2008:
        about = parameter.max_length > 0;
        break;
      case 2009:
        about = !parameter.axis_types.empty();
        break;
      case 2015:
        about = limited_by_parameter;
        break;
      case 2016:
        about = !parameter.since.empty();
        break;
      default:
        break;
    }
    if (about) codes.push_back(code_text(code));
  }
  return codes;
}

std::string default_text(schema::Parameter const& parameter) {
  auto const number =
      parameter.type == schema::DataType::string ? std::nullopt : parse_finite(parameter.default_text);
  return number ? format_exact(*number) : std::string(parameter.default_text);
}

std::string manual_section(schema::Parameter const& parameter, Language language) {
  for (auto const& [beginning, text] : manuals) {
    if (parameter.name.substr(0, beginning.size()) == beginning) {
      return render({.sentence = text, .arguments = {}}, language);
    }
  }
  return {};
}

}  // namespace axisc::cli
