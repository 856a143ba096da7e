// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/stl.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "arrays.h"
#include "exact.h"
#include "json.h"
#include "mesh.h"
#include "python.h"
#include "radcert/core/errors.h"
#include "radcert/formats/problem/problem_parts.h"
#include "radcert/formats/result/surface_json.h"
#include "radcert/geometry/mesh_file/mesh_arrays.h"
#include "radcert/hypotheses/piece_measures.h"
#include "requests/factor_request.h"
#include "work.h"

namespace radcert::python {

namespace {

std::vector<std::string> repair_of(const std::vector<std::string>& words) {
  const std::vector<std::string> known(repair_words.begin(), repair_words.end());
  for (const std::string& word : words)
    if (std::find(known.begin(), known.end(), word) == known.end())
      throw InputError({.source = "repair", .value = word, .allowed = listed(known)});
  return words;
}

Rational angle_of(const py::handle& angle) {
  const std::string allowed = "an angle in degrees, from 0 to 180";
  Rational degrees = rational_of(angle, "angle", allowed);
  if (degrees.sign() < 0 || degrees > Rational(180))
    throw InputError({.source = "angle",
                      .value = degrees.to_text(),
                      .problem = "is outside the range",
                      .allowed = allowed});
  return degrees;
}

MeshFile file_of_arrays(const std::string& name, const py::handle& points, const py::handle& triangles,
                        const std::vector<std::string>& groups) {
  const DoubleArray coordinates = with_source(name, [&] { return double_rows(points, 3, "points"); });
  const IndexArray corners = with_source(name, [&] { return index_rows(triangles, 3, "triangles"); });
  const auto count = static_cast<std::size_t>(corners.shape(0));
  if (!groups.empty() && groups.size() != count)
    throw InputError({.source = name,
                      .pointer = "groups",
                      .value = std::to_string(groups.size()) + " names",
                      .problem = "are not one a triangle",
                      .allowed = std::to_string(count) + " names, or none"});
  return mesh_of_arrays({.coordinates = {coordinates.data(), static_cast<std::size_t>(coordinates.size())},
                         .triangles = {corners.data(), static_cast<std::size_t>(corners.size())},
                         .groups = groups},
                        name);
}

/// How a mesh is to be read. Each part is assigned by itself: where an initializer throws after one in braces
/// without its type, GCC 12 destroys the members of that one twice.
Mesh unread_mesh(const std::string& name, const std::string& front, const std::vector<std::string>& repair,
                 const std::vector<std::string>& two_sided, const py::object& angle,
                 const std::string& unit) {
  Mesh mesh;
  mesh.name = name;
  mesh.choice.repair = repair_of(repair);
  mesh.choice.front = app::front_named(front);
  mesh.choice.two_sided = two_sided;
  mesh.angle = angle_of(angle);
  mesh.unit = app::unit_of_lengths(unit, "unit");
  return mesh;
}

Mesh mesh_of_file(const std::string& name, const std::string& front, const std::vector<std::string>& repair,
                  const std::vector<std::string>& two_sided, const py::object& angle,
                  const std::string& unit) {
  Mesh mesh = unread_mesh(name, front, repair, two_sided, angle, unit);
  mesh.file = compute(py::none(), [&](Progress&) { return read_mesh_file(name); });
  return mesh;
}

/// A piece or a group with its measures, as Python shows it.
py::list measured(const Mesh& mesh, const std::string& by) {
  if (by != "piece" && by != "group")
    throw InputError({.source = "by", .value = by, .allowed = "piece, group"});
  const auto [units, measures] = compute(py::none(), [&](Progress&) {
    const MeshSurvey survey = mesh.survey();
    if (!survey.components)
      throw InputError({.source = mesh.name,
                        .problem = "has triangles without an area",
                        .allowed = "triangles with an area, or repair \"faces\""});
    const FactorMesh turned = factor_mesh(survey);
    FactorUnits found = factor_units(turned, by == "piece" ? FactorUnit::piece : FactorUnit::group);
    auto sizes = piece_measures(turned.mesh, found.of_triangle, found.names.size());
    return std::pair(std::move(found), std::move(sizes));
  });
  const auto array = [](const Vector<double>& p) { return owning_array(std::vector<double>{p.x, p.y, p.z}); };
  py::list out;
  for (std::size_t i = 0; i < measures.size(); ++i) {
    const PieceMeasures& piece = measures[i];
    out.append(
        py::dict(py::arg("name") = units.names[i], py::arg("triangles") = piece.triangles,
                 py::arg("area") = piece.area.value, py::arg("area_radius") = piece.area.radius,
                 py::arg("normal") = piece.normal ? py::object(array(*piece.normal)) : py::object(py::none()),
                 py::arg("centroid") = array(piece.centroid)));
  }
  return out;
}

py::object survey_of(const Mesh& mesh) {
  const JsonValue report = compute(py::none(), [&](Progress&) {
    const MeshSurvey survey = mesh.survey();
    std::vector<PieceMeasures> measures;
    if (survey.components) {
      const FactorMesh turned = factor_mesh(survey);
      measures = piece_measures(turned.mesh, turned.piece, turned.piece_names.size());
    }
    return surface_report(mesh.name, survey, measures, mesh.unit, "radcert.Mesh.survey");
  });
  return object_of(report);
}

py::array_t<std::int64_t> corner_array(const MeshFile& file) {
  std::vector<std::int64_t> corners(file.corner.begin(), file.corner.end());
  const auto faces = static_cast<py::ssize_t>(file.face_count());
  return owning_array(std::move(corners), {faces, 3});
}

}  // namespace

MeshSurvey Mesh::survey() const {
  return with_source(
      name, [&] { return survey_mesh(file, angle.to_double(), repair_named(choice.repair), choice.front); });
}

SurfaceChoice Mesh::surface() const {
  if (!choice.two_sided.empty())
    throw InputError({.source = "two_sided",
                      .value = choice.two_sided.front(),
                      .problem = "is for factors, and a problem has a surface with one side",
                      .allowed = "a mesh without plates"});
  const MeshSurvey found = survey();
  if (const auto fault = mesh_surface_fault(name, found, "front \"right-hand\" or \"left-hand\""))
    throw InputError(*fault);
  return mesh_surface_choice(name, found, angle, choice.repair, choice.front);
}

void add_meshes(py::module_& module) {
  module.def("mesh_file_endings", mesh_file_endings);
  module.def("is_mesh_file_name", is_mesh_file_name);
  py::class_<Mesh>(module, "Mesh")
      .def_static("read", mesh_of_file, py::arg("file"), py::kw_only(), py::arg("front"), py::arg("repair"),
                  py::arg("two_sided"), py::arg("angle"), py::arg("unit"))
      .def_static(
          "of_arrays",
          [](const std::string& name, const py::object& points, const py::object& triangles,
             const std::vector<std::string>& groups, const std::string& front,
             const std::vector<std::string>& repair, const std::vector<std::string>& two_sided,
             const py::object& angle, const std::string& unit) {
            Mesh mesh = unread_mesh(name, front, repair, two_sided, angle, unit);
            mesh.file = file_of_arrays(name, points, triangles, groups);
            return mesh;
          },
          py::arg("name"), py::arg("points"), py::arg("triangles"), py::arg("groups"), py::kw_only(),
          py::arg("front"), py::arg("repair"), py::arg("two_sided"), py::arg("angle"), py::arg("unit"))
      .def_readonly("name", &Mesh::name)
      .def_property_readonly("format", [](const Mesh& mesh) { return mesh.file.format; })
      .def_property_readonly("digest", [](const Mesh& mesh) { return mesh.file.digest; })
      .def_readonly("unit", &Mesh::unit)
      .def_property_readonly("face_count", [](const Mesh& mesh) { return mesh.file.face_count(); })
      .def_property_readonly("points",
                             [](const Mesh& mesh) {
                               return point_array(mesh.file.vertices,
                                                  [](const Vector<double>& p) { return p; });
                             })
      .def_property_readonly("faces",
                             [](const Mesh& mesh) {
                               py::list out;
                               for (std::size_t k = 0; k < mesh.file.face_count(); ++k) {
                                 const auto from = mesh.file.corner.begin();
                                 out.append(py::cast(std::vector<std::size_t>(
                                     from + static_cast<std::ptrdiff_t>(mesh.file.face_begin[k]),
                                     from + static_cast<std::ptrdiff_t>(mesh.file.face_begin[k + 1]))));
                               }
                               return out;
                             })
      .def_property_readonly("triangles",
                             [](const Mesh& mesh) -> py::object {
                               for (std::size_t k = 0; k < mesh.file.face_count(); ++k)
                                 if (mesh.file.face_begin[k + 1] - mesh.file.face_begin[k] != 3)
                                   return py::none();
                               return corner_array(mesh.file);
                             })
      .def_property_readonly("groups",
                             [](const Mesh& mesh) {
                               py::list out;
                               for (const std::size_t group : mesh.file.group)
                                 out.append(mesh.file.group_names[group]);
                               return out;
                             })
      .def("measured", measured, py::arg("by"))
      .def("survey", survey_of);
}

}  // namespace radcert::python
