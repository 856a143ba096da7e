// SPDX-License-Identifier: GPL-3.0-or-later
#include "requests/factor_request.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "c/call.h"
#include "radcert/core/errors.h"
#include "radcert/core/memory_plan.h"
#include "radcert/formats/result/factors_json.h"
#include "radcert/geometry/mesh_file/mesh_arrays.h"

/// Factors with what is read from them.
struct radcert_factors {
  explicit radcert_factors(radcert::app::Factors found)
      : factors(std::move(found)), json(radcert::factors_report(factors.report).pretty() + "\n") {
    const std::size_t n = factors.count();
    const radcert::FactorMatrix& of = factors.report.matrix;
    radcert::MemoryPlan plan;
    plan.add("two square arrays", 2 * std::uint64_t{n} * n, sizeof(double))
        .require(radcert::available_memory());
    value.assign(n * n, 0.0);
    radius.assign(n * n, 0.0);
    for (const radcert::ConfigurationFactor& entry : of.entries) {
      value[entry.from * n + entry.to] = entry.factor.value;
      radius[entry.from * n + entry.to] = entry.factor.radius;
    }
    for (const radcert::FactorRow& row : of.rows) {
      area.push_back(row.area.value);
      area_radius.push_back(row.area.radius);
      row_sum.push_back(row.sum.value);
      row_sum_radius.push_back(row.sum.radius);
      const radcert::Approximation space = row.to_space.value_or(radcert::Approximation::exact(0));
      to_space.push_back(space.value);
      to_space_radius.push_back(space.radius);
    }
    names = radcert::c::pointers(factors.units.names);
    warnings = radcert::c::pointers(factors.report.warnings);
    failures = radcert::c::pointers(factors.failures);
    const bool open = factors.report.open;
    matrix = {.count = n,
              .names = names.data(),
              .value = value.data(),
              .radius = radius.data(),
              .guaranteed = of.guaranteed ? 1 : 0,
              .area = area.data(),
              .area_radius = area_radius.data(),
              .row_sum = row_sum.data(),
              .row_sum_radius = row_sum_radius.data(),
              .to_space = open ? to_space.data() : nullptr,
              .to_space_radius = open ? to_space_radius.data() : nullptr,
              .warning_count = warnings.size(),
              .warnings = warnings.data(),
              .failure_count = failures.size(),
              .failures = failures.data()};
  }
  radcert_factors(const radcert_factors&) = delete;
  radcert_factors& operator=(const radcert_factors&) = delete;

  radcert::app::Factors factors;
  std::string json;
  std::vector<double> value, radius, area, area_radius, row_sum, row_sum_radius, to_space, to_space_radius;
  std::vector<const char*> names, warnings, failures;
  radcert_factor_matrix matrix{};
};

namespace radcert::c {

namespace {

struct NamedMesh {
  std::string name;
  MeshFile file;
  FactorSceneChoice choice;
};

/// Threefold a count that a caller gives.
std::size_t three_times(std::size_t count, const std::string& place) {
  if (count > std::numeric_limits<std::size_t>::max() / (3 * sizeof(double)))
    throw InputError(
        {.pointer = place, .value = std::to_string(count), .problem = "is more than memory could hold"});
  return 3 * count;
}

NamedMesh mesh_of(const radcert_mesh* mesh, const radcert_factor_wish* wish) {
  const radcert_mesh& from = given(mesh, "mesh");
  require_size(from.size, sizeof(radcert_mesh), "mesh");
  NamedMesh out{.name = text_or(from.name, "mesh"),
                .file = {},
                .choice = {.front = app::front_named(text_or(from.front, "auto")),
                           .space = wish != nullptr && wish->space != 0}};
  if (from.point_count > 0) static_cast<void>(given(from.points, "mesh/points"));
  if (from.triangle_count > 0) static_cast<void>(given(from.triangles, "mesh/triangles"));
  const std::size_t coordinates = three_times(from.point_count, "mesh/point_count");
  const std::size_t corners = three_times(from.triangle_count, "mesh/triangle_count");
  std::vector<std::string> groups;
  if (from.groups != nullptr)
    for (std::size_t i = 0; i < from.triangle_count; ++i)
      groups.push_back(text_at(from.groups[i], "mesh/groups/" + std::to_string(i)));
  out.file = mesh_of_arrays({.coordinates = std::span(from.points, coordinates),
                             .triangles = std::span(from.triangles, corners),
                             .groups = groups},
                            out.name);
  return out;
}

app::FactorWish wish_of(const radcert_factor_wish* wish) {
  if (wish == nullptr) return {};
  require_size(wish->size, sizeof(radcert_factor_wish), "wish");
  app::FactorWish out{.by = text_or(wish->by, "group"),
                      .accuracy = std::nullopt,
                      .certified = wish->certified != 0,
                      .rays = wish->rays != 0};
  if (wish->accuracy != 0 || std::isnan(wish->accuracy)) out.accuracy = wish->accuracy;
  return out;
}

}  // namespace

}  // namespace radcert::c

extern "C" {

radcert_status radcert_factors_make(const radcert_mesh* mesh, const radcert_factor_wish* wish,
                                    const radcert_run* run, radcert_factors** factors) {
  using namespace radcert;
  return c::guarded([&] {
    c::given(factors, "factors");
    const c::Run how(run);
    const app::FactorWish wanted = c::wish_of(wish);
    app::check(wanted, false);
    const c::NamedMesh read = c::mesh_of(mesh, wish);
    std::unique_ptr<radcert_factors> made;
    c::compute(how, [&](app::Progress& told) {
      made = std::make_unique<radcert_factors>(
          app::factors_of(factor_scene(read.name, read.file, read.choice, OptionStyle::argument),
                          "radcert_factors_make", read.name, wanted, how.store, told));
    });
    *factors = made.release();
  });
}

radcert_status radcert_factors_read(const radcert_factors* factors, const radcert_factor_matrix** matrix) {
  using namespace radcert;
  return c::guarded([&] { c::given(matrix, "matrix") = &c::given(factors, "factors").matrix; });
}

radcert_status radcert_factors_json(const radcert_factors* factors, const char** text) {
  using namespace radcert;
  return c::guarded([&] { c::given(text, "text") = c::given(factors, "factors").json.c_str(); });
}

void radcert_factors_free(radcert_factors* factors) { delete factors; }
}
