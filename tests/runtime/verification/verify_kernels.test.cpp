// What verify asks of kernels, slots, groups and banks. Offsets are those of docs/image-format.md.
#include "support/catch.hpp"
#include "tests/runtime/mutation.hpp"
#include "tests/runtime/test_runtime.hpp"

#include <vector>

using namespace axisc::test;

namespace {

std::vector<Mutation> kernel_mutations() {
  return {
      f64("tail", tails_kind, 0, 0, not_a_number, AXISRT_NOT_FINITE),
      f64("last tail", tails_kind, 18, 0, -infinity, AXISRT_NOT_FINITE),
      f64("tail of 64", tails_kind, 5, 0, -64, AXISRT_OK),
      f64("tail beyond 64", tails_kind, 5, 0, 64.5, AXISRT_OUT_OF_BOUNDS),
      u32("kernel type", kernels_kind, 1, 0, 6, AXISRT_UNKNOWN_KIND),
      u32("half width that has no tails", kernels_kind, 1, 8, 5, AXISRT_OUT_OF_BOUNDS),
      u32("half width smaller than its tails", kernels_kind, 1, 8, 3, AXISRT_OUT_OF_BOUNDS),
      u32("symmetric kernel with another delay", kernels_kind, 1, 12, 3, AXISRT_OUT_OF_BOUNDS),
      u32("delay of other tails", kernels_kind, 3, 12, 2, AXISRT_OUT_OF_BOUNDS),
      u32("delay longer than its tails", kernels_kind, 3, 12, 4, AXISRT_OUT_OF_BOUNDS),
      u32("first tail", kernels_kind, 0, 16, 0xFFFFFFFE, AXISRT_OUT_OF_BOUNDS),
      u32("tails behind the end", kernels_kind, 3, 16, 17, AXISRT_OUT_OF_BOUNDS),
      u32("no tails", kernels_kind, 0, 20, 0, AXISRT_OUT_OF_BOUNDS),
      u32("more tails than stored", kernels_kind, 0, 20, 200, AXISRT_OUT_OF_BOUNDS),
      u32("kernel too long", kernels_kind, 0, 20, 201, AXISRT_KERNEL_TOO_LONG),
      u32("first sample", kernels_kind, 0, 24, 0xFFFFFFFF, AXISRT_OUT_OF_BOUNDS),
      u32("samples behind the end", kernels_kind, 3, 28, 7, AXISRT_OUT_OF_BOUNDS),
      u32("too many samples", kernels_kind, 0, 28, 1025, AXISRT_OUT_OF_BOUNDS),
      f64("share", kernels_kind, 2, 32, not_a_number, AXISRT_NOT_FINITE),
      f64("frequency", kernels_kind, 2, 40, infinity, AXISRT_NOT_FINITE),
      f64("quality", kernels_kind, 2, 48, not_a_number, AXISRT_NOT_FINITE),
      f64("group delay", kernels_kind, 2, 56, not_a_number, AXISRT_NOT_FINITE),
      f64("kernel sum", kernels_kind, 2, 64, not_a_number, AXISRT_NOT_FINITE),
      f64("peak gain", kernels_kind, 2, 72, not_a_number, AXISRT_NOT_FINITE),
      // Proofs that cannot be true: the taps' sum is 1.
      f64("another sum of the kernel", kernels_kind, 0, 64, 2, AXISRT_OUT_OF_BOUNDS),
      f64("a peak gain below the sum", kernels_kind, 0, 72, 0.99, AXISRT_OUT_OF_BOUNDS),
      f64("a negative overshoot", kernels_kind, 0, 80, -0.1, AXISRT_OUT_OF_BOUNDS),
      f64("a negative tail gain", kernels_kind, 0, 88, -1, AXISRT_OUT_OF_BOUNDS),
      f64("overshoot", kernels_kind, 2, 80, -infinity, AXISRT_NOT_FINITE),
      f64("tail gain", kernels_kind, 3, 88, infinity, AXISRT_NOT_FINITE),
  };
}

std::vector<Mutation> slot_mutations() {
  return {
      u32("axis of a slot", slots_kind, 1, 0, 3, AXISRT_OUT_OF_BOUNDS),
      u32("two slots of one axis", slots_kind, 1, 0, 0, AXISRT_OUT_OF_BOUNDS),
      u32("family 0", slots_kind, 0, 4, 0, AXISRT_UNKNOWN_KIND),
      u32("family 4", slots_kind, 0, 4, 4, AXISRT_UNKNOWN_KIND),
      u32("index of a slot", slots_kind, 0, 8, 3, AXISRT_OUT_OF_BOUNDS),
      u32("kernel of a slot", slots_kind, 0, 12, 4, AXISRT_OUT_OF_BOUNDS),
      u32("no kernel", slots_kind, 0, 12, none, AXISRT_OK),
      u32("switch", slots_kind, 0, 16, 2, AXISRT_OUT_OF_BOUNDS),
      u32("history shorter than the listed kernel", slots_kind, 0, 20, 3, AXISRT_OUT_OF_BOUNDS),
      u32("history shorter than a bank's kernel", slots_kind, 0, 20, 7, AXISRT_OUT_OF_BOUNDS),
      u32("history longer than needed", slots_kind, 0, 20, 200, AXISRT_OK),
      u32("history too long", slots_kind, 0, 20, 201, AXISRT_KERNEL_TOO_LONG),
      u32("group of a slot", slots_kind, 0, 24, 1, AXISRT_OUT_OF_BOUNDS),
      u32("slot without its group", slots_kind, 0, 24, none, AXISRT_OUT_OF_BOUNDS),
      u32("member of another axis", slots_kind, 0, 28, 1, AXISRT_OUT_OF_BOUNDS),
      u32("member behind the end", slots_kind, 0, 28, 3, AXISRT_OUT_OF_BOUNDS),
      u32("no member in its group", slots_kind, 0, 28, none, AXISRT_OUT_OF_BOUNDS),
      {"slot that no command reaches, but a group names",
       [](Bytes& b) {
         poke(b, record_offset(b, slots_kind, 0) + 24, none, 4);
         poke(b, record_offset(b, slots_kind, 0) + 28, none, 4);
       },
       AXISRT_OUT_OF_BOUNDS},
  };
}

std::vector<Mutation> group_mutations() {
  return {
      u32("name behind the names", groups_kind, 0, 0, 0xFFFFFFFF, AXISRT_OUT_OF_BOUNDS),
      u32("name too long", groups_kind, 0, 4, 1000, AXISRT_OUT_OF_BOUNDS),
      u32("first member", groups_kind, 0, 8, 1, AXISRT_OUT_OF_BOUNDS),
      u32("a member too few", groups_kind, 0, 12, 2, AXISRT_OUT_OF_BOUNDS),
      u32("a member too many", groups_kind, 0, 12, 4, AXISRT_OUT_OF_BOUNDS),
      u32("first bank", groups_kind, 0, 16, 1, AXISRT_OUT_OF_BOUNDS),
      u32("no bank", groups_kind, 0, 20, 0, AXISRT_OUT_OF_BOUNDS),
      u32("a bank too few", groups_kind, 0, 20, 5, AXISRT_OUT_OF_BOUNDS),
      u32("a bank too many", groups_kind, 0, 20, 7, AXISRT_OUT_OF_BOUNDS),
      u32("longest fade to off", groups_kind, 0, 24, 4096, AXISRT_OK),
      u32("fade to off too long", groups_kind, 0, 24, 4097, AXISRT_OUT_OF_BOUNDS),
      u32("axis of a member", members_kind, 1, 0, 3, AXISRT_OUT_OF_BOUNDS),
      u32("axis twice in a group", members_kind, 1, 0, 0, AXISRT_OUT_OF_BOUNDS),
      u32("keywords", banks_kind, 1, 0, 64, AXISRT_UNKNOWN_KIND),
      f64("SHARE", banks_kind, 2, 8, not_a_number, AXISRT_NOT_FINITE),
      f64("FCUT", banks_kind, 2, 16, infinity, AXISRT_NOT_FINITE),
      f64("QUALITY", banks_kind, 2, 24, -infinity, AXISRT_NOT_FINITE),
      u32("first choice", banks_kind, 1, 32, 0, AXISRT_OUT_OF_BOUNDS),
      u32("longest fade", banks_kind, 0, 36, 4096, AXISRT_OK),
      u32("fade too long", banks_kind, 0, 36, 4097, AXISRT_OUT_OF_BOUNDS),
      u32("chosen kernel", choices_kind, 0, 0, 4, AXISRT_OUT_OF_BOUNDS),
      u32("choice too long for the slot's history", choices_kind, 17, 0, 1, AXISRT_OUT_OF_BOUNDS),
      u32("choice of an axis without a slot", choices_kind, 1, 0, 0, AXISRT_OUT_OF_BOUNDS),
  };
}

}  // namespace

