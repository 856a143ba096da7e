// SPDX-License-Identifier: GPL-3.0-or-later
#include "records/continuous_records.h"

#include <algorithm>
#include <cmath>

#include "radcert/core/errors.h"
#include "radcert/formats/result/certificate_json.h"

namespace radcert::app {

namespace {

/// Of the claims of a certificate, how many are proved again whenever a value is given.
constexpr std::size_t elements_looked_at = 2;

/// The largest number of digits for which the radius, printed, is at most 10^-digits.
int digits_of(const Ball& value) {
  const double radius = 2 * value.radius();
  return std::clamp(static_cast<int>(std::floor(-std::log10(radius))), 1, 17);
}

std::string integral_of(const reference::ContinuousMean& mean) {
  if (mean.point) return "u at a point of the surface";
  if (mean.at_centre) return "u at the mean of the corners of a face";
  return mean.piece.empty() ? "(1/|S|) Int_S u" : "(1/|F|) Int_F u";
}

ReferenceRecord record_of(const reference::ContinuousScene& scene, const reference::EnclosedMean& found) {
  ReferenceRecord record;
  record.name = found.mean->name;
  record.digits = digits_of(found.first.value);
  record.formula = integral_of(*found.mean) +
                   ",  u = E + (rho/pi) Int V G u dS: of the solution itself, not of one constant a face";
  record.source =
      (scene.ellipsoid
           ? std::string("a residual that is bounded everywhere: "
                         "lib/radcert/certificate/ellipsoid/ellipsoid_check.h; ")
           : std::string("a theorem of duality with enclosed residuals: lib/radcert/certificate/check.h; ")) +
      scene.words;
  if (scene.ellipsoid) {
    record.parameters.emplace_back("a", scene.ellipsoid->half_axes.x.to_text());
    record.parameters.emplace_back("b", scene.ellipsoid->half_axes.y.to_text());
    record.parameters.emplace_back("c", scene.ellipsoid->half_axes.z.to_text());
  } else {
    record.parameters.emplace_back("rho", scene.reflectivity.to_text());
  }
  record.routes = {{found.first.how, found.first.value, scene.certificates[0]},
                   {found.second.how, found.second.value, scene.certificates[1]}};
  return record;
}

}  // namespace

std::vector<ReferenceRecord> continuous_records(const reference::ContinuousScene& scene) {
  const Outcome<std::vector<reference::EnclosedMean>> means =
      reference::enclose(scene, intact_certificate, elements_looked_at);
  if (!means) throw AccuracyNotReached(scene.name, "a certificate does not hold: " + means.reason());
  std::vector<ReferenceRecord> out;
  for (const reference::EnclosedMean& mean : *means) out.push_back(record_of(scene, mean));
  return out;
}

ReferenceRecord continuous_record(const reference::ContinuousMean& mean) {
  std::vector<ReferenceRecord> all = continuous_records(*reference::find_continuous_scene(mean.scene));
  return *std::find_if(all.begin(), all.end(),
                       [&](const ReferenceRecord& record) { return record.name == mean.name; });
}

std::vector<std::pair<std::filesystem::path, std::string>> certificate_files(
    const reference::ContinuousScene& scene, const std::filesystem::path& folder) {
  std::vector<std::pair<std::filesystem::path, std::string>> out;
  for (const std::string& file : scene.certificates)
    out.emplace_back(folder / file, std::string(reference::certificate_content(file)));
  return out;
}

}  // namespace radcert::app
