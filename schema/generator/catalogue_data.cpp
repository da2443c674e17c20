#include "schema/generator/catalogue_data.hpp"

#include "schema/row_reading.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace axisc::schema::generator {
namespace {

/// In the order of RowContradiction; * is the value that is wrong.
constexpr std::array<std::string_view, 8> sentences = {"the type is missing",
                                                       "array sizes do not match the [] of the name",
                                                       "limits are for numbers",
                                                       "the minimum is above the maximum",
                                                       "symbols are for strings and booleans",
                                                       "the symbol * appears twice",
                                                       "max_length is for strings",
                                                       "the default \"*\" is not a value of the type"};

std::string sentence_of(RowProblem const& problem) {
  std::string sentence(sentences.at(static_cast<std::size_t>(problem.what)));
  std::size_t const value = sentence.find('*');
  return value == std::string::npos ? sentence : sentence.replace(value, 1, problem.value);
}

/// One line per mistake.
std::string contradictions(std::vector<RowReading> const& readings) {
  std::set<std::uint16_t> numbers;
  for (RowReading const& reading : readings) numbers.insert(reading.row.p_axis);
  std::set<std::string> names;
  std::string lines;
  for (RowReading const& reading : readings) {
    auto const complain = [&](std::string const& what) { lines += reading.row.name + ": " + what + "\n"; };
    if (!names.insert(reading.row.name).second) complain("name appears twice");
    for (RowProblem const& problem : reading.problems) complain(sentence_of(problem));
    for (NamedParameter const& named : reading.named) {
      if (!numbers.contains(named.p_axis)) complain("the " + std::string(named.key) + " names no parameter");
    }
  }
  return lines;
}

std::vector<ParameterRow> read_rows(nlohmann::ordered_json const& entries, ListKind kind) {
  std::vector<RowReading> readings;
  for (auto const& entry : entries) readings.push_back(read_row(entry, nullptr, kind));
  if (readings.empty()) throw DataError("parameters: there are none");
  std::string const complaints = contradictions(readings);
  if (!complaints.empty()) throw DataError(complaints);
  std::vector<ParameterRow> rows;
  rows.reserve(readings.size());
  for (RowReading& reading : readings) rows.push_back(std::move(reading.row));
  return rows;
}

}  // namespace

std::vector<ParameterRow> read_catalogue(std::string const& data_text) {
  try {
    return read_rows(nlohmann::ordered_json::parse(data_text).at("parameters"), ListKind::axis);
  } catch (nlohmann::json::exception const& error) {
    throw DataError(error.what());
  }
}

KindRows read_kinds(std::string const& data_text) {
  KindRows kinds;
  try {
    auto const data = nlohmann::ordered_json::parse(data_text);
    for (auto const& entry : data.at("kinds")) {
      auto const word = entry.at("kind").get<std::string>();
      auto const kind = find_list_kind(&ListKindRow::word, word);
      if (!kind || kind == ListKind::axis) throw DataError(word + ": no such kind");
      if (!kinds.emplace(*kind, read_rows(entry.at("parameters"), *kind)).second) {
        throw DataError(word + ": appears twice");
      }
    }
  } catch (nlohmann::json::exception const& error) {
    throw DataError(std::string("other lists: ") + error.what());
  }
  if (kinds.size() != list_kinds - 1) throw DataError("other lists: a kind is missing");
  return kinds;
}

}  // namespace axisc::schema::generator
