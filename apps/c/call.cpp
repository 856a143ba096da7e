// SPDX-License-Identifier: GPL-3.0-or-later
#include "c/call.h"

#include <exception>
#include <filesystem>
#include <memory>
#include <new>
#include <system_error>

#include "radcert/core/contract.h"
#include "radcert/core/errors.h"
#include "radcert/core/version.h"

namespace radcert::c {

namespace {

/// The words of an error, and the struct that points to them.
struct LastError {
  InputFault fault{.problem = ""};
  std::string message;
  radcert_error shown = {RADCERT_OK, "", "", "", nullptr, "", ""};
};

LastError& last_error() {
  thread_local LastError error;
  return error;
}

void forget() noexcept { last_error().shown = {RADCERT_OK, "", "", "", nullptr, "", ""}; }

/// Words for which no memory is needed.
radcert_status keep_literal(radcert_status status, const char* words) noexcept {
  last_error().shown = {status, words, "", "", nullptr, "", ""};
  return status;
}

radcert_status keep(radcert_status status, const char* message, InputFault fault = {.problem = ""}) {
  LastError& last = last_error();
  last.fault = std::move(fault);
  last.message = message;
  last.shown = {.status = status,
                .message = last.message.c_str(),
                .source = last.fault.source.c_str(),
                .place = last.fault.pointer.c_str(),
                .value = last.fault.value ? last.fault.value->c_str() : nullptr,
                .problem = last.fault.problem.c_str(),
                .allowed = last.fault.allowed.c_str()};
  return status;
}

radcert_status keep_current() {
  try {
    throw;
  } catch (const InputError& error) {
    return keep(RADCERT_INPUT_ERROR, error.what(), error.fault());
  } catch (const AccuracyNotReached& error) {
    return keep(RADCERT_ACCURACY_NOT_REACHED, error.what());
  } catch (const EnvironmentError& error) {
    return keep(RADCERT_ENVIRONMENT_ERROR, error.what());
  } catch (const Interrupted& error) {
    return keep(RADCERT_INTERRUPTED, error.what());
  } catch (const std::bad_alloc&) {
    return keep_literal(RADCERT_ENVIRONMENT_ERROR, "memory: there is not enough of it");
  } catch (const std::system_error& error) {
    return keep(RADCERT_ENVIRONMENT_ERROR, error.what());
  } catch (const std::exception& error) {
    return keep(RADCERT_DEFECT, error.what());
  } catch (...) {
    return keep_literal(RADCERT_DEFECT, "something was thrown that is no std::exception");
  }
}

}  // namespace

radcert_status guarded(const std::function<void()>& action) noexcept try {
  const app::UsualArithmetic usual;
  action();
  forget();
  return RADCERT_OK;
} catch (...) {
  try {
    return keep_current();
  } catch (...) {
    return keep_literal(RADCERT_ENVIRONMENT_ERROR, "memory: there is not enough of it");
  }
}

void refuse_null(const std::string& place) {
  throw InputError({.pointer = place, .value = "NULL", .allowed = "what radcert.h says of it"});
}

std::string text_at(const char* text, const std::string& place) { return &given(text, place); }

std::string text_or(const char* text, const std::string& word) { return text == nullptr ? word : text; }

void require_size(std::size_t size, std::size_t known, const std::string& place) {
  if (size != known)
    throw InputError({.pointer = place + "/size",
                      .value = std::to_string(size),
                      .problem = "is not the size of the struct in this version's header",
                      .allowed = std::to_string(known)});
}

Run::Run(const radcert_run* run) {
  if (run == nullptr) return;
  require_size(run->size, sizeof(radcert_run), "run");
  listener = run->listener;
  context = run->context;
  store = text_or(run->store, "");
}

void compute(const Run& run, const std::function<void(app::Progress&)>& action) {
  std::pair<double, std::string> now{0, ""};
  app::run_apart(
      [&](app::Progress& told) {
        if (run.listener == nullptr) return;
        for (const std::string& words : told.take_warnings())
          if (run.listener(now.first, words.c_str(), run.context) != 0) throw Interrupted();
        if (auto report = told.take()) now = std::move(*report);
        if (run.listener(now.first, now.second.c_str(), run.context) != 0) throw Interrupted();
      },
      action);
}

std::vector<const char*> pointers(const std::vector<std::string>& texts) {
  std::vector<const char*> out;
  out.reserve(texts.size());
  for (const std::string& text : texts) out.push_back(text.c_str());
  return out;
}

}  // namespace radcert::c

extern "C" {

int32_t radcert_interface(void) { return RADCERT_INTERFACE; }

const char* radcert_version(void) {
  static const std::string text(radcert::version());
  return text.c_str();
}

const radcert_error* radcert_last_error(void) { return &radcert::c::last_error().shown; }

radcert_status radcert_limit_threads(int64_t threads) {
  return radcert::c::guarded([&] {
    radcert::app::limit_threads(threads == 0 ? std::nullopt : std::optional<std::int64_t>(threads));
  });
}
}
