#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <sys/mman.h>
#include <unistd.h>

/// A file with these bytes that is on no disk, while it lives.
class FileInMemory {
 public:
  FileInMemory(const std::uint8_t* data, std::size_t size) : number_(memfd_create("fuzz", 0)) {
    good_ = write(number_, data, size) == static_cast<ssize_t>(size);
  }
  ~FileInMemory() { close(number_); }
  FileInMemory(const FileInMemory&) = delete;
  FileInMemory& operator=(const FileInMemory&) = delete;
  bool good() const { return good_; }
  std::filesystem::path path() const { return "/proc/self/fd/" + std::to_string(number_); }

 private:
  int number_;
  bool good_;
};
