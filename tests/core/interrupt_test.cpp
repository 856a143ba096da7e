// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/core/interrupt.h"

#include "radcert/core/errors.h"

#include <csignal>
#include <gtest/gtest.h>

namespace {

TEST(Interrupt, FlagIsSetByTheSignalAndTakenBack) {
  EXPECT_FALSE(radcert::interruption_requested());
  EXPECT_NO_THROW(radcert::throw_if_interrupted());
  for (const int signal : {SIGINT, SIGTERM}) {
    radcert::install_interrupt_handler();
    ASSERT_EQ(std::raise(signal), 0);
    EXPECT_TRUE(radcert::interruption_requested());
    EXPECT_THROW(radcert::throw_if_interrupted(), radcert::Interrupted);
    radcert::clear_interruption();
    EXPECT_FALSE(radcert::interruption_requested());
  }
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

TEST(InterruptDeathTest, SecondSignalEndsTheProcess) {
  EXPECT_EXIT(
      {
        radcert::install_interrupt_handler();
        std::raise(SIGINT);
        std::raise(SIGINT);
      },
      testing::KilledBySignal(SIGINT), "");
}

}  // namespace
