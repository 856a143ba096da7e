// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/function_enclosure.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "radcert/continuous/elements/element_interpolation.h"
#include "radcert/continuous/elements/gauss_tables.h"
#include "radcert/continuous/observer_cells.h"
#include "radcert/continuous/residual.h"
#include "radcert/continuous/scaled_problem.h"
#include "radcert/continuous/trial.h"
#include "radcert/continuous/trial_functions.h"
#include "radcert/continuous/vertex_disks.h"
#include "radcert/core/contract.h"

namespace radcert {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// With two the elements at edges touch those at the centres of faces, which have no slopes.
constexpr int first_layers = 3;
/// Of the radius that is wanted: its products with bounds stay within double.
constexpr double largest_radius = 1e100;

/// A bound of the residual on a part of an element.
struct ResidualOnBox {
  std::size_t element = 0;
  SectorBox box;
  double residual = 0;  ///< of |u - K u - (v - K v)|
};

/// What residuals on parts that cover the surface make of u - v.
/// Requires  parts in the order of their elements
class ErrorByDistance {
public:
  ErrorByDistance(const Trial& trial, const VertexDisks& disks, std::vector<ResidualOnBox> parts, double gap)
      : trial_(trial), disks_(disks), parts_(std::move(parts)) {
    double smallest = disks.largest_radius();
    first_.assign(trial.elements.size() + 1, 0);
    for (const ResidualOnBox& part : parts_) {
      farthest_.push_back(disks.distance_at_most(trial.sector(part.element), part.box));
      smallest = std::min(smallest, farthest_.back());
      ++first_[part.element + 1];
    }
    for (std::size_t e = 0; e < trial.elements.size(); ++e) first_[e + 1] += first_[e];
    // Four shells make an octave, from a power of two.
    int exponent = 0;
    std::frexp(disks.largest_radius(), &exponent);
    for (int m = 0;; ++m) {
      const double radius = std::ldexp(std::exp2(-0.25 * (m % 4)), exponent - 1 - m / 4);
      if (!(radius > smallest)) break;
      radii_.push_back(radius);
    }
    std::vector<double> residuals(radii_.size() + 1);
    for (std::size_t k = 0; k < parts_.size(); ++k) {
      double& residual = residuals[shell(farthest_[k])];
      residual = std::max(residual, parts_[k].residual);
    }
    for (std::size_t m = 1; m < residuals.size(); ++m)
      residuals[m] = std::max(residuals[m], residuals[m - 1]);
    beyond_ = supersolution(disks, radii_, residuals, gap);
  }

  /// Of |u - v| at points that are so far from every vertex, and in piece if that is given.
  [[nodiscard]] double sup(double outside) const {
    return sup(outside, [](const Sector&) { return true; });
  }
  [[nodiscard]] double sup_on_piece(double outside, std::size_t piece) const {
    const std::vector<Panel>& panels = trial_.scene.panels();
    return sup(outside, [&](const Sector& sector) { return panels[sector.panel].piece == piece; });
  }
  /// On a part of an element.
  [[nodiscard]] double on(std::size_t element, const SectorBox& box) const {
    const double nearest = disks_.distance_at_least(trial_.sector(element), box);
    return (residual(element, box) + beyond_[shell(nearest)]) * upward;
  }
  [[nodiscard]] double residual(std::size_t element, const SectorBox& box) const {
    double most = 0;
    for (std::size_t k = first_[element]; k < first_[element + 1]; ++k) {
      const SectorBox& b = parts_[k].box;
      if (b.s0 < box.s1 && box.s0 < b.s1 && b.t0 < box.t1 && box.t0 < b.t1)
        most = std::max(most, parts_[k].residual);
    }
    return most;
  }
  [[nodiscard]] const std::vector<double>& radii() const { return radii_; }

private:
  /// The shell of the points at a distance.
  [[nodiscard]] std::size_t shell(double distance) const {
    const auto at =
        std::find_if(radii_.begin(), radii_.end(), [&](double radius) { return radius <= distance; });
    return static_cast<std::size_t>(at - radii_.begin());
  }
  /// A little further in, so that the distance may be read as a rounded decimal.
  template <class Predicate>
  [[nodiscard]] double sup(double outside, const Predicate& counts) const {
    const double from = outside / upward;
    double residual = 0;
    for (std::size_t k = 0; k < parts_.size(); ++k)
      if (farthest_[k] >= from && counts(trial_.sector(parts_[k].element)))
        residual = std::max(residual, parts_[k].residual);
    return (residual + beyond_[shell(from)]) * upward;
  }

