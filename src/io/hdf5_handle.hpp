#pragma once

#include <hdf5.h>
#include <string>
#include <utility>

#include "wirepack/core/error.hpp"

namespace wirepack {

/// Throws FileError("<what> failed") when an HDF5 call returned a negative status.
template <class Status>
Status hdf5_checked(Status status, const std::string& what) {
  if (status < 0) throw FileError(what + " failed");
  return status;
}

/// Owns one HDF5 id of any kind and gives it back with the function for that kind.
class Hdf5Handle {
 public:
  using Close = herr_t (*)(hid_t);
  /// Throws FileError("<what> failed") when `id` is a negative status.
  Hdf5Handle(hid_t id, Close close, const std::string& what)
      : id_(hdf5_checked(id, what)), close_(close) {}
  ~Hdf5Handle() {
    if (id_ >= 0) close_(id_);
  }
  Hdf5Handle(Hdf5Handle&& other) noexcept
      : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Hdf5Handle& operator=(Hdf5Handle&&) = delete;
  Hdf5Handle(const Hdf5Handle&) = delete;
  Hdf5Handle& operator=(const Hdf5Handle&) = delete;

  operator hid_t() const { return id_; }  // NOLINT(google-explicit-constructor): it is the id

 private:
  hid_t id_;
  Close close_;
};

/// Keeps HDF5 from printing its error stack while it lives; errors arrive as FileError.
class QuietHdf5 {
 public:
  QuietHdf5() {
    H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  ~QuietHdf5() { H5Eset_auto2(H5E_DEFAULT, function_, data_); }
  QuietHdf5(const QuietHdf5&) = delete;
  QuietHdf5& operator=(const QuietHdf5&) = delete;

 private:
  H5E_auto2_t function_ = nullptr;
  void* data_ = nullptr;
};

}  // namespace wirepack
