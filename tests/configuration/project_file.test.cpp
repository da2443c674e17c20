// XML as projects are written in: what belongs to which element, where its bytes are, and what is refused.
#include "configuration/project_file.hpp"

#include "configuration/machine_file.hpp"
#include "configuration/xml/xml_document.hpp"
#include "support/catch.hpp"

namespace {

using namespace axisc;
using namespace axisc::configuration;

struct Read {
  SourceSet sources;
  Project project;
  std::deque<Finding> mistakes;

  explicit Read(std::string text) {
    SourceId const source = sources.add(SourceText("p.tsproj", std::move(text)));
    project = read_project(sources, source, mistakes);
  }
  [[nodiscard]] std::string at(Span span) const { return std::string(sources[SourceId{}].slice(span)); }
  [[nodiscard]] std::string mistake() const {
    if (mistakes.empty()) return "none";
    Position const position = sources[SourceId{}].position(mistakes.front().place->span.begin);
    CHECK(mistakes.front().code == machine_file_code);
    CHECK_FALSE(render(mistakes.front().message, Language::german).empty());
    return std::to_string(position.line) + ":" + std::to_string(position.column) + " " +
           render(mistakes.front().message, Language::english);
  }
};

std::string axis(std::string const& inside) {
  return "<P><Axis><ItemName>A</ItemName>" + inside + "</Axis></P>";
}

bool begins(std::string const& text, std::string const& with) {
  INFO(text);
  return text.starts_with(with);
}

}  // namespace

TEST_CASE("the list of an object with its name and its place in a channel, as elements or attributes") {
  for (std::string const& text :
       {std::string(
            "<P><Axis><ItemName>X1</ItemName><DefaultChannel>2</DefaultChannel><DefaultIndex>3</DefaultIndex>"
            "<DefaultProgName> X\n</DefaultProgName><AchsMds><![CDATA[kopf.achs_nr "
            "1\r\n]]></AchsMds></Axis></P>"),
        std::string(
            "\xEF\xBB\xBF<P><Axis ItemName='X1' DefaultChannel=\"2\" DefaultIndex='3' DefaultProgName = 'X'>"
            "<Para><AchsMds>\n <![CDATA[kopf.achs_nr 1\r\n]]> </AchsMds></Para></Axis></P>")}) {
    Read const read(text);
    CHECK(read.mistake() == "none");
    REQUIRE(read.project.lists.size() == 1);
    ProjectList const& list = read.project.lists.front();
    CHECK(list.kind == ListKind::axis);
    CHECK(read.at(list.span) == "kopf.achs_nr 1\r\n");
    CHECK(list.name.text == "X1");
    CHECK(read.at(list.name.place.span) == "X1");
    REQUIRE(list.program_name);
    CHECK(list.program_name->text == "X");
    CHECK(list.default_channel->number == 2);
    CHECK(list.default_index->number == 3);
  }
}

TEST_CASE("an object without a name is called as its element, and an empty list is none") {
  Read const read("<P><SdaMds><![CDATA[]]></SdaMds><AchsMds/><AchsMds></AchsMds></P>");
  REQUIRE(read.project.lists.size() == 1);
  CHECK(read.project.lists.front().kind == ListKind::channel);
  CHECK(read.project.lists.front().name.text == "SdaMds");
}

TEST_CASE("a name that is too long for a name is refused once, wherever it is wanted") {
  std::string const longest(1000, 'X');
  auto const lists = "<AchsMds><![CDATA[x 1]]></AchsMds><AchsMds><![CDATA[x 2]]></AchsMds></P>";
  Read const kept("<P><ItemName>" + longest + "</ItemName>" + lists);
  CHECK(kept.mistake() == "none");
  CHECK(kept.project.lists.at(1).name.text == longest);
  Read const refused("<P>\n<ItemName>" + longest + "X</ItemName>" + lists);
  CHECK(refused.mistake() == "2:11 ItemName has more than 1000 bytes and is not read; shorten it");
  CHECK(refused.mistakes.size() == 1);
  CHECK(refused.project.lists.at(1).name.text == "AchsMds");
  // Of no list.
  CHECK(Read("<P><Q><ItemName>" + longest + "X</ItemName></Q>" + lists).mistake() == "none");
}

TEST_CASE("the cycle time is that of the task that interpolates, or the one on which all agree") {
  auto const cycle = [](std::string const& tasks) {
    Read const read("<P><AchsMds><![CDATA[x 1]]></AchsMds>" + tasks + "</P>");
    return read.project.real_time.cycle_time ? read.project.real_time.cycle_time->nanoseconds : 0;
  };
  CHECK(cycle("<Task CycleTime='20000'><Name>CNC Geo</Name></Task><Task CycleTime='40000'/>") == 2'000'000);
  CHECK(cycle("<Task><CycleTime>10000</CycleTime></Task><Task CycleTime='10000'/>") == 1'000'000);
  CHECK(cycle("<Task CycleTime='10000'/><Task CycleTime='20000'/>") == 0);
  CHECK(cycle("<Task CycleTime='0'/>") == 0);
  CHECK(cycle("<Task CycleTime='99999999999'/>") == 0);
  CHECK(cycle("<Task/>") == 0);
}

