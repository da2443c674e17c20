// Parallel work on many tasks whose results are taken one after another, in the order of the tasks.
#pragma once

#include <algorithm>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace axisc {

template <class Result>
struct OrderedTasks {
  std::size_t count = 0;
  std::function<Result(std::size_t)> work;           ///< called by many threads
  std::function<void(std::size_t, Result&&)> take;   ///< called by the caller's thread, by rising index
  std::function<std::size_t(Result const&)> weight;  ///< bytes of a result
};

/// Finished results that have not been taken occupy at most about this much memory; beyond it the threads
/// wait.
inline constexpr std::size_t most_waiting_bytes = std::size_t{16} << 20U;

/// The threads of one call of in_order().
template <class Result>
class OrderedWork {
 public:
  OrderedWork(OrderedTasks<Result> const& tasks, unsigned threads)
      : tasks_(tasks),
        piece_(std::clamp<std::size_t>(tasks.count / (std::size_t{16} * threads), 1, largest_piece)),
        pieces_((tasks.count + piece_ - 1) / piece_),
        window_(std::size_t{4} * threads) {
    auto const wanted = std::min<std::size_t>(threads, pieces_);
    for (std::size_t i = 0; i < wanted; ++i) {
      try {
        threads_.emplace_back([this] { run(); });
      } catch (std::system_error const&) {
        // If fewer threads could be started than wanted, they do all the work.
        if (threads_.empty()) throw;
        break;
      }
    }
  }
  OrderedWork(OrderedWork const&) = delete;
  OrderedWork& operator=(OrderedWork const&) = delete;
  ~OrderedWork() {
    {
      std::lock_guard const lock(mutex_);
      stopped_ = true;
    }
    room_.notify_all();
    for (auto& thread : threads_) thread.join();
  }

  void take_all() {
    for (std::size_t i = 0; i < pieces_; ++i) take(next_finished());
  }

 private:
  /// This many neighbours go to one thread together, because handing over costs more than a small input.
  static constexpr std::size_t largest_piece = 16;

  struct Piece {
    std::size_t first = 0;
    std::vector<Result> results;
    std::exception_ptr error;  ///< of the task after `results`
    std::size_t weight = 0;
  };

  void run() {
    while (auto const number = next_to_do()) {
      Piece piece{.first = *number * piece_, .results = {}, .error = {}, .weight = 0};
      auto const end = std::min(piece.first + piece_, tasks_.count);
      try {
        for (std::size_t i = piece.first; i < end; ++i) {
          piece.results.push_back(tasks_.work(i));
          piece.weight += tasks_.weight(piece.results.back());
        }
      } catch (...) {
        piece.error = std::current_exception();
      }
      finish(*number, std::move(piece));
    }
  }

  /// Waits for room. The piece that is taken next never waits: otherwise the threads could deadlock.
  std::optional<std::size_t> next_to_do() {
    std::unique_lock lock(mutex_);
    room_.wait(lock, [this] {
      bool const near = begun_ < taken_ + window_ && waiting_bytes_ < most_waiting_bytes;
      return stopped_ || begun_ == pieces_ || begun_ == taken_ || near;
    });
    if (stopped_ || begun_ == pieces_) return std::nullopt;
    return begun_++;
  }

  void finish(std::size_t number, Piece piece) {
    {
      std::lock_guard const lock(mutex_);
      while (finished_.size() <= number - taken_) finished_.emplace_back();
      waiting_bytes_ += piece.weight;
      finished_[number - taken_] = std::move(piece);
    }
    done_.notify_one();
  }

  Piece next_finished() {
    std::unique_lock lock(mutex_);
    done_.wait(lock, [this] { return !finished_.empty() && finished_.front().has_value(); });
    Piece piece = *std::move(finished_.front());
    finished_.pop_front();
    ++taken_;
    waiting_bytes_ -= piece.weight;
    lock.unlock();
    room_.notify_all();
    return piece;
  }

  void take(Piece piece) {
    for (std::size_t i = 0; i < piece.results.size(); ++i) {
      tasks_.take(piece.first + i, std::move(piece.results[i]));
    }
    if (piece.error) std::rethrow_exception(piece.error);
  }

  OrderedTasks<Result> const& tasks_;
  std::size_t piece_;
  std::size_t pieces_;
  std::size_t window_;
  std::mutex mutex_;
  std::condition_variable room_;  ///< something was taken
  std::condition_variable done_;  ///< something was finished
  std::size_t begun_ = 0;
  std::size_t taken_ = 0;
  std::size_t waiting_bytes_ = 0;
  std::deque<std::optional<Piece>> finished_;  ///< from number `taken_` on
  bool stopped_ = false;
  std::vector<std::thread> threads_;
};

/// A single thread does the work, and each result is taken before the next one is begun.
[[nodiscard]] constexpr bool is_one_by_one(std::size_t count, unsigned threads) {
  return threads <= 1 || count <= 1;
}

/// Memory: that of `threads` results at work, and most_waiting_bytes of finished ones. An exception of `work`
/// for the lowest index is rethrown here, after the results before it were taken and all threads have ended.
template <class Result>
void in_order(OrderedTasks<Result> const& tasks, unsigned threads) {
  if (is_one_by_one(tasks.count, threads)) {
    for (std::size_t i = 0; i < tasks.count; ++i) tasks.take(i, tasks.work(i));
    return;
  }
  OrderedWork<Result>(tasks, threads).take_all();
}

}  // namespace axisc
