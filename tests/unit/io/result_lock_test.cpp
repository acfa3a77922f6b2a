#include "wirepack/io/result_lock.hpp"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <unistd.h>

#include "wirepack/core/error.hpp"

#include "../../support/temporary_folder.hpp"

namespace wirepack {
namespace {

class ResultLockTest : public ::testing::Test {
 protected:
  testing::TemporaryFolder folder_;
  std::filesystem::path result_ = folder_ / "out.h5";
};

TEST_F(ResultLockTest, only_one_has_it_and_it_ends_with_its_scope) {
  {
    const ResultLock lock(result_);
    EXPECT_TRUE(lock.doubt().empty());
    EXPECT_THROW(ResultLock{result_}, FileError);
    EXPECT_NO_THROW(ResultLock{folder_ / "other.h5"});
    const auto writer = writer_of(result_);
    ASSERT_TRUE(writer);
    EXPECT_EQ(writer->find("process " + std::to_string(::getpid()) + " on "), 0u);
  }
  EXPECT_FALSE(writer_of(result_));
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path()));
  EXPECT_NO_THROW(ResultLock{result_});
}

TEST_F(ResultLockTest, asking_for_the_writer_takes_nothing) {
  const ResultLock lock(result_);
  EXPECT_TRUE(writer_of(result_));
  EXPECT_TRUE(writer_of(result_));
  EXPECT_THROW(ResultLock{result_}, FileError);
}

TEST_F(ResultLockTest, a_link_to_a_result_is_that_result) {
  std::ofstream(result_) << "x";
  std::filesystem::create_symlink(result_, folder_ / "link.h5");
  const ResultLock lock(result_);
  EXPECT_THROW(ResultLock{folder_ / "link.h5"}, FileError);
}

TEST_F(ResultLockTest, what_a_killed_process_leaves_does_not_count) {
  std::ofstream(folder_ / "out.h5.lock") << "process 1 on nowhere\n";
  EXPECT_FALSE(writer_of(result_));
  EXPECT_NO_THROW(ResultLock{result_});
}

TEST_F(ResultLockTest, a_file_of_the_user_is_not_taken_for_a_lock) {
  std::ofstream(folder_ / "out.h5.lock") << "my notes\n";
  EXPECT_THROW(ResultLock{result_}, FileError);
  std::string line;
  std::ifstream in(folder_ / "out.h5.lock");
  std::getline(in, line);
  EXPECT_EQ(line, "my notes");
}

}  // namespace
}  // namespace wirepack
