// SPDX-License-Identifier: GPL-3.0-or-later
#include "requests/reference_request.h"

#include "radcert/core/errors.h"
#include "radcert/reference/continuous_means.h"
#include "radcert/reference/reference_value.h"
#include "records/continuous_records.h"

namespace radcert::app {

namespace {

constexpr int usual_digits = 20;

int digits_of(std::int64_t digits) {
  if (digits >= 1 && digits <= reference::most_reference_digits) return static_cast<int>(digits);
  throw InputError(
      {.source = "digits",
       .value = std::to_string(digits),
       .allowed = "a whole number from 1 to " + std::to_string(reference::most_reference_digits)});
}

ReferenceRecord continuous(const reference::ContinuousMean& mean, const std::vector<Setting>& settings,
                           std::optional<int> digits) {
  if (!settings.empty())
    throw InputError({.source = mean.name,
                      .value = settings.front().name,
                      .problem = "is for a family, and " + mean.name + " is one value"});
  ReferenceRecord record = continuous_record(mean);
  if (digits && *digits > record.digits)
    throw AccuracyNotReached(mean.name, "a radius of 1e-" + std::to_string(*digits) +
                                            " is not proved by its certificate, 1e-" +
                                            std::to_string(record.digits) + " is");
  return record;
}

}  // namespace

ReferenceRecord requested_reference(const std::string& name, const std::vector<Setting>& settings,
                                    const std::optional<std::int64_t>& digits) {
  const std::optional<int> wanted = digits ? std::optional(digits_of(*digits)) : std::nullopt;
  if (const reference::ContinuousMean* mean = reference::find_continuous_mean(name))
    return continuous(*mean, settings, wanted);
  return record_of(wanted_reference(name, settings, OptionStyle::argument), wanted.value_or(usual_digits));
}

}  // namespace radcert::app
