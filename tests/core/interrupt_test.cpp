// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/core/interrupt.h"

#include "radcert/core/errors.h"
#include "radcert/core/files/atomic_file.h"
#include "radcert/core/files/temporary_files.h"
#include "tests/core/temporary_folder.h"

#include <chrono>
#include <csignal>
#include <filesystem>
#include <gtest/gtest.h>
#include <optional>
#include <string>
#include <vector>

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

/// Names that are left in a folder.
std::vector<std::string> names_in(const std::filesystem::path& folder) {
  std::vector<std::string> out;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    out.push_back(entry.path().filename().string());
  return out;
}

/// Computes for ever, without a look at the flag. The thread sanitizer delivers signals at calls of the
/// system, such as that for the time.
[[noreturn]] void compute_on() {
  volatile unsigned steps = 0;
  while (true) steps = steps + (std::chrono::steady_clock::now().time_since_epoch().count() > 0 ? 1 : 2);
}

TEST(InterruptDeathTest, WhatDoesNotLookAtTheFlagEndsByTheClock) {
  const radcert::test::TemporaryFolder folder;
  EXPECT_EXIT(
      {
        radcert::install_interrupt_handler();
        radcert::set_last_words("half is kept\n");
        radcert::AtomicFile file(folder / "file");
        file.put("half");
        std::raise(SIGTERM);
        compute_on();
      },
      testing::ExitedWithCode(130), "^half is kept\n$");
  EXPECT_TRUE(names_in(folder.path()).empty());
}

TEST(InterruptDeathTest, ASecondSignalLeavesNoTemporary) {
  const radcert::test::TemporaryFolder folder;
  EXPECT_EXIT(
      {
        radcert::install_interrupt_handler();
        radcert::AtomicFile file(folder / "file");
        file.put("half");
        std::raise(SIGINT);
        std::raise(SIGINT);
      },
      testing::KilledBySignal(SIGINT), "");
  EXPECT_TRUE(names_in(folder.path()).empty());
}

TEST(InterruptDeathTest, FilesThatAreBeingRenamedAreWaitedFor) {
  EXPECT_EXIT(
      {
        radcert::install_interrupt_handler();
        auto renaming = std::make_optional<radcert::RenamingFiles>();
        std::raise(SIGINT);
        std::raise(SIGINT);
        const auto until = std::chrono::steady_clock::now() + std::chrono::milliseconds(900);
        while (std::chrono::steady_clock::now() < until) continue;
        radcert::set_last_words("after the renaming\n");
        renaming.reset();
        compute_on();
      },
      testing::ExitedWithCode(130), "after the renaming");
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
