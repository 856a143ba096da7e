// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/core/files/temporary_files.h"

#include <array>
#include <atomic>
#include <unistd.h>

namespace radcert {

namespace {

enum class Use : int { free, being_written, named };

struct Slot {
  std::atomic<Use> use{Use::free};
  std::array<char, 4096> name{};
};
static_assert(std::atomic<Use>::is_always_lock_free, "a signal handler may touch lock-free atomics only");

constexpr std::size_t slot_count = 256;
// Never destroyed, for a signal may come while the process ends; not in the program file, being zero.
std::array<Slot, slot_count> slots;
std::atomic<int> renaming{0};

}  // namespace

TemporaryName::TemporaryName(std::string_view name) : slot_(slot_count) {
  if (name.size() >= slots[0].name.size()) return;
  for (std::size_t i = 0; i < slot_count; ++i) {
    Use free = Use::free;
    if (!slots[i].use.compare_exchange_strong(free, Use::being_written)) continue;
    slots[i].name[name.copy(slots[i].name.data(), name.size())] = '\0';
    slots[i].use.store(Use::named, std::memory_order_release);
    slot_ = i;
    return;
  }
}

TemporaryName::~TemporaryName() {
  if (slot_ < slot_count) slots[slot_].use.store(Use::free, std::memory_order_release);
}

void remove_temporary_files() noexcept {
  for (const Slot& slot : slots)
    if (slot.use.load(std::memory_order_acquire) == Use::named) ::unlink(slot.name.data());
}

RenamingFiles::RenamingFiles() { ++renaming; }
RenamingFiles::~RenamingFiles() { --renaming; }

bool renaming_files() noexcept { return renaming.load() > 0; }

}  // namespace radcert
