#include "process_pool.hpp"

#include <cerrno>
#include <csignal>
#include <gtest/gtest.h>
#include <stdexcept>
#include <sys/wait.h>

#include "wirepack/core/error.hpp"

namespace wirepack {

namespace {

// A pool that waits for ever is a failure and not a test that never ends.
PoolEvents impatient(std::vector<int>& codes) {
  int events = 0;
  return {[&codes](std::size_t command, int code) { codes.at(command) = code; },
          [events]() mutable {
            if (++events > 30) throw std::runtime_error("what has ended is still waited for");
          }};
}

TEST(ProcessPool, tells_exit_codes_and_signals_of_what_has_ended) {
  std::vector<int> codes(3, -100);
  EXPECT_TRUE(run_processes({{"true"}, {"sh", "-c", "exit 7"}, {"sh", "-c", "kill -KILL $$"}},
                            ProcessKind::other, 2, impatient(codes)));
  EXPECT_EQ(codes, (std::vector<int>{0, 7, -SIGKILL}));
}

TEST(ProcessPool, waits_for_its_processes_also_where_the_caller_ignores_their_ends) {
  struct sigaction ignored {
  }, before{}, after{};
  ignored.sa_handler = SIG_IGN;
  sigaction(SIGCHLD, &ignored, &before);
  std::vector<int> codes(2, -100);
  EXPECT_TRUE(
      run_processes({{"true"}, {"sh", "-c", "exit 7"}}, ProcessKind::other, 1, impatient(codes)));
  sigaction(SIGCHLD, &before, &after);
  EXPECT_EQ(codes, (std::vector<int>{0, 7}));
  EXPECT_EQ(after.sa_handler, SIG_IGN) << "what the caller wants is not restored";
}

TEST(ProcessPool, leaves_nothing_running_when_a_program_cannot_be_started) {
  std::vector<int> codes(2, -100);
  EXPECT_THROW(run_processes({{"sleep", "1000"}, {"/there/is/no/such/program"}}, ProcessKind::other,
                             2, impatient(codes)),
               FileError);
  EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1);
  EXPECT_EQ(errno, ECHILD);
}

}  // namespace

}  // namespace wirepack