  const Trial& trial_;
  const VertexDisks& disks_;
  std::vector<ResidualOnBox> parts_;
  std::vector<std::size_t> first_;  ///< part of each element, and the number of all
  std::vector<double> farthest_;    ///< of each part from its nearest vertex
  std::vector<double> radii_;
  std::vector<double> beyond_;  ///< z of supersolution
};

/// w_0 at a place of an element, x and y in [-1,1].
double value(const SectorFunctions& w, std::size_t element, double x, double y) {
  const auto powers = static_cast<std::size_t>(w.degree() + 1);
  std::vector<double> p_x(powers);
  std::vector<double> p_y(powers);
  legendre_values<double>(x, p_x);
  legendre_values<double>(y, p_y);
  const std::span<const double> c = w.of(element, 0);
  double sum = 0;
  for (std::size_t i = 0; i < powers; ++i)
    for (std::size_t j = 0; j < powers; ++j) sum += c[i * powers + j] * p_x[i] * p_y[j];
  return sum;
}

/// The function on a part of an element, as a function of the part.
void put_restriction(const SectorFunctions& f, std::size_t element, const SectorBox& whole,
                     const SectorBox& part, std::size_t number, SectorFunctions& out) {
  const PartOfInterval in_s = part_in_s(part, whole);
  const PartOfInterval in_t = part_in_t(part, whole);
  const std::vector<double>& nodes = gauss_on_interval(f.degree() + 1).nodes;
  std::vector<double> values;
  for (const double x : nodes)
    for (const double y : nodes) values.push_back(value(f, element, in_s.place(x), in_t.place(y)));
  ElementInterpolation(f.degree() + 1).coefficients(values, 1, out.of(number, 0));
}

/// What cells may miss: less where the residual is small, and more near a vertex, from where little of it
/// comes (the power 3/2 of the distance's part, see VertexDisks). Next to it they need not be looked into.
class DemandOutside final : public LargestDemand {
public:
  struct Distances {
    double outside = 0;   ///< from there on nothing more is allowed than of elements
    double of_strip = 0;  ///< up to there nothing is looked into
  };
  DemandOutside(const VertexDisks& disks, std::vector<double> of_elements, double far_from_vertices,
                const Distances& distances)
      : disks_(disks),
        of_elements_(std::move(of_elements)),
        far_from_vertices_(far_from_vertices),
        distances_(distances) {}
  [[nodiscard]] double allowed(std::size_t element, const Sector& sector,
                               const SectorBox& box) const override {
    const double farthest = disks_.distance_at_most(sector, box);
    if (!(farthest < distances_.outside)) return of_elements_[element];
    return std::max(of_elements_[element], 0.25 * far_from_vertices_ * distances_.outside / farthest);
  }
  [[nodiscard]] bool may_be_strip(const Sector& sector, const SectorBox& box) const override {
    return disks_.distance_at_most(sector, box) <= distances_.of_strip;
  }

private:
  const VertexDisks& disks_;
  std::vector<double> of_elements_;
  double far_from_vertices_;
  Distances distances_;
};

class FunctionSearch {
public:
  FunctionSearch(const ScaledProblem& data, double wanted, double outside, bool with_proof)
      : data_(data),
        disks_(data.scene),
        radius_(std::min(0.5 * std::ldexp(wanted, -data.exponent), largest_radius)),
        outside_(outside),
        with_proof_(with_proof) {
    best_.sup = infinity;
  }

