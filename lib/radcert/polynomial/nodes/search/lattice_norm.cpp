// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/polynomial/nodes/search/lattice_norm.h"

#include <Eigen/Dense>

#include <cstddef>
#include <vector>

#include "radcert/polynomial/triangle_modes.h"

namespace radcert {

double norm_at(std::span<const Barycentric<double>> points, int degree,
               std::span<const Barycentric<double>> nodes) {
  std::vector<double> modes(mode_count(degree));
  const auto values_at = [&](std::span<const Barycentric<double>> list) {
    Eigen::MatrixXd values(static_cast<Eigen::Index>(nodes.size()), static_cast<Eigen::Index>(list.size()));
    for (std::size_t k = 0; k < list.size(); ++k) {
      triangle_modes<double>(degree, list[k], modes);
      values.col(static_cast<Eigen::Index>(k)) =
          Eigen::Map<const Eigen::VectorXd>(modes.data(), values.rows());
    }
    return values;
  };
  const Eigen::MatrixXd l = values_at(nodes).partialPivLu().solve(values_at(points));
  return l.cwiseAbs().colwise().sum().maxCoeff();
}

}  // namespace radcert
