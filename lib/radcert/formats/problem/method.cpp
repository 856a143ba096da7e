// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <string>
#include <vector>

#include "radcert/formats/problem/problem_parts.h"

namespace radcert {

namespace {

bool is_among(const std::vector<std::string>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

struct MethodJson {
  JsonValue operator()(const Collocation& method) const { return triangle_basis_json(method.basis); }
  JsonValue operator()(const Meshless& method) const { return meshless_json(method); }
  JsonValue operator()(const Galerkin& method) const { return galerkin_json(method); }
};

struct MethodWords {
  std::vector<std::string> operator()(const Collocation& method) const {
    return triangle_basis_words(method.basis);
  }
  std::vector<std::string> operator()(const Meshless& method) const { return meshless_words(method); }
  std::vector<std::string> operator()(const Galerkin& method) const { return galerkin_words(method); }
};

}  // namespace

Method read_method(const JsonReader& basis, const std::filesystem::path& folder) {
  if (basis.value().string() != nullptr) return read_meshless(basis);
  if (basis.value().members() == nullptr) basis.refuse("is " + basis.value().kind(), "an object");
  if (basis.find("method")) return read_galerkin(basis);
  if (basis.find("file")) return Collocation{read_triangle_basis(basis, folder)};
  std::vector<std::string> families = triangle_basis_families();
  const std::vector<std::string> meshless = meshless_families();
  families.insert(families.end(), meshless.begin(), meshless.end());
  const std::string& family = basis
                                  .at("family", "one of " + listed(families) +
                                                    "; or \"file\", a file of nodes; or \"method\", galerkin")
                                  .word(families);
  if (is_among(meshless, family)) return read_meshless(basis);
  return Collocation{read_triangle_basis(basis, folder)};
}

JsonValue method_json(const Method& method) { return std::visit(MethodJson(), method); }

std::vector<std::string> method_words(const Method& method) { return std::visit(MethodWords(), method); }

}  // namespace radcert