  FunctionEnclosure operator()(const SearchContext& context) {
    if (!(disks_.largest_radius() > 0)) {
      best_.hindrance = "two vertices lie as near to each other as double can tell";
      return std::move(best_);
    }
    for (int layers = first_layers; layers <= most_layers.value(); ++layers) {
      if (!try_layers(layers, context)) continue;
      if (context.progress) context.progress(best_.last);
      if (std::ldexp(radius_, data_.exponent) >= best_.sup) return std::move(best_);
      if (is_cut_short_) {
        best_.hindrance =
            "cells that were cut as often as is allowed: the two sides of an edge have not the same ends, or "
            "too "
            "much is seen in part";
        return std::move(best_);
      }
    }
    best_.hindrance = "the residual of polynomials of degree " + std::to_string(best_.last.degree) + " on " +
                      std::to_string(best_.last.layers) + " layers of elements";
    return std::move(best_);
  }

private:
  /// |rho t| with the rounding of E, rho and v.
  /// Maths     v is E + rho q within Trial::rounding
  /// Result    infinite where that is not bounded; what does not reflect has no residual, however little is
  ///           known of t
  [[nodiscard]] static double residual(const Trial& trial, std::size_t element, double largest) {
    const double reflected = trial.rho(element) > 0 ? trial.rho(element) * largest : 0;
    const double bound = (reflected + trial.rounding + 1e-300) * upward;
    return bound >= 0 ? bound : infinity;
  }

  /// One mesh; false where it is passed over, since its residuals would be too large.
  bool try_layers(int layers, const SearchContext& context) {
    const int degree = data_.trial_degree(layers + 1);
    const double tolerance = 1e-2 * std::pow(4.0, -layers);
    std::vector<SectorElement> elements = graded_elements(data_.scene, layers);
    EnclosureProgress begun{.layers = layers, .degree = degree, .elements = elements.size()};
    begun.samples = best_.last.samples;
    begun.width = 2 * best_.sup;
    MeshWork work(context, begun);
    const SectorFunctions emission = emission_functions(data_.exact, data_.scene, elements, 1,
                                                        degree + data_.reflectivity.degree(), data_.exponent);
    SectorFunctions q = kept_functions(work, 1, degree, elements.size(), [&] {
      return trial_functions(data_.scene, elements, data_.reflectivity, emission, tolerance);
    });
    const Trial trial(data_.scene, data_.reflectivity, std::move(elements), emission, std::move(q));

    const bool last = layers == most_layers.value();
    std::vector<double> expected = expected_largest(trial);
    std::vector<ResidualOnBox> parts;
    double smallest = infinity;
    double of_outside = 0;
    for (std::size_t e = 0; e < trial.elements.size(); ++e) {
      const SectorBox& box = trial.elements[e].box;
      parts.push_back({.element = e, .box = box, .residual = residual(trial, e, expected[e])});
      smallest = std::min(smallest, trial.sector(e).jacobian * box.weight());
      if (disks_.distance_at_most(trial.sector(e), box) >= outside_)
        of_outside = std::max(of_outside, expected[e]);
    }
    const double hoped = ErrorByDistance(trial, disks_, std::move(parts), data_.gap).sup(outside_);
    if (hoped > radius_ && !last) return false;

    // What rules may miss: a part of what is left of the radius, or of what is there anyhow. Cells miss up to
    // one and a half times that, and those near vertices add half of it: 2.25 rho/gap times `left` in all.
    const double left = std::max(0.36 * (radius_ - hoped) * data_.gap / (1 - data_.gap), 0.3 * of_outside);
    for (std::size_t e = 0; e < expected.size(); ++e)
      expected[e] = trial.rho(e) > 0 ? std::max(left, 0.3 * expected[e]) : infinity;
    const DemandOutside demand(disks_, std::move(expected), left,
                               {.outside = outside_, .of_strip = 0x1p-10 * std::sqrt(smallest)});
    work.begin_plan();
    const std::vector<ObserverCell> cells = observer_cells(trial, demand, [&] { work.add_planned(); });
    is_cut_short_ = std::any_of(cells.begin(), cells.end(), [&](const ObserverCell& cell) {
      return cell.is_strip() && trial.rho(cell.element) > 0 &&
             !demand.may_be_strip(trial.sector(cell.element), cell.box);
    });
    work.begin(cells.size());
    const std::vector<double> largest = largest_residuals(trial, cells, demand, &work);
    std::vector<ResidualOnBox> proved;
    for (std::size_t c = 0; c < cells.size(); ++c)
      proved.push_back({.element = cells[c].element,
                        .box = cells[c].box,
                        .residual = residual(trial, cells[c].element, largest[c])});
    const ErrorByDistance error(trial, disks_, std::move(proved), data_.gap);
    std::shared_ptr<const FunctionProof> proof;
    if (with_proof_) proof = std::make_shared<FunctionProof>(proof_of(trial, error));
    take(trial, error, std::move(proof));
    std::size_t samples = 0;
    for (const ObserverCell& cell : cells) samples += static_cast<std::size_t>(cell.nodes_s * cell.nodes_t);
    best_.last = {.layers = layers,
                  .degree = degree,
                  .elements = trial.elements.size(),
                  .unknowns = trial.elements.size() * trial.q.size(),
                  .mesh_size = mesh_size(data_.scene, trial.elements),
                  .samples = best_.last.samples + samples,
                  .width = 2 * best_.sup};
    return true;
  }

