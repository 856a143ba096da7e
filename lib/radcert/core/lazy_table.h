// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <mutex>
#include <optional>

namespace radcert {

/// A table whose entries are made when they are first asked for.
/// Requires  index < Size; `make` gives the same value every time
/// Result    the entry; safe to ask from several threads at once: one makes, the others wait
/// Limits    entries stay for the table's life
template <class T, std::size_t Size>
class LazyTable {
public:
  template <class Make>
  const T& at(std::size_t index, const Make& make) {
    Slot& slot = slots_[index];
    std::call_once(slot.made, [&] { slot.value.emplace(make()); });
    return *slot.value;
  }

private:
  struct Slot {
    std::once_flag made;
    std::optional<T> value;
  };
  std::array<Slot, Size> slots_;
};

}  // namespace radcert