TEST_CASE("images with kernels are accepted") {
  CHECK(verify(write_image(channel_image())) == AXISRT_OK);
  ImageRecord stripped = channel_image();
  stripped.strip = true;
  CHECK(verify(write_image(stripped)) == AXISRT_OK);
  CHECK(verify(kernel_image(moving_average(100))) == AXISRT_OK);
  CHECK(verify(kernel_image(moving_average(101))) == AXISRT_KERNEL_TOO_LONG);
}

TEST_CASE("each fault of a kernel has its status") {
  check_mutations(channel_image(), kernel_mutations());
}

TEST_CASE("each fault of a slot has its status") {
  check_mutations(channel_image(), slot_mutations());
}

TEST_CASE("each fault of a group has its status") {
  check_mutations(channel_image(), group_mutations());
}

TEST_CASE("a kernel has at least one tail") {
  CHECK(verify(kernel_image(delay_kernel(1))) == AXISRT_OK);
  CHECK(verify(kernel_image(delay_kernel(0))) == AXISRT_OUT_OF_BOUNDS);
}

TEST_CASE("a slot's member is a record of its own axis") {
  ImageRecord image = channel_image();
  image.groups[0].members = {2, 1};
  for (BankRecord& bank : image.groups[0].banks) bank.choices.erase(bank.choices.begin());
  image.slots[0].group = none;
  CHECK(verify(write_image(image)) == AXISRT_OK);
  check_mutations(image, {{"member without a slot claimed by another axis",
                           [](Bytes& b) {
                             poke(b, record_offset(b, slots_kind, 0) + 24, 0, 4);
                             poke(b, record_offset(b, slots_kind, 0) + 28, 0, 4);
                           },
                           AXISRT_OUT_OF_BOUNDS}});
}

