// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <string>
#include <thread>

namespace radcert::app {

/// How far long work has come, on stderr: a bar with the time left on a terminal, now and then a line
/// elsewhere, the first within half a second; nothing when quiet. While one lives, those made before it are
/// silent. Where no thread can be had, it speaks when it is told something.
class ProgressDisplay {
public:
  explicit ProgressDisplay(bool quiet);
  /// Of work whose extent is not known: the label and the time it has taken.
  ProgressDisplay(bool quiet, const std::string& label);
  ~ProgressDisplay();
  ProgressDisplay(const ProgressDisplay&) = delete;
  ProgressDisplay& operator=(const ProgressDisplay&) = delete;

  /// The work before this point is so much of the whole; `label` is what begins now. `expected_seconds` is
  /// how long all the rest may take, if that is known.
  void at(double fraction, const std::string& label, double expected_seconds = 0);
  /// So many parts of all are done, whose times differ too much to foresee that of the rest.
  void counted(std::size_t done, std::size_t all, const std::string& label);
  /// Clears what is drawn and draws no more: a result follows.
  static void put_away();
  /// A line that stays.
  void note(const std::string& text);

private:
  using Clock = std::chrono::steady_clock;
  enum class Mode { none, lines, bar };
  void begin();
  void begin_part(double fraction, const std::string& label);
  [[nodiscard]] bool silent() const;
  double seconds_left() const;
  double shown_fraction() const;
  std::string status() const;
  void clear();
  void redraw();
  void keep_drawing();
  void say_line();

  Mode mode_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point since_ = start_;
  Clock::time_point last_line_ = start_;
  double fraction_ = 0;
  double expected_ = 0;
  std::string label_;
  std::string count_;  ///< "3 of 20", in place of a share and the time left; else empty
  bool extent_known_ = true;
  bool drawn_ = false;
  bool said_ = false;
  bool stop_ = false;
  std::atomic<int> over_{0};  ///< displays that were made after this one and live
  ProgressDisplay* below_;
  std::mutex mutex_;
  std::condition_variable wake_;
  std::thread drawer_;
};

}  // namespace radcert::app
