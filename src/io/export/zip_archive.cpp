#include "zip_archive.hpp"

#include <memory>
#include <zip.h>

#include "wirepack/core/error.hpp"

namespace wirepack {

namespace {

template <class T>
T made(T result) {
  if (!result) throw FileError("making a zip archive failed");
  return result;
}

void done(bool ok) { made(ok); }

void add(zip_t* archive, const ZipMember& member) {
  zip_source_t* const source =
      made(zip_source_buffer(archive, member.bytes.data(), member.bytes.size(), 0));
  const zip_int64_t index = zip_file_add(archive, member.name.c_str(), source, ZIP_FL_ENC_UTF_8);
  if (index < 0) zip_source_free(source);
  done(index >= 0);
  const auto place = static_cast<zip_uint64_t>(index);
  // the earliest date of the format, at noon: the same bytes on any day, in any time zone
  constexpr zip_uint16_t date = (0 << 9) | (1 << 5) | 1, time = 12 << 11;
  done(zip_file_set_dostime(archive, place, time, date, 0) == 0);
}

}  // namespace

std::string zip_archive(const std::vector<ZipMember>& members) {
  zip_error_t error;
  zip_error_init(&error);
  const std::unique_ptr<zip_source_t, void (*)(zip_source_t*)> memory(
      made(zip_source_buffer_create(nullptr, 0, 0, &error)), zip_source_free);
  zip_source_keep(memory.get());  // the archive takes one
  std::unique_ptr<zip_t, void (*)(zip_t*)> archive(
      zip_open_from_source(memory.get(), ZIP_TRUNCATE, &error), zip_discard);
  if (!archive) zip_source_free(memory.get());
  made(archive.get());
  for (const ZipMember& member : members) add(archive.get(), member);
  done(zip_close(archive.get()) == 0);
  archive.release();

  zip_stat_t status;
  zip_stat_init(&status);
  done(zip_source_stat(memory.get(), &status) == 0 && zip_source_open(memory.get()) == 0);
  std::string bytes(status.size, '\0');
  const zip_int64_t got = zip_source_read(memory.get(), bytes.data(), bytes.size());
  zip_source_close(memory.get());
  done(got == static_cast<zip_int64_t>(bytes.size()));
  return bytes;
}

}  // namespace wirepack
