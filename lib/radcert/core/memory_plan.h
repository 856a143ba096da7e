// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace radcert {

/// The memory that a computation will need, counted before it starts.
/// Maths     total = sum of count * bytes_each in the integers; 2^64 - 1 stands for "that or more"
/// Requires  nothing
/// Result    exact below 2^64 - 1, never wraps round
/// Limits    counts what it is told: the allocator's own overhead and the program itself are not in it
class MemoryPlan {
public:
  struct Item {
    std::string name;
    std::uint64_t bytes;
  };
  /// Adds an item; a product that does not fit into 64 bits counts as 2^64 - 1.
  MemoryPlan& add(std::string name, std::uint64_t count, std::uint64_t bytes_each);
  [[nodiscard]] const std::vector<Item>& items() const { return items_; }
  [[nodiscard]] std::uint64_t total() const;
  /// Throws InputError that names needed and available bytes and the largest item, if total() > limit_bytes.
  void require(std::uint64_t limit_bytes) const;

private:
  std::vector<Item> items_;
};

/// The memory that this process may still take without swapping or being killed.
/// Maths     min(MemAvailable, limit - use + reclaimable file cache over the cgroups that hold the process,
///           what its limit of address space leaves)
/// Source    proc(5), getrlimit(2), the kernel's documentation of cgroup v1 and v2
/// Requires  nothing
/// Result    bytes, an estimate of this moment; 2^64 - 1 where the system says nothing
/// Limits    other processes may take it first. `system_root` stands for "/" (a test gives a folder of its
///           own)
[[nodiscard]] std::uint64_t available_memory(const std::string& system_root = "/");

/// Bytes for people: "1.5 GiB", "37 bytes".
[[nodiscard]] std::string byte_text(std::uint64_t bytes);

}  // namespace radcert
