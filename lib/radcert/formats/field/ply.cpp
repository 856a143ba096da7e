// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/field/ply.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/core/text.h"

namespace radcert {

namespace {

std::string decimal(double value) {
  expects(std::isfinite(value), "a finite number", named("value", value));
  return shortest(value);
}

/// A name on one line: a comment ends there.
std::string one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < ' '; }, ' ');
  return text;
}

}  // namespace

std::string ply_text(std::span<const ElementValue> elements, const std::optional<CornerErrors>& errors,
                     const std::optional<CornerErrors>& iterated_errors) {
  expects(!errors || errors->size() == elements.size(), "errors for every element",
          named("elements", elements.size()));
  const std::vector<std::string> pieces = pieces_of(elements);
  const bool iterated = !elements.empty() && elements.front().iterated;
  std::string out = "ply\nformat ascii 1.0\n";
  for (std::size_t i = 0; i < pieces.size(); ++i)
    out += "comment piece " + std::to_string(i) + " is " + one_line(pieces[i]) + "\n";
  out += "element vertex " + std::to_string(3 * elements.size()) +
         "\nproperty double x\nproperty double y\nproperty double z\nproperty double radiosity\n" +
         (errors ? "property double error\n" : "") + (iterated ? "property double iterated\n" : "") +
         (iterated_errors ? "property double iterated_error\n" : "") + "element face " +
         std::to_string(elements.size()) +
         "\nproperty list uchar uint vertex_indices\nproperty uint piece\nend_header\n";
  for (std::size_t k = 0; k < elements.size(); ++k)
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector<double>& at = elements[k].corners[i];
      out += decimal(at.x) + " " + decimal(at.y) + " " + decimal(at.z) + " " +
             decimal(elements[k].corner_values[i]);
      if (errors) out += " " + decimal((*errors)[k][i]);
      if (iterated) out += " " + decimal(elements[k].iterated.value()[i]);
      if (iterated_errors) out += " " + decimal((*iterated_errors)[k][i]);
      out += "\n";
    }
  for (std::size_t k = 0; k < elements.size(); ++k) {
    const auto piece = std::find(pieces.begin(), pieces.end(), elements[k].piece) - pieces.begin();
    out += "3 " + std::to_string(3 * k) + " " + std::to_string(3 * k + 1) + " " + std::to_string(3 * k + 2) +
           " " + std::to_string(piece) + "\n";
  }
  return out;
}

}  // namespace radcert
