// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/certificate/certificate.h"

#include "radcert/certificate/check.h"
#include "radcert/certificate/ellipsoid/ellipsoid_check.h"

namespace radcert::certificate {

namespace {

std::vector<CertifiedNumber> numbers_of(const PolyhedronCertificate& c) {
  std::vector<CertifiedNumber> out;
  for (std::size_t k = 0; k < c.goals(); ++k) {
    if (c.of_values())
      out.push_back({c.pieces[c.faces[c.points[k].face].piece], c.points[k].at, c.enclosures[k]});
    else
      out.push_back({c.pieces[k], std::nullopt, c.enclosures[k]});
  }
  return out;
}

std::vector<CertifiedNumber> numbers_of(const EllipsoidCertificate& c) {
  std::vector<CertifiedNumber> out;
  for (std::size_t k = 0; k < c.enclosures.size(); ++k)
    out.push_back({c.piece,
                   c.of == OnEllipsoid::values ? std::optional<Vector<Rational>>(c.points[k]) : std::nullopt,
                   c.enclosures[k]});
  return out;
}

}  // namespace

std::vector<CertifiedNumber> numbers(const Certificate& certificate) {
  return std::visit([](const auto& of_its_kind) { return numbers_of(of_its_kind); }, certificate);
}

std::optional<BoundAtDistance> function_bound(const Certificate& certificate) {
  if (const auto* const c = std::get_if<EllipsoidCertificate>(&certificate)) {
    if (c->of != OnEllipsoid::function) return std::nullopt;
    return BoundAtDistance{.outside = 0, .sup = c->bound};
  }
  const auto& c = *std::get_if<PolyhedronCertificate>(&certificate);
  if (!c.of_function()) return std::nullopt;
  return BoundAtDistance{.outside = c.outside, .sup = Rational(1, 2) * c.width};
}

std::size_t part_count(const Certificate& certificate) {
  if (const auto* const polyhedron = std::get_if<PolyhedronCertificate>(&certificate))
    return polyhedron->elements.size();
  return part_count(*std::get_if<EllipsoidCertificate>(&certificate));
}

Report check(const Certificate& certificate, const Part& part, const CheckListener& progress) {
  return std::visit([&](const auto& of_its_kind) { return check(of_its_kind, part, progress); }, certificate);
}

}  // namespace radcert::certificate
