#include "diagnostics/unusual_character.hpp"

#include <algorithm>
#include <iterator>

namespace axisc {
namespace {

/// In the order of the codes.
constexpr UnusualCharacter table[] = {
    {.code = 0x00A0, .name = "NO-BREAK SPACE", .instead = " "},
    {.code = 0x00AD, .name = "SOFT HYPHEN", .instead = ""},
    {.code = 0x0391, .name = "GREEK CAPITAL LETTER ALPHA", .instead = "A"},
    {.code = 0x0392, .name = "GREEK CAPITAL LETTER BETA", .instead = "B"},
    {.code = 0x0395, .name = "GREEK CAPITAL LETTER EPSILON", .instead = "E"},
    {.code = 0x0396, .name = "GREEK CAPITAL LETTER ZETA", .instead = "Z"},
    {.code = 0x0397, .name = "GREEK CAPITAL LETTER ETA", .instead = "H"},
    {.code = 0x0399, .name = "GREEK CAPITAL LETTER IOTA", .instead = "I"},
    {.code = 0x039A, .name = "GREEK CAPITAL LETTER KAPPA", .instead = "K"},
    {.code = 0x039C, .name = "GREEK CAPITAL LETTER MU", .instead = "M"},
    {.code = 0x039D, .name = "GREEK CAPITAL LETTER NU", .instead = "N"},
    {.code = 0x039F, .name = "GREEK CAPITAL LETTER OMICRON", .instead = "O"},
    {.code = 0x03A1, .name = "GREEK CAPITAL LETTER RHO", .instead = "P"},
    {.code = 0x03A4, .name = "GREEK CAPITAL LETTER TAU", .instead = "T"},
    {.code = 0x03A5, .name = "GREEK CAPITAL LETTER UPSILON", .instead = "Y"},
    {.code = 0x03A7, .name = "GREEK CAPITAL LETTER CHI", .instead = "X"},
    {.code = 0x03B1, .name = "GREEK SMALL LETTER ALPHA", .instead = "a"},
    {.code = 0x03B9, .name = "GREEK SMALL LETTER IOTA", .instead = "i"},
    {.code = 0x03BD, .name = "GREEK SMALL LETTER NU", .instead = "v"},
    {.code = 0x03BF, .name = "GREEK SMALL LETTER OMICRON", .instead = "o"},
    {.code = 0x03C1, .name = "GREEK SMALL LETTER RHO", .instead = "p"},
    {.code = 0x0405, .name = "CYRILLIC CAPITAL LETTER DZE", .instead = "S"},
    {.code = 0x0406, .name = "CYRILLIC CAPITAL LETTER BYELORUSSIAN-UKRAINIAN I", .instead = "I"},
    {.code = 0x0408, .name = "CYRILLIC CAPITAL LETTER JE", .instead = "J"},
    {.code = 0x0410, .name = "CYRILLIC CAPITAL LETTER A", .instead = "A"},
    {.code = 0x0412, .name = "CYRILLIC CAPITAL LETTER VE", .instead = "B"},
    {.code = 0x0415, .name = "CYRILLIC CAPITAL LETTER IE", .instead = "E"},
    {.code = 0x041A, .name = "CYRILLIC CAPITAL LETTER KA", .instead = "K"},
    {.code = 0x041C, .name = "CYRILLIC CAPITAL LETTER EM", .instead = "M"},
    {.code = 0x041D, .name = "CYRILLIC CAPITAL LETTER EN", .instead = "H"},
    {.code = 0x041E, .name = "CYRILLIC CAPITAL LETTER O", .instead = "O"},
    {.code = 0x0420, .name = "CYRILLIC CAPITAL LETTER ER", .instead = "P"},
    {.code = 0x0421, .name = "CYRILLIC CAPITAL LETTER ES", .instead = "C"},
    {.code = 0x0422, .name = "CYRILLIC CAPITAL LETTER TE", .instead = "T"},
    {.code = 0x0423, .name = "CYRILLIC CAPITAL LETTER U", .instead = "Y"},
    {.code = 0x0425, .name = "CYRILLIC CAPITAL LETTER HA", .instead = "X"},
    {.code = 0x0430, .name = "CYRILLIC SMALL LETTER A", .instead = "a"},
    {.code = 0x0435, .name = "CYRILLIC SMALL LETTER IE", .instead = "e"},
    {.code = 0x043E, .name = "CYRILLIC SMALL LETTER O", .instead = "o"},
    {.code = 0x0440, .name = "CYRILLIC SMALL LETTER ER", .instead = "p"},
    {.code = 0x0441, .name = "CYRILLIC SMALL LETTER ES", .instead = "c"},
    {.code = 0x0443, .name = "CYRILLIC SMALL LETTER U", .instead = "y"},
    {.code = 0x0445, .name = "CYRILLIC SMALL LETTER HA", .instead = "x"},
    {.code = 0x0455, .name = "CYRILLIC SMALL LETTER DZE", .instead = "s"},
    {.code = 0x0456, .name = "CYRILLIC SMALL LETTER BYELORUSSIAN-UKRAINIAN I", .instead = "i"},
    {.code = 0x0458, .name = "CYRILLIC SMALL LETTER JE", .instead = "j"},
    {.code = 0x04BB, .name = "CYRILLIC SMALL LETTER SHHA", .instead = "h"},
    {.code = 0x0501, .name = "CYRILLIC SMALL LETTER KOMI DE", .instead = "d"},
    {.code = 0x2000, .name = "EN QUAD", .instead = " "},
    {.code = 0x2001, .name = "EM QUAD", .instead = " "},
    {.code = 0x2002, .name = "EN SPACE", .instead = " "},
    {.code = 0x2003, .name = "EM SPACE", .instead = " "},
    {.code = 0x2004, .name = "THREE-PER-EM SPACE", .instead = " "},
    {.code = 0x2005, .name = "FOUR-PER-EM SPACE", .instead = " "},
    {.code = 0x2006, .name = "SIX-PER-EM SPACE", .instead = " "},
    {.code = 0x2007, .name = "FIGURE SPACE", .instead = " "},
    {.code = 0x2008, .name = "PUNCTUATION SPACE", .instead = " "},
    {.code = 0x2009, .name = "THIN SPACE", .instead = " "},
    {.code = 0x200A, .name = "HAIR SPACE", .instead = " "},
    {.code = 0x200B, .name = "ZERO WIDTH SPACE", .instead = ""},
    {.code = 0x200C, .name = "ZERO WIDTH NON-JOINER", .instead = ""},
    {.code = 0x200D, .name = "ZERO WIDTH JOINER", .instead = ""},
    {.code = 0x200E, .name = "LEFT-TO-RIGHT MARK", .instead = ""},
    {.code = 0x200F, .name = "RIGHT-TO-LEFT MARK", .instead = ""},
    {.code = 0x2010, .name = "HYPHEN", .instead = "-"},
    {.code = 0x2011, .name = "NON-BREAKING HYPHEN", .instead = "-"},
    {.code = 0x2012, .name = "FIGURE DASH", .instead = "-"},
    {.code = 0x2013, .name = "EN DASH", .instead = "-"},
    {.code = 0x2014, .name = "EM DASH", .instead = "-"},
    {.code = 0x2018, .name = "LEFT SINGLE QUOTATION MARK", .instead = "'"},
    {.code = 0x2019, .name = "RIGHT SINGLE QUOTATION MARK", .instead = "'"},
    {.code = 0x201C, .name = "LEFT DOUBLE QUOTATION MARK", .instead = "\""},
    {.code = 0x201D, .name = "RIGHT DOUBLE QUOTATION MARK", .instead = "\""},
    {.code = 0x201E, .name = "DOUBLE LOW-9 QUOTATION MARK", .instead = "\""},
    {.code = 0x2028, .name = "LINE SEPARATOR", .instead = " "},
    {.code = 0x202F, .name = "NARROW NO-BREAK SPACE", .instead = " "},
    {.code = 0x205F, .name = "MEDIUM MATHEMATICAL SPACE", .instead = " "},
    {.code = 0x2060, .name = "WORD JOINER", .instead = ""},
    {.code = 0x2212, .name = "MINUS SIGN", .instead = "-"},
    {.code = 0x3000, .name = "IDEOGRAPHIC SPACE", .instead = " "},
    {.code = 0xFEFF, .name = "ZERO WIDTH NO-BREAK SPACE", .instead = ""},
};

static_assert(std::is_sorted(std::begin(table), std::end(table),
                             [](UnusualCharacter const& a, UnusualCharacter const& b) {
                               return a.code < b.code;
                             }));

}  // namespace

UnusualCharacter const* find_unusual(char32_t character) {
  auto const* const found =
      std::lower_bound(std::begin(table), std::end(table), character,
                       [](UnusualCharacter const& row, char32_t wanted) { return row.code < wanted; });
  return found != std::end(table) && found->code == character ? found : nullptr;
}

}  // namespace axisc
