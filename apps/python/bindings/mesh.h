// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "radcert/factors/input/factor_scene.h"
#include "radcert/geometry/mesh_file/mesh_file.h"
#include "radcert/hypotheses/mesh_survey.h"
#include "radcert/scalar/rational.h"
#include "radcert/study/problem.h"

namespace radcert::python {

/// A mesh of Python's: as its file or its arrays have it, and how it is to be read.
struct Mesh {
  std::string name;
  MeshFile file;
  FactorSceneChoice choice;
  Rational angle;
  std::optional<std::string> unit = std::nullopt;  ///< of lengths, where it is known

  /// All that is decided about it, without the backs of plates.
  [[nodiscard]] MeshSurvey survey() const;
  /// As the surface of a problem; InputError where it is none.
  [[nodiscard]] SurfaceChoice surface() const;
};

}  // namespace radcert::python
