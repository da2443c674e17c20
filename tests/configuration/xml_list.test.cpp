// Update and template files: elements named by a parameter's number become lines of a list, shown where the file says them.
#include "configuration/xml_list.hpp"

#include "support/catch.hpp"

#include <string>

using namespace axisc;
using configuration::ListKind;

namespace {

Translation translated(std::string const& bytes, ListKind kind) {
  return std::get<Translation>(configuration::read_xml_list(bytes, kind));
}

}  // namespace

TEST_CASE("the first element says which list an XML file holds") {
  using configuration::xml_list_kind;
  CHECK(xml_list_kind("<AX_MDS/>") == ListKind::axis);
  CHECK(xml_list_kind("\xEF\xBB\xBF<?xml version='1.0'?>\r\n<!-- <StartUp> -->\n<SDA_MDS a='1'>") ==
        ListKind::channel);
  CHECK(xml_list_kind("<StartUp>") == ListKind::startup);
  CHECK(xml_list_kind("<RTConfiguration\n/>") == ListKind::real_time);
  for (std::string const other : {"", "<", "<AX_MDS2/>", "kopf.achs_nr 1", "<project><AX_MDS/></project>",
                                  "<!-- <AX_MDS/>", "<?xml AX_MDS"}) {
    CHECK_FALSE(xml_list_kind(other));
  }
}

TEST_CASE("numbers behind a parameter's number are its indices, at any depth of elements") {
  CHECK(translated("<AX_MDS><P-AXIS-00016 Value=\"1\"/><any><P-AXIS-00008.3 Value='2.5'/></any></AX_MDS>",
                   ListKind::axis)
            .list == "kopf.achs_nr 1\ngetriebe[3].dynamik.a_max 2.5\n");
  CHECK(translated("<StartUp><P-STUP-00015.1 Value=\"./x.xml\"/></StartUp>", ListKind::startup).list ==
        "achs_mds[1] ./x.xml\n");
  CHECK(translated("<RTConfiguration><P-RTCF-00012.1.2 Value=\"task_int\"/></RTConfiguration>",
                   ListKind::real_time)
            .list == "thread[1].function[2].name task_int\n");
  // A channel has one group, whose index may be left out.
  CHECK(translated("<SDA_MDS><P-CHAN-00006.0.4 Value=\"X\"/><P-CHAN-00006.5 Value=\"Y\"/></SDA_MDS>",
                   ListKind::channel)
            .list == "gruppe[0].achse[4].bezeichnung X\ngruppe[0].achse[5].bezeichnung Y\n");
}

TEST_CASE("what is no parameter of the list becomes a name that it does not know") {
  CHECK(translated("<AX_MDS><P-AXIS-99999.1 Value=\"1\"/><P-CHAN-00006.1 Value=\"2\"/><P-AXIS-00016.1 "
                   "Value=\"3\"/><P-AXIS-16 Value=\"4\"/><a Value=\"5\"/><b value=\"6\">7</b></AX_MDS>",
                   ListKind::axis)
            .list == "P_AXIS_99999_1 1\nP_CHAN_00006_1 2\nP_AXIS_00016_1 3\nP_AXIS_16 4\na 5\n");
}

TEST_CASE("values keep their text: references to characters, encodings, comments, nothing") {
  auto const value = [](std::string const& declaration, std::string const& raw) {
    std::string const list =
        translated(declaration + "<AX_MDS><P-AXIS-00297 Value=" + raw + "/></AX_MDS>", ListKind::axis).list;
    return list.substr(list.find(' ') + 1);
  };
  CHECK(value("", "\"X&#49;&amp;&lt;\"") == "X1&<\n");
  CHECK(value("", "'say &quot;x\"'") == "say \"x\"\n");
  CHECK(value("", "\"&#xE4;\"") == "\xC3\xA4\n");
  CHECK(value("<?xml version='1.0' encoding='windows-1252'?>", "\"\xFC&#xE4;&#x4E2D;\"") == "\xFC\xE4?\n");
  CHECK(value("", "\"A | B\"") == "A | B\n");
  CHECK(value("", "\"a (b) #c\"") == "\"a (b) #c\"\n");
  CHECK(value("", "\"\"") == "\"\"\n");
  CHECK(value("", "\" a\r\nb \"") == "a b\n");
}

TEST_CASE("places in a translated list are those of the elements and attributes") {
  std::string const bytes =
      "\xEF\xBB\xBF<AX_MDS><P-AXIS-00016 Value=\"1\"/>\r\n  <P-AXIS-00297\n    "
      "Value=\"X&#49;Y\"/></AX_MDS>\n";
  std::optional<configuration::XmlMistake> mistake;
  SourceText const source = configuration::list_text("x.xml", bytes, mistake);
  REQUIRE_FALSE(mistake);
  REQUIRE(source.is_translation());
  CHECK(source.list_bytes() == "kopf.achs_nr 1\nkopf.log_achs_name X1Y\n");
  auto const at = [&](std::string_view text) {
    auto const begin = static_cast<std::uint32_t>(source.bytes().rfind(text));
    return std::pair{source.position(begin),
                     source.position(begin + static_cast<std::uint32_t>(text.size()))};
  };
  CHECK(at("kopf.achs_nr") ==
        std::pair{Position{.line = 1, .column = 10}, Position{.line = 1, .column = 22}});
  CHECK(at("1\n").first == Position{.line = 1, .column = 30});
  CHECK(at("kopf.log_achs_name") ==
        std::pair{Position{.line = 2, .column = 4}, Position{.line = 2, .column = 16}});
  CHECK(at("X1Y") == std::pair{Position{.line = 3, .column = 12}, Position{.line = 3, .column = 19}});
  CHECK(source.slice(source.line_span(1)) == "<AX_MDS><P-AXIS-00016 Value=\"1\"/>");
  CHECK(source.slice(source.shown_line(3)) == "    Value=\"X&#49;Y\"/></AX_MDS>");
}

TEST_CASE("XML that is malformed, or no list, is an empty list with a mistake") {
  for (std::string const bytes :
       {"<AX_MDS><P-AXIS-00016 Value=\"1\"></AX_MDS>", "<AX_MDS", "<project/>", "",
        "<!DOCTYPE a [<!ENTITY b 'c'>]><AX_MDS><P-AXIS-00016 Value='&b;'/></AX_MDS>"}) {
    std::optional<configuration::XmlMistake> mistake;
    SourceText const source = configuration::list_text("x.XML", bytes, mistake);
    CHECK(mistake);
    CHECK(source.list_bytes().empty());
  }
  std::optional<configuration::XmlMistake> mistake;
  CHECK_FALSE(configuration::list_text("x.lis", "kopf.achs_nr 1\n", mistake).is_translation());
  CHECK_FALSE(mistake);
}
