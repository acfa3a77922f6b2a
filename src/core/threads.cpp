#include "wirepack/core/threads.hpp"

#include <csignal>
#include <exception>
#include <omp.h>

namespace wirepack {

void use_threads(int count) { omp_set_num_threads(count); }

namespace {

// Signals are for threads that wait for them, which those of a pool do not.
void take_no_signals() {
  thread_local bool takes_signals = omp_get_thread_num() > 0;
  if (!takes_signals) return;
  takes_signals = false;
  sigset_t all;
  sigfillset(&all);
  pthread_sigmask(SIG_BLOCK, &all, nullptr);
}

}  // namespace

// An exception may not leave a parallel region: the first one waits for its end.
void detail::run_shared(Index count, void (*call)(void* work, Index number), void* work) {
  if (omp_get_max_threads() == 1 || omp_in_parallel() != 0) {
    for (Index k = 0; k < count; ++k) call(work, k);
    return;
  }
  std::exception_ptr thrown;
#pragma omp parallel
  {
    take_no_signals();
#pragma omp for schedule(dynamic, 1)
    for (Index k = 0; k < count; ++k) {
      try {
        call(work, k);
      } catch (...) {
#pragma omp critical(wirepack_exception)
        if (!thrown) thrown = std::current_exception();
      }
    }
  }
  if (thrown) std::rethrow_exception(thrown);
}

}  // namespace wirepack
