// How the commands of NC programs are read.
#include "grammar/nc_command.hpp"

#include "grammar/program_trace.hpp"
#include "support/catch.hpp"

namespace nc_command_test {

namespace {

using axisc::test::trace_command;

TEST_CASE("the switch and the keywords of #FILTER are optional") {
  CHECK(trace_command("#FILTER") == "1: filter <#FILTER>\n");
  CHECK(trace_command("#FILTER ON") == "1: filter <#FILTER> on\n");
  CHECK(trace_command("#FILTER OFF") == "1: filter <#FILTER> off\n");
  CHECK(trace_command("#FILTER [ORDER=20]") == "1: filter <#FILTER> <ORDER>=integer <20>\n");
  CHECK(trace_command("#FILTER ON []") == "1: filter <#FILTER> on\n");
  CHECK(trace_command("#FILTER ON [HSC]") == "1: filter <#FILTER> on <HSC>\n");
}

TEST_CASE("every keyword of the manuals") {
  CHECK(
      trace_command(
          "#FILTER ON [ORDER=40 ORDER_TIME=40000 SHARE=80 AX_DEV=0.001 FCUT=100 ACC_FACT=1.5 QUALITY=0.5]") ==
      "1: filter <#FILTER> on <ORDER>=integer <40> <ORDER_TIME>=integer <40000> <SHARE>=integer <80> "
      "<AX_DEV>=real <0.001> <FCUT>=integer <100> <ACC_FACT>=real <1.5> <QUALITY>=real <0.5>\n");
  CHECK(trace_command("#VIB GUARD ON [MODE=1 FREQ=30 DAMPING=0.1 AX_DEV=.01 ACC_FACT=2.]") ==
        "1: vibration-guard <#VIB GUARD> on <MODE>=integer <1> <FREQ>=integer <30> <DAMPING>=real <0.1> "
        "<AX_DEV>=real <.01> <ACC_FACT>=real <2.>\n");
  CHECK(trace_command("#VIB GUARD OFF") == "1: vibration-guard <#VIB GUARD> off\n");
}

TEST_CASE("blanks are free around brackets and equals signs") {
  std::string const expected = "1: filter <#FILTER> on <ORDER>=integer <20> <SHARE>=integer <80>\n";
  CHECK(trace_command("#FILTER ON[ORDER=20 SHARE=80]") == expected);
  CHECK(trace_command("  #FILTER\t ON  [  ORDER = 20\tSHARE=  80  ]  ") == expected);
  CHECK(trace_command("#FILTER[ORDER=20]") == "1: filter <#FILTER> <ORDER>=integer <20>\n");
  CHECK(trace_command("#VIB   GUARD ON") == "1: vibration-guard <#VIB   GUARD> on\n");
}

TEST_CASE("comments may stand in every gap") {
  CHECK(trace_command("#FILTER (a) ON (b (c)) [(d)ORDER(e)=(f)20(g)](h") ==
        "1: filter <#FILTER> on <ORDER>=integer <20>\n");
  CHECK(trace_command("#FILTER ON ; [ORDER=20]") == "1: filter <#FILTER> on\n");
}

TEST_CASE("values") {
  CHECK(trace_command("#FILTER [ORDER=-5 SHARE=+80 FCUT=1e2 QUALITY=1.5E-1 AX_DEV=020]") ==
        "1: filter <#FILTER> <ORDER>=integer <-5> <SHARE>=integer <+80> <FCUT>=real <1e2> "
        "<QUALITY>=real <1.5E-1> <AX_DEV>=integer <020>\n");
  CHECK(trace_command("#FILTER [ORDER=P10 SHARE=V.P.SHARE FCUT=V.L.TABLE[2]]") ==
        "1: filter <#FILTER> <ORDER>=variable <P10> <SHARE>=variable <V.P.SHARE> "
        "<FCUT>=variable <V.L.TABLE[2]>\n");
  CHECK(trace_command("#FILTER [ORDER=2O SHARE=0,5 FCUT=. QUALITY=high]") ==
        "1: filter <#FILTER> <ORDER>=malformed <2O> <SHARE>=malformed <0,5> <FCUT>=malformed <.> "
        "<QUALITY>=malformed <high>\n");
  CHECK(trace_command("#FILTER [ORDER= SHARE=80 FCUT=]") ==
        "1: filter <#FILTER> <ORDER>=missing <> <SHARE>=integer <80> <FCUT>=missing <>\n");
  CHECK(trace_command("#FILTER [AX DEV=0.001]") == "1: filter <#FILTER> <AX> <DEV>=real <0.001>\n");
}

TEST_CASE("a malformed command keeps what could be read") {
  CHECK(trace_command("#FILTER on") == "1: filter <#FILTER> ! unexpected-text <on>\n");
  CHECK(trace_command("#FILTER ON OFF") == "1: filter <#FILTER> on ! unexpected-text <OFF>\n");
  CHECK(trace_command("#FILTER ON ORDER=20") == "1: filter <#FILTER> on ! unexpected-text <ORDER>\n");
  CHECK(trace_command("#FILTER ON [ORDER=20") ==
        "1: filter <#FILTER> on <ORDER>=integer <20> ! unclosed-bracket <[>\n");
  CHECK(trace_command("#FILTER ON [ORDER=20 (comment]") ==
        "1: filter <#FILTER> on <ORDER>=integer <20> ! unclosed-bracket <[>\n");
  CHECK(trace_command("#FILTER ON [ORDER=20, SHARE=80]") ==
        "1: filter <#FILTER> on <ORDER>=malformed <20,> <SHARE>=integer <80>\n");
  CHECK(trace_command("#FILTER ON [ORDER=20 , SHARE=80]") ==
        "1: filter <#FILTER> on <ORDER>=integer <20> ! expected-keyword <,>\n");
  CHECK(trace_command("#FILTER ON [ORDER 20]") == "1: filter <#FILTER> on <ORDER> ! expected-keyword <20>\n");
  CHECK(trace_command("#FILTER ON [ORDER=20] [SHARE=80]") ==
        "1: filter <#FILTER> on <ORDER>=integer <20> ! unexpected-text <[SHARE>\n");
  CHECK(trace_command("#FILTER ON [ORDER=20]]") ==
        "1: filter <#FILTER> on <ORDER>=integer <20> ! unexpected-text <]>\n");
  CHECK(trace_command("#FILTER ON [ORDER=20] M30") ==
        "1: filter <#FILTER> on <ORDER>=integer <20> ! unexpected-text <M30>\n");
}

TEST_CASE("another letter case is recognised as a mistake") {
  CHECK(trace_command("#filter ON") == "1: filter <#filter> on ! letter-case <#filter>\n");
  CHECK(trace_command("#Vib Guard on") == "1: vibration-guard <#Vib Guard> ! letter-case <#Vib Guard>\n");
}

TEST_CASE("names end where letters and digits end") {
  CHECK(trace_command("#FILTERON") == "1: other <#FILTERON>\n");
  CHECK(trace_command("#VIBGUARD ON") == "1: other <#VIBGUARD>\n");
  CHECK(trace_command("#VIB") == "1: other <#VIB>\n");
  CHECK(trace_command("#FILTER ONE") == "1: filter <#FILTER> ! unexpected-text <ONE>\n");
}

TEST_CASE("axis exchange commands") {
  CHECK(trace_command("#CALL AX [X,1,0]") == "1: axis-exchange <#CALL AX>\n");
  CHECK(trace_command("#CALL AX FAST [X,1,0]") == "1: axis-exchange <#CALL AX>\n");
  CHECK(trace_command("#PUT  AX ALL") == "1: axis-exchange <#PUT  AX>\n");
  CHECK(trace_command("#SET AX [X,1,0]") == "1: axis-exchange <#SET AX>\n");
  CHECK(trace_command("#SET AX LINK [1, X=Y]") == "1: other <#SET>\n");
  CHECK(trace_command("#CALL AXIS") == "1: other <#CALL>\n");
  CHECK(trace_command("#SLOPE [TYPE=TRAPEZ]") == "1: other <#SLOPE>\n");
}

TEST_CASE("the text of one command holds nothing in front of it") {
  CHECK(trace_command("") == "no command\n");
  CHECK(trace_command("FILTER ON") == "no command\n");
  CHECK(trace_command("N10 #FILTER ON") == "no command\n");
  CHECK(trace_command("; #FILTER ON") == "no command\n");
  CHECK(trace_command("(comment) #FILTER ON") == "1: filter <#FILTER> on\n");
}

}  // namespace

}  // namespace nc_command_test
