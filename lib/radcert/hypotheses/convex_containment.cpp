// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/hypotheses/convex_containment.h"

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <utility>

#include "radcert/core/contract.h"
#include "radcert/hypotheses/chart_pairs.h"
#include "radcert/hypotheses/chart_shape.h"
#include "radcert/hypotheses/chart_witness.h"
#include "radcert/surface/exact_chart.h"

namespace radcert {
namespace {

/// Enough for boxes as small as bisection makes them: what is decided has a margin far above the rounding.
const WorkLimit box_bits("hypotheses/convex_containment: bits of boxes", 64, BallPrecision::smallest_bits,
                         "undecided: wide balls settle nothing");
/// A condition on Q alone is decided by few boxes or not at all.
const WorkLimit boxes_of_a_condition("hypotheses/convex_containment: boxes of a condition on Q", 2000, 1,
                                     "not settled this way: pairs of boxes are tried");

/// A chart with what is known of it.
struct KnownChart {
  const Chart* chart;
  std::optional<Vector<ExactFunction>> image;
  ProvedShape shape;
  std::unique_ptr<PatchTable> patches;
};

/// How P on one chart and Q on another were settled, or how many boxes are left.
struct Settled {
  std::string how;
  std::size_t boxes_left = 0;
  std::optional<std::pair<ParameterPoint<double>, ParameterPoint<double>>> witness = std::nullopt;
};

class Certificate {
public:
  Certificate(const Surface& surface, const ContainmentBudget& budget)
      : surface_(&surface), budget_(&budget) {
    for (const Chart& chart : surface.charts) {
      const ExactImage* exact = exact_image(chart.in<Ball>());
      KnownChart known{.chart = &chart, .image = std::nullopt, .shape = {}, .patches = nullptr};
      if (exact != nullptr) known.image = exact->image();
      known.shape = prove_shape(chart, known.image ? &*known.image : nullptr, result_.boxes);
      known.patches = std::make_unique<PatchTable>(chart);
      charts_.push_back(std::move(known));
    }
  }

  ConvexContainment result() {
    for (const KnownChart& each : charts_)
      for (const std::string* proof : {&each.shape.proof, &each.shape.refusal})
        if (!proof->empty()) add_step("chart " + each.chart->facts().name, *proof);
    for (std::size_t p = 0; p < charts_.size(); ++p)
      for (std::size_t q = 0; q < charts_.size(); ++q) {
        const Settled settled = settle(p, q);
        if (settled.witness) {
          result_.chart_witness =
              witness_at(*surface_, p, settled.witness->first, q, settled.witness->second);
          if (result_.chart_witness) return std::move(result_);
        }
        if (settled.how.empty())
          result_.open.push_back({.chart_p = p, .chart_q = q, .boxes = settled.boxes_left});
        else
          ++pairs_settled_[settled.how];
      }
    for (const auto& [how, pairs] : pairs_settled_)
      add_step(std::to_string(pairs) + (pairs == 1 ? " pair" : " pairs") + " of charts", how);
    return std::move(result_);
  }

private:
  void add_step(const std::string& says, const std::string& proof) {
    result_.steps.push_back({.says = says, .proof = proof});
  }

  std::size_t limit() const {
    return std::min(budget_->boxes_a_pair, budget_->boxes - std::min(budget_->boxes, result_.boxes));
  }

  Settled settle(std::size_t p, std::size_t q) {
    const ProvedShape& shape = charts_[p].shape;
    if (shape.inner) {
      Settled settled = settle_behind_plane(*shape.inner, charts_[q]);
      if (!settled.how.empty()) return settled;
    }
    if (shape.quadric) {
      Settled settled = settle_in_quadric(*shape.quadric, charts_[q]);
      if (!settled.how.empty()) return settled;
    }
    if (p == q && shape.profile_is_convex) return {.how = "P and Q on one ruled chart with a convex profile"};
    PairSearch search = search_pairs(*charts_[p].patches, *charts_[q].patches, limit(), result_.boxes);
    if (search.witness) return {.how = "", .boxes_left = search.boxes_left, .witness = search.witness};
    if (search.boxes_left > 0) return {.how = "", .boxes_left = search.boxes_left};
    return {
        .how = p == q ? "one chart with itself: pairs of boxes, near the diagonal the second fundamental form"
                      : "two charts: pairs of boxes, (Q-P).n_P enclosed"};
  }

  Settled settle_behind_plane(const AffineForm& inner, KnownChart& of_q) {
    if (of_q.shape.inner && is_zero_on(inner, of_q)) return {.how = "P and Q in one plane: an identity"};
    if (of_q.image && is_nowhere_negative(inner.value(*of_q.image), region_of(*of_q.chart)))
      return {.how = "Q on the inner side of the plane of P: exact coefficients in the basis of Bernstein"};
    return over_boxes(of_q, "Q on the inner side of the plane of P: balls over boxes",
                      [&](const Frame<Ball>& frame) { return certainly_positive(inner.value(frame.point)); });
  }

