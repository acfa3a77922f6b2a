#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace wirepack {

/// The right to write one result, which one process has at a time: a lock of the kernel on the file
/// RESULT.lock, which is there while a run is. It ends with the process, however that ends; what a
/// kill -9 leaves of the file does not count. Whoever reads a result needs no lock.
class ResultLock {
 public:
  /// Throws FileError when another process has it, and says which, or when the file cannot be made.
  explicit ResultLock(const std::filesystem::path& result);
  ~ResultLock();
  ResultLock(ResultLock&&) noexcept;

  /// Why the lock may not keep others away: a file system that has no locks, or none that other
  /// machines know of. Empty: it does.
  const std::string& doubt() const;

 private:
  struct Held;
  std::unique_ptr<Held> held_;
};

/// The process that has the lock of a result, as "process 123 on host"; nothing when none has.
std::optional<std::string> writer_of(const std::filesystem::path& result);

}  // namespace wirepack
