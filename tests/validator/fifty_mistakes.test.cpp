// One list with a mistake on each of fifty lines: fifty findings, each at its line and column, whatever
// stands before the mistake on its line.
#include "support/catch.hpp"
#include "support/checked.hpp"

#include <string>
#include <vector>

namespace fifty_mistakes_test {

namespace {

using namespace axisc;
using tests::Checked;
using tests::Lines;

/// A line; `@` stands where the finding must, and is not part of the line.
struct Mistake {
  char const* line;
  char const* code;
};

// clang-format off
std::vector<Mistake> const mistakes = {
    {"kopf.achs_nr @01", "AX1006"},
    {"kopf.mds_ident @12abc", "AX1006"},
    {"kopf.log_achs_name @Achse_mit_langem_Namen ( Länge", "AX2008"},
    {"@kopf.hugo 1", "AX2001"},
    {"@kopf.clone_of", "AX1003"},
    {"\t@= 5", "AX1002"},
    {"filter[0].type @LOWPAS", "AX2007"},
    {"filter[0].order @viel", "AX2003"},
    {"filter[0].enable @2", "AX2003"},
    {"filter[0].fg_f0 @17,5", "AX1005"},
    {"filter[0].guete\t\t@0.5", "AX2005"},
    {"filter[0].share_percent @100.1", "AX2005"},
    {"filter[0].time_constant @-1", "AX2004"},
    {"filter[0].prototype BESSEL @# gewählt", "AX1009"},
    {"filter[1].type @lowpass", "AX1010"},
    {"@Filter[1].fg_f0 30", "AX1010"},
    {"filter@[].order 1", "AX1004"},
    {"filter@[1.guete 1", "AX1004"},
    {"@filter[3].order 1", "AX2002"},
    {"@filter.order 1", "AX2002"},
    {"@kopf[0].link_to 1", "AX2002"},
    {"filter[1].share_percent 50 ( «öä» @P-AXIS-00140", "AX1011"},
    {"filter[1].time_constant 10000 @500", "AX1007"},
    {"lr_hw[0].cam_hw_id_string @\"offen", "AX1012"},
    {"lr_hw[1].cam_hw_id_string A @/* c */", "AX1009"},
    {"vib_guard.mode @0", "AX2005"},
    {"@vib_guard.aktiv 1", "AX2001"},
    {"vib_guard.damping @1.5", "AX2005"},
    {"filter_fir.type @5", "AX2005"},
    {"filter_fir.share @-1", "AX2004"},
    {"filter_fir.fcut @schnell", "AX2003"},
    {"filter_fir.quality @0,5", "AX1005"},
    {"getriebe[0].dynamik.a_max @P-AXIS-99999", "AX2010"},
    {"getriebe[1].dynamik.a_max @P-AXIS-00008.1", "AX2011"},
    {"getriebe[2].dynamik.a_max @P-AXIS-00297", "AX2012"},
    {"getriebe[3].dynamik.a_max @P-AXIS-00008.6", "AX2013"},
    {"getriebe[4].dynamik.a_max 2000 ( «ß» axisc: allow @AX2005", "AX1013"},
    {"getriebe[0].vb_eilgang @4000000000", "AX2015"},
    {"getriebe[1].vb_eilgang @5000000000", "AX2004"},
    {"kenngr.vb_messen @P-AXIS-00008.4", "AX2014"},
    {"kenngr.achs_mode @0x", "AX1006"},
    {"kenngr.swe_neg 5 ( Ä Ö Ü @\x07", "AX1001"},
    {"kenngr.antr_typ @8 ( überschrieben", "AX2006"},
    {"kenngr.antr_typ 2 @TRUE", "AX1007"},
    {"kenngr.set_refpos_mode @1", "AX2007"},
    {"antr.operation_mode @DRIVE", "AX2007"},
    {"lr_param.improved_position_control.stage[0].filter.order @4", "AX2005"},
    {"@lr_param.add_interface.filter[1].order 2", "AX2002"},
    {"@ende", "AX1010"},
    {"@filter[2].order 1 ( hinter dem Ende", "AX1008"},
};
// clang-format on

struct PlantedList {
  std::string bytes;
  Lines expected;
};

/// UTF-8 text in windows-1252, for the few letters that stand above.
std::string windows_1252(std::string const& utf8) {
  std::string bytes;
  for (std::size_t i = 0; i < utf8.size(); ++i) {
    auto const byte = static_cast<unsigned char>(utf8[i]);
    if (byte < 0x80) {
      bytes += utf8[i];
    } else {
      auto const next = static_cast<unsigned char>(utf8[++i]);
      bytes += static_cast<char>(((byte & 3U) << 6U) | (next & 0x3FU));
    }
  }
  return bytes;
}

PlantedList list_of(std::string const& line_end) {
  PlantedList text;
  unsigned number = 0;
  for (Mistake const& mistake : mistakes) {
    std::string line = mistake.line;
    std::size_t const at = line.find('@');
    std::size_t column = 1;
    for (char const c : line.substr(0, at))
      column += (static_cast<unsigned char>(c) & 0xC0U) != 0x80U ? 1U : 0U;
    line.erase(at, 1);
    text.bytes += line + line_end;
    text.expected.push_back(std::to_string(++number) + ":" + std::to_string(column) + " " + mistake.code);
  }
  return text;
}

}  // namespace

TEST_CASE("fifty mistakes give fifty findings, each in its place") {
  REQUIRE(mistakes.size() == 50);
  for (char const* const line_end : {"\n", "\r\n"}) {
    PlantedList const text = list_of(line_end);
    SECTION(std::string("UTF-8, line end of ") + std::to_string(std::string(line_end).size())) {
      CHECK(Checked(text.bytes).found() == text.expected);
    }
    SECTION(std::string("with byte order mark, line end of ") +
            std::to_string(std::string(line_end).size())) {
      CHECK(Checked("\xEF\xBB\xBF" + text.bytes).found() == text.expected);
    }
    SECTION(std::string("windows-1252, line end of ") + std::to_string(std::string(line_end).size())) {
      CHECK(Checked(windows_1252(text.bytes)).found() == text.expected);
    }
  }
}

}  // namespace fifty_mistakes_test