TEST_CASE("a cycle time that no control runs with is refused where it is written") {
  auto const mistake = [](std::string const& tasks) {
    return Read("<P><AchsMds><![CDATA[x 1]]></AchsMds>\n" + tasks + "</P>").mistake();
  };
  for (std::string const value : {"0", "20", "199", "1000001", "99999999999", "1ms"}) {
    CHECK(mistake("<Task CycleTime='" + value + "'/>") ==
          "2:18 CycleTime of the NC must be 200 to 1000000 (20 µs to 100 ms in units of 100 ns), not " +
              value);
  }
  CHECK(mistake("<Task CycleTime='200'/>") == "none");
  CHECK(mistake("<Task CycleTime='1000000'/>") == "none");
  // The task that interpolates is meant, whatever others have.
  CHECK(begins(mistake("<Task CycleTime='0'><Name>GEO</Name></Task><Task CycleTime='10000'/>"), "2:18 "));
  CHECK(mistake("<Task CycleTime='20000000'/><Task CycleTime='10000'/>") == "none");
  // A project without a CNC has other tasks.
  CHECK(begins(Read("<P><Task CycleTime='20000000'/></P>").mistake(), "1:1 the project holds no list"));
}

TEST_CASE("the task that interpolates must state its cycle time, in this spelling") {
  auto const read = [](std::string const& tasks) {
    Read const whole("<P><AchsMds><![CDATA[x 1]]></AchsMds>\n" + tasks + "</P>");
    CHECK_FALSE(whole.project.real_time.cycle_time.has_value());
    CHECK(whole.mistakes.size() == 1);
    return whole.mistake();
  };
  std::string const other = "<Task CycleTime='40000'><Name>SDA</Name></Task>";
  std::string const missing =
      "2:2 the task GEO states no CycleTime, the cycle time of the NC; add it in units of 100 ns, as in "
      "CycleTime=\"10000\" for 1 ms";
  CHECK(read("<Task><Name>GEO</Name></Task>" + other) == missing);
  CHECK(read("<Task Name='GEO' CycleTime=''/>" + other) == missing);
  CHECK(read("<Task Name='GEO'/>") == missing);
  CHECK(read("<Task Name='GEO'/><Task Name='Geo2' CycleTime='20000'/>") == missing);
  std::string const spelling =
      " is not read, because names in XML have one spelling, without a prefix; write CycleTime";
  CHECK(read("<Task cycletime='20000'><Name>GEO</Name></Task>" + other) == "2:7 cycletime" + spelling);
  CHECK(read("<Task><Name>GEO</Name>\n<t:CycleTime>20000</t:CycleTime></Task>" + other) ==
        "3:2 t:CycleTime" + spelling);
  // Where no name fits, all tasks count.
  CHECK(read("<Task CYCLETIME='40000'/>" + other) == "2:7 CYCLETIME" + spelling);
  CHECK(begins(read("<Task Name='GEO' CycleTime='" + std::string(1001, '1') + "'/>"),
               "2:29 CycleTime has more"));
}

TEST_CASE("tasks without a cycle time do not matter where the one that interpolates is known") {
  Read const read(
      "<P><AchsMds><![CDATA[x 1]]></AchsMds><Task Name='PLC'/><Task cycletime='1'/>"
      "<Task Name='GEO' CycleTime='20000' cycletime='1'/></P>");
  CHECK(read.mistake() == "none");
  CHECK(read.project.real_time.cycle_time->nanoseconds == 2'000'000);
  CHECK(begins(Read("<P><Task Name='GEO'/></P>").mistake(), "1:1 the project holds no list"));
}

TEST_CASE("XML that is not well-formed is one finding with its place") {
  CHECK(begins(Read("<P>\n <A>\n</P>").mistake(), "3:3 this end tag"));
  CHECK(begins(Read("<P><AchsMds><![CDATA[x").mistake(), "1:13 the CDATA section"));
  CHECK(begins(Read("<P a=>").mistake(), "1:6 an attribute"));
  CHECK(begins(Read("").mistake(), "1:1 "));
  CHECK(begins(Read("   \n").mistake(), "1:1 the file holds no XML element"));
  CHECK(begins(Read("<P>").mistake(), "1:4 the XML ends"));
  CHECK(begins(Read(std::string("<P>\0</P>", 8)).mistake(), "1:4 a byte 0"));
  CHECK(begins(Read("<P/>").mistake(), "1:1 the project holds no list"));
}