  void take(const Trial& trial, const ErrorByDistance& error, std::shared_ptr<const FunctionProof> proof) {
    const auto scaled = [&](double x) { return std::ldexp(x, data_.exponent); };
    const double everywhere = error.sup(0);
    const double outside = everywhere <= radius_ ? 0 : outside_;
    const double sup = scaled(error.sup(outside));
    if (!(sup < best_.sup)) return;
    best_.sup = sup;
    best_.outside = outside;
    best_.proof = std::move(proof);
    best_.by_distance.clear();
    for (const double radius : error.radii())
      best_.by_distance.push_back({radius, scaled(error.sup(radius))});
    best_.by_distance.push_back({0, scaled(everywhere)});
    std::size_t pieces = 0;
    for (const Panel& panel : data_.scene.panels()) pieces = std::max(pieces, panel.piece + 1);
    best_.parts = parts(trial, error);
    best_.pieces.clear();
    for (std::size_t piece = 0; piece < pieces; ++piece)
      best_.pieces.push_back(
          {scaled(error.sup_on_piece(outside, piece)), scaled(error.sup_on_piece(0, piece))});
  }

  [[nodiscard]] FunctionProof proof_of(const Trial& trial, const ErrorByDistance& error) const {
    FunctionProof proof{.elements = {},
                        .q = SectorFunctions(0, 1, trial.q.degree()),
                        .exponent = data_.exponent,
                        .radii = error.radii()};
    const double least = error.radii().empty() ? disks_.largest_radius() : error.radii().back();
    std::vector<std::size_t> whole;
    for (std::size_t e = 0; e < trial.elements.size(); ++e)
      for (const SectorBox& box : cut_towards_vertex(trial.sector(e), trial.elements[e].box, least)) {
        proof.elements.push_back({.sector = trial.elements[e].sector, .box = box});
        proof.residuals.push_back(error.residual(e, box));
        proof.farthest.push_back(disks_.distance_at_most(trial.sector(e), box));
        whole.push_back(e);
      }
    proof.q = SectorFunctions(whole.size(), 1, trial.q.degree());
    for (std::size_t part = 0; part < whole.size(); ++part)
      put_restriction(trial.q, whole[part], trial.elements[whole[part]].box, proof.elements[part].box, part,
                      proof.q);
    return proof;
  }

