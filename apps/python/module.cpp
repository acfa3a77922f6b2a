#include "module.hpp"

#include <cmath>
#include <fmt/format.h>
#include <omp.h>
#include <system_error>
#include <utility>

#include "wirepack/core/error.hpp"
#include "wirepack/core/plain_text.hpp"
#include "wirepack/core/threads.hpp"

namespace wirepack {

namespace {

void set_error(PyObject* type, const std::exception& error) {
  PyErr_SetString(type, plain_lines(error.what()).c_str());
}

// What ends the program with exit code 2 or 5, with the same message.
void translate(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(std::move(thrown));
  } catch (const InvalidInput& error) {
    set_error(PyExc_ValueError, error);
  } catch (const FileError& error) {
    set_error(PyExc_OSError, error);
  } catch (const std::system_error& error) {
    set_error(PyExc_OSError, error);
  }
}

}  // namespace

Threads::Threads(int count) : before_(omp_get_max_threads()) {
  if (count < 1 || count > most_threads) {
    throw InvalidInput(fmt::format("threads = {}: must be from 1 to {}", count, most_threads));
  }
  use_threads(count);
}

Threads::~Threads() { use_threads(before_); }

std::vector<Quat> frames_of(const Quaternions& quaternion, Index edges) {
  if (quaternion.rows() != edges) {
    throw InvalidInput(
        fmt::format("quaternion: has {} rows; must have one for each of the {} edges",
                    quaternion.rows(), edges));
  }
  std::vector<Quat> frames;
  for (Index j = 0; j < edges; ++j) {
    const Eigen::RowVector4d q = quaternion.row(j);
    if (!(q.norm() > 0 && std::isfinite(q.norm())))
      throw InvalidInput(fmt::format("quaternion[{}]: has no length, or an infinite one", j));
    frames.push_back(Quat(q[0], q[1], q[2], q[3]).normalized());
  }
  return frames;
}

}  // namespace wirepack

PYBIND11_MODULE(_wirepack, module) {
  module.doc() = "What wirepack.py packs wires with, and observables of positions.";
  pybind11::register_exception<wirepack::NumericalFailure>(module, "NumericalFailure",
                                                           PyExc_RuntimeError);
  pybind11::register_exception_translator(wirepack::translate);
  wirepack::add_packing(module);
  wirepack::add_observables(module);
}
