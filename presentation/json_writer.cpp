#include "diagnostics/writers/json_stream.hpp"
#include "presentation/shown_table.hpp"
#include "presentation/writers.hpp"

namespace axisc::presentation {

namespace {

/// A foreign name as a key.
std::string escaped_key(std::string_view name) {
  std::string quoted;
  JsonStream(quoted, 0).string(name);
  return quoted.substr(1, quoted.size() - 2);
}

class JsonWriter {
 public:
  JsonWriter(std::string& out, Language language) : json_(out, 0), language_(language) {}

  void write(Document const& document) {
    json_.begin_object();
    if (document.version > 0) json_.member("version", static_cast<std::uint64_t>(document.version));
    members(document.blocks);
    json_.end_object();
  }

  void operator()(Facts const& facts) { fields(facts.fields); }
  void operator()(Table const& table) {
    if (!is_for_programs(table.audience)) return;
    json_.key(table.key);
    json_.begin_array();
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
      json_.begin_object();
      row(table.columns, table.rows[i]);
      if (!table.details.empty()) (*this)(table.details[i]);
      json_.end_object();
    }
    json_.end_array();
  }
  void operator()(Paragraph const& /*paragraph*/) {}
  void operator()(Verbatim const& verbatim) {
    if (!is_for_programs(verbatim.audience)) return;
    json_.key(verbatim.key);
    json_.string(verbatim.text);
  }
  void operator()(Prose const& prose) {
    json_.key(prose.key);
    json_.string(prose.markdown.in(language_));
  }
  void operator()(Picture const& /*picture*/) {}
  void operator()(Section const& section) {
    if (!is_for_programs(section.audience)) return;
    if (section.key.empty()) {
      fields(section.identity);
      members(section.blocks);
      return;
    }
    json_.key(section.key);
    object(section);
  }
  void operator()(Sections const& sections) {
    json_.key(sections.key);
    json_.begin_array();
    for (auto const& section : sections.items) object(section);
    json_.end_array();
  }

  void operator()(Nothing const& /*nothing*/) { json_.null(); }
  void operator()(bool value) { json_.boolean(value); }
  void operator()(std::int64_t value) { json_.raw(std::to_string(value)); }
  void operator()(Quantity const& quantity) { json_.raw(json_number(quantity.value)); }
  void operator()(std::string const& text) { json_.string(text); }
  void operator()(Symbol const& symbol) { json_.string(symbol.symbol); }
  void operator()(Words const& words) { json_.string(text_of(words, language_)); }
  void operator()(Names const& names) {
    json_.begin_array();
    for (auto const& name : names) json_.string(name);
    json_.end_array();
  }
  void operator()(Numbers const& numbers) {
    json_.begin_array();
    for (double const number : numbers.values) json_.raw(json_number(number));
    json_.end_array();
  }
  void operator()(NameLists const& lists) {
    json_.begin_array();
    for (auto const& names : lists) (*this)(names);
    json_.end_array();
  }
  void operator()(Wording const& wording) { json_.string(wording.in(language_)); }
  void operator()(Link const& link) { json_.string(link.text); }

 private:
  void members(std::vector<Block> const& blocks) {
    for (auto const& block : blocks) std::visit(*this, block);
  }
  void fields(std::vector<Field> const& all) {
    for (auto const& field : all) {
      if (is_for_programs(field.audience)) member(field.key, field.member, field.value);
    }
    close_members();
  }
  /// Neighbours of one key with different members are one object.
  void member(std::string_view key, std::string_view name, Value const& value) {
    if (name.empty() || key != open_) close_members();
    if (!name.empty() && open_.empty()) {
      json_.key(open_ = key);
      json_.begin_object();
    }
    name.empty() ? json_.key(key) : json_.key(escaped_key(name));
    std::visit(*this, value.form());
  }
  void close_members() {
    if (!open_.empty()) json_.end_object();
    open_ = {};
  }
  void object(Section const& section) {
    json_.begin_object();
    fields(section.identity);
    members(section.blocks);
    json_.end_object();
  }
  void row(std::vector<Column> const& columns, std::vector<Value> const& row) {
    for (std::size_t i = 0; i < columns.size(); ++i) {
      auto const& column = columns[i];
      if (is_for_programs(column.audience)) member(column.key, column.member, row[i]);
    }
    close_members();
  }

  JsonStream json_;
  Language language_;
  std::string_view open_;  ///< key of the object that members are added to
};

}  // namespace

std::string write_json(Document const& document, WriterOptions const& options) {
  std::string text;
  JsonWriter(text, options.language).write(document);
  return text + "\n";
}

}  // namespace axisc::presentation
