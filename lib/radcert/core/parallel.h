// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace radcert {

/// A reference to a callable (begin, end): no copy, no allocation.
/// Requires  the callable outlives the reference and may be called from several threads at once
/// Result    calls it
/// Limits    for arguments of functions, never stored
class RangeBody {
public:
  template <class Body>
    requires(!std::is_same_v<std::remove_cvref_t<Body>, RangeBody> &&
             std::is_invocable_v<Body&, std::size_t, std::size_t>)
  RangeBody(
      Body&& body)  // NOLINT(bugprone-forwarding-reference-overload): RangeBody itself is excluded above
      : object_(const_cast<void*>(static_cast<const void*>(std::addressof(body)))),
        call_([](void* object, std::size_t begin, std::size_t end) {
          (*static_cast<std::remove_reference_t<Body>*>(object))(begin, end);
        }) {}
  void operator()(std::size_t begin, std::size_t end) const { call_(object_, begin, end); }

private:
  void* object_;
  void (*call_)(void*, std::size_t, std::size_t);
};

/// The chunk length of a loop that states none.
/// Maths     ceil(count / 256), at least 1
/// Requires  nothing
/// Result    depends on count alone: at most 256 chunks
/// Limits    a loop whose iterations differ much in cost states its own, shorter grain
[[nodiscard]] constexpr std::size_t default_grain(std::size_t count) {
  return count == 0 ? 1 : (count - 1) / 256 + 1;
}

/// Runs body(begin, end) over [0, count) in chunks [k grain, min((k+1) grain, count)), on all threads.
/// Maths     the chunks depend on count and grain, never on the number of threads or the order of execution
/// Source    oneTBB
/// Requires  grain >= 1, else ContractViolation; chunks do not write to the same place
/// Result    every chunk ran once; if chunks threw, the exception of the lowest of them; if an interruption
///           was requested, Interrupted
/// Limits    after an exception or an interruption chunks may have been left out. Loops may be nested
void parallel_for(std::size_t count, std::size_t grain, RangeBody body);

/// The same in chunks of default_grain(count).
inline void parallel_for(std::size_t count, RangeBody body) {
  parallel_for(count, default_grain(count), body);
}

/// Folds map(begin, end) over the chunks of [0, count) in ascending order.
/// Maths     combine(...combine(combine(identity, m_0), m_1)..., m_last),
///           m_k = map(k grain, min((k+1) grain, count))
/// Requires  grain >= 1, else ContractViolation
/// Result    the same bits for every number of threads; combine runs on the calling thread and need not be
///           associative
/// Limits    holds one T a chunk; other grains may give other roundings
template <class T, class Map, class Combine>
[[nodiscard]] T parallel_reduce_ordered(std::size_t count, std::size_t grain, T identity, Map&& map,
                                        Combine&& combine) {
  std::vector<std::optional<T>> parts(grain == 0 || count == 0 ? 0 : (count - 1) / grain + 1);
  parallel_for(count, grain,
               [&](std::size_t begin, std::size_t end) { parts[begin / grain].emplace(map(begin, end)); });
  T total = std::move(identity);
  for (std::optional<T>& part : parts) total = combine(std::move(total), std::move(*part));
  return total;
}

/// The number of threads that a loop started here may use.
/// Source    oneTBB
/// Requires  nothing
/// Result    at least 1
/// Limits    other programs on the machine are not seen
[[nodiscard]] std::size_t thread_count();

/// Limits the number of threads while it lives.
/// Source    oneTBB global_control: of several limits the lowest holds
/// Requires  threads >= 1, else ContractViolation
/// Result    thread_count() <= threads in the whole process; results do not change, only the time
/// Limits    cannot raise the number above an outer limit
class ThreadLimit {
public:
  explicit ThreadLimit(std::size_t threads);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

private:
  struct Control;
  std::unique_ptr<Control> control_;
};

}  // namespace radcert
