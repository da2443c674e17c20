// Units as people write them.
#include "validator/views/written_unit.hpp"

#include "support/catch.hpp"

#include <string_view>

using namespace axisc::validator;

TEST_CASE("a unit is known in any letter case and in its usual forms") {
  struct Written {
    std::string_view word;
    std::string_view unit;
    double ratio;
  };
  for (Written const& each :
       {Written{"kHz", "Hz", 1000}, Written{"KHz", "Hz", 1000}, Written{"KHZ", "Hz", 1000},
        Written{"mHz", "Hz", 1e-3}, Written{"MHz", "Hz", 1e6}, Written{"HZ", "Hz", 1},
        Written{"Ms", "us", 1000}, Written{"msec", "us", 1000}, Written{"Sek", "us", 1e6},
        Written{"µsec", "us", 1}, Written{"MM/S", "um/s", 1000}, Written{"mm/sec", "um/s", 1000},
        Written{"Mm", "um", 1000}, Written{"mm/sec2", "mm/s^2", 1}, Written{"M/MIN", "um/s", 1e6 / 60},
        Written{"Prozent", "0.1 %", 10}, Written{"percent", "%", 1}, Written{"Grad", "1e-4 deg", 1e4},
        Written{"Nm", "N m", 1}}) {
    INFO(each.word << " in " << each.unit);
    CHECK(is_unit(each.word));
    CHECK(unit_ratio(each.word, each.unit).value_or(0) == Approx(each.ratio).epsilon(1e-12));
  }
}

TEST_CASE("a unit that may be two is one, without a number") {
  for (std::string_view const word : {"MHZ", "mhz", "Mhz", "NM"}) {
    INFO(word);
    CHECK(is_unit(word));
    CHECK_FALSE(unit_ratio(word, "Hz"));
    CHECK_FALSE(unit_ratio(word, "um"));
  }
}

TEST_CASE("words that look like units are none") {
  for (std::string_view const word : {"S", "M", "Min", "MIN", "Section", "Sekunde", "Sinus", "", "[]", "1"}) {
    INFO(word);
    CHECK_FALSE(is_unit(word));
  }
}

TEST_CASE("a unit ends where the text after it begins") {
  for (std::string_view const text : {"ms", "ms; dead time", "ms;dead time", "ms, so", "ms.", "ms: so",
                                      "ms(so", "ms\tso", "ms# so", "ms) so"}) {
    INFO(text);
    CHECK(unit_word(text) == "ms");
  }
  CHECK(unit_word("min. of all") == "min.");
  CHECK(unit_word("").empty());
}
