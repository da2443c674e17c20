// Many workspaces in many threads: each gives what one gives alone, also where calls are cancelled meanwhile.
#include "axisc/axisc.h"
#include "support/catch.hpp"

#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <functional>
#include <future>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace {

std::string const samples = std::string(AXISC_SOURCE_DIR) + "/samples";

/// What one call gave. A cancelled one gave nothing.
struct Given {
  int status = 0;
  std::string bytes, error;

  bool operator==(Given const&) const = default;
};

using Call = std::function<int(axisc_workspace*, axisc_bytes*)>;

Given given_by(axisc_workspace* workspace, Call const& call) {
  axisc_bytes bytes{};
  Given given{.status = call(workspace, &bytes), .bytes = {}, .error = axisc_error(workspace)};
  if (bytes.data != nullptr) given.bytes.assign(bytes.data, bytes.size);
  axisc_free(&bytes);
  return given;
}

Call asking(std::string question) {
  return [question](axisc_workspace* workspace, axisc_bytes* answer) {
    return axisc_answer(workspace, question.c_str(), answer);
  };
}
std::string about(std::string const& name, std::string const& input, std::string const& more = "") {
  return R"({"question": ")" + name + R"(", "input": ")" + samples + "/" + input + "\"" + more + "}";
}
Call checking(std::string path) {
  return [path](axisc_workspace* workspace, axisc_bytes* findings) {
    return axisc_check(workspace, path.c_str(), findings);
  };
}

/// In this order, in every workspace.
std::vector<Call> const& calls() {
  static std::vector<Call> const all = {
      checking(samples + "/mill"),
      checking(samples + "/mistakes/typing.lis"),
      [](axisc_workspace* workspace, axisc_bytes* image) {
        return axisc_compile(workspace, (samples + "/motion/rack").c_str(), nullptr, image, nullptr);
      },
      asking(R"({"question": "explain", "word": "Kerbfilter", "format": "markdown"})"),
      asking(R"({"question": "explain", "word": "50663"})"),
      asking(about("machine", "controller")),
      asking(about("filters", "mill")),
      asking(about("contour", "motion/rack", R"(, "format": "json")")),
      asking(about("circle", "motion/square", R"(, "feed": "1000", "radius": "50")")),
      asking(about("picture", "motion/rack", R"(, "kind": "step")")),
      [](axisc_workspace* workspace, axisc_bytes* report) {
        auto const list = samples + "/mistakes/typing.lis";
        return axisc_fix(workspace, list.c_str(), AXISC_FIX_ALL, report);
      },
      checking(samples + "/mistakes/typing.lis"),  // as it is repaired
      [](axisc_workspace* workspace, axisc_bytes* replies) {
        return axisc_message(
            workspace,
            R"(["{\"jsonrpc\":\"2.0\",\"id\":1,\"method\":\"initialize\",\"params\":{\"capabilities\":{}}}",)"
            R"("{\"jsonrpc\":\"2.0\",\"method\":\"textDocument/didOpen\",\"params\":{\"textDocument\":)"
            R"({\"uri\":\"file:///x.lis\",\"languageId\":\"axis-list\",\"version\":1,\"text\":\"a 01\\n\"}}}"])",
            replies);
      }};
  return all;
}

/// The open workspace of a thread, for the thread that cancels.
struct Shown {
  std::mutex mutex;
  axisc_workspace* workspace = nullptr;

  void show(axisc_workspace* shown) {
    std::scoped_lock const lock(mutex);
    workspace = shown;
  }
};

struct Wanted {
  std::size_t workspaces, threads;
};

/// Every second workspace is of the other language, every third can be cancelled.
struct Outcome {
  std::size_t calls = 0, cancelled = 0;
  std::vector<std::string> mistakes = {};  ///< calls that gave something else
};

axisc_workspace* opened(std::size_t language) {
  static constexpr std::array options = {R"({"language": "en"})", R"({"language": "de"})"};
  axisc_workspace* workspace = nullptr;
  axisc_open(options.at(language), nullptr, &workspace);
  return workspace;
}

std::array<std::vector<Given>, 2> given_alone() {
  std::array<std::vector<Given>, 2> given;
  for (std::size_t language = 0; language < given.size(); ++language) {
    auto* const workspace = opened(language);
    for (auto const& call : calls()) given.at(language).push_back(given_by(workspace, call));
    axisc_close(workspace);
  }
  return given;
}

