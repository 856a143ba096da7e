// SPDX-License-Identifier: GPL-3.0-or-later
#include "requests/factor_request.h"

#include <algorithm>
#include <utility>

#include "radcert/core/errors.h"
#include "radcert/core/files/result_store.h"
#include "radcert/core/memory_plan.h"
#include "radcert/core/text.h"
#include "radcert/core/version.h"
#include "radcert/factors/factor_mesh.h"
#include "radcert/factors/ray_factors.h"
#include "radcert/formats/result/factor_remarks.h"
#include "requests/store.h"

namespace radcert::app {

namespace {

FactorUnit unit_of(const std::string& word) {
  if (word == "triangle") return FactorUnit::triangle;
  if (word == "piece") return FactorUnit::piece;
  if (word == "group") return FactorUnit::group;
  throw InputError({.source = "by", .value = word, .allowed = "triangle, piece, group"});
}

double accuracy_of(const FactorWish& wish) {
  constexpr double usual_of_certified = 1e-9;
  constexpr double least_of_rays = 1e-6;
  constexpr double least = 1e-12;
  constexpr double most = 0.1;
  if (!wish.accuracy)
    return wish.rays ? RayDemand{}.accuracy : (wish.certified ? usual_of_certified : FactorDemand{}.accuracy);
  if (*wish.accuracy >= (wish.rays ? least_of_rays : least) && *wish.accuracy <= most) return *wish.accuracy;
  throw InputError(
      {.source = "accuracy",
       .value = shortest(*wish.accuracy),
       .allowed = wish.rays ? "with rays a number from 1e-6 to 0.1" : "a number from 1e-12 to 0.1"});
}

FactorMatrix computed(const Factors& of, const FactorDemand& demand, bool by_rays, ResultStore& store,
                      Progress& progress) {
  const FacetScene& scene = of.scene->scene;
  const RayDemand rays{.accuracy = demand.accuracy, .open_to_space = demand.open_to_space};
  FactorPlan plan =
      by_rays ? ray_plan(scene, of.units, rays) : factor_plan(scene, of.units, demand, FactorsKept::all);
  plan.memory.require(available_memory());
  const FactorProgress report{.at = [&](double fraction) { progress.say(fraction, "factors"); },
                              .key = "factors\n" + std::string(source_digest()) + "\n" + of.scene->identity,
                              .store = &store};
  return by_rays ? ray_factors(scene, of.units, rays, report)
                 : factor_matrix(scene, of.units, demand, report);
}

}  // namespace

void check(const FactorWish& wish, bool two_sided) {
  if (two_sided && wish.certified)
    throw InputError(
        {.source = "two_sided", .problem = "is not served with certified", .allowed = "estimated radii"});
  if (wish.rays && wish.certified)
    throw InputError({.source = "rays", .problem = "proves nothing", .allowed = "without certified"});
  static_cast<void>(unit_of(wish.by));
  static_cast<void>(accuracy_of(wish));
}

Factors factors_of(FactorScene scene, const std::string& command, const std::string& name,
                   const FactorWish& wish, const std::string& store, Progress& progress) {
  const double accuracy = accuracy_of(wish);
  if (wish.certified) require_exact_corners(name, scene, OptionStyle::argument);
  Factors out{.scene = std::make_shared<const FactorScene>(std::move(scene)),
              .units = {},
              .report = {.command = command,
                         .name = name,
                         .by = wish.by,
                         .names = {},
                         .matrix = {},
                         .warnings = {},
                         .comparison = std::nullopt},
              .failures = {}};
  out.units = factor_units(out.scene->mesh, unit_of(wish.by));
  out.report.triangles = out.scene->scene.facet_count();
  out.report.open = out.scene->open;
  if (!out.scene->front.empty()) out.report.front = out.scene->front;
  out.report.facets_only = out.scene->mesh.pieces_bend;
  out.report.names = out.units.names;
  out.report.unit = wish.unit;
  ResultStore kept = store_named(store);
  const FactorDemand demand{
      .certified = wish.certified, .accuracy = accuracy, .open_to_space = out.scene->open};
  out.report.matrix = computed(out, demand, wish.rays, kept, progress);
  warn_where_nothing_is_kept(kept, store, progress);
  out.report.warnings = factor_warnings(out.report, OptionStyle::argument);
  for (const std::string& done : out.scene->mended) out.report.warnings.push_back("mended: " + done);
  out.report.warnings.insert(out.report.warnings.end(), out.scene->remarks.begin(), out.scene->remarks.end());
  out.failures = factor_failures(out.report, wish.accuracy ? std::optional(accuracy) : std::nullopt,
                                 OptionStyle::argument);
  return out;
}

FrontRule front_named(std::string_view word) {
  const auto at = std::find(front_words.begin(), front_words.end(), word);
  if (at == front_words.end())
    throw InputError({.source = "front",
                      .value = std::string(word),
                      .allowed = listed(std::vector<std::string>(front_words.begin(), front_words.end()))});
  return static_cast<FrontRule>(at - front_words.begin());
}

std::optional<std::string> unit_of_lengths(const std::string& word, const std::string& source) {
  if (word.empty()) return std::nullopt;
  const std::vector<std::string> known{"mm", "cm", "m", "in"};
  if (std::find(known.begin(), known.end(), word) == known.end())
    throw InputError({.source = source, .value = word, .allowed = listed(known)});
  return word;
}

}  // namespace radcert::app
