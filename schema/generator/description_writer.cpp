#include "schema/generator/description_writer.hpp"

#include "schema/generator/catalogue_data.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace axisc::schema::generator {
namespace {

using Json = nlohmann::ordered_json;

/// Compilers take no literals above 64 KiB.
constexpr std::size_t longest_literal = 60000;

class DescriptionWriter {
 public:
  DescriptionWriter(std::vector<ParameterRow> const& parameters, Json const& data) : parameters_(parameters) {
    for (Json const& row : data.at("parameters")) add(by_name_, row, row.at("name").get<std::string>());
    for (Json const& row : data.at("families")) add(families_, row, row.at("prefix").get<std::string>());
    for (ParameterRow const& parameter : parameters_) {
      names_.insert(parameter.name);
      if (auto const found = by_name_.find(parameter.name);
          found != by_name_.end() && parameter.p_axis != 0) {
        by_number_.emplace(parameter.p_axis, found->second);
      }
    }
    for (auto const& [name, row] : by_name_) {
      if (!names_.contains(name)) complain(name, "there is no such parameter");
    }
  }

  std::string write() && {
    std::ostringstream rows;
    for (ParameterRow const& parameter : parameters_) write_row(rows, parameter);
    if (!complaints_.empty()) throw DataError(complaints_);
    std::ostringstream out;
    out << "// Generated from axis-descriptions.json. Edit that file instead.\n";
    for (std::size_t i = 0; i < literals_.size(); ++i) {
      out << "\nconstexpr char literal_" << i << "[] =" << literals_[i] << ";\n";
    }
    out << "\nconstexpr char const* literals[] = {";
    for (std::size_t i = 0; i < literals_.size(); ++i) out << "literal_" << i << ", ";
    out << "};\n\nconstexpr ValueRow value_table[] = {\n"
        << values_.str() << "};\n\n// By parameter.\nconstexpr DescriptionRow description_table[] = {\n"
        << rows.str() << "};\n";
    return std::move(out).str();
  }

 private:
  using Rows = std::map<std::string, Json const*>;

  void complain(std::string const& name, std::string_view what) {
    complaints_ += name + ": " + std::string(what) + "\n";
  }

  void add(Rows& rows, Json const& row, std::string const& name) {
    if (!rows.emplace(name, &row).second) complain(name, "is described twice");
  }

  [[nodiscard]] Json const* family_of(std::string const& name) const {
    Json const* longest = nullptr;
    std::size_t length = 0;
    for (auto const& [prefix, row] : families_) {
      if (!name.starts_with(prefix) || prefix.size() < length) continue;
      longest = row;
      length = prefix.size();
    }
    return longest;
  }

  void write_row(std::ostream& out, ParameterRow const& parameter) {
    auto const own = by_name_.find(parameter.name);
    auto const same = by_number_.find(parameter.p_axis);
    Json const* row = own != by_name_.end() ? own->second : same != by_number_.end() ? same->second : nullptr;
    bool const inferred = row == nullptr;
    if (inferred) row = family_of(parameter.name);
    if (row == nullptr) {
      complain(parameter.name, "neither it nor its family is described");
      return;
    }
    std::size_t const first_value = value_count_;
    if (row->contains("values")) {
      for (Json const& value : row->at("values")) write_value(parameter, value);
    }
    out << "    {" << pair(parameter.name, row->at("what")) << ", "
        << (row->contains("detail") ? pair(parameter.name, row->at("detail")) : "{}") << ", " << first_value
        << ", " << value_count_ - first_value << ", " << (inferred ? "true" : "false") << ", "
        << (row->value("restart", false) ? "true" : "false") << "},\n";
  }

  void write_value(ParameterRow const& parameter, Json const& value) {
    values_ << "    {" << text(value.at("value").get<std::string>()) << ", " << pair(parameter.name, value)
            << "},\n";
    ++value_count_;
  }

  std::string pair(std::string const& name, Json const& object) {
    auto const english = object.value("en", "");
    auto const german = object.value("de", "");
    if (english.empty() || german.empty()) complain(name, "a text is missing in one of the languages");
    return "{" + text(english) + ", " + text(german) + "}";
  }

  /// Number of its literal, place and size; equal texts are written once.
  std::string text(std::string const& content) {
    auto const [known, is_new] = known_.try_emplace(content);
    if (!is_new) return known->second;
    if (literals_.empty() || size_ + content.size() > longest_literal) {
      literals_.emplace_back();
      size_ = 0;
    }
    std::string& literal = literals_.back();
    literal += "\n    \"";
    for (char const byte : content) {
      if (byte == '"' || byte == '\\') literal += '\\';
      literal += byte;
    }
    literal += '"';
    known->second = "{" + std::to_string(literals_.size() - 1) + ", " + std::to_string(size_) + ", " +
                    std::to_string(content.size()) + "}";
    size_ += content.size();
    return known->second;
  }

  std::vector<ParameterRow> const& parameters_;
  Rows by_name_;
  Rows families_;
  std::map<std::uint16_t, Json const*> by_number_;
  std::set<std::string> names_;
  std::map<std::string, std::string> known_;
  std::vector<std::string> literals_;
  std::size_t size_ = 0;  ///< of the last one
  std::ostringstream values_;
  std::size_t value_count_ = 0;
  std::string complaints_;
};

}  // namespace

std::string write_descriptions(std::vector<ParameterRow> const& parameters, std::string const& data_text) {
  try {
    auto const data = Json::parse(data_text);
    return DescriptionWriter(parameters, data).write();
  } catch (Json::exception const& error) {
    throw DataError(std::string("descriptions: ") + error.what());
  }
}

}  // namespace axisc::schema::generator
