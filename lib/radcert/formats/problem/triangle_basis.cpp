// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "radcert/core/errors.h"
#include "radcert/formats/problem/node_file.h"
#include "radcert/formats/problem/problem_parts.h"
#include "radcert/polynomial/basis_limits.h"
#include "radcert/polynomial/nodes/superconvergent_inset.h"
#include "radcert/polynomial/nodes/symmetric_nodes.h"
#include "radcert/scalar/real.h"

namespace radcert {

namespace {

std::string degrees_allowed() { return "from 0 to " + std::to_string(largest_basis_degree); }
constexpr const char* alpha_allowed =
    "a decimal or fraction in a string, or a number, in [0, 1/3); superconvergent at degrees 1 and 3; "
    "at degree 0 it may be left out";

void read_alpha(const JsonReader& alpha, TriangleBasisChoice& choice) {
  if (const std::string* word = alpha.value().string(); word != nullptr && *word == "superconvergent") {
    if (choice.degree == 0)
      alpha.refuse("names no number at degree 0, where alpha has no effect", alpha_allowed);
    // Far below the rounding of every arithmetic that a problem is solved in.
    const Outcome<NearInset> inset = superconvergent_inset(choice.degree, 1 / power(Rational(10), 100));
    if (!inset) alpha.refuse("does not exist: " + inset.reason(), alpha_allowed);
    choice.alpha = inset->value;
    choice.alpha_is_near = !inset->is_exact;
    return;
  }
  const Rational value = alpha.rational(alpha_allowed);
  if (value < Rational(0) || value >= Rational(1, 3)) alpha.refuse("is outside the range", alpha_allowed);
  choice.alpha = value;
}

TriangleBasisChoice read_file(const JsonReader& basis, const JsonReader& file,
                              const std::filesystem::path& folder) {
  basis.require_object({"file", "digest"});
  const std::string& name = file.string("the name of a file of nodes, relative to the problem's folder");
  const std::filesystem::path path = folder / name;
  if (!std::filesystem::exists(path))
    file.refuse("is not there", "a file of nodes, its name relative to the problem's folder");
  NodeFile nodes = read_nodes(path);
  require_digest(basis, nodes.digest);
  const int degree = nodes.functions.degree();
  if (degree > largest_basis_degree)
    file.refuse("has functions of degree " + std::to_string(degree),
                "functions of a degree " + degrees_allowed());
  return node_file_basis(std::move(nodes), name);
}

TriangleBasisChoice read_symmetric(const JsonReader& basis) {
  basis.require_object({"family", "degree"});
  const std::string allowed = "a whole number from " + std::to_string(smallest_symmetric_degree) + " to " +
                              std::to_string(largest_symmetric_degree);
  TriangleBasisChoice choice;
  choice.family = NodeFamily::symmetric;
  choice.degree = static_cast<int>(
      basis.at("degree", allowed).whole(smallest_symmetric_degree, largest_symmetric_degree, allowed));
  choice.functions = std::make_shared<const LagrangeFunctions>(
      lagrange_functions(symmetric_nodes(choice.degree).nodes()).value());
  return choice;
}

TriangleBasisChoice read_inset(const JsonReader& basis) {
  basis.require_object({"family", "degree", "alpha"});
  TriangleBasisChoice choice;
  const std::string degree_allowed = "a whole number " + degrees_allowed();
  choice.degree =
      static_cast<int>(basis.at("degree", degree_allowed).whole(0, largest_basis_degree, degree_allowed));
  if (const auto alpha = basis.find("alpha"))
    read_alpha(*alpha, choice);
  else if (choice.degree > 0)
    read_alpha(basis.at("alpha", alpha_allowed), choice);
  return choice;
}

}  // namespace

std::vector<std::string> triangle_basis_families() { return {"inset", "symmetric"}; }

TriangleBasisChoice node_file_basis(NodeFile nodes, const std::string& name) {
  TriangleBasisChoice choice;
  choice.family = NodeFamily::file;
  choice.file = name;
  choice.digest = std::move(nodes.digest);
  choice.degree = nodes.functions.degree();
  if (choice.degree > largest_basis_degree)
    throw InputError({.source = name,
                      .problem = "has functions of degree " + std::to_string(choice.degree),
                      .allowed = "functions of a degree " + degrees_allowed()});
  choice.functions = std::make_shared<const LagrangeFunctions>(std::move(nodes.functions));
  return choice;
}

TriangleBasisChoice read_triangle_basis(const JsonReader& basis, const std::filesystem::path& folder) {
  if (const auto file = basis.find("file")) return read_file(basis, *file, folder);
  const std::vector<std::string> families = triangle_basis_families();
  const std::string& family = basis.at("family", "one of " + listed(families)).word(families);
  return family == "symmetric" ? read_symmetric(basis) : read_inset(basis);
}

JsonValue triangle_basis_json(const TriangleBasisChoice& basis) {
  JsonValue out = JsonValue::object();
  if (basis.family == NodeFamily::file) {
    out.set("file", basis.file);
    out.set("digest", basis.digest);
    return out;
  }
  out.set("family", basis.family == NodeFamily::symmetric ? "symmetric" : "inset");
  out.set("degree", basis.degree);
  if (basis.alpha) out.set("alpha", basis.alpha_is_near ? "superconvergent" : basis.alpha->to_text());
  return out;
}

std::vector<std::string> triangle_basis_words(const TriangleBasisChoice& basis) {
  if (basis.family == NodeFamily::file) return {basis.file};
  const std::string family = basis.family == NodeFamily::symmetric ? "symmetric" : "inset";
  std::vector<std::string> words{family + " of degree " + std::to_string(basis.degree)};
  if (basis.alpha)
    words.push_back("alpha " + (basis.alpha_is_near ? "superconvergent" : basis.alpha->to_text()));
  return words;
}

}  // namespace radcert
