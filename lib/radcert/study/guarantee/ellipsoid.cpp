// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "radcert/continuous/ellipsoid/ellipsoid_enclosure.h"
#include "radcert/core/errors.h"
#include "radcert/study/collocation/operator_norm.h"
#include "radcert/study/guarantee/ellipsoid_certificate.h"
#include "radcert/study/guarantee/enclosed_problem.h"
#include "radcert/study/problem.h"
#include "radcert/study/result.h"

namespace radcert {
namespace {

Vector<Rational> half_axes(const Surface& surface) {
  if (surface.name == "sphere") return {1, 1, 1};
  return {surface.parameters[0].value, surface.parameters[1].value, surface.parameters[2].value};
}

/// p with P = A p.
Vector<Rational> on_sphere(const Vector<Rational>& point, const Vector<Rational>& axes) {
  return {point.x / axes.x, point.y / axes.y, point.z / axes.z};
}

/// The points at which values are asked for: those of the problem, or the ends of the axes.
std::vector<Vector<Rational>> solution_points(const Guarantee& guarantee, const Vector<Rational>& axes) {
  if (guarantee.points.empty())
    return {{axes.x, 0, 0},  {-axes.x, 0, 0}, {0, axes.y, 0},
            {0, -axes.y, 0}, {0, 0, axes.z},  {0, 0, -axes.z}};
  for (std::size_t k = 0; k < guarantee.points.size(); ++k) {
    const Vector<Rational> p = on_sphere(guarantee.points[k], axes);
    if (!(dot(p, p) == Rational(1)))
      throw InputError({.pointer = "/guarantee/points/" + std::to_string(k),
                        .value = coordinates_text(guarantee.points[k]),
                        .problem = "does not lie on the surface",
                        .allowed = "(x/a)^2 + (y/b)^2 + (z/c)^2 = 1 exactly, as at (3/5 a, 4/5 b, 0)"});
  }
  return guarantee.points;
}

class EnclosedEllipsoid final : public EnclosedProblem {
public:
  EnclosedEllipsoid(const Problem& problem, const Guarantee& guarantee, Surface surface)
      : guarantee_(guarantee),
        surface_(std::move(surface)),
        piece_(surface_.piece_names().front()),
        ellipsoid_{.half_axes = half_axes(surface_),
                   .reflectivity = problem.reflectivity.on(piece_),
                   .emission = problem.emission->on(piece_)} {
    for (const Rational& axis : {ellipsoid_.half_axes.x, ellipsoid_.half_axes.y, ellipsoid_.half_axes.z})
      require_normal(axis, "/surface");
    const Outcome<double> emission = emission_bound(ellipsoid_);
    if (!emission)
      refuse("/emission", ellipsoid_.emission, emission.reason(),
             "a polynomial in x, y, z of degree " + std::to_string(most_sphere_degree) +
                 " or less, from whole numbers, decimals and fractions by + - * /");
    const Outcome<ReflectivityBound> rho = reflectivity_bound(ellipsoid_);
    if (!rho)
      refuse("/reflectivity", ellipsoid_.reflectivity, rho.reason(),
             "a polynomial in x, y, z of degree " + std::to_string(most_reflectivity_degree) +
                 " or less with values from 0 to below 1");
    if (!std::isfinite(*emission))
      refuse("/emission", ellipsoid_.emission, "it is beyond the range of double",
             "values from 1e-60 to 1e60");
    require_normal(Rational::exactly(*emission), "/emission");
    // ||K|| = sup rho, between what is seen of it and its bound.
    norm_ = problem.reflectivity.on(piece_).is_constant()
                ? norm_of_K(surface_, problem.reflectivity, {}, {})
                : Approximation::proved(0.5 * (rho->seen + rho->largest),
                                        (0.5 * (rho->largest - rho->seen)) * (1 + 0x1p-40) + 0x1p-50);
    require_width(guarantee, least_relative_width_on_ellipsoids,
                  Rational::exactly(*emission) / Rational::exactly(rho->gap));
    if (guarantee.of == EnclosedQuantity::values) points_ = solution_points(guarantee, ellipsoid_.half_axes);
  }

  [[nodiscard]] std::pair<LevelResult, SolutionEnclosure> solve(
      const GuaranteeContext& context) const override {
    return result_of(found(wanted(), context));
  }

  [[nodiscard]] std::vector<std::string> certificate_hindrances() const override { return {}; }

  [[nodiscard]] CertifiedSolution certified(const GuaranteeContext& context) const override {
    const EllipsoidEnclosure enclosure = found(certified_share * wanted(), context);
    auto [level, result] = result_of(enclosure);
    certificate::EllipsoidCertificate certificate =
        ellipsoid_certificate(ellipsoid_, enclosure, piece_, kind(), points_);
    const Rational width = certificate.width;
    CertifiedSolution out{
        .level = std::move(level), .enclosure = std::move(result), .certificate = std::move(certificate)};
    say_width_of_certificate(width, guarantee_, out.enclosure);
    return out;
  }

private:
  [[nodiscard]] double wanted() const { return guarantee_.width.to_double() * (1 - unit_roundoff<double>()); }