TEST_CASE("no record of a group is left over") {
  // One record more, made of the zeros between two sections.
  auto const one_more = [](std::string name, std::uint32_t kind) {
    return Mutation{std::move(name),
                    [kind](Bytes& b) {
                      std::size_t const at = entry_offset(b, kind);
                      poke(b, at + 16, peek(b, at + 16, 8) + 4, 8);
                      poke(b, at + 28, peek(b, at + 28, 4) + 1, 4);
                    },
                    AXISRT_OUT_OF_BOUNDS};
  };
  check_mutations(channel_image(), {one_more("member", members_kind), one_more("choice", choices_kind)});
  ImageRecord image = channel_image();
  image.groups.push_back({.name = "", .members = {}, .banks = {{}, {}}});
  CHECK(verify(write_image(image)) == AXISRT_OK);
  check_mutations(image, {u32("bank", groups_kind, 1, 20, 1, AXISRT_OUT_OF_BOUNDS)});
}

TEST_CASE("commands of two groups never reach one slot") {
  ImageRecord image = channel_image();
  image.groups.push_back(image.groups[0]);
  CHECK(verify(write_image(image)) == AXISRT_OUT_OF_BOUNDS);
  image.groups[1].members = {2};
  for (BankRecord& bank : image.groups[1].banks) bank.choices = {none};
  CHECK(verify(write_image(image)) == AXISRT_OK);
}

TEST_CASE("a reader that does not know the kernels' sections refuses the image") {
  // Their entries have no flag, so a missing kind is refused as any mandatory one.
  for (std::uint32_t const kind :
       {kernels_kind, tails_kind, slots_kind, groups_kind, members_kind, banks_kind, choices_kind}) {
    Bytes const image = write_image(channel_image());
    CHECK(peek(image, entry_offset(image, kind) + 4, 4) == 0);
  }
  check_mutations(channel_image(), {entry("later kind", groups_kind, 0, 13, 4, AXISRT_UNKNOWN_KIND)});
}