TEST_CASE("lists that are not exactly one CDATA section are refused and named") {
  CHECK(begins(Read(axis("<AchsMds>kopf.achs_nr 1</AchsMds>")).mistake(),
               "1:33 the list in AchsMds is not a CDATA"));
  CHECK(begins(Read(axis("<AchsMds><![CDATA[a]]]]><![CDATA[>]]></AchsMds>")).mistake(),
               "1:33 the list in AchsMds is split"));
}

TEST_CASE("document types and entities are never expanded") {
  std::string bomb = "<?xml version='1.0'?>\n<!DOCTYPE P [<!ENTITY a 'aaaaaaaaaa'>";
  for (char name = 'b'; name < 'k'; ++name) {
    std::string const before(1, static_cast<char>(name - 1));
    bomb += "<!ENTITY " + std::string(1, name) + " '&" + before + ";&" + before + ";'>";
  }
  bomb += "]>\n<P><AchsMds><![CDATA[x 1]]></AchsMds><ItemName>&j;</ItemName></P>";
  Read const refused(bomb);
  CHECK(begins(refused.mistake(), "2:1 a document type definition"));
  CHECK(refused.project.lists.empty());
  Read const unknown(axis("<AchsMds><![CDATA[&lt; x]]></AchsMds>"));
  CHECK(unknown.at(unknown.project.lists.front().span) == "&lt; x");
}

TEST_CASE("any nesting is read") {
  constexpr std::size_t depth = 200'000;
  std::string text;
  for (std::size_t i = 0; i < depth; ++i) text += "<a>";
  text += "<AchsMds><![CDATA[x 1]]></AchsMds>";
  for (std::size_t i = 0; i < depth; ++i) text += "</a>";
  Read const read(text);
  REQUIRE(read.project.lists.size() == 1);
  CHECK(read.at(read.project.lists.front().span) == "x 1");
}

TEST_CASE("the encoding is the one that is declared, else the one that the bytes show") {
  CHECK(xml_encoding("<?xml version='1.0' encoding=\"Windows-1252\"?><P/>") == Encoding::windows_1252);
  CHECK(xml_encoding("<?xml version='1.0' encoding='ISO-8859-1'?><P/>") == Encoding::windows_1252);
  CHECK(xml_encoding("<?xml version='1.0' encoding='utf-8'?><P/>") == Encoding::utf8);
  CHECK(xml_encoding("<P>\xFC</P>") == Encoding::windows_1252);
  CHECK(xml_encoding("<P encoding='windows-1252'>\xC3\xBC</P>") == Encoding::utf8);
}

TEST_CASE("projects are known by their names and by the elements for lists") {
  CHECK(is_project_name("a/M.TsProj"));
  CHECK(is_project_name("Axis 1.xti"));
  CHECK_FALSE(is_project_name("M.tspproj"));
  CHECK_FALSE(is_project_name(".xti"));
}

TEST_CASE("only well-formed XML without an element for a list is not of a CNC") {
  CHECK_FALSE(Read("<a><Device/></a>").project.is_of_cnc);
  CHECK_FALSE(Read("<a><!-- <AchsMds> --></a>").project.is_of_cnc);
  for (std::string const text : {"<a><SdaMds>", "<a><SdaMds/></a>", "<a><Device/>", "", "<a/> x",
                                 "<!DOCTYPE a><a/>", "<a><t:AchsMds>x</t:AchsMds></a>"}) {
    INFO(text);
    Read const read(text);
    CHECK(read.project.is_of_cnc);
    CHECK(read.mistakes.size() == 1);
  }
}

TEST_CASE("what is next to the CDATA section of a list is told, and the list is read") {
  for (auto const& [inside, place] :
       {std::pair<std::string, std::string>("<AchsMds>x 1<![CDATA[a 1]]></AchsMds>", "1:41"),
        {"<AchsMds><![CDATA[a 1]]> x 1</AchsMds>", "1:57"},
        {"<AchsMds><![CDATA[a 1]]><b/></AchsMds>", "1:57"}}) {
    Read const read(axis(inside));
    CHECK(begins(read.mistake(), place + " this is next to the CDATA section of AchsMds"));
    CHECK(read.project.lists.size() == 1);
  }
  CHECK(Read(axis("<AchsMds>\n <!-- x --> <![CDATA[a 1]]> </AchsMds>")).mistake() == "none");
}

TEST_CASE("an element for a list in another spelling is told, beside a good one, too") {
  std::string const good = "<AchsMds><![CDATA[a 1]]></AchsMds>";
  CHECK(
      begins(Read(axis(good + "<achsmds><![CDATA[a 1]]></achsmds>")).mistake(), "1:67 achsmds is not read"));
  CHECK(begins(
      Read(axis(good + "<t:SdaMds><![CDATA[a 1]]></t:SdaMds>")).mistake(),
      "1:67 t:SdaMds is not read, because names in XML have one spelling, without a prefix; write SdaMds"));
  CHECK(Read(axis(good + "<achsmds/>")).mistake() == "none");
}
