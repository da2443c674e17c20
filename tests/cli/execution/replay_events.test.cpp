// Events of a recording: what is repeated in consecutive cycles is one line.
#include "axisc/answers/replay/replay_report.hpp"
#include "presentation/writers.hpp"
#include "support/catch.hpp"

namespace replay_events_test {

using namespace axisc;

namespace {

image::ReplayedEntry off_command(std::uint64_t cycle, axisrt_status status) {
  image::ReplayedEntry entry;
  entry.kind = image::RecordedKind::command;
  entry.cycle = cycle;
  entry.command.action = AXISRT_ACTION_OFF;
  entry.recorded_status = entry.computed_status = status;
  return entry;
}

image::ReplayedEntry reset(std::uint64_t cycle, double position) {
  image::ReplayedEntry entry;
  entry.kind = image::RecordedKind::reset;
  entry.cycle = cycle;
  entry.in = {position};
  return entry;
}

std::string events_of(std::vector<image::ReplayedEntry> const& entries) {
  image::ImageContents image;
  image.axes.resize(1);
  image.axes[0].name = "X";
  image.groups.resize(1);
  image.groups[0].name = "CH1";
  ReplayReport report(image);
  for (auto const& entry : entries) report.add(entry);
  return presentation::write(report.answer(AXISRT_LEVEL_PORTABLE), presentation::Format::csv, {});
}

}  // namespace

TEST_CASE("a command that is tried again in every cycle is one event of a replay") {
  CHECK(events_of({off_command(3, AXISRT_BUSY), off_command(4, AXISRT_BUSY), off_command(5, AXISRT_BUSY),
                   off_command(6, AXISRT_OK), off_command(9, AXISRT_OK)}) ==
        "first_cycle,last_cycle,subject,call,status\n"
        "3,5,CH1,#FILTER OFF,AXISRT_BUSY\n"
        "6,6,CH1,#FILTER OFF,AXISRT_OK\n"
        "9,9,CH1,#FILTER OFF,AXISRT_OK\n");
}

TEST_CASE("resets to the same position in consecutive cycles are one event of a replay") {
  CHECK(events_of({reset(0, 5), reset(1, 5), reset(2, 6)}) ==
        "first_cycle,last_cycle,subject,call,status\n"
        "0,1,X,reset to 5,AXISRT_OK\n"
        "2,2,X,reset to 6,AXISRT_OK\n");
}

}  // namespace replay_events_test
