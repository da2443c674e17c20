// What a parameter is in the end: which list wins, what a reference means, and when nothing is known.
#include "validator/values/effective_values.hpp"

#include "support/catch.hpp"
#include "validator/values/list_reader.hpp"
#include "validator/values/lost_assignment.hpp"
#include "validator/values/merge_lists.hpp"

#include <string>
#include <utility>

namespace effective_values_test {

namespace {

using namespace axisc;
using namespace axisc::validator;

class Lists {
 public:
  explicit Lists(std::string const& axis_list, std::string const& default_list = "") {
    axis_ = load(axis_list);
    default_ = load(default_list);
    default_.is_default_list = true;
    merged = merge_lists(default_list.empty() ? nullptr : &default_, axis_, std::nullopt);
  }

  [[nodiscard]] EffectiveValue const& at(std::string_view pattern, std::uint32_t index = 0) const {
    return merged.values.at(pattern, index);
  }
  [[nodiscard]] std::vector<ReferenceTrouble> troubles() const {
    std::vector<ReferenceTrouble> list;
    for (ReferenceProblem const& problem : merged.reference_problems) list.push_back(problem.trouble);
    return list;
  }

  MergedValues merged;

 private:
  LoadedList load(std::string const& text) {
    LoadedList list;
    list.source = sources_.add(SourceText("x.lis", text));
    SourceText const& source = sources_[list.source];
    ReadList read = read_list(source);
    list.tree = std::move(read.tree);
    list.line_values = std::move(read.line_values);
    list.lost = lost_assignments(source, list.tree, list.line_values);
    return list;
  }

