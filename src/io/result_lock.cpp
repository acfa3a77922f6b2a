#include "wirepack/io/result_lock.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <fstream>
#include <sstream>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include "wirepack/core/error.hpp"

#include "file_descriptor.hpp"

namespace wirepack {

struct ResultLock::Held {
  std::filesystem::path file;
  FileDescriptor descriptor;
  std::string doubt;
};

namespace {

// A link to a result and the result are one.
std::filesystem::path lock_file_of(const std::filesystem::path& result) {
  std::error_code error;
  std::filesystem::path file = std::filesystem::weakly_canonical(result, error);
  if (error) file = result;
  return file += ".lock";
}

// Locks of an open file, not of a process: no other close() of ours gives them back, they can be
// asked for without being taken, and NFS hands them on to its server.
int lock_call(int descriptor, int command, struct flock& range) {
  range = {};
  range.l_type = F_WRLCK;
  range.l_whence = SEEK_SET;
  return ::fcntl(descriptor, command, &range);
}

bool is_at(const std::filesystem::path& file, int descriptor) {
  struct stat opened {
  }, there{};
  return ::fstat(descriptor, &opened) == 0 && ::stat(file.c_str(), &there) == 0 &&
         opened.st_dev == there.st_dev && opened.st_ino == there.st_ino;
}

std::string first_bytes(int descriptor) {
  std::array<char, 200> text{};
  const ssize_t size = ::pread(descriptor, text.data(), text.size(), 0);
  return {text.data(), static_cast<std::size_t>(std::max<ssize_t>(size, 0))};
}

std::string holder_in(int descriptor) {
  std::string holder = first_bytes(descriptor);
  if (holder.empty() || holder.back() != '\n') return "another process";
  holder.pop_back();
  for (char& c : holder) {
    if (static_cast<unsigned char>(c) < 0x20) c = '?';
  }
  return holder;
}

void write_holder(int descriptor) {
  std::array<char, 100> host{};
  ::gethostname(host.data(), host.size() - 1);
  const std::string text = fmt::format("process {} on {}\n", ::getpid(), host.data());
  // It is for messages only: a full disk does not matter.
  const bool written =
      ::ftruncate(descriptor, 0) == 0 && ::pwrite(descriptor, text.data(), text.size(), 0) >= 0;
  static_cast<void>(written);
}

// NFS that is mounted with nolock, or with local_lock, keeps locks to one machine.
bool locks_stay_here(int descriptor) {
  struct stat status {};
  if (::fstat(descriptor, &status) != 0) return false;
  const std::string device = fmt::format("{}:{}", major(status.st_dev), minor(status.st_dev));
  std::ifstream mounts("/proc/self/mountinfo");
  for (std::string line; std::getline(mounts, line);) {
    std::istringstream words(line);
    std::string number, parent, of;
    words >> number >> parent >> of;
    if (of != device) continue;
    const bool nfs = line.find(" - nfs") != std::string::npos;
    return nfs && (line.find("local_lock=all") != std::string::npos ||
                   line.find("local_lock=posix") != std::string::npos);
  }
  return false;
}

}  // namespace

ResultLock::ResultLock(const std::filesystem::path& result)
    : held_(std::make_unique<Held>(Held{lock_file_of(result), FileDescriptor(-1), ""})) {
  const std::filesystem::path& file = held_->file;
  do {
    held_->descriptor =
        FileDescriptor(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666));
    const int descriptor = held_->descriptor.number();
    if (descriptor < 0) {
      throw FileError(fmt::format("{}: cannot be written: {}", file.string(), strerror(errno)));
    }
    struct flock range {};
    if (lock_call(descriptor, F_OFD_SETLK, range) == 0) continue;
    if (errno == EAGAIN || errno == EACCES) {
      throw FileError(fmt::format("{} is being written by {}; two runs cannot share a result",
                                  result.string(), holder_in(descriptor)));
    }
    held_->doubt = std::string("its file system cannot lock files: ") + strerror(errno);
    // Who had the lock and has ended has taken the file away, and another may have made a new one.
  } while (!is_at(file, held_->descriptor.number()));
  const std::string before = first_bytes(held_->descriptor.number());
  if (!before.empty() && before.rfind("process ", 0) != 0) {
    throw FileError(file.string() + ": is in the way: a run needs a file of this name as its lock");
  }
  write_holder(held_->descriptor.number());
  if (locks_stay_here(held_->descriptor.number())) {
    held_->doubt = "locks of its file system (NFS without locks) do not reach other machines";
  }
}

ResultLock::~ResultLock() {
  if (held_) ::unlink(held_->file.c_str());
}
ResultLock::ResultLock(ResultLock&&) noexcept = default;

const std::string& ResultLock::doubt() const { return held_->doubt; }

std::optional<std::string> writer_of(const std::filesystem::path& result) {
  const FileDescriptor file(
      ::open(lock_file_of(result).c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK));
  struct flock range {};
  const bool locked = file.number() >= 0 && lock_call(file.number(), F_OFD_GETLK, range) == 0 &&
                      range.l_type != F_UNLCK;
  return locked ? std::optional(holder_in(file.number())) : std::nullopt;
}

}  // namespace wirepack
