// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace radcert {

/// A value of a C library that frees itself.
/// Requires  init(&value) makes it, clear(&value) frees it
/// Result    stands wherever the library takes a pointer to the value; it is neither copied nor moved
template <class Value, auto init, auto clear>
class CValue {
public:
  CValue() { init(&value_); }
  ~CValue() { clear(&value_); }
  CValue(const CValue&) = delete;
  CValue& operator=(const CValue&) = delete;

  operator Value*() { return &value_; }
  operator const Value*() const { return &value_; }
  Value* operator->() { return &value_; }
  const Value* operator->() const { return &value_; }

private:
  Value value_;
};

}  // namespace radcert
