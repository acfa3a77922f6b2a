#pragma once

#include <chrono>

namespace wirepack {

// When to save a run: with every frame and every so many seconds, if that does not take too much
// time.
class SavingTimes {
 public:
  explicit SavingTimes(double every_seconds) : every_seconds_(every_seconds) {}

  // Saves, and notes how long it takes.
  template <class Save>
  void time(Save&& save) {
    const Clock::time_point start = Clock::now();
    save();
    last_ = Clock::now();
    seconds_ = std::chrono::duration<double>(last_ - start).count();
    frame_waits_ = false;
  }
  void frame_waits() { frame_waits_ = true; }
  bool is_due() const {
    const double passed = std::chrono::duration<double>(Clock::now() - last_).count();
    const bool wanted = frame_waits_ || passed >= every_seconds_;
    return wanted && (every_seconds_ == 0 || seconds_ <= most_saving * passed);
  }

 private:
  using Clock = std::chrono::steady_clock;
  // Saving takes no larger share of a run's time, but for what is asked for and the end.
  static constexpr double most_saving = 0.02;

  double every_seconds_, seconds_ = 0;
  bool frame_waits_ = false;
  Clock::time_point last_ = Clock::now();
};

}  // namespace wirepack
