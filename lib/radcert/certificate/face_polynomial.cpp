// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/certificate/face_polynomial.h"

#include <algorithm>
#include <utility>

#include "radcert/core/work_limit.h"
#include "radcert/geometry/plane_polygon.h"

namespace radcert::certificate {

const WorkLimit most_face_parts("certificate/face_polynomial: parts of a face", 20000, 0,
                                "the reflectivity is not verified");

namespace {

/// Coefficients by powers, or numbers, of s and t.
using Square = std::vector<std::vector<Rational>>;

/// x = constant + s (1-t) along + t inward, of one coordinate of a face's plane.
struct Bilinear {
  Rational constant, along, inward;
};

/// out += f g by powers, g = constant + along (s - s t) + inward t.
Square times(const Square& f, const Bilinear& g) {
  const std::size_t n = f.size();
  Square out(n, std::vector<Rational>(n));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      if (f[i][j].sign() == 0) continue;
      out[i][j] += f[i][j] * g.constant;
      // Beyond the degree there is nothing: f has less than the degree where it is multiplied.
      if (i + 1 < n) out[i + 1][j] += f[i][j] * g.along;
      if (i + 1 < n && j + 1 < n) out[i + 1][j + 1] -= f[i][j] * g.along;
      if (j + 1 < n) out[i][j + 1] += f[i][j] * g.inward;
    }
  return out;
}

Rational binomial(std::size_t n, std::size_t k) {
  Rational out = 1;
  for (std::size_t i = 0; i < k; ++i)
    out = out * Rational(static_cast<long>(n - i)) / Rational(static_cast<long>(i + 1));
  return out;
}

/// b_i = sum_(k <= i) C(i,k)/C(n,k) a_k, in both parameters.
Square bernstein(Square f) {
  const std::size_t degree = f.size() - 1;
  const auto along = [&](const auto& at) {
    std::vector<Rational> out(degree + 1);
    for (std::size_t i = 0; i <= degree; ++i)
      for (std::size_t k = 0; k <= i; ++k) out[i] += binomial(i, k) / binomial(degree, k) * at(k);
    return out;
  };
  for (std::vector<Rational>& row : f) row = along([&row](std::size_t k) { return row[k]; });
  for (std::size_t j = 0; j <= degree; ++j) {
    const std::vector<Rational> column = along([&](std::size_t k) { return f[k][j]; });
    for (std::size_t i = 0; i <= degree; ++i) f[i][j] = column[i];
  }
  return f;
}

/// The two halves of a list of Bernstein coefficients, by de Casteljau's rule.
std::pair<std::vector<Rational>, std::vector<Rational>> halves(std::vector<Rational> b) {
  std::vector<Rational> low;
  std::vector<Rational> high(b.size());
  const Rational half(1, 2);
  for (std::size_t n = b.size(); n > 0; --n) {
    low.push_back(b.front());
    high[n - 1] = b[n - 1];
    for (std::size_t i = 0; i + 1 < n; ++i) b[i] = half * (b[i] + b[i + 1]);
  }
  return {std::move(low), std::move(high)};
}

/// The halves in s, or in t.
std::pair<Square, Square> cut(const Square& b, bool in_s) {
  const std::size_t n = b.size();
  Square low(n, std::vector<Rational>(n));
  Square high = low;
  for (std::size_t k = 0; k < n; ++k) {
    std::vector<Rational> line(n);
    for (std::size_t i = 0; i < n; ++i) line[i] = in_s ? b[i][k] : b[k][i];
    const auto [lower, upper] = halves(std::move(line));
    for (std::size_t i = 0; i < n; ++i) {
      (in_s ? low[i][k] : low[k][i]) = lower[i];
      (in_s ? high[i][k] : high[k][i]) = upper[i];
    }
  }
  return {std::move(low), std::move(high)};
}

/// f on the triangle of a side, by its Bernstein coefficients.
Square on_side(const Face& face, std::size_t side, const Square& f) {
  const std::vector<Vector<Rational>>& c = face.corners;
  Vector<Rational> sum;
  for (const Vector<Rational>& p : c) sum = sum + p;
  const Vector<Rational> centre = Rational(1, static_cast<long>(c.size())) * sum;
  const auto at = [&](const Vector<Rational>& v) { return coordinates(v, c[1] - c[0], c[2] - c[0]); };
  const ParameterPoint<Rational> a = at(c[side] - c[0]);
  const ParameterPoint<Rational> along = at(c[(side + 1) % c.size()] - c[side]);
  const ParameterPoint<Rational> inward = at(centre - c[side]);
  const Bilinear x{a.s, along.s, inward.s};
  const Bilinear y{a.t, along.t, inward.t};
  const std::size_t n = f.size();
  Square out(n, std::vector<Rational>(n));
  for (std::size_t i = n; i-- > 0;) {
    Square inner(n, std::vector<Rational>(n));
    for (std::size_t j = f[i].size(); j-- > 0;) {
      inner = times(inner, y);
      inner[0][0] += f[i][j];
    }
    out = times(out, x);
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t l = 0; l < n; ++l) out[k][l] += inner[k][l];
  }
  return bernstein(std::move(out));
}

struct Waiting {
  Square numbers;
  bool in_s = true;
};

}  // namespace

int reflectivity_degree(const Face& face) {
  return face.varying_reflectivity.empty() ? 0 : static_cast<int>(face.varying_reflectivity.size()) - 1;
}

Rational reflectivity_at(const Face& face, const Vector<Rational>& point) {
  if (face.varying_reflectivity.empty()) return face.reflectivity;
  const std::vector<Vector<Rational>>& c = face.corners;
  const ParameterPoint<Rational> at = coordinates(point - c[0], c[1] - c[0], c[2] - c[0]);
  return polynomial_value(face.varying_reflectivity, at.s, at.t);
}

bool lies_within(const Face& face, const std::vector<std::vector<Rational>>& f, const Rational& bound) {
  const auto is_within = [&](const Rational& x) { return x.sign() >= 0 && x <= bound; };
  std::vector<Waiting> parts;
  for (std::size_t side = 0; side < face.corners.size(); ++side) parts.push_back({on_side(face, side, f)});
  std::size_t left = most_face_parts.count();
  while (!parts.empty()) {
    const Waiting part = std::move(parts.back());
    parts.pop_back();
    const Square& b = part.numbers;
    if (std::all_of(b.begin(), b.end(), [&](const std::vector<Rational>& row) {
          return std::all_of(row.begin(), row.end(), is_within);
        }))
      continue;
    const bool corners = is_within(b.front().front()) && is_within(b.front().back()) &&
                         is_within(b.back().front()) && is_within(b.back().back());
    if (!corners || left == 0) return false;
    --left;
    auto [low, high] = cut(b, part.in_s);
    parts.push_back({std::move(low), !part.in_s});
    parts.push_back({std::move(high), !part.in_s});
  }
  return true;
}

}  // namespace radcert::certificate