  Settled settle_in_quadric(const Quadric& quadric, KnownChart& of_q) {
    if (of_q.shape.quadric && is_same(quadric, *of_q.shape.quadric))
      return {.how = "P and Q on one quadric with a convex inside: an identity"};
    const auto is_at_least_zero = [&](const ExactFunction& f) {
      return is_nowhere_negative(f, region_of(*of_q.chart));
    };
    if (of_q.image && is_at_least_zero(-quadric.value(*of_q.image)) &&
        (!quadric.nappe || is_at_least_zero(quadric.nappe->value(*of_q.image))))
      return {.how = "Q inside the quadric of P: exact coefficients in the basis of Bernstein"};
    return over_boxes(of_q, "Q inside the quadric of P: balls over boxes", [&](const Frame<Ball>& frame) {
      const Vector<Ball>& at = frame.point;
      return certainly_negative(quadric.value(at)) &&
             (!quadric.nappe || certainly_positive(quadric.nappe->value(at)));
    });
  }

  static bool is_zero_on(const AffineForm& form, const KnownChart& of_q) {
    return of_q.image && form.value(*of_q.image).is_zero();
  }

  Settled over_boxes(KnownChart& of_q, const std::string& how,
                     const std::function<bool(const Frame<Ball>&)>& holds) {
    const std::size_t most_boxes = boxes_of_a_condition.count();
    const std::size_t left = boxes_left(*of_q.chart, std::min(limit(), most_boxes), result_.boxes, holds);
    return left == 0 ? Settled{.how = how} : Settled{.how = "", .boxes_left = left};
  }

  const Surface* surface_;
  const ContainmentBudget* budget_;
  ConvexContainment result_;
  std::vector<KnownChart> charts_;
  std::map<std::string, std::size_t> pairs_settled_;
};

ConvexContainment refuted_by(const Surface& surface, ChartWitness witness) {
  ConvexContainment result;
  result.verdict = Containment::refuted;
  result.relative_depth = relative_depth(surface, witness);
  result.reason = "Q on chart " + surface.charts[witness.chart_q].facts().name +
                  " lies behind the tangent plane at P on chart " +
                  surface.charts[witness.chart_p].facts().name + ", in balls";
  result.chart_witness = std::move(witness);
  return result;
}

/// The charts that open pairs name, at most three of them.
std::string what_is_left(const Surface& surface, const std::vector<OpenPair>& open) {
  constexpr std::size_t most_pairs = 3;
  std::string text = std::to_string(open.size()) + " pairs of charts are left: ";
  for (std::size_t i = 0; i < std::min(open.size(), most_pairs); ++i) {
    const OpenPair& pair = open[i];
    text += (i == 0 ? "" : ", ") + surface.charts[pair.chart_p].facts().name + " and " +
            surface.charts[pair.chart_q].facts().name + " (" + std::to_string(pair.boxes) + " boxes)";
  }
  return text + (open.size() > most_pairs ? ", ..." : "");
}

}  // namespace

const WorkLimit most_boxes_a_pair("hypotheses/convex_containment: boxes of a pair of charts", 60000, 1,
                                  "undecided, with the pairs of charts that are left");
const WorkLimit most_containment_boxes("hypotheses/convex_containment: boxes in all", 200000, 1,
                                       "undecided, with the pairs of charts that are left");

std::string containment_word(Containment verdict) {
  switch (verdict) {
    case Containment::certified: return "certified";
    case Containment::refuted: return "refuted";
    case Containment::undecided: return "undecided";
  }
  expects(false, "a verdict of the list", named("verdict", static_cast<int>(verdict)));
  return {};
}

ConvexContainment convex_containment(const Surface& surface, const ContainmentBudget& budget) {
  expects(budget.boxes > 0 && budget.boxes_a_pair > 0, "a positive budget", named("boxes", budget.boxes),
          named("boxes_a_pair", budget.boxes_a_pair));
  for (const Chart& chart : surface.charts)
    if (!has_balls(chart)) {
      ConvexContainment result;
      result.reason = "chart " + chart.facts().name + " has no formula in balls";
      return result;
    }
  if (auto witness = witness_on_lattices(surface)) return refuted_by(surface, std::move(*witness));
  const BallPrecision precision(box_bits.value());
  ConvexContainment result = Certificate(surface, budget).result();
  if (!result.open.empty() && !result.chart_witness) result.chart_witness = witness_nearby(surface);
  if (result.chart_witness) {
    ConvexContainment refuted = refuted_by(surface, std::move(*result.chart_witness));
    refuted.steps = std::move(result.steps);
    refuted.boxes = result.boxes;
    return refuted;
  }
  if (!result.open.empty()) {
    result.reason = what_is_left(surface, result.open);
    return result;
  }
  result.verdict = Containment::certified;
  result.reason = "no point lies behind the tangent plane of another, for all pairs of charts";
  return result;
}

}  // namespace radcert
