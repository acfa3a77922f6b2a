#pragma once

#include <stdexcept>
#include <string>

namespace wirepack {

/// What the user gave is wrong: configuration, command line, input data. The message names the
/// place, the value and what is allowed; several problems are joined by newlines. Exit code 2.
class InvalidInput : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The numbers broke down: NaN, coincident nodes, a turn of pi between two edges. Exit code 4.
class NumericalFailure : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A file could not be read or written. Exit code 5.
class FileError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace wirepack
