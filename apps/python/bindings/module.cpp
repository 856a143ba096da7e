// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "python.h"
#include "radcert/core/version.h"

PYBIND11_MODULE(_core, module) {
  using namespace radcert::python;
  module.doc() = "radcert's library; what users write is in the package radcert.";
  module.attr("version") = std::string(radcert::version());
  add_errors(module);
  add_work(module);
  add_exact(module);
  add_references(module);
  add_expressions(module);
  add_meshes(module);
  add_factors(module);
  add_bases(module);
  add_problems(module);
  add_own_surfaces(module);
  add_solutions(module);
  add_pictures(module);
  add_experiments(module);
  add_guarantees(module);
  add_edges(module);
  add_verification(module);
  seal_classes();
}
