#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <string>

#include "lsp/frames.hpp"
#include "lsp/message.hpp"
#include "lsp/position.hpp"
#include "lsp/uri.hpp"

namespace gapcheck::app::lsp {
namespace {

/// Reads what is written into a pipe.
class Pipe {
 public:
  explicit Pipe(const std::string& bytes) {
    EXPECT_EQ(::pipe(ends_.data()), 0);
    EXPECT_EQ(::write(ends_[1], bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
    ::close(ends_[1]);
  }
  ~Pipe() { ::close(ends_[0]); }
  [[nodiscard]] int out() const { return ends_[0]; }

 private:
  std::array<int, 2> ends_{};
};

TEST(LspFrames, MessagesOneAfterTheOther) {
  const Pipe pipe("Content-Length: 2\r\n\r\n{}content-length:3\r\nContent-Type: x\r\n\r\n[1]");
  FrameReader reader(pipe.out());
  EXPECT_EQ(reader.next().text, "{}");
  EXPECT_EQ(reader.next().text, "[1]");
  EXPECT_EQ(reader.next().kind, Frame::Kind::end);
}

TEST(LspFrames, ALargeMessageIsPassedOver) {
  const Pipe pipe("Content-Length: 7\r\n\r\n1234567Content-Length: 1\r\n\r\n8");
  FrameReader reader(pipe.out(), 6);
  EXPECT_EQ(reader.next().kind, Frame::Kind::refused);
  EXPECT_EQ(reader.next().text, "8");
}

TEST(LspFrames, BrokenHeaders) {
  for (const char* header : {"Content-Length: -1\r\n\r\n", "Content-Length: 99999999999999999999999\r\n\r\n",
                             "Content-Length: 1x\r\n\r\n", "Content-Length:\r\n\r\n", "Content-Length: 5\r\n\r\n{}",
                             "X: 1\r\n\r\n{}", "Content-Length: 5", "Content-Leng"}) {
    const Pipe pipe(header);
    EXPECT_EQ(FrameReader(pipe.out()).next().kind, Frame::Kind::broken) << header;
  }
  const Pipe pipe(std::string(longest_header + 2, 'x'));
  EXPECT_EQ(FrameReader(pipe.out()).next().kind, Frame::Kind::broken);
}

TEST(LspMessage, LongTextsMeanWhatJsonSays) {
  std::string raw = R"(\u00e4\ud83d\ude00\"\\\/\b\f\n\r\t\u0041 ä)";
  const std::string meant = json::parse('"' + raw + '"').get<std::string>();
  std::string many, expected;
  while (many.size() < 1'100'000) many += raw, expected += meant;
  const Message message = read_message("{\"a\":\"short\",\"b\":[\"" + many + "\"],\"c\":\"" + many + "x\"}");
  ASSERT_EQ(message.wrong, "");
  EXPECT_EQ(message.text(message.value["a"]), "short");
  EXPECT_TRUE(message.text(message.value["b"][0]) == expected);
  EXPECT_TRUE(message.text(message.value["c"]) == expected + "x");
  EXPECT_LT(message.value.dump().size(), 200U);
}

TEST(LspMessage, WhatIsNoMessage) {
  const std::string many(1'100'000, 'x');
  for (const std::string& text : {std::string("{"), std::string("\"a"), std::string("{\"a\": \"\xff\"}"), std::string(),
                                  "[\"" + many + "\\q\"]", "[\"" + many + "\\u12\"]", "[\"" + many})
    EXPECT_TRUE(read_message(text).value.is_discarded()) << text.substr(0, 20);
  const auto nested = [](std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); };
  EXPECT_FALSE(read_message(nested(deepest_nesting)).value.is_discarded());
  EXPECT_TRUE(read_message(nested(deepest_nesting + 1)).value.is_discarded());
  EXPECT_TRUE(read_message(std::string(5'000'000, '[')).value.is_discarded());
  // Brackets in texts are no nesting.
  EXPECT_FALSE(read_message('"' + std::string(1000, '[') + '"').value.is_discarded());
}

/// An editor that cuts a character in two sends its halves; each has one unit of UTF-16, and so has what is read.
TEST(LspMessage, HalfCharactersKeepTheirLength) {
  const auto read = [](const std::string& raw) {
    const Message message = read_message("[\"" + raw + "\"]");
    return message.value.is_discarded() ? message.wrong : message.text(message.value[0]);
  };
  const std::string half = "\xef\xbf\xbd", whole = "\xf0\x9f\x98\x80";
  for (const std::string& many : {std::string(), std::string(1'100'000, 'x')}) {
    EXPECT_TRUE(read(many + R"(a\ud83db)") == many + "a" + half + "b");
    EXPECT_TRUE(read(many + R"(\uDE00)") == many + half);
    EXPECT_TRUE(read(many + R"(\ud83d\ud83d\ude00\ude00)") == many + half + whole + half);
    EXPECT_TRUE(read(many + R"(\\ud83d)") == many + R"(\ud83d)") << "no escape";
    EXPECT_TRUE(read(many + R"(\ud83d\n)") == many + half + "\n");
  }
}

TEST(LspPosition, UnitsOfUtf16AndUtf8) {
  const std::string line = "a\xc3\xa4\xf0\x9f\x98\x80z";  // a ä 😀 z
  EXPECT_EQ(byte_at(line, 0, Encoding::utf16), 0U);
  EXPECT_EQ(byte_at(line, 2, Encoding::utf16), 3U);
  EXPECT_EQ(byte_at(line, 3, Encoding::utf16), 3U);  // between the halves
  EXPECT_EQ(byte_at(line, 4, Encoding::utf16), 7U);
  EXPECT_EQ(byte_at(line, 99, Encoding::utf16), line.size());
  EXPECT_EQ(byte_at(line, 3, Encoding::utf8), 3U);
  EXPECT_EQ(byte_at(line, 2, Encoding::utf8), 1U);  // inside ä
  EXPECT_EQ(units_before(line, line.size(), Encoding::utf16), 5U);
  EXPECT_EQ(units_before(line, line.size(), Encoding::utf8), 8U);
  EXPECT_EQ(units_before("\xff\xe4x", 3, Encoding::utf16), 3U);
}

TEST(LspPosition, WhatAClientMaySend) {
  const Text text("ab\ncd");
  Place place;
  EXPECT_TRUE(read_place({{"line", 1}, {"character", 1}}, text, Encoding::utf16, place));
  EXPECT_EQ(place, (Place{1, 1}));
  EXPECT_TRUE(read_place({{"line", 4'000'000'000'000}, {"character", 7}}, text, Encoding::utf16, place));
  EXPECT_EQ(place.line, 1U);
  EXPECT_TRUE(read_place({{"line", 0}, {"character", 99}}, text, Encoding::utf16, place));
  EXPECT_EQ(place, (Place{0, 2}));
  for (const json& wrong : {json(), json(1), json{{"line", -1}, {"character", 0}}, json{{"line", 0}},
                            json{{"line", "0"}, {"character", 0}}, json{{"line", 0.5}, {"character", 0}}})
    EXPECT_FALSE(read_place(wrong, text, Encoding::utf16, place)) << wrong;
}

TEST(LspUri, BlanksUmlautsAndOthers) {
  EXPECT_EQ(path_of("file:///a%20b/T%C3%BCr.k"), "/a b/T\xc3\xbcr.k");
  EXPECT_EQ(path_of("file://localhost/a"), "/a");
  EXPECT_EQ(path_of("file:///a%2"), "/a%2");
  EXPECT_EQ(path_of("untitled:Untitled-1"), "");
  EXPECT_EQ(path_of("file://server/share"), "");
  EXPECT_EQ(path_of("file:///a%00b"), "");
  EXPECT_EQ(uri_of("/a b/T\xc3\xbcr#.k"), "file:///a%20b/T%C3%BCr%23.k");
  EXPECT_EQ(path_of("file:///C%3A/a.k"), "/C:/a.k");  // only Windows has drives
  EXPECT_EQ(path_of(uri_of("/a b/T\xc3\xbcr#%.k")), "/a b/T\xc3\xbcr#%.k");
}

}  // namespace
}  // namespace gapcheck::app::lsp
