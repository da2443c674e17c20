#include "schema/generator/lookup_writer.hpp"

#include "schema/generator/catalogue_data.hpp"

#include <cstddef>
#include <cstdint>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

namespace axisc::schema::generator {
namespace {

using Json = nlohmann::ordered_json;

class LookupWriter {
 public:
  explicit LookupWriter(std::vector<ParameterRow> const& parameters) {
    for (ParameterRow const& parameter : parameters) parameters_.insert(parameter.name);
  }

  std::string write(Json const& messages, Json const& lookup) && {
    for (Json const& row : messages.at("messages")) write_message(row);
    for (Json const& row : lookup.at("topics")) write_topic(row);
    for (Json const& row : lookup.at("synonyms")) write_synonyms(row);
    auto const search_words = written_search_words(lookup);
    if (!complaints_.empty()) throw DataError(complaints_);
    return "// Generated from control-messages.json and lookup.json. Edit those files instead.\n" +
           arrays_.str() + "\nconstexpr ControlMessage message_table[] = {\n" + messages_.str() +
           "};\n\nconstexpr Topic topic_table[] = {\n" + topics_.str() +
           "};\n\nconstexpr Synonyms synonym_table[] = {\n" + synonyms_.str() +
           "};\n\nconstexpr SearchWords search_word_table = {\n" + search_words + "};\n";
  }

 private:
  void complain(std::string const& name, std::string_view what) {
    complaints_ += name + ": " + std::string(what) + "\n";
  }

  void write_message(Json const& row) {
    std::vector<std::string> numbers;
    for (Json const& number : row.at("numbers")) {
      numbers.push_back(std::to_string(number.get<std::uint32_t>()));
      if (!numbers_.insert(numbers.back()).second) complain(numbers.back(), "this message is there twice");
    }
    auto const& name = numbers.at(0);
    std::vector<std::string> parameters;
    for (Json const& parameter : row.value("parameters", Json::array())) {
      auto const pattern = parameter.get<std::string>();
      if (!parameters_.contains(pattern)) complain(name, "there is no parameter " + pattern);
      parameters.push_back(literal(pattern));
    }
    messages_ << "    {" << array("std::uint32_t", numbers) << ", " << page(name, row, "meaning")
              << ",\n     " << page(name, row, "reaction") << ",\n     " << page(name, row, "remedy")
              << ",\n     " << array("std::string_view", parameters) << "},\n";
  }

  void write_topic(Json const& row) {
    auto const name = row.at("name").get<std::string>();
    if (!names_.insert(name).second) complain(name, "this topic is there twice");
    std::vector<std::string> see;
    for (Json const& other : row.at("see")) see.push_back(literal(other.get<std::string>()));
    topics_ << "    {" << literal(name) << ", " << page(name, row, "title") << ",\n     "
            << page(name, row, "page") << ",\n     " << array("std::string_view", see) << ", "
            << words(name, row) << "},\n";
  }

  void write_synonyms(Json const& row) {
    auto const name = row.at("of").get<std::string>();
    if (!names_.insert(name).second) complain(name, "its words are there twice");
    bool const is_parameter = name.find('.') != std::string::npos;
    if (is_parameter && !parameters_.contains(name)) complain(name, "there is no such parameter");
    synonyms_ << "    {" << literal(name) << ", " << words(name, row) << "},\n";
  }

  std::string written_search_words(Json const& lookup) {
    std::string text;
    for (auto const* const key : {"fillers", "units", "prepositions", "for_messages"}) {
      text += "    " + group(key, lookup.at(key)) + ",\n";
    }
    std::set<std::string> known;
    for (auto const* const key : {"faults", "degrees", "actions", "same"}) {
      std::vector<std::string> groups;
      for (Json const& row : lookup.at(key)) {
        for (Json const& word : row) {
          if (!known.insert(word.get<std::string>()).second) complain(key, word.dump() + " is there twice");
        }
        groups.push_back(group(key, row));
      }
      text += "    " + array("WordGroup", groups) + ",\n";
    }
    return text;
  }

  std::string group(std::string const& key, Json const& row) {
    std::set<std::string> known;
    std::vector<std::string> words;
    for (Json const& word : row) {
      if (!known.insert(word.get<std::string>()).second) complain(key, word.dump() + " is there twice");
      words.push_back(literal(word.get<std::string>()));
    }
    return array("std::string_view", words);
  }

  /// The words of both languages; one that is the same in both is written once.
  std::string words(std::string const& name, Json const& row) {
    std::vector<std::string> all;
    std::set<std::string> known;
    for (std::string_view const language : {"en", "de"}) {
      std::set<std::string> own;
      for (Json const& word : row.at("words").at(std::string(language))) {
        auto const text = word.get<std::string>();
        if (!own.insert(text).second) complain(name, "\"" + text + "\" is there twice");
        if (known.insert(text).second) all.push_back(literal(text));
      }
    }
    return array("std::string_view", all);
  }

  /// A constant of its own, as the tables refer to them.
  std::string array(std::string_view type, std::vector<std::string> const& elements) {
    if (elements.empty()) return "{}";
    auto name = "array_" + std::to_string(array_count_++);
    arrays_ << "constexpr " << type << " " << name << "[] = {";
    for (std::string const& element : elements) arrays_ << element << ", ";
    arrays_ << "};\n";
    return name;
  }

  /// Empty where the row does not have it.
  std::string page(std::string const& name, Json const& row, std::string const& key) {
    if (!row.contains(key)) return "{}";
    auto const english = row.at(key).value("en", "");
    auto const german = row.at(key).value("de", "");
    if (english.empty() || german.empty()) complain(name, "a text is missing in one of the languages");
    return "{" + literal(english) + ", " + literal(german) + "}";
  }

  static std::string literal(std::string const& content) {
    std::string text = "\"";
    for (char const byte : content) {
      if (byte == '"' || byte == '\\') text += '\\';
      if (byte == '\n') {
        text += "\\n";
      } else {
        text += byte;
      }
    }
    return text + '"';
  }

  std::set<std::string> parameters_;
  std::set<std::string> numbers_;
  std::set<std::string> names_;
  std::ostringstream arrays_;
  std::size_t array_count_ = 0;
  std::ostringstream messages_;
  std::ostringstream topics_;
  std::ostringstream synonyms_;
  std::string complaints_;
};

}  // namespace

std::string write_lookup(std::vector<ParameterRow> const& parameters, std::string const& messages_text,
                         std::string const& lookup_text) {
  try {
    auto const messages = Json::parse(messages_text);
    return LookupWriter(parameters).write(messages, Json::parse(lookup_text));
  } catch (Json::exception const& error) {
    throw DataError(std::string("messages and topics: ") + error.what());
  }
}

}  // namespace axisc::schema::generator
