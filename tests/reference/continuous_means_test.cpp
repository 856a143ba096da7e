// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/reference/continuous_means.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <set>
#include <string>

#include "radcert/certificate/check.h"
#include "radcert/certificate/densities.h"
#include "radcert/core/errors.h"
#include "radcert/formats/result/certificate_json.h"
#include "tests/repeats.h"

namespace radcert::reference {
namespace {

using certificate::EllipsoidCertificate;
using certificate::PolyhedronCertificate;

/// A change of a certificate on its way from the file.
CertificateReader changing(std::function<void(PolyhedronCertificate&)> change) {
  return [change = std::move(change)](std::string_view text, const std::string& file) {
    PolyhedronCertificate c = std::get<PolyhedronCertificate>(intact_certificate(text, file));
    change(c);
    return c;
  };
}

bool hides_parts(const ContinuousScene& scene) {
  return scene.name.starts_with("l_room") || scene.name.starts_with("cube_in_a_cube");
}

TEST(ContinuousMeans, AreEnclosedByTwoCertificatesOnDifferentMeshes) {
  std::set<std::string> found;
  for (const ContinuousScene& scene : continuous_scenes()) {
    // Throws where both have no number in common. All that is exact; HaveClaimsThatHold is about the claims.
    const Outcome<std::vector<EnclosedMean>> means = enclose(scene, intact_certificate, 0);
    ASSERT_TRUE(means) << scene.name << ": " << means.reason();
    EXPECT_FALSE(means->empty()) << scene.name;
    for (const EnclosedMean& mean : *means) {
      found.insert(mean.mean->name);
      EXPECT_LT(mean.first.value.radius(), mean.second.value.radius()) << mean.mean->name;
      EXPECT_LT(mean.first.value.radius(), hides_parts(scene) ? 5e-2 : 1e-4) << mean.mean->name;
      EXPECT_NE(mean.first.how, mean.second.how);
    }
    const certificate::Certificate fine =
        intact_certificate(certificate_content(scene.certificates[0]), scene.certificates[0]);
    const certificate::Certificate coarse =
        intact_certificate(certificate_content(scene.certificates[1]), scene.certificates[1]);
    if (scene.ellipsoid) {
      EXPECT_GT(std::get<EllipsoidCertificate>(fine).degree, std::get<EllipsoidCertificate>(coarse).degree);
      continue;
    }
    const auto& first = std::get<PolyhedronCertificate>(fine);
    const auto& second = std::get<PolyhedronCertificate>(coarse);
    EXPECT_NE(first.elements.size(), second.elements.size()) << scene.name;
    // The kernels of points ask for a degree of their own; where parts hide each other there is one alone.
    EXPECT_EQ(first.degree == second.degree, scene.power > 1 || first.of_values() || hides_parts(scene))
        << scene.name;
  }
  EXPECT_EQ(found.size(), continuous_means().size());
  for (const ContinuousMean& mean : continuous_means()) {
    EXPECT_EQ(find_value(mean.name), nullptr) << mean.name;
    EXPECT_EQ(find_family(mean.name), nullptr) << mean.name;
    EXPECT_TRUE(mean.name.starts_with(mean.is_value() ? "continuous_value_" : "continuous_mean_"))
        << mean.name;
  }
}

/// With one reflectivity Int u = Int E/(1 - rho): areas times means are known.
TEST(ContinuousMeans, KeepTheBalanceOfEnergy) {
  for (const ContinuousScene& scene : continuous_scenes())
    for (const std::string& file : scene.certificates) {
      if (scene.ellipsoid) continue;
      const PolyhedronCertificate c =
          std::get<PolyhedronCertificate>(intact_certificate(certificate_content(file), file));
      ASSERT_EQ(scene_fault(scene, c), "") << file;
      // Of values nothing is known, and where there are openings not how much leaves.
      if (!scene.black.empty() || c.of_values()) continue;
      const std::vector<Ball> areas = certificate::piece_areas(c);
      Ball left;
      Ball right;
      for (std::size_t k = 0; k < c.pieces.size(); ++k)
        left += areas[k] * widened(Ball(c.enclosures[k].midpoint), Ball(c.enclosures[k].radius));
      // Of (1 - z)^4 and of 1 on one face, by hand.
      if (scene.power == 4) {
        right = Ball(Rational(1) + Rational(4, 5));
      } else {
        for (const certificate::Face& face : c.faces)
          if (face.emission[0][0].sign() > 0) right += certificate::area_of(face);
      }
      right = right / Ball(Rational(1) - scene.reflectivity);
      EXPECT_TRUE(overlaps(left, right)) << file << ": " << left.to_text() << ", " << right.to_text();
      // Radii are rigorous sums of norms: the balance holds far better.
      EXPECT_LT(std::abs((left - right).to_double()), 0.5 * left.radius()) << file;
    }
}

/// The claims on a few elements of each file, others with RADCERT_ATTACK_SEED; radcert check --all is for
/// all of them.
TEST(ContinuousMeans, HaveClaimsThatHold) {
  const char* const seed = std::getenv("RADCERT_ATTACK_SEED");
  for (const EmbeddedFile& file : embedded_certificates()) {
    const certificate::Certificate c = intact_certificate(file.content, std::string(file.path));
    const certificate::Report report =
        certificate::check(c, {.elements = test::repeats(1), .seed = seed == nullptr ? "a test" : seed});
    EXPECT_FALSE(report.refusal) << file.path << report.refusal->pointer << ": " << report.refusal->says;
  }
}

TEST(ContinuousMeans, AreRefusedWhereTheCertificateIsOfAnotherEquation) {
  const ContinuousScene& scene = *find_continuous_scene("cube_rho_1/2");
  // A certificate of another equation may hold by itself: the scene has to tell them apart.
  const auto is_another = [&](const std::function<void(PolyhedronCertificate&)>& change) {
    PolyhedronCertificate certificate = std::get<PolyhedronCertificate>(
        intact_certificate(certificate_content(scene.certificates[1]), scene.certificates[1]));
    change(certificate);
    return !scene_fault(scene, certificate).empty();
  };
  EXPECT_FALSE(is_another([](PolyhedronCertificate&) {}));
  EXPECT_TRUE(is_another([](PolyhedronCertificate& c) { c.faces[3].reflectivity = Rational(2, 5); }));
  EXPECT_TRUE(is_another([](PolyhedronCertificate& c) {
    for (certificate::Face& face : c.faces) face.emission[0][0] = Rational(1) - face.emission[0][0];
  }));
  EXPECT_TRUE(is_another([](PolyhedronCertificate& c) {
    c.faces[1].emission = {{Rational(0)}, {Rational(1)}};
  }));
  // A face that is black, and one that closes an open surface and is not.
  EXPECT_TRUE(is_another([](PolyhedronCertificate& c) { c.faces[2].reflectivity = Rational(0); }));
  const ContinuousScene& open = *find_continuous_scene("two_squares_rho_1/2");
  PolyhedronCertificate of_open = std::get<PolyhedronCertificate>(
      intact_certificate(certificate_content(open.certificates[1]), open.certificates[1]));
  EXPECT_EQ(scene_fault(open, of_open), "");
  of_open.faces.back().reflectivity = Rational(1, 2);
  EXPECT_NE(scene_fault(open, of_open), "");
  EXPECT_TRUE(is_another([](PolyhedronCertificate& c) {
    for (certificate::Face& face : c.faces)
      for (Vector<Rational>& corner : face.corners) corner.x *= Rational(2);
  }));
  EXPECT_TRUE(is_another([](PolyhedronCertificate& c) {
    for (certificate::Face& face : c.faces)
      for (Vector<Rational>& corner : face.corners) corner.z = Rational(1) - corner.z;
  }));
  // Faces in the polygons of the scene that leave some of one out.
  const ContinuousScene& room = *find_continuous_scene("l_room_rho_1/2");
  PolyhedronCertificate of_room = std::get<PolyhedronCertificate>(
      intact_certificate(certificate_content(room.certificates[1]), room.certificates[1]));
  EXPECT_EQ(scene_fault(room, of_room), "");
  for (certificate::Face& face : of_room.faces) {
    const Vector<Rational> corner = face.corners[1];
    face.corners[1] = face.corners[0] + Rational(1, 2) * (corner - face.corners[0]);
    EXPECT_THAT(scene_fault(room, of_room), testing::StartsWith("has not all of "));
    face.corners[1] = corner;
  }
  of_room.faces.pop_back();
  EXPECT_THAT(scene_fault(room, of_room), testing::StartsWith("has not all of "));
  const auto is_refused = [&](const std::function<void(PolyhedronCertificate&)>& change) {
    return !enclose(scene, changing(change), 0);
  };
  EXPECT_FALSE(is_refused([](PolyhedronCertificate&) {}));
  EXPECT_TRUE(is_refused([](PolyhedronCertificate& c) { c.faces[3].reflectivity = Rational(2, 5); }));
  EXPECT_TRUE(is_refused([](PolyhedronCertificate& c) {
    for (certificate::Face& face : c.faces) face.emission[0][0] = Rational(1) - face.emission[0][0];
  }));
  EXPECT_TRUE(is_refused([](PolyhedronCertificate& c) {
    for (certificate::Face& face : c.faces)
      for (Vector<Rational>& corner : face.corners) corner.x *= Rational(2);
  }));
  // The emission on another face: the cube turned over.
  EXPECT_TRUE(is_refused([](PolyhedronCertificate& c) {
    for (certificate::Face& face : c.faces) {
      for (Vector<Rational>& corner : face.corners) corner.z = Rational(1) - corner.z;
      std::reverse(face.corners.begin(), face.corners.end());
    }
  }));
  EXPECT_TRUE(is_refused([](PolyhedronCertificate& c) {
    c.faces[1].emission = {{Rational(0), Rational(0)}, {Rational(1, 1000)}};
  }));
  EXPECT_TRUE(is_refused([](PolyhedronCertificate& c) { c.faces[1].piece = c.faces[0].piece; }));
  EXPECT_TRUE(is_refused([](PolyhedronCertificate& c) { c.enclosures[2].midpoint += Rational(1, 1000000); }));
  EXPECT_TRUE(is_refused([](PolyhedronCertificate& c) { c.claims[100].radii[1] *= 2; }));
  EXPECT_TRUE(is_refused([](PolyhedronCertificate& c) { c.sums.norms[3] *= 0.99; }));
  EXPECT_TRUE(is_refused([](PolyhedronCertificate& c) { c.elements.pop_back(), c.claims.pop_back(); }));
}

TEST(ContinuousMeans, OfEllipsoidsAreRefusedWhereTheCertificateIsOfAnotherEquation) {
  const ContinuousScene& scene = *find_continuous_scene("ellipsoid_linear_rho");
  const EllipsoidCertificate good = std::get<EllipsoidCertificate>(
      intact_certificate(certificate_content(scene.certificates[1]), scene.certificates[1]));
  EXPECT_EQ(scene_fault(scene, good), "");
  const auto is_another = [&](const std::function<void(EllipsoidCertificate&)>& change) {
    EllipsoidCertificate c = good;
    change(c);
    return !scene_fault(scene, c).empty();
  };
  EXPECT_TRUE(is_another([](EllipsoidCertificate& c) { c.half_axes.x = 2; }));
  EXPECT_TRUE(is_another([](EllipsoidCertificate& c) { c.reflectivity[1].coefficient = Rational(1, 5); }));
  EXPECT_TRUE(is_another([](EllipsoidCertificate& c) { c.reflectivity.pop_back(); }));
  EXPECT_TRUE(is_another([](EllipsoidCertificate& c) { c.emission.push_back({{1, 1, 0}, 1}); }));
  // Written otherwise, it is the same.
  EXPECT_FALSE(is_another([](EllipsoidCertificate& c) {
    c.emission.push_back({{1, 1, 0}, 0});
    c.emission[0].coefficient = Rational(1, 3);
    c.emission.push_back({{0, 0, 2}, Rational(2, 3)});
  }));
  const PolyhedronCertificate of_cube = std::get<PolyhedronCertificate>(
      intact_certificate(certificate_content("cube_rho_1_over_2_coarse.json"), "cube"));
  EXPECT_NE(scene_fault(scene, of_cube), "");
  EXPECT_NE(scene_fault(*find_continuous_scene("cube_rho_1/2"), good), "");
  // Of values and means, each names its own.
  EXPECT_FALSE(enclose(
      scene,
      [](std::string_view, const std::string&) {
        return certificate::Certificate(std::get<EllipsoidCertificate>(
            intact_certificate(certificate_content("ellipsoid_values_coarse.json"), "values")));
      },
      0));
}

TEST(ContinuousMeans, AreNotGivenWhereTheFileWasChanged) {
  const std::string file = continuous_scenes()[0].certificates[1];
  std::string text(certificate_content(file));
  const std::size_t at = text.find("\"claims\"");
  ASSERT_NE(at, std::string::npos);
  const std::size_t digit = text.find_first_of("123456789", at);
  text[digit] = text[digit] == '1' ? '2' : '1';
  EXPECT_THROW(static_cast<void>(intact_certificate(text, file)), InputError);
}

/// One constant a face is another model: its value is no approximation of the mean to these digits.
TEST(ContinuousMeans, AreNotTheLumpedValues) {
  const std::vector<EnclosedMean> means =
      enclose(*find_continuous_scene("cube_rho_1/2"), intact_certificate, 0).value();
  for (const auto& [mean, lumped] :
       {std::pair("continuous_mean_cube_floor_rho_1/2", "cube_floor_radiosity"),
        std::pair("continuous_mean_cube_ceiling_rho_1/2", "cube_ceiling_radiosity"),
        std::pair("continuous_mean_cube_wall_rho_1/2", "cube_wall_radiosity")}) {
    const auto found =
        std::find_if(means.begin(), means.end(), [&](const EnclosedMean& x) { return x.mean->name == mean; });
    ASSERT_NE(found, means.end()) << mean;
    const NamedValue& other = *find_value(lumped);
    const Ball value = enclose(*find_family(other.family), other.arguments, 10).value().first.value;
    EXPECT_FALSE(overlaps(found->first.value, value)) << mean;
    EXPECT_FALSE(overlaps(found->second.value, value)) << mean;
  }
}

}  // namespace
}  // namespace radcert::reference
