// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/hypotheses/chart_shape.h"

#include <algorithm>
#include <array>
#include <deque>

#include "radcert/core/work_limit.h"

namespace radcert {
namespace {

template <class R>
Vector<R> in_arithmetic(const Vector<Rational>& v) {
  return {from_rational<R>(v.x), from_rational<R>(v.y), from_rational<R>(v.z)};
}

/// grad q at a point.
template <class R>
Vector<R> gradient_of(const Quadric& q, const Vector<R>& at) {
  const Vector<R> squares = in_arithmetic<R>(q.squares);
  const Vector<R> of_squares{squares.x * at.x, squares.y * at.y, squares.z * at.z};
  const Vector<R> gradient = in_arithmetic<R>(q.linear.gradient) + R(2) * of_squares;
  if (!q.nappe) return gradient;
  return gradient - (R(2) * q.nappe->value(at)) * in_arithmetic<R>(q.nappe->gradient);
}

std::string stated_but(const std::string& what, const std::string& why) {
  return what + " is stated, but " + why;
}

const char* const no_sign = "the direction of its normals is not shown";

std::string not_an_identity(const ExactFunction& f) {
  return f.is_known() ? "does not hold" : "is not shown: the formula is not one of powers and simple roots";
}

const WorkLimit boxes_of_a_sign("hypotheses/chart_shape: boxes of a sign over a domain", 20000, 1,
                                "the stated shape counts as not proved");

/// Whether a number is positive on all frames of a chart, by balls over boxes.
bool is_positive(const Chart& chart, std::size_t& boxes,
                 const std::function<Ball(const Frame<Ball>&)>& number) {
  return boxes_left(chart, boxes_of_a_sign.count(), boxes,
                    [&](const Frame<Ball>& over) { return certainly_positive(number(over)); }) == 0;
}

ProvedShape prove_plane(const Chart& chart, const Vector<ExactFunction>& image, std::size_t& boxes) {
  const Plane& plane = *chart.facts().flat_in();
  const AffineForm form{.gradient = plane.normal(), .constant = -plane.offset()};
  ProvedShape shape;
  const ExactFunction identity = form.value(image);
  if (!identity.is_zero()) {
    shape.refusal = stated_but("a plane", "it " + not_an_identity(identity));
    return shape;
  }
  const Frame<Ball> somewhere = chart.in<Ball>().frame({Ball(0), Ball(0)});
  const bool along = certainly_positive(dot(somewhere.area_normal, in_arithmetic<Ball>(plane.normal())));
  const AffineForm inner = along ? form : AffineForm{.gradient = -form.gradient, .constant = -form.constant};
  if (!is_positive(chart, boxes, [&](const Frame<Ball>& over) {
        return dot(over.area_normal, in_arithmetic<Ball>(inner.gradient));
      })) {
    shape.refusal = stated_but("a plane", no_sign);
    return shape;
  }
  shape.inner = inner;
  shape.proof =
      "flat: its plane holds as an identity of its formula, the side of its normals in balls over boxes";
  return shape;
}

ProvedShape prove_quadric(const Chart& chart, const Vector<ExactFunction>& image, std::size_t& boxes) {
  const Quadric& quadric = *chart.facts().structure.quadric;
  ProvedShape shape;
  if (!quadric.has_convex_inside()) {
    shape.refusal = stated_but("a quadric", "its inside is not shown to be convex");
    return shape;
  }
  const ExactFunction identity = quadric.value(image);
  if (!identity.is_zero()) {
    shape.refusal = stated_but("a quadric", "it " + not_an_identity(identity));
    return shape;
  }
  if (!is_positive(chart, boxes, [&](const Frame<Ball>& over) {
        return -dot(over.area_normal, gradient_of(quadric, over.point));
      })) {
    shape.refusal = stated_but("a quadric", no_sign);
    return shape;
  }
  if (quadric.nappe &&
      !is_positive(chart, boxes, [&](const Frame<Ball>& over) { return quadric.nappe->value(over.point); })) {
    shape.refusal = stated_but("a quadric", "the nappe is not shown to be the upper one");
    return shape;
  }
  shape.quadric = quadric;
  shape.proof =
      "on a quadric whose inside is convex: the quadric holds as an identity of its formula, the side of its "
      "normals in "
      "balls over boxes";
  return shape;
}

/// The coefficients of one power of s in the three coordinates.
using ProfileTerms = std::map<Rational, Vector<Rational>>;

std::optional<ProfileTerms> profile_terms(const Vector<ExactFunction>& profile) {
  ProfileTerms terms;
  std::size_t axis = 0;
  for (const ExactFunction* coordinate : {&profile.x, &profile.y, &profile.z}) {
    const std::optional<PowerQuotient> f = coordinate->quotient();
    const PowerSum one{{{Rational(0), Rational(0)}, Rational(1)}};
    if (!f || f->denominator != one) return std::nullopt;
    for (const auto& [exponents, coefficient] : f->numerator) {
      Vector<Rational>& term = terms[exponents[0]];
      (axis == 0 ? term.x : axis == 1 ? term.y : term.z) = coefficient;
    }
    ++axis;
  }
  return terms;
}

Rational determinant(const Vector<Rational>& a, const Vector<Rational>& b, const Vector<Rational>& c) {
  return dot(a, cross(b, c));
}

/// Whether the profile bends to the side of the normal: see prove_shape.
bool bends_inwards(const ProfileTerms& terms, const Vector<Rational>& ruling, Orientation orientation) {
  const auto linear = terms.find(Rational(1));
  if (linear == terms.end()) return false;
  const int sign = orientation == Orientation::along_the_cross_product ? 1 : -1;
  const auto is_bend = [](const Rational& exponent) { return exponent.sign() != 0 && exponent != 1; };
  for (const auto& [e, v] : terms) {
    if (!is_bend(e)) continue;
    if (e < 1 || sign * determinant(linear->second, v, ruling).sign() > 0) return false;
    for (const auto& [f, w] : terms)
      if (is_bend(f) && determinant(v, w, ruling).sign() != 0) return false;
  }
  return true;
}

ProvedShape prove_ruling(const Chart& chart, const Vector<ExactFunction>& image) {
  const Vector<Rational>& ruling = *chart.facts().structure.ruling;
  ProvedShape shape;
  const Vector<ExactFunction> profile{image.x.where_t_is_zero(), image.y.where_t_is_zero(),
                                      image.z.where_t_is_zero()};
  const auto rest = [](const ExactFunction& f, const ExactFunction& at_zero, const Rational& along) {
    return f - at_zero - ExactFunction(along) * ExactFunction::t();
  };
  for (const ExactFunction& identity :
       {rest(image.x, profile.x, ruling.x), rest(image.y, profile.y, ruling.y),
        rest(image.z, profile.z, ruling.z)})
    if (!identity.is_zero()) {
      shape.refusal = stated_but("a ruling", "it " + not_an_identity(identity));
      return shape;
    }
  const std::optional<ProfileTerms> terms = profile_terms(profile);
  if (!terms || !bends_inwards(*terms, ruling, chart.facts().orientation)) {
    shape.refusal = "its ruling holds, but its profile is not shown to bend inwards";
    return shape;
  }
  shape.profile_is_convex = true;
  shape.proof =
      "ruled: the ruling holds as an identity of its formula, the profile is a sum of convex powers with "
      "exact coefficients";
  return shape;
}

}  // namespace

bool is_same(const AffineForm& a, const AffineForm& b) {
  return a.gradient == b.gradient && a.constant == b.constant;
}

bool is_same(const Quadric& a, const Quadric& b) {
  if (a.nappe.has_value() != b.nappe.has_value() || (a.nappe && !is_same(*a.nappe, *b.nappe))) return false;
  return a.squares == b.squares && is_same(a.linear, b.linear);
}

std::size_t boxes_left(const Chart& chart, std::size_t limit, std::size_t& boxes,
                       const std::function<bool(const Frame<Ball>&)>& holds) {
  const ChartIn<Ball>& formula = chart.in<Ball>();
  std::deque<ParameterBox> waiting{{}};
  for (std::size_t looked_at = 0; !waiting.empty(); ++looked_at) {
    if (looked_at == limit) return waiting.size();
    const ParameterBox box = waiting.front();
    waiting.pop_front();
    if (!meets(box, chart.facts().domain)) continue;
    ++boxes;
    const Frame<Ball> frame = formula.frame(ball_of(box));
    if (holds(frame)) continue;
    const auto [low, high] = box.halves(is_longer_in_s(frame, box));
    waiting.push_back(low);
    waiting.push_back(high);
  }
  return 0;
}

ProvedShape prove_shape(const Chart& chart, const Vector<ExactFunction>* image, std::size_t& boxes) {
  const ChartFacts& facts = chart.facts();
  const ChartStructure& structure = facts.structure;
  if (image == nullptr) {
    ProvedShape shape;
    if (facts.flat_in() || structure.quadric || structure.ruling)
      shape.refusal = "its shape is stated, but its formula is not known exactly";
    return shape;
  }
  if (facts.flat_in()) return prove_plane(chart, *image, boxes);
  if (structure.quadric) {
    const ProvedShape shape = prove_quadric(chart, *image, boxes);
    if (shape.quadric || !structure.ruling) return shape;
  }
  if (structure.ruling) return prove_ruling(chart, *image);
  return {};
}

}  // namespace radcert
