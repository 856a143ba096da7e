// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "radcert/core/option_name.h"
#include "radcert/formats/problem/node_file.h"
#include "radcert/formats/result/basis_json.h"
#include "radcert/polynomial/nodes/symmetric_certificate.h"
#include "radcert/scalar/rational.h"

namespace radcert::app {

/// What is known of interpolation at the inset nodes of a degree.
/// Requires  0 <= degree
/// Result    InputError at the option alpha for a word that is neither a number in [0, 1/3) nor
///           "superconvergent" where that exists, and where there is none at a degree above 0
[[nodiscard]] BasisRecord inset_record(int degree, const std::string& alpha_text, OptionStyle style);

/// The same of a symmetric set. Requires a degree for which there is one.
[[nodiscard]] BasisRecord symmetric_record(int degree);

/// The same of other nodes, symmetric or not, which are not decided but by their certificate, and of nodes
/// that are what they are.
[[nodiscard]] BasisRecord certified_record(const std::string& family, const SymmetricNodes& set,
                                           const SymmetricCertificate& certificate);
[[nodiscard]] BasisRecord certified_record(const std::string& family,
                                           const std::vector<Barycentric<Rational>>& nodes,
                                           const SymmetricCertificate& certificate);
[[nodiscard]] BasisRecord node_record(const std::string& family,
                                      const std::vector<Barycentric<Rational>>& nodes);

/// The same of nodes of a user's own, by the name that messages have; InputError where they are not decided.
[[nodiscard]] BasisRecord basis_record(const std::string& name, const NodeFile& file);

/// The digits of symmetric sets hold to this; see their test.
[[nodiscard]] const Rational& symmetric_radius();

}  // namespace radcert::app
