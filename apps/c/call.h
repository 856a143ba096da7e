// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "c/radcert.h"
#include "requests/work.h"

namespace radcert::c {

/// Runs what a function of the interface does, and keeps what it throws as this thread's last error.
/// Result    RADCERT_OK, or the status of what was thrown; nothing leaves. All of it in UsualArithmetic
radcert_status guarded(const std::function<void()>& action) noexcept;

/// A text that a caller gives.
/// Result    InputError at `place` for NULL
[[nodiscard]] std::string text_at(const char* text, const std::string& place);
/// The same with a word for NULL.
[[nodiscard]] std::string text_or(const char* text, const std::string& word);

/// A pointer that may not be NULL.
/// Result    InputError at `place` for NULL
template <class T>
T& given(T* pointer, const std::string& place);

/// InputError at `place`/size unless a struct that a caller gives is of the size of this header's.
void require_size(std::size_t size, std::size_t known, const std::string& place);

/// How a caller wants a computation to be run, checked.
struct Run {
  explicit Run(const radcert_run* run);
  radcert_listener listener = nullptr;
  void* context = nullptr;
  std::string store;
};

/// Computes apart, and lets the caller's listener hear of it.
/// Result    Interrupted where the listener asks to stop
void compute(const Run& run, const std::function<void(app::Progress&)>& action);

/// Texts as an array of pointers. The texts may not be moved: they own what is pointed to.
[[nodiscard]] std::vector<const char*> pointers(const std::vector<std::string>& texts);

/// Throws the InputError of a NULL at a place.
[[noreturn]] void refuse_null(const std::string& place);

template <class T>
T& given(T* pointer, const std::string& place) {
  if (pointer == nullptr) refuse_null(place);
  return *pointer;
}

}  // namespace radcert::c
