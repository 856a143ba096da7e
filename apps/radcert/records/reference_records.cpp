// SPDX-License-Identifier: GPL-3.0-or-later
#include "records/reference_records.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "radcert/core/errors.h"
#include "radcert/formats/json/json_reader.h"
#include "radcert/reference/continuous_means.h"
#include "verification/claims/psg10/figures/sphere_over_disk_records.h"

namespace radcert::app {

void apply(std::span<const Setting> settings, std::string_view family,
           std::span<const reference::ValueParameter> parameters, reference::Arguments& arguments,
           OptionStyle style) {
  const bool by_words = style == OptionStyle::command_line;
  const std::string source = by_words ? option_name(style, "set") : std::string(family);
  std::vector<std::string> names;
  for (const reference::ValueParameter& parameter : parameters) names.push_back(parameter.name);
  std::vector<std::string> seen;
  for (const auto& [name, text] : settings) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end())
      throw InputError({.source = source,
                        .value = name,
                        .problem = "is no parameter of " + std::string(family),
                        .allowed = names.empty() ? "it has none" : listed(names)});
    if (std::find(seen.begin(), seen.end(), name) != seen.end())
      throw InputError({.source = source, .value = name, .problem = "is given twice"});
    seen.push_back(name);
    const auto i = static_cast<std::size_t>(found - names.begin());
    const Outcome<Rational> value = Rational::parse(text);
    if (!value || !parameters[i].allows(*value))
      throw InputError(
          {.source = by_words ? source + " " + name : name, .value = text, .allowed = parameters[i].allowed});
    arguments[i] = *value;
  }
}

WantedReference member(const reference::NamedValue& value) {
  return {.name = value.name, .family = reference::find_family(value.family), .arguments = value.arguments};
}

std::vector<std::string> reference_names() {
  std::vector<std::string> names;
  for (const reference::NamedValue& value : reference::named_values()) names.push_back(value.name);
  for (const reference::ValueFamily& family : reference::value_families()) names.push_back(family.name);
  for (const reference::ContinuousMean& mean : reference::continuous_means()) names.push_back(mean.name);
  names.emplace_back(verification::psg10::sphere_over_disk_name);
  return names;
}

WantedReference wanted_reference(const std::string& name, std::span<const Setting> settings,
                                 OptionStyle style) {
  if (const reference::NamedValue* value = reference::find_value(name)) {
    if (!settings.empty())
      throw InputError({.source = style == OptionStyle::command_line ? option_name(style, "set") : name,
                        .value = settings.front().name + "=" + settings.front().value,
                        .problem = "is for a family, and " + name + " is one value",
                        .allowed = "the family is " + value->family});
    return member(*value);
  }
  const reference::ValueFamily* family = reference::find_family(name);
  if (family == nullptr)
    throw InputError({.source = "reference",
                      .value = name,
                      .problem = with_nearest_word("is unknown", name, reference_names()),
                      .allowed = "the names of radcert list references"});
  WantedReference out{
      .name = family->name, .family = family, .arguments = reference::default_arguments(*family)};
  apply(settings, family->name, family->parameters, out.arguments, style);
  return out;
}

ReferenceRecord record_with(const WantedReference& wanted, int digits, std::vector<ReferenceRoute> routes) {
  ReferenceRecord record;
  record.name = wanted.name;
  record.digits = digits;
  record.formula = wanted.family->formula;
  record.source = wanted.family->source;
  for (std::size_t i = 0; i < wanted.arguments.size(); ++i)
    record.parameters.emplace_back(wanted.family->parameters[i].name, wanted.arguments[i].to_text());
  record.routes = std::move(routes);
  return record;
}

ReferenceRecord record_of(const WantedReference& wanted, int digits) {
  const Outcome<reference::EnclosedValue> value =
      reference::enclose(*wanted.family, wanted.arguments, digits + 1);
  if (!value)
    throw AccuracyNotReached(
        wanted.name, "a radius of 1e-" + std::to_string(digits) + " was not reached; " + value.reason());
  return record_with(wanted, digits,
                     {{value->first.how, value->first.value}, {value->second.how, value->second.value}});
}

}  // namespace radcert::app
