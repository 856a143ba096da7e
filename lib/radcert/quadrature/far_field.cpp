// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/quadrature/far_field.h"

#include <algorithm>
#include <cmath>

namespace radcert {
namespace {

template <Real R>
auto broadcast(const Vector<R>& v) {
  using B = typename Block<R>::Type;
  return Vector<B>{B(v.x), B(v.y), B(v.z)};
}

/// value_j = sum_q g_q l_j(x_q) for `Many` functions from the first on. Each sum runs in `Strands` strands: a
/// sum of its own has to wait for every step before the next.
template <std::size_t Many, std::size_t Strands, Real R>
void add_products(const std::vector<typename Block<R>::Type>& g, const Samples<R>& samples, std::size_t first,
                  FarSums<R>& sums) {
  using B = typename Block<R>::Type;
  std::array<std::array<B, Strands>, Many> value;
  for (std::array<B, Strands>& strands : value) strands.fill(B(R(0)));
  const auto add = [&](std::size_t q, std::size_t strand) {
    const R* l = samples.basis_at(q) + first * Samples<R>::lanes;
    for (std::size_t j = 0; j < Many; ++j)
      value[j][strand] = multiply_add(g[q], B(l[j * Samples<R>::lanes]), value[j][strand]);
  };
  std::size_t q = 0;
  for (; q + Strands <= samples.count; q += Strands)
    for (std::size_t strand = 0; strand < Strands; ++strand) add(q + strand, strand);
  for (; q < samples.count; ++q) add(q, 0);
  for (std::size_t j = 0; j < Many; ++j) {
    sums.value[first + j] = value[j][0];
    for (std::size_t strand = 1; strand < Strands; ++strand)
      sums.value[first + j] = sums.value[first + j] + value[j][strand];
  }
}

}  // namespace

template <Real R>
void far_sums(const CollocationPointBlock<R>& observers, const Samples<R>& samples,
              std::vector<typename Block<R>::Type>& g, FarSums<R>& sums) {
  using B = typename Block<R>::Type;
  using std::abs;
  if (g.size() < samples.count) g.resize(samples.count);
  const Vector<B> point = observers.point;
  const Vector<B> minus_normal = -observers.normal;
  B size = B(R(0));
  for (std::size_t q = 0; q < samples.count; ++q) {
    const Vector<B> d{point.x - B(samples.x[q]), point.y - B(samples.y[q]), point.z - B(samples.z[q])};
    const Vector<B> normal_q{B(samples.normal_x[q]), B(samples.normal_y[q]), B(samples.normal_z[q])};
    g[q] = kernel_terms<B>(d, minus_normal, normal_q).value();
    size = size + abs(g[q]);
  }
  sums.size = size;

  std::size_t j = 0;
  for (; j + 3 <= samples.functions; j += 3) add_products<3, 1>(g, samples, j, sums);
  for (; j < samples.functions; ++j) add_products<1, 4>(g, samples, j, sums);
}

template <Real R>
FarView<R>::FarView(const Samples<R>& samples, const Vector<R>& centre) {
  using std::abs;
  const auto normal_at = [&samples](std::size_t q) {
    return Vector<R>{samples.normal_x[q], samples.normal_y[q], samples.normal_z[q]};
  };
  for (std::size_t q = 0; q < samples.count; ++q) {
    const R weight = norm(normal_at(q));
    area += weight;
    normal = normal + normal_at(q);
    for (std::size_t j = 0; j < samples.functions; ++j)
      share[j] += weight * abs(samples.basis_at(q)[j * Samples<R>::lanes]);
  }
  normal = (R(1) / area) * normal;
  for (std::size_t q = 0; q < samples.count; ++q) {
    const Vector<R> unit = (R(1) / norm(normal_at(q))) * normal_at(q);
    const Vector<R> point{samples.x[q], samples.y[q], samples.z[q]};
    const Vector<R> deviation = unit - normal;
    spread = {std::max(spread.x, static_cast<R>(abs(deviation.x))),
              std::max(spread.y, static_cast<R>(abs(deviation.y))),
              std::max(spread.z, static_cast<R>(abs(deviation.z)))};
    rise = std::max(rise, static_cast<R>(abs(dot(point - centre, unit))));
    height = std::max(height, static_cast<R>(abs(dot(point - centre, normal))));
  }
}

template <Real R>
FarBounds<R>::FarBounds(const CollocationPointBlock<R>& observers, const FarView<R>& view,
                        const Vector<R>& centre, const R& radius, const R& extent) {
  using std::abs;
  using std::sqrt;
  const Vector<B> d = observers.point - broadcast<R>(centre);
  const B squared = dot(d, d);
  const B distance = sqrt(squared);
  const Vector<B> normal = broadcast<R>(view.normal);
  const B face_on = abs(dot(d, normal));
  const B along = dot(observers.normal, normal) * B(R(1) / dot(view.normal, view.normal));
  const Vector<B> across = observers.normal - along * normal;
  const B seen_from_p =
      abs(dot(d, observers.normal)) + abs(along) * B(view.height) + B(radius) * norm(across);
  const B seen_from_q = face_on + abs(d.x) * B(view.spread.x) + abs(d.y) * B(view.spread.y) +
                        abs(d.z) * B(view.spread.z) + B(view.rise);
  const B least = distance - B(radius);
  const B least_squared = least * least;
  const B inverse = B(R(1)) / (least_squared * least_squared);
  const R root_three = sqrt(R(3));
  largest = seen_from_p * seen_from_q * inverse;
  const B blur = B(R(coordinate_roundings) * unit_roundoff<R>() * extent);
  lean = B(extent) * ((B(root_three) * (seen_from_p + blur) + seen_from_q) * inverse);
  solid_angle = B(view.area) * face_on / (squared * distance);
}

template void far_sums<double>(const CollocationPointBlock<double>&, const Samples<double>&,
                               std::vector<Pack>&, FarSums<double>&);
template struct FarView<double>;
template struct FarBounds<double>;
template void far_sums<Mpfr<50>>(const CollocationPointBlock<Mpfr<50>>&, const Samples<Mpfr<50>>&,
                                 std::vector<Mpfr<50>>&, FarSums<Mpfr<50>>&);
template struct FarView<Mpfr<50>>;
template struct FarBounds<Mpfr<50>>;

}  // namespace radcert
