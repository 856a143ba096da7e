// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <barrier>
#include <cstddef>
#include <exception>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

#include "radcert/core/ranks/ranks.h"

namespace radcert {

/// Ranks that are threads of one process, for tests: what they hold for each other lies in shared vectors.
class ThreadRanks {
public:
  /// Calls the body on so many ranks together; what the lowest rank throws that throws, it throws, and where
  /// a rank throws the others end at their next step together.
  static void run(std::size_t count, const std::function<void(const Ranks&)>& body) {
    Shared shared(count);
    std::vector<std::exception_ptr> failed(count);
    {
      std::vector<std::jthread> threads;
      for (std::size_t r = 0; r < count; ++r)
        threads.emplace_back([&, r] {
          try {
            body(One(shared, r));
            // Who goes on alone is not waited for: a fault makes ranks part.
            shared.barrier.arrive_and_drop();
          } catch (const EndedElsewhere&) {
            shared.barrier.arrive_and_drop();
          } catch (...) {
            failed[r] = std::current_exception();
            shared.ended = true;
            shared.barrier.arrive_and_drop();
          }
        });
    }
    for (const std::exception_ptr& each : failed)
      if (each) std::rethrow_exception(each);
  }

private:
  struct Shared {
    explicit Shared(std::size_t count)
        : barrier(static_cast<std::ptrdiff_t>(count)), texts(count), held(count) {}
    /// Waits for all ranks that have not ended.
    void meet() {
      barrier.arrive_and_wait();
      if (ended) throw EndedElsewhere(1, "another thread has ended");
    }
    std::barrier<> barrier;
    std::atomic<bool> ended = false;
    std::vector<std::string> texts;
    std::vector<std::span<const double>> held;
  };
  class Bring final : public Exchange {
  public:
    Bring(Shared& shared, std::size_t here, std::span<const RemoteNumber> wanted)
        : shared_(shared), here_(here), wanted_(wanted.begin(), wanted.end()) {}
    void bring(std::span<const double> held, std::span<double> wanted) const override {
      shared_.held[here_] = held;
      shared_.meet();
      for (std::size_t i = 0; i < wanted_.size(); ++i)
        wanted[i] = shared_.held[wanted_[i].rank][wanted_[i].place];
      shared_.meet();
    }
    [[nodiscard]] std::uint64_t bytes_sent() const override { return wanted_.size() * sizeof(double); }

  private:
    Shared& shared_;
    std::size_t here_;
    std::vector<RemoteNumber> wanted_;
  };
  class One final : public Ranks {
  public:
    One(Shared& shared, std::size_t here) : shared_(shared), here_(here) {}
    [[nodiscard]] std::size_t count() const override { return shared_.texts.size(); }
    [[nodiscard]] std::size_t here() const override { return here_; }
    [[nodiscard]] std::vector<std::string> gather(std::string_view own) const override {
      shared_.texts[here_] = own;
      shared_.meet();
      std::vector<std::string> all = shared_.texts;
      shared_.meet();
      return all;
    }
    [[nodiscard]] std::vector<std::string> gather_at_first(std::string_view own) const override {
      std::vector<std::string> all = gather(own);
      return here_ == 0 ? all : std::vector<std::string>();
    }
    [[nodiscard]] std::unique_ptr<const Exchange> exchange(
        std::size_t, std::span<const RemoteNumber> wanted) const override {
      return std::make_unique<Bring>(shared_, here_, wanted);
    }

  private:
    Shared& shared_;
    std::size_t here_;
  };
};

}  // namespace radcert
