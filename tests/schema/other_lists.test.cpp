// The catalogues of the kinds of lists beside axis lists: what they know, and that facts and tables agree.
#include "schema/catalogue.hpp"
#include "schema/tables/kind_tables.hpp"
#include "schema/value.hpp"
#include "support/catch.hpp"

#include <filesystem>
#include <fstream>
#include <string>

#include <nlohmann/json.hpp>

namespace {

using namespace axisc::schema;
using Status = NameLookup::Status;

nlohmann::json facts() {
  auto const path =
      std::filesystem::path(AXISC_SOURCE_DIR).parent_path() / "shared/catalogue/other-lists.json";
  std::ifstream file(path);
  return file ? nlohmann::json::parse(file) : nlohmann::json();
}

}  // namespace

TEST_CASE("names of other lists are found with up to three indices") {
  Catalogue const channel = Catalogue::of(ListKind::channel);
  CHECK(channel.kind() == ListKind::channel);
  NameLookup const lookup = channel.find("gruppe[0].achse[31].log_achs_nr");
  REQUIRE(lookup.status == Status::found);
  CHECK(number_text(lookup.row->kind, lookup.row->p_axis) == "P-CHAN-00035");
  CHECK(lookup.index == Indices{0, 31, 0});
  CHECK(slot_name(*lookup.row, lookup.slot) == "gruppe[0].achse[31].log_achs_nr");
  CHECK(&channel.parameter_of(lookup.slot) == lookup.row);
  CHECK(channel.find("gruppe[0].achse[32].log_achs_nr").status == Status::index_out_of_range);
  CHECK(channel.find("gruppe.achse[1].log_achs_nr").status == Status::index_missing);
  CHECK(channel.find("kenngr.achs_typ").status == Status::unknown);
  CHECK(channel.find("GRUPPE[0].bezeichnung").case_folded);

  // Every slot of a row with three indices has its own name.
  for (Parameter const& row : channel.parameters()) {
    if (row.index_count() != 3) continue;
    Indices const last{row.array[0] - 1U, row.array[1] - 1U, row.array[2] - 1U};
    Slot const slot = slot_of(row, last);
    CHECK(static_cast<std::uint32_t>(slot) - static_cast<std::uint32_t>(row.first_slot) == row.slots - 1);
    CHECK(indices_of(row, slot) == last);
  }
}

TEST_CASE("flags are words that are joined") {
  Catalogue const startup = Catalogue::of(ListKind::startup);
  CHECK(is_bit_mask(*startup.find("error_protocol_mode").row));
  CHECK_FALSE(is_bit_mask(*startup.find("listen").row));
}

TEST_CASE("suggestions stay within a kind") {
  CHECK(Catalogue::of(ListKind::tool).suggest_names("wz[3].radiuss").names.front() == "wz[3].radius");
  CHECK(Catalogue::of(ListKind::tool).suggest_names("kenngr.achs_typ").names.empty());
}

TEST_CASE("what names of one kind alone begin with") {
  CHECK(kind_named_by("gruppe[0].bezeichnung") == ListKind::channel);
  CHECK(kind_named_by("kw.ssfk.kw_nr_max") == ListKind::compensation);
  CHECK(kind_named_by("filter[0].order") == ListKind::axis);
  for (char const* const shared : {"kopf.achs_nr", "error_filter[0].reason", "trafo[0].id", "hugo"}) {
    CHECK_FALSE(kind_named_by(shared));
  }
}

TEST_CASE("the catalogues have every documented parameter, with its number, type and words") {
  auto const documented = facts();
  if (documented.is_null()) {
    WARN("the documented facts are not there");
    return;
  }
  std::size_t structures = 0;
  for (auto const& [word, kind_facts] : documented.items()) {
    auto const kind = find_list_kind(&ListKindRow::word, word);
    REQUIRE(kind);
    Catalogue const catalogue = Catalogue::of(*kind);
    for (auto const& fact : kind_facts["parameters"]) {
      auto const name = fact["name"].get<std::string>();
      INFO(name);
      std::string concrete;
      for (char const byte : name) {
        concrete += byte;
        if (byte == '[') concrete += '0';
      }
      // A part with two indices is nothing that the grammar reads.
      if (name.find("[][]") != std::string::npos) continue;
      NameLookup const lookup = catalogue.find(concrete);
      if (fact["type"] == "STRUCT") {
        ++structures;
        CHECK(lookup.status == Status::unknown);
        continue;
      }
      REQUIRE(lookup.status == Status::found);
      CHECK(number_text(*kind, lookup.row->p_axis) == fact["id"]);
      CHECK(lookup.row->is_flags == fact.value("flags", false));
      if (fact.contains("symbols")) {
        for (auto const& [symbol, number] : fact["symbols"].items()) {
          CHECK(read_symbol(*lookup.row, symbol).symbol != nullptr);
        }
      }
    }
  }
  CHECK(structures == 1);
}
