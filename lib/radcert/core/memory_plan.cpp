// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/core/memory_plan.h"

#include "radcert/core/checked.h"
#include "radcert/core/errors.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <string_view>
#include <sys/resource.h>
#include <unistd.h>
#include <utility>

namespace radcert {

namespace {

constexpr std::uint64_t without_bound = UINT64_MAX;

/// The whole file; /proc and /sys give no size in advance.
std::optional<std::string> content(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) return std::nullopt;
  std::ostringstream out;
  out << in.rdbuf();
  return out.str();
}

/// The number at the start of a text, after blanks; nothing for "max".
std::optional<std::uint64_t> leading_number(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
  std::uint64_t number = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
  if (read.ec != std::errc()) return std::nullopt;
  return number;
}

std::optional<std::uint64_t> number_in(const std::filesystem::path& path) {
  const auto text = content(path);
  return text ? leading_number(*text) : std::nullopt;
}

/// The number after a key at the start of a line.
std::optional<std::uint64_t> number_after(const std::optional<std::string>& text, std::string_view key) {
  if (!text) return std::nullopt;
  std::istringstream lines(*text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(key)) return leading_number(std::string_view(line).substr(key.size()));
  }
  return std::nullopt;
}

struct CgroupFiles {
  const char* limit;
  const char* use;
  std::string_view cache_key;
};

/// What is left in a group and in all that hold it.
std::uint64_t left_in_groups(const std::filesystem::path& mount, std::filesystem::path group,
                             const CgroupFiles& files) {
  std::uint64_t least = without_bound;
  group = group.relative_path();
  while (true) {
    const std::filesystem::path folder = group.empty() ? mount : mount / group;
    if (const auto limit = number_in(folder / files.limit)) {
      const std::uint64_t use = number_in(folder / files.use).value_or(0);
      const std::uint64_t cache = number_after(content(folder / "memory.stat"), files.cache_key).value_or(0);
      const std::uint64_t held = use - std::min(use, cache);
      least = std::min(least, *limit - std::min(*limit, held));
    }
    if (group.empty()) return least;
    group = group.parent_path();
  }
}

/// What `ulimit -v` leaves of the addresses; statm begins with the pages that the process holds.
std::uint64_t left_in_address_space(const std::filesystem::path& system_root) {
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return without_bound;
  const std::uint64_t pages = number_in(system_root / "proc/self/statm").value_or(0);
  const std::uint64_t held =
      checked_multiply(pages, static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE))).value_or(0);
  return limit.rlim_cur - std::min<std::uint64_t>(limit.rlim_cur, held);
}

}  // namespace

MemoryPlan& MemoryPlan::add(std::string name, std::uint64_t count, std::uint64_t bytes_each) {
  items_.push_back({std::move(name), checked_multiply(count, bytes_each).value_or(without_bound)});
  return *this;
}

std::uint64_t MemoryPlan::total() const {
  std::uint64_t sum = 0;
  for (const Item& item : items_) sum = checked_add(sum, item.bytes).value_or(without_bound);
  return sum;
}

void MemoryPlan::require(std::uint64_t limit_bytes) const {
  const std::uint64_t needed = total();
  if (needed <= limit_bytes && needed != without_bound) return;
  const auto exactly = [](std::uint64_t bytes) {
    return bytes == without_bound ? "2^64 bytes or more"
                                  : byte_text(bytes) + " (" + std::to_string(bytes) + " bytes)";
  };
  const auto largest = std::max_element(items_.begin(), items_.end(),
                                        [](const Item& a, const Item& b) { return a.bytes < b.bytes; });
  throw InputError({.problem = "needs " + exactly(needed) + " of memory, most of it for " + largest->name +
                               ": " + exactly(largest->bytes),
                    .allowed = "at most " + exactly(limit_bytes)});
}

std::uint64_t available_memory(const std::string& system_root) {
  const std::filesystem::path root = system_root;
  std::uint64_t least = left_in_address_space(root);
  if (const auto kib = number_after(content(root / "proc/meminfo"), "MemAvailable:")) {
    least = std::min(least, checked_multiply(*kib, 1024).value_or(without_bound));
  }
  const std::filesystem::path mount = root / "sys/fs/cgroup";
  const CgroupFiles v1{"memory.limit_in_bytes", "memory.usage_in_bytes", "total_inactive_file "};
  const CgroupFiles v2{"memory.max", "memory.current", "inactive_file "};
  std::istringstream lines(content(root / "proc/self/cgroup").value_or(""));
  for (std::string line; std::getline(lines, line);) {
    // <number>:<controllers>:<path>; version 2 has no controllers here.
    const std::size_t first = line.find(':');
    const std::size_t second = first == std::string::npos ? first : line.find(':', first + 1);
    if (second == std::string::npos) continue;
    const std::string controllers = "," + line.substr(first + 1, second - first - 1) + ",";
    const std::filesystem::path group = line.substr(second + 1);
    if (controllers == ",,") least = std::min(least, left_in_groups(mount, group, v2));
    if (controllers.find(",memory,") != std::string::npos)
      least = std::min(least, left_in_groups(mount / "memory", group, v1));
  }
  return least;
}

std::string byte_text(std::uint64_t bytes) {
  if (bytes < 1024) return std::to_string(bytes) + " bytes";
  constexpr std::string_view units[] = {"KiB", "MiB", "GiB", "TiB", "PiB", "EiB"};
  std::size_t unit = 0;
  std::uint64_t scale = 1024;
  while (bytes / scale >= 1024) {
    scale *= 1024;
    ++unit;
  }
  // One decimal, rounded up: a need is never shown as smaller than it is.
  const std::uint64_t whole = bytes / scale;
  const std::uint64_t tenths = (bytes % scale * 10 + (scale - 1)) / scale;
  const std::uint64_t shown = whole * 10 + tenths;
  return std::to_string(shown / 10) + (shown % 10 == 0 ? "" : "." + std::to_string(shown % 10)) + " " +
         std::string(units[unit]);
}

}  // namespace radcert
