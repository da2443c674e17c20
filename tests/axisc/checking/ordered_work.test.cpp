#include "axisc/checking/ordered_work.hpp"

#include "support/catch.hpp"

#include <atomic>
#include <chrono>
#include <stdexcept>

using namespace axisc;

namespace {

void wait(unsigned microseconds) {
  std::this_thread::sleep_for(std::chrono::microseconds(microseconds));
}

}  // namespace

TEST_CASE("results come in order, whoever finishes first") {
  for (unsigned const threads : {1U, 2U, 7U}) {
    std::vector<std::size_t> taken;
    in_order<std::size_t>({.count = 500,
                           .work =
                               [](std::size_t i) {
                                 wait(i % 7 == 0 ? 300 : 1);
                                 return i * i;
                               },
                           .take =
                               [&](std::size_t i, std::size_t&& result) {
                                 CHECK(result == i * i);
                                 taken.push_back(i);
                               },
                           .weight = [](std::size_t const&) { return std::size_t{8}; }},
                          threads);
    CHECK(taken.size() == 500);
    CHECK(std::is_sorted(taken.begin(), taken.end()));
  }
}

TEST_CASE("threads do not run far ahead of a slow reader") {
  std::atomic<std::size_t> made{0};
  std::size_t furthest = 0;
  constexpr std::size_t large = most_waiting_bytes / 4;
  in_order<int>({.count = 100,
                 .work =
                     [&](std::size_t) {
                       ++made;
                       return 0;
                     },
                 .take =
                     [&](std::size_t i, int&&) {
                       wait(500);
                       furthest = std::max(furthest, made - i);
                     },
                 .weight = [](int const&) { return large; }},
                2);
  // Four finished ones fill the room, and each thread may be at work on one more piece.
  CHECK(furthest <= 4 + 3 * 4);
}

TEST_CASE("the first exception in order ends the work, after the results before it") {
  std::vector<std::size_t> taken;
  auto const run = [&] {
    in_order<int>({.count = 200,
                   .work =
                       [](std::size_t i) {
                         if (i == 40) wait(2000);
                         if (i == 40 || i == 60) throw std::runtime_error(std::to_string(i));
                         return 0;
                       },
                   .take = [&](std::size_t i, int&&) { taken.push_back(i); },
                   .weight = [](int const&) { return std::size_t{1}; }},
                  4);
  };
  CHECK_THROWS_WITH(run(), "40");
  CHECK(taken.size() == 40);
  auto const closed = [] {
    in_order<int>({.count = 1000,
                   .work = [](std::size_t) { return 0; },
                   .take = [](std::size_t, int&&) { throw std::runtime_error("closed"); },
                   .weight = [](int const&) { return std::size_t{1}; }},
                  4);
  };
  CHECK_THROWS_WITH(closed(), "closed");
}