  [[nodiscard]] certificate::OnEllipsoid kind() const {
    switch (guarantee_.of) {
      case EnclosedQuantity::means: return certificate::OnEllipsoid::mean;
      case EnclosedQuantity::values: return certificate::OnEllipsoid::values;
      case EnclosedQuantity::function: break;
    }
    return certificate::OnEllipsoid::function;
  }

  [[nodiscard]] EllipsoidEnclosure found(double width, const GuaranteeContext& context) const {
    const auto tell = [&](const EllipsoidProgress& now) {
      if (context.progress)
        context.progress({.degree = now.degree,
                          .unknowns = unknowns(now),
                          .samples = now.samples,
                          .width = 2 * now.bound});
    };
    // Means and values have roundings of their own beside the bound.
    const double share = guarantee_.of == EnclosedQuantity::function ? 0.5 : 0.45;
    Outcome<EllipsoidEnclosure> out = enclose_on_ellipsoid(ellipsoid_, share * width, tell);
    if (!out) throw AccuracyNotReached("the solution u", out.reason());
    if (!std::isfinite(out->bound)) throw AccuracyNotReached("the solution u", out->hindrance);
    return *std::move(out);
  }

  [[nodiscard]] std::pair<LevelResult, SolutionEnclosure> result_of(const EllipsoidEnclosure& found) const {
    SolutionEnclosure enclosure{.wanted = guarantee_, .width = 0, .hindrance = found.hindrance};
    LevelResult level;
    level.level = found.last.degree;
    level.elements = 1;
    level.unknowns = unknowns(found.last);
    const Vector<Rational>& axes = ellipsoid_.half_axes;
    level.mesh_size = 2 * std::max({axes.x, axes.y, axes.z}).to_double();
    level.norm_K = norm_;
    const auto widen = [&](double radius) { enclosure.width = std::max(enclosure.width, 2 * radius); };
    switch (guarantee_.of) {
      case EnclosedQuantity::means:
        enclosure.pieces.emplace_back(piece_, found.mean);
        level.piece_means = enclosure.pieces;
        widen(found.mean.radius);
        break;
      case EnclosedQuantity::values:
        for (const Vector<Rational>& point : points_) {
          const Vector<Rational> p = on_sphere(point, axes);
          const Approximation value = found.at({p.x.to_double(), p.y.to_double(), p.z.to_double()});
          enclosure.points.push_back({piece_, point, value});
          widen(value.radius);
        }
        break;
      case EnclosedQuantity::function:
        enclosure.function = FunctionBound{.sup = found.bound, .outside = 0};
        enclosure.patches = patches(found);
        widen(found.bound);
        break;
    }
    if (!std::isfinite(enclosure.width)) throw AccuracyNotReached("the solution u", found.hindrance);
    if (enclosure.width <= wanted())
      enclosure.hindrance.clear();
    else if (enclosure.hindrance.empty())
      enclosure.hindrance = "the rounding of double";
    return {std::move(level), std::move(enclosure)};
  }

  static std::uint64_t unknowns(const EllipsoidProgress& now) {
    const auto powers = static_cast<std::uint64_t>(now.degree + 1);
    return powers * powers;
  }
  /// v on a grid of angles.
  [[nodiscard]] std::vector<EnclosedPatch> patches(const EllipsoidEnclosure& found) const {
    constexpr int rows = 24;
    constexpr int columns = 48;
    const auto place = [](int row, int column) -> Vector<double> {
      const double polar = std::numbers::pi * row / rows;
      const double azimuth = 2 * std::numbers::pi * (column % columns) / columns;
      return {std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth), std::cos(polar)};
    };
    const Vector<double> axes{ellipsoid_.half_axes.x.to_double(), ellipsoid_.half_axes.y.to_double(),
                              ellipsoid_.half_axes.z.to_double()};
    std::vector<EnclosedPatch> out;
    for (int row = 0; row < rows; ++row)
      for (int column = 0; column < columns; ++column) {
        EnclosedPatch patch{.piece = piece_, .corners = {}, .bound = found.bound};
        const std::array<Vector<double>, 4> corners{place(row, column), place(row + 1, column),
                                                    place(row + 1, column + 1), place(row, column + 1)};
        for (std::size_t k = 0; k < corners.size(); ++k) {
          const Vector<double>& p = corners[k];
          patch.corners[k] = {axes.x * p.x, axes.y * p.y, axes.z * p.z};
          const Approximation value = found.at(p);
          patch.values[k] = value.value;
          patch.bound = std::max(patch.bound, value.radius);
        }
        out.push_back(std::move(patch));
      }
    return out;
  }
  [[noreturn]] static void refuse(const std::string& pointer, const Expression& formula,
                                  const std::string& reason, const std::string& allowed) {
    throw InputError({.pointer = pointer,
                      .value = formula.text(),
                      .problem = "cannot be taken: " + reason,
                      .allowed = allowed});
  }

  const Guarantee& guarantee_;
  Surface surface_;
  std::string piece_;
  EllipsoidProblem ellipsoid_;
  Approximation norm_;
  std::vector<Vector<Rational>> points_;
};

}  // namespace

std::unique_ptr<EnclosedProblem> enclosed_ellipsoid(const Problem& problem, const Guarantee& guarantee,
                                                    Surface surface) {
  return std::make_unique<EnclosedEllipsoid>(problem, guarantee, std::move(surface));
}

}  // namespace radcert