  /// A box, or where it is at a vertex its parts: a quarter as large from one to the next.
  [[nodiscard]] std::vector<SectorBox> cut_towards_vertex(const Sector& sector, SectorBox box,
                                                          double least) const {
    std::vector<SectorBox> out;
    const bool at_start = box.s0 == 0;
    constexpr double narrowest = 0x1p-36;  // certificates have parameters with 40 bits
    while (box.t0 == 0 && (at_start || box.s1 == 1) && box.s1 - box.s0 > narrowest && box.t1 > narrowest &&
           disks_.distance_at_most(sector, box) > least) {
      SectorBox beside = box;
      const double quarter = 0.25 * (box.s1 - box.s0);
      if (at_start)
        beside.s0 = box.s1 = box.s0 + quarter;
      else
        beside.s1 = box.s0 = box.s1 - quarter;
      SectorBox above = box;
      above.t0 = box.t1 = 0.25 * box.t1;
      out.push_back(beside);
      out.push_back(above);
    }
    out.push_back(box);
    return out;
  }

  /// v and its bound on each element in 4 x 4.
  [[nodiscard]] std::vector<EnclosedPart> parts(const Trial& trial, const ErrorByDistance& error) const {
    constexpr int cuts = 4;
    std::vector<EnclosedPart> out;
    const auto powers = static_cast<double>(trial.w.degree() + 1);
    for (std::size_t e = 0; e < trial.elements.size(); ++e) {
      const Sector& sector = trial.sector(e);
      const SectorBox& box = trial.elements[e].box;
      // Of the values of v, as products of polynomials and coefficients are off by.
      const double rounding =
          40 * powers * powers * unit_roundoff<double>() * trial.smoothness.density_size(e);
      const auto at = [](double from, double to, int k) { return from + (to - from) * k / cuts; };
      const auto corner = [&](int i, int j, EnclosedPart& part, std::size_t place) {
        const double s = at(box.s0, box.s1, i);
        const double t = at(box.t0, box.t1, j);
        part.corners[place] = data_.scene.origin() + sector.point(s, t);
        part.values[place] =
            std::ldexp(value(trial.w, e, 2.0 * i / cuts - 1, 2.0 * j / cuts - 1), data_.exponent);
      };
      for (int i = 0; i < cuts; ++i)
        for (int j = 0; j < cuts; ++j) {
          EnclosedPart part{.piece = data_.scene.panels()[sector.panel].piece, .corners = {}};
          corner(i, j, part, 0);
          corner(i + 1, j, part, 1);
          corner(i + 1, j + 1, part, 2);
          corner(i, j + 1, part, 3);
          part.bound = std::ldexp(rounding + error.on(e, {.s0 = at(box.s0, box.s1, i),
                                                          .s1 = at(box.s0, box.s1, i + 1),
                                                          .t0 = at(box.t0, box.t1, j),
                                                          .t1 = at(box.t0, box.t1, j + 1)}),
                                  data_.exponent);
          out.push_back(part);
        }
    }
    return out;
  }

  const ScaledProblem& data_;
  VertexDisks disks_;
  double radius_;
  double outside_;
  bool with_proof_;
  bool is_cut_short_ = false;  ///< whether cells of the last mesh were cut as often as is allowed
  FunctionEnclosure best_;
};

}  // namespace

FunctionEnclosure enclose_function(const PolyhedronProblem& problem, double wanted, double outside,
                                   const SearchContext& context, bool with_proof) {
  expects(wanted > 0 && std::isfinite(wanted), "0 < wanted < infinity", named("wanted", wanted));
  expects(outside >= 0, "0 <= outside", named("outside", outside));
  expects(problem.further_emissions.empty(), "one emission");
  const ScaledProblem data(problem);
  return FunctionSearch(data, wanted, outside, with_proof)(context);
}

}  // namespace radcert
