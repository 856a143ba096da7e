// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "radcert/surface/surface.h"

namespace radcert {

/// A parameter that a surface of the catalogue takes.
struct ParameterDescription {
  std::string name;
  std::string requirement;  ///< what is allowed, in words: "a number >= 1"
  std::string default_text;
  std::function<bool(const Rational&)> admits;
  std::string meaning = {};  ///< in words: "the edge along x"
};

/// A surface of the catalogue: what it is called, what it takes, how it is made.
struct SurfaceDescription {
  std::string name;
  std::string summary;  ///< one line
  std::vector<ParameterDescription> parameters;
  std::vector<std::string> pieces;
  std::function<Surface(std::span<const Rational>)> build;  ///< values in the order of `parameters`
  bool unoccluded = true;  ///< as of every surface made: what is not needs visibility to be solved on

  /// The surface for values in the order of `parameters`; ContractViolation, with the surface's name, for a
  /// value that is not admitted, and where `build` leaves out the diagonal of a chart.
  [[nodiscard]] Surface make(std::span<const Rational> values) const;
};

/// The surfaces that radcert knows by name.
/// Maths     see the header of each in surface/catalogue
/// Source    [ac98, sections 2.2, 3 and 5]
/// Result    in a fixed order; a structure test makes every one of them
/// Limits    what a parameter may be does not depend on the others
const std::vector<SurfaceDescription>& surface_catalogue();

/// The entry of that name, or null.
const SurfaceDescription* find_surface(std::string_view name);

/// The surface of an entry with its default parameters.
Surface default_surface(const SurfaceDescription& description);

}  // namespace radcert
