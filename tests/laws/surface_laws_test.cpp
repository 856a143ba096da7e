// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/laws/surface_laws.h"

#include <memory>

#include "radcert/surface/catalogue.h"
#include "radcert/surface/catalogue/box.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "tests/surface/default_surface.h"

namespace radcert::laws {
namespace {

/// A parabolic arch over the unit square; its chart takes either orientation.
template <Field R>
struct Parabola {
  template <Field T>
  Vector<T> operator()(const T& s, const T& t) const {
    return {s, t, s * (R(1) - s)};
  }
};

Surface arch(Orientation orientation) {
  Surface surface;
  surface.name = "arch";
  surface.charts.push_back(
      make_chart<Parabola>({.name = "arch", .piece = "arch", .orientation = orientation}));
  surface.diagonals.push_back(Diagonal::main);
  return surface;
}

/// A chart whose tangents and normal are those of another formula.
class WrongTangents final : public ChartIn<double> {
public:
  explicit WrongTangents(Vector<double> twist) : twist_(twist) {}
  Frame<double> frame(const ParameterPoint<double>& at) const override {
    Frame<double> frame{.point = {at.s, at.t, at.s * (1 - at.s)},
                        .tangent_s = Vector<double>{1, 0, 1 - 2 * at.s} + twist_,
                        .tangent_t = {0, 1, 0},
                        .area_normal = {}};
    frame.area_normal = -cross(frame.tangent_s, frame.tangent_t);
    return frame;
  }
  Chord<double> chord(const ParameterPoint<double>&, const ParameterPoint<double>&) const override {
    return {};
  }

private:
  Vector<double> twist_;
};

TEST(SurfaceLaws, HoldForEverySurfaceOfTheCatalogue) {
  for (const SurfaceDescription& entry : surface_catalogue()) {
    EXPECT_TRUE(obeys_the_surface_laws(default_surface(entry))) << entry.name;
  }
}

/// A chart's formula in double, as a chart's constructor takes it.
std::shared_ptr<const ChartIn<double>> doubles_of(const Chart& chart) {
  const auto kept = std::make_shared<Chart>(chart);
  return {kept, &kept->in<double>()};
}

TEST(SurfaceLaws, RejectASurfaceTurnedInsideOut) {
  EXPECT_TRUE(obeys_the_surface_laws(arch(Orientation::against_the_cross_product)));
  EXPECT_FALSE(obeys_the_surface_laws(arch(Orientation::along_the_cross_product)));
  EXPECT_FALSE(lies_inside_its_tangent_planes(arch(Orientation::along_the_cross_product), 1e-14));
}

TEST(SurfaceLaws, RejectTangentsThatAreNotDerivatives) {
  const auto with_twist = [](const Vector<double>& twist) {
    Surface surface = arch(Orientation::against_the_cross_product);
    surface.charts = {Chart(surface.charts[0].facts(), std::make_shared<WrongTangents>(twist))};
    return surface;
  };
  EXPECT_TRUE(has_tangents_that_are_derivatives(with_twist({0, 0, 0}), 1e-5, 1e-9));
  EXPECT_FALSE(has_tangents_that_are_derivatives(with_twist({0, 1e-6, 0}), 1e-5, 1e-9));
}

TEST(SurfaceLaws, RejectAFormulaThatDiffersInPacks) {
  Surface surface = sphere();
  const Surface other = ellipsoid(1, 1, Rational(1000001, 1000000));
  surface.charts[0] = Chart(surface.charts[0].facts(), doubles_of(surface.charts[0]),
                            std::make_shared<ChartByLane>(doubles_of(other.charts[0])));
  EXPECT_TRUE(has_the_same_bits_in_packs(sphere()));
  EXPECT_FALSE(has_the_same_bits_in_packs(surface));
}

TEST(SurfaceLaws, RejectAnOrientationThatTheNormalDoesNotHave) {
  Surface surface = cube();
  ChartFacts facts = surface.charts[0].facts();
  facts.orientation = Orientation::against_the_cross_product;
  surface.charts[0] = Chart(facts, std::make_shared<WrongTangents>(Vector<double>{}));
  EXPECT_TRUE(has_normals_across_its_tangents(surface, 4e-16));
  facts.orientation = Orientation::along_the_cross_product;
  surface.charts[0] = Chart(facts, std::make_shared<WrongTangents>(Vector<double>{}));
  EXPECT_FALSE(has_normals_across_its_tangents(surface, 4e-16));
}

TEST(SurfaceLaws, RejectAClosedSurfaceWithAHole) {
  Surface surface = sphere();
  EXPECT_TRUE(has_a_vanishing_integral_of_its_normal(surface, 64, 1e-3));
  surface.charts.pop_back();
  EXPECT_FALSE(has_a_vanishing_integral_of_its_normal(surface, 64, 1e-3));
}

TEST(SurfaceLaws, RejectAnIncompleteDescription) {
  Surface surface = cube();
  surface.diagonals.pop_back();
  EXPECT_FALSE(is_fully_described(surface));
  surface = cube();
  surface.charts[1] = surface.charts[0];
  EXPECT_FALSE(is_fully_described(surface));
  EXPECT_FALSE(is_fully_described(Surface{}));
}

}  // namespace
}  // namespace radcert::laws