  SourceSet sources_;
  LoadedList axis_;
  LoadedList default_;
};

using Troubles = std::vector<ReferenceTrouble>;

}  // namespace

TEST_CASE("the internal default counts where no list sets a value") {
  Lists const lists("");
  EffectiveValue const& frequency = lists.at("filter[].fg_f0", 2);
  CHECK(frequency.value.number == 30);
  CHECK_FALSE(frequency.set());
  CHECK_FALSE(frequency.value_place().has_value());
  CHECK(schema::slot_name(frequency.slot) == "filter[2].fg_f0");
}

TEST_CASE("the default list wins over the default, the axis list over both, the last line within a list") {
  Lists const lists("filter[0].order 1\nfilter[0].order 2\n",
                    "filter[0].order 5\nfilter[0].fg_f0 40\nfilter[1].order 3\nfilter[1].order 4\n");
  CHECK(lists.at("filter[].order", 0).value.number == 2);
  CHECK(lists.at("filter[].order", 0).origin == Origin::axis_list);
  CHECK(lists.at("filter[].order", 0).line == 2);
  CHECK(lists.at("filter[].fg_f0", 0).value.number == 40);
  CHECK(lists.at("filter[].fg_f0", 0).origin == Origin::default_list);
  CHECK(lists.at("filter[].order", 1).value.number == 4);
}

TEST_CASE("what lists set is listed by origin and line") {
  Lists const lists("filter[0].order 1\nkopf.achs_nr 1\nfilter[0].order 2\n",
                    "kopf.achs_nr 0\nfilter[1].order 1\n");
  std::vector<std::string> names;
  for (EffectiveValue const* const value : lists.merged.values.set_values()) {
    names.push_back(parameter_name(*value));
  }
  CHECK(names == std::vector<std::string>{"filter[1].order", "kopf.achs_nr", "filter[0].order"});
  CHECK(lists.at("filter[].order", 0).value.number == 2);
  CHECK(lists.at("filter[].order", 1).value.number == 1);
  CHECK(lists.at("kopf.achs_nr").value.number == 1);
}

TEST_CASE("a broken line makes its parameter unusable, a good one behind it repairs that") {
  CHECK(Lists("filter[0].order 1,5\n").at("filter[].order").unusable);
  CHECK(Lists("filter[0].order 2\nfilter[0].order 1,5\n").at("filter[].order").unusable);
  CHECK_FALSE(Lists("filter[0].order 1,5\nfilter[0].order 2\n").at("filter[].order").unusable);
  CHECK_FALSE(Lists("filter[0].order 2\n", "filter[0].order 1,5\n").at("filter[].order").unusable);
  for (char const* const line :
       {"filter[0].order", "filter[0].order two", "filter[0].order -1", "filter[0].order \x01",
        "filter[0.order 2", "filter[].order 2", "filter.order 2", "filter[0].oder 2"}) {
    INFO(line);
    CHECK(Lists(std::string(line) + "\n").at("filter[].order").unusable);
  }
}

TEST_CASE("a guessed name counts only where the list does not set the parameter") {
  CHECK_FALSE(Lists("filter[0].order 2\nfilter[0].oder 3\n").at("filter[].order").unusable);
  CHECK(Lists("filter[0].oder 3\n", "filter[0].order 2\n").at("filter[].order").unusable);
}

TEST_CASE("a value outside its documented range is usable") {
  CHECK_FALSE(Lists("filter[0].guete 11\n").at("filter[].guete").unusable);
  CHECK(Lists("filter[0].guete 11\n").at("filter[].guete").value.number == 11);
}

TEST_CASE("references point back and forward, to defaults and to the default list") {
  Lists const lists(
      "getriebe[0].vb_eilgang P-AXIS-00212.0\n"
      "getriebe[0].dynamik.vb_max 500000\n"
      "getriebe[1].vb_eilgang P-AXIS-00212\n"
      "kenngr.vb_messen P-AXIS-00212.2\n"
      "getriebe[3].vb_eilgang P-AXIS-00212.3\n",
      "getriebe[3].dynamik.vb_max 1234\n");
  CHECK(lists.troubles().empty());
  CHECK(lists.at("getriebe[].vb_eilgang", 0).value.number == 500000);
  CHECK(lists.at("getriebe[].vb_eilgang", 0).referenced);
  CHECK(lists.at("getriebe[].vb_eilgang", 1).value.number == 500000);
  CHECK(lists.at("kenngr.vb_messen").value.number == lists.at("getriebe[].dynamik.vb_max", 2).value.number);
  CHECK(lists.at("getriebe[].vb_eilgang", 3).value.number == 1234);
}

TEST_CASE("a reference in the default list takes the value of each axis") {
  Lists const lists("getriebe[0].dynamik.vb_max 300000\n", "getriebe[0].vb_eilgang P-AXIS-00212.0\n");
  CHECK(lists.at("getriebe[].vb_eilgang").value.number == 300000);
}

TEST_CASE("what came through a reference is known by its parameter, wherever its line stands in the end") {
  Lists const lists("kopf.achs_nr 1\ngetriebe[0].vb_eilgang P-AXIS-00212.0\n",
                    "getriebe[0].vb_eilgang 5\ngetriebe[0].dynamik.vb_max 300000\nkopf.achs_nr 0\n");
  std::vector<std::string> names;
  for (EffectiveValue const* const value : lists.merged.values.set_values()) {
    names.push_back(parameter_name(*value));
  }
  CHECK(names ==
        std::vector<std::string>{"getriebe[0].dynamik.vb_max", "kopf.achs_nr", "getriebe[0].vb_eilgang"});
  REQUIRE(lists.merged.values.referenced_slots().size() == 1);
  EffectiveValue const& referenced = lists.merged.values[lists.merged.values.referenced_slots().front()];
  CHECK(parameter_name(referenced) == "getriebe[0].vb_eilgang");
  CHECK(referenced.referenced);
  CHECK(referenced.value.number == 300000);
}

TEST_CASE("a chain of references is followed to its end") {
  Lists const lists(
      "getriebe[0].dynamik.a_max P-AXIS-00008.1\n"
      "getriebe[1].dynamik.a_max P-AXIS-00008.2\n"
      "getriebe[2].dynamik.a_max P-AXIS-00008.3\n"
      "getriebe[3].dynamik.a_max 77\n");
  CHECK(lists.at("getriebe[].dynamik.a_max", 0).value.number == 77);
}

TEST_CASE("references that mean nothing say why") {
  CHECK(Lists("filter[0].order P-AXIS-99999\n").troubles() == Troubles{ReferenceTrouble::unresolvable});
  CHECK(Lists("filter[0].order P-AXIS-00140.0\n").troubles() == Troubles{ReferenceTrouble::circular});
  CHECK(Lists("filter[0].order P-AXIS-00140.1\n").troubles().empty());
  CHECK(Lists("filter[0].order P-AXIS-00140.3\n").troubles() == Troubles{ReferenceTrouble::wrong_index});
  CHECK(Lists("filter[0].order P-AXIS-00067\n").troubles() == Troubles{ReferenceTrouble::wrong_type});
  CHECK(Lists("filter[0].fg_f0 P-AXIS-00140\n").troubles().empty());
  CHECK(Lists("kopf.achs_nr P-AXIS-00212\n").troubles() == Troubles{ReferenceTrouble::out_of_data_range});
  Lists const other_unit("getriebe[0].vb_eilgang P-AXIS-00008\n");
  CHECK(other_unit.troubles() == Troubles{ReferenceTrouble::other_unit});
  CHECK_FALSE(other_unit.at("getriebe[].vb_eilgang").unusable);
}

TEST_CASE("a circle is reported once, at its last line, and whoever leads into it is silent") {
  Lists const lists(
      "getriebe[3].dynamik.a_max P-AXIS-00008.0\n"
      "getriebe[1].dynamik.a_max P-AXIS-00008.2\n"
      "getriebe[2].dynamik.a_max P-AXIS-00008.0\n"
      "getriebe[0].dynamik.a_max P-AXIS-00008.1\n");
  REQUIRE(lists.troubles() == Troubles{ReferenceTrouble::circular});
  ReferenceProblem const& problem = lists.merged.reference_problems.front();
  CHECK(schema::slot_name(problem.slot) == "getriebe[0].dynamik.a_max");
  CHECK(problem.circle.size() == 2);
  for (std::uint32_t gear = 0; gear < 4; ++gear) CHECK(lists.at("getriebe[].dynamik.a_max", gear).unusable);
}

TEST_CASE("a reference to something unusable is unusable without a word") {
  Lists const lists("getriebe[0].vb_eilgang P-AXIS-00212\ngetriebe[0].dynamik.vb_max 1,5\n");
  CHECK(lists.troubles().empty());
  CHECK(lists.at("getriebe[].vb_eilgang").unusable);
}

TEST_CASE("of several names with one number the one that is set is meant") {
  Lists const lists(
      "lr_param.improved_position_control.stage[0].filter[0].fg_f0 55\n"
      "filter[0].fg_f0 P-AXIS-00751.0\n");
  CHECK(lists.troubles().empty());
  CHECK(lists.at("filter[].fg_f0").value.number == 55);
}

TEST_CASE("a boolean may be a number, however it is written and wherever it stands") {
  // Numbers in the first bytes of a file are read in another way than those behind.
  for (std::string const before : {"", "# a comment that is long enough to have room behind it\n"}) {
    for (std::string const yes : {"1", "+1", "0x1", "TRUE"}) {
      Lists const lists(before + "bahnrg.bahnregelung " + yes + "\n");
      INFO(yes);
      CHECK(lists.at("bahnrg.bahnregelung").value.flag());
      CHECK_FALSE(lists.at("bahnrg.bahnregelung").unusable);
    }
    for (std::string const no : {"0", "-0", "+0", "0x0", "FALSE"}) {
      Lists const lists(before + "kenngr.achs_nr 1\nlr_hw[0].cam_direct_access " + no + "\n");
      INFO(no);
      CHECK_FALSE(lists.at("lr_hw[].cam_direct_access").value.flag());
      CHECK_FALSE(lists.at("lr_hw[].cam_direct_access").unusable);
    }
    for (std::string const neither : {"2", "-1", "100000000", "1000000001", "99999999999999999999"}) {
      Lists const lists(before + "bahnrg.bahnregelung " + neither + "\n");
      INFO(neither);
      CHECK(lists.at("bahnrg.bahnregelung").unusable);
    }
  }
}

TEST_CASE("broken lines and lines of both lists stand in their order") {
  Lists const lists("filter[0].order 1,5\nfilter[2.order 2\nkopf.achs_nr 1\n",
                    "filter[1].order 1\nfilter[0].order 2\nfilter[1].order\nfilter[0].fg_f0 20\n");
  std::vector<std::string> shown;
  for (EffectiveValue const* const value : lists.merged.values.set_values()) {
    shown.push_back(parameter_name(*value) + (value->unusable ? " unusable " : " ") +
                    std::to_string(value->line));
  }
  CHECK(shown == std::vector<std::string>{"filter[1].order unusable 1", "filter[0].fg_f0 4",
                                          "filter[0].order unusable 1", "filter[2].order unusable 2",
                                          "kopf.achs_nr 3"});
}

}  // namespace effective_values_test
