// Machines on the disk that the capabilities are asked about.
#pragma once

#include "support/conversation.hpp"
#include "support/temporary_folder.hpp"

#include <string>

namespace axisc::test {

/// The answer to one request about an open document.
inline Json asked(std::string const& method, std::string const& path, std::string const& text,
                  Json const& params = Json::object()) {
  return Conversation().open(path, text).ask(method, path, params).results()[0];
}

/// An axis that sets a frequency twice, over a default list.
inline TemporaryFolder const& folder_of_one_axis() {
  static TemporaryFolder const folder;
  folder.write("machine.json", R"({"default_list": "all.lis", "axes": [{"name": "X", "list": "x.lis"}]})");
  folder.write("all.lis", "# all\nfilter[0].fg_f0  42\nfilter[0].type BANDSTOP\n");
  folder.write("x.lis", "filter[0].order 2\nfilter[0].fg_f0  17\nfilter[0].fg_f0  18\n");
  return folder;
}

/// Two axes with an NC cycle time, the first with a low-pass.
inline TemporaryFolder const& folder_of_two_axes() {
  static TemporaryFolder const folder;
  folder.write("machine.json",
               R"({"cycle_time_us": 1000, "default_list": "all.lis",
                   "axes": [{"name": "X", "list": "x.lis"}, {"name": "Y", "list": "y.lis"}]})");
  folder.write("all.lis", "getriebe[0].dynamik.vb_max 500000\nfilter[0].fg_f0  42\n");
  folder.write("x.lis",
               "kopf.achs_nr 1\nfilter[0].enable 1\nfilter[0].order 2\nfilter[0].prototype "
               "BUTTERWORTH\nfilter[0].type LOWPASS\nfilter[0].fg_f0 17\n");
  folder.write("y.lis", "kopf.achs_nr 2\n");
  return folder;
}

}  // namespace axisc::test
