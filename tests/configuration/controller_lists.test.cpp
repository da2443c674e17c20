// Start-up, channel and real-time lists.
#include "configuration/channel_list.hpp"
#include "configuration/real_time_list.hpp"
#include "configuration/start_up_list.hpp"
#include "support/catch.hpp"

namespace {

using namespace axisc;
using namespace axisc::configuration;

SourceText source_of(std::string text) {
  return {"a.lis", std::move(text)};
}

std::string cycle_of(std::string text) {
  std::deque<Finding> mistakes;
  RealTimeList const list = read_real_time_list(source_of(std::move(text)), SourceId{}, mistakes);
  if (!mistakes.empty()) return "refused@" + std::to_string(mistakes.front().place->span.begin);
  return list.cycle_time
             ? std::to_string(list.cycle_time->nanoseconds) + "@" + std::to_string(list.place.span.begin)
             : "none";
}

}  // namespace

TEST_CASE("a start-up list names the lists of a machine, by rising index") {
  StartUpList const list = read_start_up_list(
      source_of("zahl_mds 2\nachs_mds[1] y.lis\nACHS_MDS[0] x.lis\nachs_mds[2] z.lis\n"
                "kanal_anzahl 1\nsda_mds[0] c.lis\ndefault_achs_mds d.lis\n"
                "zahl_kw 1\nachs_kw_log_ax_nr[0] 3\nachs_kw[0] k.lis\nachs_kw_log_ax_nr[1] 4\n"
                "rtconf_lis r.lis\nwerkz_data[0] w.lis\n"),
      SourceId{});
  REQUIRE(list.axes.size() == 3);
  CHECK(list.axes[0].file.text == "x.lis");
  CHECK(list.axes[1].file.text == "y.lis");
  CHECK(is_read(list.axes[1], list.axis_count));
  CHECK_FALSE(is_read(list.axes[2], list.axis_count));
  CHECK_FALSE(is_read(list.axes[0], std::nullopt));
  REQUIRE(list.compensations.size() == 1);
  CHECK(list.compensations[0].list.file.text == "k.lis");
  CHECK(list.compensations[0].axis->number == 3);
  CHECK(list.channels.size() == 1);
  CHECK(list.default_axis_list->text == "d.lis");
  CHECK(list.real_time->text == "r.lis");
  CHECK(named_lists(list).size() == 8);
}

TEST_CASE("of an entry that is given twice the last line counts") {
  StartUpList const list = read_start_up_list(
      source_of("achs_mds[0] x.lis\nachs_mds[0] y.lis\nzahl_mds 1\nzahl_mds 2\n"), SourceId{});
  REQUIRE(list.axes.size() == 1);
  CHECK(list.axes[0].file.text == "y.lis");
  CHECK(list.axis_count->number == 2);
}

TEST_CASE("a start-up list is known by names that only it has") {
  CHECK(looks_like_start_up_list("# Hochlauf\r\n  zahl_mds 2\r\n"));
  CHECK(looks_like_start_up_list("achs_mds[0] x.lis"));
  CHECK(looks_like_start_up_list("# a\rsda_mds[0] x.lis\r"));
  CHECK(looks_like_start_up_list("# a\nfilter[0].order 2\rkanal_anzahl 1"));
  CHECK_FALSE(looks_like_start_up_list("# achs_mds[0] x.lis\nfilter[0].order 2\n"));
  CHECK_FALSE(looks_like_start_up_list("my_zahl_mds 2\n"));
  CHECK_FALSE(looks_like_start_up_list(""));
}

TEST_CASE("a channel has axes, spindles, couplings and programs that run by themselves") {
  ChannelList const list = read_channel_list(
      source_of(
          "gruppe[0].bezeichnung Mill\ngruppe[0].achs_anzahl 2\n"
          "gruppe[0].achse[3].log_achs_nr 2\ngruppe[0].achse[3].bezeichnung Y\n"
          "gruppe[0].achse[0].bezeichnung X\ngruppe[0].achse[0].log_achs_nr 1\n"
          "gruppe[0].achse[7].log_achs_nr 0\ngruppe[1].achse[0].log_achs_nr 9\n"
          "spindel[0].log_achs_nr 6\nspindel[0].bezeichnung S\nspdl_anzahl 1\n"
          "synchro_data.koppel_gruppe[0].paar[1].log_achs_nr_slave 4\n"
          "synchro_data.koppel_gruppe[0].paar[1].log_achs_nr_master 1\n"
          "synchro_data.koppel_gruppe[0].paar[2].log_achs_nr_master 1\n"
          "path[0].dir ./prog\nstart_init_prog_file init.nc\ng800_prog_file[3] cycle.nc\nm6_prog_file \n"),
      SourceId{});
  CHECK(list.name->text == "Mill");
  CHECK(list.axis_count->number == 2);
  REQUIRE(list.axes.size() == 2);
  CHECK(list.axes[0].name->text == "X");
  CHECK(list.axes[1].index == 3);
  CHECK(list.axes[1].number->number == 2);
  REQUIRE(list.spindles.size() == 1);
  CHECK(list.spindles[0].name->text == "S");
  REQUIRE(list.pairs.size() == 1);
  CHECK(list.pairs[0].slave->number == 4);
  REQUIRE(list.programs.size() == 2);
  CHECK(list.programs[1].file.text == "cycle.nc");
  CHECK(list.folders.size() == 1);
}

TEST_CASE("G80 to G89 call programs that the channel names") {
  std::string text;
  for (char digit = '0'; digit <= '9'; ++digit) {
    text += std::string("g8") + digit + "_prog_file drill" + digit + ".nc\n";
  }
  ChannelList const list = read_channel_list(source_of(text + "g90_prog_file no.nc\n"), SourceId{});
  REQUIRE(list.programs.size() == 10);
  CHECK(list.programs[0].parameter == "g80_prog_file");
  CHECK(list.programs[9].file.text == "drill9.nc");
}

TEST_CASE("the cycle time is that of the interpolator's thread, else that of the list") {
  CHECK(cycle_of("cycle_time 1000\n") == "1000000@11");
  CHECK(cycle_of("cycle_time 1000\nthread[2].cycle 2000\nthread[2].function[1].name TASK_INT\n") ==
        "2000000@32");
  CHECK(cycle_of("cycle_time 1000\nthread[0].cycle 2000\nthread[0].function[0].name task_sda\n") ==
        "1000000@11");
  CHECK(cycle_of("cycle_time 1000\nthread[2].function[1].name task_int\n") == "1000000@11");
  CHECK(cycle_of("thread[0].name CNC\n") == "none");
  // One that no control runs with is told, whatever the rest of the list says.
  CHECK(cycle_of("cycle_time 0\n") == "refused@11");
  CHECK(cycle_of("cycle_time 19\n") == "refused@11");
  CHECK(cycle_of("cycle_time 20\n") == "20000@11");
  CHECK(cycle_of("cycle_time 100000\n") == "100000000@11");
  CHECK(cycle_of("cycle_time 100001\n") == "refused@11");
  CHECK(cycle_of("cycle_time 4294967295\n") == "refused@11");
  CHECK(cycle_of("cycle_time 1000\nthread[2].cycle 2\nthread[2].function[1].name TASK_INT\n") ==
        "refused@32");
  CHECK(cycle_of("cycle_time 1000\nthread[2].cycle 2\nthread[2].function[1].name task_sda\n") ==
        "1000000@11");
  CHECK(cycle_of("cycle_time fast\n") == "none");
}
