// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/enclosure/maximum.h"

#include <algorithm>
#include <queue>
#include <string>
#include <utility>

#include "radcert/core/contract.h"

namespace radcert {

namespace {

struct Range {
  double low;
  double high;
  double middle() const { return low + (high - low) / 2; }
};

struct OpenBox {
  std::vector<Range> sides;
  Ball upper;  ///< no value in the box exceeds it; a failure where nothing is known
};

std::vector<Ball> balls(const std::vector<Range>& sides) {
  std::vector<Ball> result;
  for (const Range& side : sides) result.push_back(hull(Ball(side.low), Ball(side.high)));
  return result;
}

class Search {
public:
  Search(const CubeFunction& f, const Demand& demand) : f_(f), demand_(demand), boxes_(&is_below) {}

  Enclosure run() {
    if (demand_.work_limit < evaluations_per_box)
      return out_of_work(Ball::failed("no evaluation was allowed"));
    add({.sides = std::vector<Range>(f_.dimension, Range{0, 1}), .upper = {}});
    while (true) {
      // The box of a maximum is never left out.
      expects(!boxes_.empty(), "a gradient that encloses the derivatives of its function",
              named("largest value", best_));
      const Ball& upper = boxes_.top().upper;
      const Ball reached =
          best_.is_finite() && upper.is_finite() ? hull(best_.lower(), upper) : Ball::failed(failure(upper));
      if (reached.is_finite() && reached.radius() <= demand_.radius) {
        return Enclosed{.value = reached, .evaluations = evaluations_};
      }
      if (evaluations_ + 2 * evaluations_per_box > demand_.work_limit) return out_of_work(reached);
      const OpenBox box = boxes_.top();
      boxes_.pop();
      if (!halve(box)) return undecided("a box too small to be bisected", reached);
    }
  }

private:
  /// A gradient, the value in the middle, the range.
  static constexpr long evaluations_per_box = 3;

  /// Boxes of which nothing is known come first.
  static bool is_below(const OpenBox& a, const OpenBox& b) {
    if (!b.upper.is_finite()) return a.upper.is_finite();
    return a.upper.is_finite() && certainly_less(a.upper, b.upper);
  }

  const char* failure(const Ball& upper) const {
    return upper.is_finite() ? best_.failure().data() : upper.failure().data();
  }

  Enclosure out_of_work(const Ball& reached) const {
    return undecided("the work limit of " + std::to_string(demand_.work_limit) + " evaluations", reached);
  }

  Enclosure undecided(std::string why, const Ball& reached) const {
    why += " was reached with " + std::to_string(boxes_.size()) + " boxes open";
    return because(Undecided{.why = std::move(why), .reached = reached, .evaluations = evaluations_});
  }

  bool halve(const OpenBox& box) {
    std::size_t longest = 0;
    for (std::size_t k = 1; k < box.sides.size(); ++k) {
      if (box.sides[k].high - box.sides[k].low > box.sides[longest].high - box.sides[longest].low)
        longest = k;
    }
    const Range side = box.sides[longest];
    const double middle = side.middle();
    if (!(side.low < middle && middle < side.high)) return false;
    OpenBox low = box;
    OpenBox high = box;
    low.sides[longest].high = middle;
    high.sides[longest].low = middle;
    add(std::move(low));
    add(std::move(high));
    return true;
  }

  /// Bounds the box and keeps it where a maximum may be.
  void add(OpenBox box) {
    const std::vector<Ball> gradient = f_.gradient(balls(box.sides));
    evaluations_ += evaluations_per_box;
    for (std::size_t k = 0; k < box.sides.size(); ++k) {
      Range& side = box.sides[k];
      if (certainly_positive(gradient[k]) && side.low < side.high) {
        if (side.high < 1) return;
        side.low = 1;
      } else if (certainly_negative(gradient[k]) && side.low < side.high) {
        if (side.low > 0) return;
        side.high = 0;
      }
    }
    const std::vector<Ball> x = balls(box.sides);
    std::vector<Ball> middle;
    for (const Range& side : box.sides) middle.emplace_back(side.middle());
    const Ball at_middle = f_.value(middle);
    Ball mean_value_form = at_middle;
    for (std::size_t k = 0; k < x.size(); ++k) mean_value_form += gradient[k] * (x[k] - middle[k]);
    Ball range = f_.value(x);
    // The middle is one of the box's points: a better lower bound of the maximum, perhaps.
    if (at_middle.is_finite() && (!best_.is_finite() || certainly_less(best_.lower(), at_middle.lower()))) {
      best_ = at_middle;
    }
    if (!range.is_finite()) {
      range = mean_value_form;
    } else if (mean_value_form.is_finite()) {
      range = intersection(range, mean_value_form);
    }
    box.upper = range.upper();
    if (best_.is_finite() && certainly_less(box.upper, best_.lower())) return;
    boxes_.push(std::move(box));
  }

  const CubeFunction& f_;
  const Demand& demand_;
  std::priority_queue<OpenBox, std::vector<OpenBox>, bool (*)(const OpenBox&, const OpenBox&)> boxes_;
  Ball best_ = Ball::failed("no value of the function is known");
  long evaluations_ = 0;
};

}  // namespace

Enclosure maximum(const CubeFunction& f, const Demand& demand) {
  expects(demand.radius > 0 && demand.work_limit >= 1, "radius > 0, work_limit >= 1",
          named("radius", demand.radius), named("work_limit", demand.work_limit));
  expects(f.dimension >= 1, "dimension >= 1", named("dimension", f.dimension));
  return Search(f, demand).run();
}

}  // namespace radcert
