// SPDX-License-Identifier: GPL-3.0-or-later
#include "progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <system_error>

#include "output.h"
#include "radcert/scalar/enclosing_text.h"

namespace radcert::app {

namespace {

constexpr std::size_t bar_width = 24;
constexpr std::size_t label_width = 40;
constexpr double seconds_between_lines = 5;
constexpr std::chrono::milliseconds before_first_line(300);  // what is done sooner needs no progress

/// The last one that was made and lives; displays are made and end in the main thread alone.
ProgressDisplay* uppermost = nullptr;

double seconds(std::chrono::steady_clock::duration time) {
  return std::chrono::duration<double>(time).count();
}

std::string time_text(double s) {
  if (s < 90) return nearest_text(s, DecimalForm::fixed(0)) + " s";
  if (s < 5400) return nearest_text(s / 60, DecimalForm::fixed(0)) + " min";
  return nearest_text(s / 3600, DecimalForm::fixed(1)) + " h";
}

/// Whether stderr is a terminal that can clear a line.
bool can_redraw() {
  const char* terminal = std::getenv("TERM");
  return isatty(STDERR_FILENO) != 0 && terminal != nullptr && std::string_view(terminal) != "dumb";
}

}  // namespace

ProgressDisplay::ProgressDisplay(bool quiet)
    : mode_(quiet || is_silent() ? Mode::none : (can_redraw() ? Mode::bar : Mode::lines)), below_(uppermost) {
  begin();
}

ProgressDisplay::ProgressDisplay(bool quiet, const std::string& label)
    : mode_(quiet || is_silent() ? Mode::none : (can_redraw() ? Mode::bar : Mode::lines)),
      label_(label),
      extent_known_(false),
      below_(uppermost) {
  begin();
}

void ProgressDisplay::begin() {
  if (below_ != nullptr) {
    const std::scoped_lock lock(below_->mutex_);
    below_->clear();
    ++below_->over_;
  }
  uppermost = this;
  if (mode_ == Mode::none) return;
  try {
    drawer_ = std::thread([this] { keep_drawing(); });
  } catch (const std::system_error&) {
    // There are no more threads: at() and note() still speak.
  }
}

void ProgressDisplay::put_away() {
  for (ProgressDisplay* display = uppermost; display != nullptr; display = display->below_) {
    const std::scoped_lock lock(display->mutex_);
    display->clear();
    ++display->over_;
  }
}

bool ProgressDisplay::silent() const { return over_ > 0; }

ProgressDisplay::~ProgressDisplay() {
  {
    const std::scoped_lock lock(mutex_);
    stop_ = true;
  }
  wake_.notify_all();
  if (drawer_.joinable()) drawer_.join();
  clear();
  uppermost = below_;
  if (below_ != nullptr) --below_->over_;
}

void ProgressDisplay::at(double fraction, const std::string& label, double expected_seconds) {
  const std::scoped_lock lock(mutex_);
  expected_ = expected_seconds;
  begin_part(fraction, label);
}

void ProgressDisplay::counted(std::size_t done, std::size_t all, const std::string& label) {
  const std::scoped_lock lock(mutex_);
  count_ = std::to_string(done) + " of " + std::to_string(all);
  begin_part(all == 0 ? 0 : static_cast<double>(done) / static_cast<double>(all), label);
}

void ProgressDisplay::begin_part(double fraction, const std::string& label) {
  fraction_ = std::clamp(fraction, 0.0, 1.0);
  label_ = label;
  since_ = Clock::now();
  extent_known_ = true;
  const bool due = seconds(since_ - last_line_) >= seconds_between_lines;
  const bool first = !said_ && !drawer_.joinable() && since_ - start_ >= before_first_line;
  if (mode_ == Mode::lines && (due || first)) say_line();
  if (mode_ == Mode::bar) redraw();
}

void ProgressDisplay::note(const std::string& text) {
  const std::scoped_lock lock(mutex_);
  if (mode_ == Mode::none) return;
  clear();
  say(text + "\n");
  said_ = true;
  last_line_ = Clock::now();
  if (mode_ == Mode::bar) redraw();
}

void ProgressDisplay::say_line() {
  say(status() + "\n");
  said_ = true;
  last_line_ = Clock::now();
}

/// What is expected of the rest, else what the earlier ones took in proportion.
double ProgressDisplay::seconds_left() const {
  const double here = seconds(Clock::now() - since_);
  if (expected_ > 0) return std::max(0.0, expected_ - here);
  if (fraction_ <= 0) return 0;
  return std::max(0.0, seconds(since_ - start_) * (1 - fraction_) / fraction_ - here);
}

/// The fraction that was told, and of what is left as much as time has passed.
double ProgressDisplay::shown_fraction() const {
  if (expected_ <= 0) return fraction_;
  constexpr double nearly_all = 0.99;
  return fraction_ + (1 - fraction_) * std::min(nearly_all, seconds(Clock::now() - since_) / expected_);
}

std::string ProgressDisplay::status() const {
  std::string out = time_text(seconds(Clock::now() - start_));
  if (extent_known_ && !count_.empty()) {
    out = count_ + "  " + out;
  } else if (extent_known_) {
    out = fmt::format("{:>3} %  ", nearest_text(100 * shown_fraction(), DecimalForm::fixed(0))) + out;
    const double left = seconds_left();
    if (left > 0) out += ", about " + time_text(left) + " left";
  }
  return out + ": " + label_.substr(0, label_width);
}

void ProgressDisplay::clear() {
  if (drawn_) say("\r\x1b[K");
  drawn_ = false;
}

void ProgressDisplay::redraw() {
  if (!extent_known_) {
    say("\r\x1b[K" + status());
    drawn_ = true;
    return;
  }
  const auto full = static_cast<std::size_t>(shown_fraction() * static_cast<double>(bar_width));
  say("\r\x1b[K[" + std::string(full, '#') + std::string(bar_width - full, '.') + "] " + status());
  drawn_ = true;
}

void ProgressDisplay::keep_drawing() {
  std::unique_lock lock(mutex_);
  if (mode_ == Mode::lines) {
    if (!wake_.wait_for(lock, before_first_line, [this] { return stop_; }) && !said_ && !silent()) say_line();
    return;
  }
  while (!wake_.wait_for(lock, std::chrono::milliseconds(500), [this] { return stop_; }))
    if ((drawn_ || !extent_known_) && !silent()) redraw();
}

}  // namespace radcert::app
