// Update and template files: elements named by a parameter's number become lines of a list, shown where the
// file says them.
#include "configuration/xml/xml_list.hpp"

#include "configuration/xml/xml_names.hpp"
#include "support/catch.hpp"

#include <string>
#include <vector>

using namespace axisc;
using configuration::ListKind;

namespace {

Translation translated(std::string const& bytes, ListKind kind) {
  auto read = configuration::read_xml_list(bytes, kind);
  CHECK(read.mistakes.empty());
  return std::move(read.translation);
}

/// "12 the value has …": the offset of each mistake and what is said of it.
std::vector<std::string> mistakes_in(std::string const& bytes, ListKind kind = ListKind::axis) {
  std::vector<std::string> mistakes;
  for (configuration::XmlMistake const& mistake : configuration::read_xml_list(bytes, kind).mistakes) {
    CHECK_FALSE(render(mistake.message, Language::german).empty());
    mistakes.push_back(std::to_string(mistake.span.begin) + " " + render(mistake.message, Language::english));
  }
  return mistakes;
}

bool is_one_mistake(std::string const& bytes, std::string const& beginning) {
  auto const mistakes = mistakes_in(bytes);
  INFO(bytes);
  for (auto const& mistake : mistakes) UNSCOPED_INFO(mistake);
  CHECK(mistakes.size() == 1);
  return mistakes.size() == 1 && mistakes.front().starts_with(beginning);
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

TEST_CASE("a list's first element in another spelling is one where its parameters follow") {
  using configuration::xml_list_kind;
  CHECK(xml_list_kind("<ax_mds><p-axis-00016 Value='1'/>") == ListKind::axis);
  CHECK(xml_list_kind("<t:AX_MDS xmlns:t='x'><t:P-AXIS-00016/>") == ListKind::axis);
  CHECK(xml_list_kind("<!DOCTYPE StartUp [<!-- > don't ] --><!ENTITY a ']>'>]>\n<StartUp/>") ==
        ListKind::startup);
  CHECK_FALSE(xml_list_kind("<startup mode='x'/>"));
}

TEST_CASE("only a first element that is something else says that XML is no list") {
  using configuration::may_be_xml_list;
  for (std::string const no :
       {"<project/>", "<?xml version='1.0'?><!-- x --><AX_MDS2>", "<!DOCTYPE a><a/>", "<startup/>"}) {
    CHECK_FALSE(may_be_xml_list(no));
  }
  for (std::string const yes :
       {"", " ", "<", "<?xml", "<!-- <a/>", "<!DOCTYPE a [", "<pro", "<AX_MDS/>", "text", "<<<<<<< HEAD"}) {
    CHECK(may_be_xml_list(yes));
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
  std::vector<configuration::XmlMistake> mistakes;
  SourceText const source = configuration::list_text("x.xml", bytes, mistakes);
  REQUIRE(mistakes.empty());
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
       {"<AX_MDS><P-AXIS-00016 Value=\"1\"></AX_MDS>", "<AX_MDS", "<project/>", "", "<?xml",
        "<AX_MDS><P-AXIS-00016 Value='1'/></AX_MDS><AX_MDS/>", "<AX_MDS/> x", "<AX_MDS/><![CDATA[x]]>",
        "<!DOCTYPE a [<!ENTITY b 'c'>]><AX_MDS><P-AXIS-00016 Value='&b;'/></AX_MDS>"}) {
    INFO(bytes);
    std::vector<configuration::XmlMistake> mistakes;
    SourceText const source = configuration::list_text("x.XML", bytes, mistakes);
    CHECK(mistakes.size() == 1);
    CHECK(source.list_bytes().empty());
  }
  std::vector<configuration::XmlMistake> mistakes;
  CHECK_FALSE(configuration::list_text("x.lis", "kopf.achs_nr 1\n", mistakes).is_translation());
  CHECK(mistakes.empty());
}

TEST_CASE("a parameter that sets nothing, and a list of none, are mistakes") {
  CHECK(is_one_mistake("<AX_MDS><P-AXIS-00351.0>1,5x</P-AXIS-00351.0></AX_MDS>",
                       "9 the element has no attribute"));
  CHECK(is_one_mistake("<AX_MDS><P-AXIS-00016/></AX_MDS>", "9 the element has no attribute Value"));
  CHECK(is_one_mistake("<AX_MDS><P-CHAN-00016 Name='x'/></AX_MDS>", "9 the element has no attribute Value"));
  CHECK(is_one_mistake("<AX_MDS></AX_MDS>", "1 the list sets no parameter"));
  CHECK(is_one_mistake("<AX_MDS/>", "1 the list sets no parameter"));
  CHECK(is_one_mistake("<AX_MDS><Achse/></AX_MDS>", "1 the list sets no parameter"));
}

TEST_CASE("names in another letter case or with a prefix are mistakes at their place") {
  CHECK(is_one_mistake(
      "<AX_MDS><P-AXIS-00140.0 value=\"1,5x\"/></AX_MDS>",
      "24 value is not read, because names in XML have one spelling, without a prefix; write Value"));
  CHECK(is_one_mistake("<AX_MDS><P-AXIS-00140 t:Value=\"1\"/></AX_MDS>", "22 t:Value is not read"));
  CHECK(is_one_mistake("<AX_MDS><p-axis-00140.0 Value=\"1\"/></AX_MDS>", "9 p-axis-00140.0 is not read"));
  CHECK(is_one_mistake("<AX_MDS><t:P-AXIS-00140 Value=\"1\"/></AX_MDS>", "9 t:P-AXIS-00140 is not read"));
  CHECK(is_one_mistake("<Ax_Mds><P-AXIS-00140 Value=\"1\"/></Ax_Mds>", "1 Ax_Mds is not read"));
  CHECK(mistakes_in("<t:AX_MDS><p-axis-00140 value=\"1\"/></t:AX_MDS>").size() == 3);
}

TEST_CASE("text beside values is a mistake, that of other elements decoration") {
  CHECK(is_one_mistake("<AX_MDS>x 1<P-AXIS-00016 Value='1'/></AX_MDS>", "8 text in an XML list is not read"));
  CHECK(is_one_mistake("<AX_MDS><P-AXIS-00016 Value='1'/> x\n</AX_MDS>", "34 text in an XML list"));
  CHECK(
      is_one_mistake("<AX_MDS><P-AXIS-00016 Value='1'>2</P-AXIS-00016></AX_MDS>", "32 text in an XML list"));
  CHECK(is_one_mistake("<AX_MDS><a>x<P-AXIS-00016 Value='1'/></a></AX_MDS>", "11 text in an XML list"));
  CHECK(is_one_mistake("<AX_MDS><![CDATA[x]]><P-AXIS-00016 Value='1'/></AX_MDS>", "17 text in an XML list"));
  CHECK(mistakes_in("<AX_MDS><Note>written by hand</Note><P-AXIS-00016 Value='1'/></AX_MDS>").empty());
}

TEST_CASE("a value stays in its line") {
  for (std::string const value : {"1&#10;Ende", "1&#xA;Ende", "1&#x00000A;", "1&#13;", "1&#9;2", "1&#0;",
                                  "\x01", "1\x7F", "&#4294967306;", "&#x10000000A;"}) {
    std::string const bytes =
        "<AX_MDS><P-AXIS-00016 Value=\"" + value + "\"/><P-AXIS-00140 Value=\"1\"/></AX_MDS>";
    CHECK(is_one_mistake(bytes, "29 the value has a line break or another control character"));
    CHECK(configuration::read_xml_list(bytes, ListKind::axis).translation.list == "filter[0].order 1\n");
  }
  CHECK(mistakes_in("<AX_MDS><P-AXIS-00297 Value=\"&#65;&#x42;&#xE4;\"/></AX_MDS>").empty());
}
