#include "wirepack/core/plain_text.hpp"

#include <gtest/gtest.h>

namespace wirepack {
namespace {

TEST(PlainText, text_of_any_language_stays) {
  const std::string text = "phi = 0.5, \xce\xb6, \xe2\x82\xac, \xf0\x9f\x98\x80, 'a' \"b\" $(c)";
  EXPECT_EQ(plain_text(text), text);
  EXPECT_EQ(plain_lines(text + "\n\tmore"), text + "\n\tmore");
}

TEST(PlainText, what_a_terminal_obeys_is_replaced) {
  EXPECT_EQ(plain_text("a\x1b[31mb\x7f"), "a?[31mb?");
  EXPECT_EQ(plain_text("one\ntwo\r\tthree"), "one?two??three");
  EXPECT_EQ(plain_lines("one\ntwo\r\tthree"), "one\ntwo?\tthree");
  EXPECT_EQ(plain_text("\xc2\x9b"), "??");  // CSI of ISO 8859-1
  EXPECT_EQ(plain_text(std::string("a\0b", 3)), "a?b");
}

TEST(PlainText, bytes_that_are_no_characters_are_replaced) {
  EXPECT_EQ(plain_text("\xff"
                       "a\xc3"),
            "?a?");
  EXPECT_EQ(plain_text("\xc0\xaf"), "??");            // a slash in disguise
  EXPECT_EQ(plain_text("\xed\xa0\x80"), "???");       // half of a pair
  EXPECT_EQ(plain_text("\xf4\x90\x80\x80"), "????");  // beyond the last character
}

TEST(PlainText, long_texts_are_cut_between_characters) {
  EXPECT_EQ(plain_text("12345", 5), "12345");
  EXPECT_EQ(plain_text("123456", 5), "12345...");
  EXPECT_EQ(plain_text("123\xe2\x82\xac", 5), "123...");
  EXPECT_EQ(plain_text("12\xe2\x82\xac"
                       "3",
                       5),
            "12\xe2\x82\xac...");
  EXPECT_EQ(plain_text("\x1b[31mlong", 2), "?[...");
}

}  // namespace
}  // namespace wirepack
