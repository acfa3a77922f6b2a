#include "wirepack/core/shell_quoted.hpp"

#include <cstdio>
#include <gtest/gtest.h>
#include <sys/wait.h>

namespace wirepack {
namespace {

// What a shell hands to a program that is given this word.
std::string read_by_a_shell(const std::string& word) {
  std::FILE* shell = popen(("printf %s. " + word).c_str(), "r");
  std::string text;
  for (int c = std::fgetc(shell); c != EOF; c = std::fgetc(shell)) text += static_cast<char>(c);
  EXPECT_EQ(pclose(shell), 0);
  return text;
}

TEST(ShellQuoted, a_shell_reads_back_what_was_quoted) {
  for (const char* text : {"", "plain/name.h5", "two words", "it's", "$HOME `id` $(id)", "a\\b\"c",
                           "*?[a]{b,c}~!#&;|<>()", "one\ntwo\tthree", "\xce\xb6", "-n", "''"}) {
    EXPECT_EQ(read_by_a_shell(shell_quoted(text)), std::string(text) + ".");
  }
}

TEST(ShellQuoted, words_that_need_no_quotes_have_none) {
  EXPECT_EQ(shell_quoted("/usr/bin/wirepack"), "/usr/bin/wirepack");
  EXPECT_EQ(shell_quoted("setup=low_torsion,radius=10"), "setup=low_torsion,radius=10");
  EXPECT_EQ(shell_quoted("~"), "'~'");
}

}  // namespace
}  // namespace wirepack
