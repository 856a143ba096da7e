// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/surface/catalogue.h"

#include <utility>

#include "radcert/core/contract.h"
#include "radcert/surface/catalogue_parameters.h"

namespace radcert {

ParameterDescription positive_length(std::string name, std::string default_text, std::string meaning) {
  const Rational largest = power(Rational(10), 60);
  return {.name = std::move(name),
          .requirement = "a number in [1e-60, 1e60]",
          .default_text = std::move(default_text),
          .admits = [largest](const Rational& length) { return length * largest >= 1 && length <= largest; },
          .meaning = std::move(meaning)};
}

ParameterDescription inner_part(std::string name, std::string default_text, std::string meaning) {
  return {
      .name = std::move(name),
      .requirement = "a number in [1/1000, 999/1000]",
      .default_text = std::move(default_text),
      .admits = [](const Rational& part) { return part >= Rational(1, 1000) && part <= Rational(999, 1000); },
      .meaning = std::move(meaning)};
}

const SurfaceDescription* find_surface(std::string_view name) {
  for (const SurfaceDescription& surface : surface_catalogue())
    if (surface.name == name) return &surface;
  return nullptr;
}

Surface SurfaceDescription::make(std::span<const Rational> values) const {
  expects(values.size() == parameters.size(), "a value for each parameter of the surface " + name,
          named("values", values.size()));
  for (std::size_t i = 0; i < values.size(); ++i)
    expects(parameters[i].admits(values[i]),
            parameters[i].name + " of the surface " + name + ": " + parameters[i].requirement,
            named("value", values[i]));
  Surface surface = build(values);
  expects(surface.diagonals.size() == surface.charts.size(),
          "the surface " + name + " has a diagonal for each of its charts",
          named("charts", surface.charts.size()), named("diagonals", surface.diagonals.size()));
  return surface;
}

Surface default_surface(const SurfaceDescription& description) {
  std::vector<Rational> values;
  for (const ParameterDescription& parameter : description.parameters)
    values.push_back(Rational::parse(parameter.default_text).value());
  return description.make(values);
}

}  // namespace radcert
