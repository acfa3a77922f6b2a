#include "atomic_file.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <string>
#include <sys/stat.h>
#include <unistd.h>

#include "wirepack/core/error.hpp"

#include "file_descriptor.hpp"

namespace wirepack {

namespace {

// Short, so that the longest name of a result has room for it; hidden, as it is there for moments.
constexpr std::string_view beginning = ".wirepack-", ending = ".tmp";

std::string beginning_on_this_host() {
  std::array<char, 100> host{};
  ::gethostname(host.data(), host.size() - 1);
  return fmt::format("{}{}-", beginning, host.data());
}

[[noreturn]] void fail(const std::filesystem::path& file, const char* action) {
  const int reason = errno;
  throw FileError(file.string() + ": cannot be " + action + ": " + std::strerror(reason));
}

std::filesystem::path folder_of(const std::filesystem::path& file) {
  return file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
}

// Rights and owner of a file are the user's business; where they cannot be given, it stays ours.
void take_over_rights(const std::filesystem::path& from, int descriptor) {
  struct stat status {};
  if (::stat(from.c_str(), &status) != 0) return;
  const bool owned = ::fchown(descriptor, status.st_uid, status.st_gid) == 0;
  static_cast<void>(owned);
  ::fchmod(descriptor, status.st_mode & 0777);
}

// Everything up to the rename; false with errno when a step fails.
bool write_durably(const std::filesystem::path& file, const std::filesystem::path& target,
                   std::span<const char> bytes) {
  FileDescriptor out(::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
  if (out.number() < 0) return false;
  take_over_rights(target, out.number());
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t n = ::write(out.number(), bytes.data() + done, bytes.size() - done);
    if (n < 0 && errno != EINTR) return false;
    if (n > 0) done += static_cast<std::size_t>(n);
  }
  return ::fsync(out.number()) == 0 && out.close() == 0;
}

}  // namespace

std::vector<char> read_bytes(const std::filesystem::path& file) {
  const FileDescriptor in(::open(file.c_str(), O_RDONLY | O_CLOEXEC));
  struct stat status {};
  if (in.number() < 0 || ::fstat(in.number(), &status) != 0) fail(file, "read");
  std::vector<char> bytes(static_cast<std::size_t>(status.st_size));
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t n = ::read(in.number(), bytes.data() + done, bytes.size() - done);
    if (n == 0) throw FileError(file.string() + ": cannot be read: it has just become shorter");
    if (n < 0 && errno != EINTR) fail(file, "read");
    if (n > 0) done += static_cast<std::size_t>(n);
  }
  return bytes;
}

void replace_file(const std::filesystem::path& file, std::span<const char> bytes) {
  // Host and process keep runs that share a folder from mixing their bytes.
  const std::filesystem::path temporary =
      folder_of(file) / fmt::format("{}{}{}", beginning_on_this_host(), ::getpid(), ending);
  ::unlink(temporary.c_str());
  if (!write_durably(temporary, file, bytes) || ::rename(temporary.c_str(), file.c_str()) != 0) {
    const int reason = errno;
    ::unlink(temporary.c_str());
    errno = reason;
    fail(file, "written");
  }
  // The new name itself must survive a power cut. Some file systems cannot sync folders; the file
  // is in place all the same.
  const FileDescriptor folder(::open(folder_of(file).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (folder.number() >= 0) ::fsync(folder.number());
}

void remove_leftovers(const std::filesystem::path& file) {
  const std::string start = beginning_on_this_host();
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder_of(file), ignored)) {
    const std::string name = entry.path().filename().string();
    if (name.size() <= start.size() + ending.size() || name.compare(0, start.size(), start) != 0 ||
        name.compare(name.size() - ending.size(), ending.size(), ending) != 0) {
      continue;
    }
    const std::string number =
        name.substr(start.size(), name.size() - start.size() - ending.size());
    const bool all_digits = number.find_first_not_of("0123456789") == std::string::npos;
    const bool dead = all_digits && number.size() < 10 &&
                      ::kill(static_cast<pid_t>(std::atol(number.c_str())), 0) != 0 &&
                      errno == ESRCH;
    if (dead) std::filesystem::remove(entry.path(), ignored);
  }
}

}  // namespace wirepack
