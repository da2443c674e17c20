// Frames arrive in pieces of any size.
#include "editor/framing.hpp"

#include "support/catch.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace framing_test {

using namespace axisc::editor;

namespace {

std::vector<std::string> read(FrameReader& frames) {
  std::vector<std::string> messages;
  while (auto message = frames.next()) messages.push_back(std::move(*message));
  return messages;
}

bool breaks(std::string_view bytes) {
  FrameReader frames;
  frames.add(bytes);
  static_cast<void>(read(frames));
  return frames.is_broken();
}

}  // namespace

TEST_CASE("messages come out of their frames, whatever the pieces that arrive") {
  std::vector<std::string> const messages = {"{}", "", "{\"a\": \"\r\n\r\n\"}", std::string(5000, 'x')};
  std::string bytes;
  for (auto const& message : messages) bytes += framed(message);
  auto const size = GENERATE(std::size_t{1}, std::size_t{2}, std::size_t{17}, std::size_t{100'000});
  FrameReader frames;
  std::vector<std::string> found;
  for (std::size_t at = 0; at < bytes.size(); at += size) {
    frames.add(std::string_view(bytes).substr(at, size));
    for (auto& message : read(frames)) found.push_back(std::move(message));
  }
  CHECK(found == messages);
  CHECK_FALSE(frames.is_broken());
}

TEST_CASE("a header names the length of the message, among other things and in any case") {
  FrameReader frames;
  frames.add("Content-Type: x\r\ncontent-LENGTH:   2\r\n\r\n{}");
  CHECK(read(frames) == std::vector<std::string>{"{}"});
  frames.add("Content-Length: 100\r\n\r\n{\"jsonrpc\":");
  CHECK(read(frames).empty());
  CHECK_FALSE(frames.is_broken());
}

TEST_CASE("nothing is read after a header without a usable length") {
  CHECK(breaks("Content-Length: many\r\n\r\n{}"));
  CHECK(breaks("Content-Length: -5\r\n\r\n{}"));
  CHECK(breaks("Content-Length: 99999999999999999999\r\n\r\n{}"));
  CHECK(breaks("Content-Length: 1073741825\r\n\r\n{}"));
  CHECK(breaks("Content-Type: x\r\n\r\n{}"));
  CHECK(breaks(std::string(100'000, 'x')));
  CHECK_FALSE(breaks("Content-Len"));
  // Too short by one byte: the next header is not one.
  CHECK(breaks("Content-Length: 1\r\n\r\n{}" + framed("{}")));
}

}  // namespace framing_test