Outcome outcome_of(Wanted const& wanted) {
  auto const alone = given_alone();
  std::vector<Shown> shown(wanted.threads);
  std::vector<Outcome> outcomes(wanted.threads);
  std::atomic<std::size_t> next = 0;
  std::atomic<bool> is_over = false;
  auto const work = [&](std::size_t thread) {
    auto& outcome = outcomes[thread];
    for (auto i = next++; i < wanted.workspaces; i = next++) {
      auto* const workspace = opened(i % 2);
      if (i % 3 == 0) shown[thread].show(workspace);
      // After a cancelled repair the text is another.
      bool was_cancelled = false;
      for (std::size_t k = 0; k < calls().size() && !was_cancelled; ++k) {
        auto const given = given_by(workspace, calls()[k]);
        ++outcome.calls;
        was_cancelled = given.status == AXISC_CANCELLED;
        bool const is_right = was_cancelled ? i % 3 == 0 && given.bytes.empty() : given == alone.at(i % 2)[k];
        if (!is_right) {
          outcome.mistakes.push_back("workspace " + std::to_string(i) + ", call " + std::to_string(k) + ", " +
                                     std::to_string(given.status) + ": " + given.error);
        }
      }
      outcome.cancelled += was_cancelled ? 1 : 0;
      shown[thread].show(nullptr);
      axisc_close(workspace);
    }
  };
  std::thread canceller([&] {
    while (!is_over) {
      for (auto& one : shown) {
        std::scoped_lock const lock(one.mutex);
        axisc_cancel(one.workspace);
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(25));
    }
  });
  std::vector<std::thread> threads;
  for (std::size_t thread = 0; thread < wanted.threads; ++thread) threads.emplace_back(work, thread);
  for (auto& thread : threads) thread.join();
  is_over = true;
  canceller.join();
  Outcome all;
  for (auto const& outcome : outcomes) {
    all.calls += outcome.calls;
    all.cancelled += outcome.cancelled;
    all.mistakes.insert(all.mistakes.end(), outcome.mistakes.begin(), outcome.mistakes.end());
  }
  return all;
}

void check(Wanted const& wanted) {
  auto const outcome = outcome_of(wanted);
  CHECK(outcome.mistakes == std::vector<std::string>());
  CHECK(outcome.calls >= wanted.workspaces);
  CHECK(outcome.cancelled < wanted.workspaces);
  WARN(wanted.workspaces << " workspaces in " << wanted.threads << " threads: " << outcome.calls << " calls, "
                         << outcome.cancelled << " cancelled");
}

}  // namespace

TEST_CASE("what the threads are compared with are answers") {
  for (auto const& given : given_alone()) {
    for (std::size_t i = 0; i < given.size(); ++i) {
      INFO(i << ": " << given[i].error);
      CHECK(given[i].status >= AXISC_OK);
      CHECK(given[i].bytes.size() > 20);
    }
  }
}

TEST_CASE("workspaces in many threads give what one gives, also while others are cancelled") {
  check({.workspaces = 60, .threads = 8});
}

TEST_CASE("1,000 workspaces in many threads give what one gives", "[.long]") {
  check({.workspaces = 1000, .threads = 16});
}

TEST_CASE("a call that another thread cancels ends before it reads its next file") {
  struct Reader {
    std::promise<void> reads, goes_on;
    std::vector<std::string> paths = {};

    static int read(void* context, char const* path, axisc_bytes* file) {
      auto& reader = *static_cast<Reader*>(context);
      reader.paths.emplace_back(path);
      reader.reads.set_value();  // throws where there is a second file
      reader.goes_on.get_future().wait();
      std::string const machine = R"({"axes": [{"list": "x.lis"}]})";
      return axisc_copy(file, machine.data(), machine.size());
    }
  } reader;
  axisc_files const files{
      .size = sizeof(axisc_files), .reserved = 0, .context = &reader, .read = Reader::read, .list = nullptr};
  axisc_workspace* workspace = nullptr;
  REQUIRE(axisc_open(nullptr, &files, &workspace) == AXISC_OK);
  std::thread canceller([&] {
    reader.reads.get_future().wait();
    axisc_cancel(workspace);
    reader.goes_on.set_value();
  });
  auto const given = given_by(workspace, checking("shelf/machine.json"));
  canceller.join();
  CHECK(given.status == AXISC_CANCELLED);
  CHECK(given.bytes.empty());
  CHECK(reader.paths == std::vector<std::string>{"shelf/machine.json"});
  axisc_close(workspace);
}
