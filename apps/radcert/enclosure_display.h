// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <mutex>

#include "progress.h"
#include "radcert/study/guarantee_context.h"

namespace radcert::app {

/// How wide an enclosure has become, and after how long: a line for each mesh, and within a mesh how many of
/// its cells are done.
class EnclosureDisplay {
public:
  explicit EnclosureDisplay(bool quiet);
  void mesh_done(const GuaranteeProgress& now);
  /// By any thread.
  void at(const MeshProgress& now);

private:
  using Clock = std::chrono::steady_clock;
  ProgressDisplay display_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point cells_begin_ = start_;
  std::uint64_t cells_before_ = 0;  ///< done when the clock of this mesh was started
  int layers_ = -1;
  std::mutex mutex_;
};

}  // namespace radcert::app
