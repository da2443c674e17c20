// Axis lists with planted mistakes, the same ones in every run.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <string_view>

namespace axisc::tests {

/// The list of number `seed`: sound lines, mistakes of many kinds, comments, blank lines, tabs, both kinds of
/// line ends, umlauts in UTF-8 or windows-1252, with and without a byte order mark.
[[nodiscard]] inline std::string random_list(std::uint32_t seed) {
  constexpr std::string_view lines[] = {
      "kopf.achs_nr 1",
      "kopf.achs_nr\t2",
      "kenngr.achs_typ 1",
      "KENNGR.achs_typ 1 ( Art",
      "kopf.log_achs_name X  Achse",
      "kopf.log_achs_name X # Achse",
      "kopf.log_achs_name 5  a (b",
      "lr_hw[0].cam_hw_id_string \"a (b)\"   ( c",
      "lr_hw[0].cam_hw_id_string \"offen",
      "lr_hw[0].cam_hw_id_string \"offen ( c",
      "filter[0].enable 1",
      "filter[0].enable\ttrue  # an",
      "Filter[0].enable 1",
      "filter[0].order 3   ( Ordnung",
      "filter[0].order 7",
      "filter[0].ordre 2",
      "filter[ 0 ].order 2",
      "filter[0.order 2",
      "filter[-1].order 2",
      "filter[0].order 007",
      "filter[0].order 3.0",
      "filter[0].order 2 4 ( zwei",
      "filter[0].type LOWPASS",
      "filter[0].type lowpass",
      "filter[0].type LOWPAS",
      "filter[0].type HIGHPASS # hoch",
      "filter[0].prototype Bessel(x",
      "filter[0].fg_f0 17,5",
      "filter[0].fg_f0      20.5 # G\xC3\xBCte",
      "filter[0].guete 0,7 ( G\xFCte",
      "filter[1].enable 1",
      "filter[1].type TIME_DELAY",
      "filter[1].time_constant 12000  # lang",
      "filter[1].time_constant 3000 500",
      "filter[1].order 1",
      "filter_fir.type 5",
      "filter_fir.fcut 30",
      "getriebe[0].dynamik.a_max P-AXIS-00212 ( wie dort",
      "getriebe[0].dynamik.a_max 20000",
      "getriebe[0].dynamik.a_max 0x4E20",
      "kopf.hugo 1",
      "kopf[0].link_to 1",
      "kenngr.antr_typ 8 ( P-AXIS-00021",
      "kenngr.antr_typ 2",
      "; Kommentar von anderswo",
      "// noch einer",
      "( offen",
      "= 5",
      "# Kommentar",
      "# axisc: allow AX2006",
      "filter[1].order 1 ( axisc: allow AX3005",
      "   filter[2].share_percent 50",
      "\tfilter[2].order\t2\t\t# Tab",
      "filter[2].enable",
      "filter[2].type BANDPASS\x01",
      "",
      "   ",
  };
  std::mt19937 random(seed);
  // The distributions of the standard library differ from one to the next.
  auto const below = [&random](std::size_t limit) { return static_cast<std::size_t>(random() % limit); };
  std::string const line_end = below(3) == 0 ? "\r\n" : "\n";
  std::string list = below(8) == 0 ? "\xEF\xBB\xBF" : "";
  for (std::size_t count = 3 + below(25); count > 0; --count) {
    list += lines[below(std::size(lines))];
    list += line_end;
  }
  constexpr std::string_view ends[] = {"Ende", "ende", "Ende dahinter", "Ende\nfilter[2].order 1\n# x\n  y",
                                       ""};
  list += ends[below(std::size(ends))];
  if (below(4) != 0) list += line_end;
  return list;
}

}  // namespace axisc::tests
