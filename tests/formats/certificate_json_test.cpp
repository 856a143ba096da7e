// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/result/certificate_json.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>

#include "radcert/core/errors.h"

namespace radcert {
namespace {

/// A tetrahedron with odd numbers; nothing here is true.
certificate::PolyhedronCertificate sample() {
  certificate::PolyhedronCertificate c;
  c.pieces = {"one", "other"};
  const std::vector<Vector<Rational>> p{
      {0, 0, 0}, {Rational(1, 3), 0, 0}, {0, 1, 0}, {0, 0, Rational(-7, 2)}};
  for (std::size_t k = 0; k < 4; ++k)
    c.faces.push_back({.piece = k % 2,
                       .corners = {p[k], p[(k + 1) % 4], p[(k + 2) % 4]},
                       .reflectivity = Rational(1, 7),
                       .emission = {{Rational(2, 3), Rational(0)}, {Rational(-5)}}});
  c.elements = {{.face = 1, .side = 2, .s0 = 0, .s1 = 0.5, .t0 = 0.25, .t1 = 1}, {.face = 3, .side = 0}};
  c.degree = 1;
  for (int k = 0; k < 24; ++k) c.coefficients.push_back(0.1 * k - 1e-30);
  c.claims.assign(2, {.norms = {1e-3, 0, 0.1}, .products = {-1e-9, 3}, .radii = {1e-300, 2}});
  c.sums = {.norms = {1, 2, 3}, .products = {0.1, -0.2}, .radii = {2e-7, 7}};
  c.enclosures = {{Rational::exactly(0.1), Rational::exactly(1e-5)}, {Rational(2), Rational(1)}};
  c.width = Rational(3);
  return c;
}

TEST(CertificateJson, IsReadAsItWasWritten) {
  const certificate::PolyhedronCertificate c = sample();
  const std::string text = certificate_text(c, "radcert test");
  const ReadCertificate read = read_certificate(text, "c.json");
  EXPECT_TRUE(read.digest_holds);
  EXPECT_EQ(certificate_text(read.certificate, "radcert test"), text);
  const auto& back = std::get<certificate::PolyhedronCertificate>(read.certificate);
  EXPECT_EQ(back.coefficients, c.coefficients);
  EXPECT_EQ(back.faces[2].corners, c.faces[2].corners);
  EXPECT_EQ(back.faces[0].emission, c.faces[0].emission);
  EXPECT_EQ(back.claims[1].products, c.claims[1].products);
  EXPECT_EQ(back.sums.radii, c.sums.radii);
  EXPECT_EQ(back.elements[0].t0, 0.25);
}

TEST(CertificateJson, IsOfValuesWhereItHasPoints) {
  certificate::PolyhedronCertificate c = sample();
  c.points = {{.face = 2, .at = {Rational(1, 9), 0, Rational(-1, 3)}},
              {.face = 0, .at = {0, Rational(1, 5), 1}}};
  const std::string text = certificate_text(c, "a command");
  EXPECT_NE(text.find("\"of\": \"values\""), std::string::npos) << text;
  const certificate::PolyhedronCertificate read =
      std::get<certificate::PolyhedronCertificate>(intact_certificate(text, "file"));
  ASSERT_EQ(read.points.size(), 2U);
  EXPECT_EQ(read.points[0].face, 2U);
  EXPECT_EQ(read.points[1].at, c.points[1].at);
  EXPECT_EQ(certificate_text(read, "a command"), text);
  // The point of a value is that of the problem.
  std::string other = text;
  const std::size_t place = other.rfind("\"1/5\"");
  ASSERT_NE(place, std::string::npos);
  other.replace(place, 5, "\"2/5\"");
  EXPECT_THROW(static_cast<void>(read_certificate(other, "file")), InputError);
}

TEST(CertificateJson, IsOfAFunctionWhereItHasBoundsByDistance) {
  certificate::PolyhedronCertificate c = sample();
  c.coefficients.resize(8);
  c.claims = {{.largest = 1e-3}, {.largest = 0.1}};
  c.sums = {};
  c.enclosures.clear();
  c.by_distance = {{Rational(1, 3), Rational::exactly(0.125)}, {0, Rational(7)}};
  c.outside = Rational(1, 3);
  const std::string text = certificate_text(c, "a command");
  EXPECT_NE(text.find("\"of\": \"function\""), std::string::npos) << text;
  EXPECT_EQ(text.find("sums"), std::string::npos);
  const ReadCertificate read = read_certificate(text, "file");
  EXPECT_TRUE(read.digest_holds);
  EXPECT_EQ(certificate_text(read.certificate, "a command"), text);
  const auto& back = std::get<certificate::PolyhedronCertificate>(read.certificate);
  EXPECT_EQ(back.by_distance[0].outside, Rational(1, 3));
  EXPECT_EQ(back.by_distance[1].sup, Rational(7));
  EXPECT_EQ(back.claims[1].largest, 0.1);
  EXPECT_EQ(function_bound(read.certificate)->sup, Rational(3, 2));
  for (const auto& [from, to] :
       {std::pair("\"sup\": \"7", "\"sup\": \"-7"), std::pair("\"largest\": 0.1", "\"largest\": -1"),
        std::pair("{\"outside\": \"1/3\", \"sup\"", "{\"outside\": \"-1/3\", \"sup\"")}) {
    std::string changed = text;
    ASSERT_NE(changed.find(from), std::string::npos) << from;
    changed.replace(changed.find(from), std::string(from).size(), to);
    EXPECT_THROW(static_cast<void>(read_certificate(changed, "file")), InputError) << to;
  }
}

TEST(CertificateJson, LeavesOutDigitsThatAreZeroInAllNumbersOfAFunction) {
  certificate::PolyhedronCertificate c = sample();
  for (std::size_t k = 0; k < c.coefficients.size(); ++k) c.coefficients[k] = 0.25 * static_cast<double>(k);
  c.coefficients[3] = -0x1.8p-900;
  const std::string text = certificate_text(c, "radcert test");
  EXPECT_LT(text.size() + 200, certificate_text(sample(), "radcert test").size());
  EXPECT_EQ(
      std::get<certificate::PolyhedronCertificate>(read_certificate(text, "c.json").certificate).coefficients,
      c.coefficients);
  // One odd number, and its function has all digits again; zeros alone have a few.
  c.coefficients[1] = 0.1;
  std::fill(c.coefficients.end() - 8, c.coefficients.end(), 0.0);
  EXPECT_EQ(std::get<certificate::PolyhedronCertificate>(
                read_certificate(certificate_text(c, "radcert test"), "c.json").certificate)
                .coefficients,
            c.coefficients);
}

TEST(CertificateJson, SeesAnyChangedDigit) {
  const std::string text = certificate_text(sample(), "radcert test");
  const std::size_t begin = text.find("\"problem\"");
  int changed = 0;
  for (std::size_t k = begin; k < text.size(); ++k) {
    if (text[k] < '0' || text[k] > '9') continue;
    std::string other = text;
    other[k] = other[k] == '7' ? '3' : '7';
    try {
      EXPECT_FALSE(read_certificate(other, "c.json").digest_holds) << k;
      ++changed;
    } catch (const InputError&) {
      // Then it is no certificate any more.
    }
  }
  EXPECT_GT(changed, 300);
}

TEST(CertificateJson, RefusesWhatIsNoCertificate) {
  const std::string text = certificate_text(sample(), "radcert test");
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string out = text;
    const std::size_t at = out.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return out.replace(at, from.size(), to);
  };
  for (const std::string& wrong :
       {std::string(), std::string("{}"), text.substr(0, text.size() / 3),
        changed("certificate/1", "certificate/2"), changed("\"of\": \"means\"", "\"of\": \"values\""),
        changed("\"degree\": 1", "\"degree\": 2"), changed("\"degree\": 1", "\"degree\": 13"),
        changed("\"coefficients\": [\"", "\"coefficients\": [\"0"),
        changed("\"coefficients\": [\"b", "\"coefficients\": [\"g"),
        changed("\"coefficients\": [\"b", "\"coefficients\": [\"f"), changed("\"1/7\"", "\"1/0\""),
        changed("\"1/7\"", "\"1e300\""), changed("\"1/7\"", "\"nan\""),
        // Not all readers of JSON take a number for the nearest double.
        changed("\"1/7\"", "0.125"), changed("\"2/3\"", "9007199254740995"),
        changed("\"width\": \"3", "\"width\": 3, \"width\": \"3"), changed("[1, 2, 0", "[4, 2, 0"),
        changed("[1, 2, 0", "[1, 3, 0"), changed("[1, 2, 0", "[1, 2, 0.3"),
        changed("\"norms\": [", "\"norms\": [-1,"), changed("\"norms\": [0", "\"norms\": [-0"),
        changed("\"claims\": [", "\"claims\": [{},"),
        changed("\"pieces\": [\"one\"", "\"pieces\": [\"other\""),
        changed("{\"piece\": \"one\", \"midpoint\"", "{\"piece\": \"other\", \"midpoint\""),
        changed("\"means\": [", "\"means\": [1,"), changed("\"digest\"", "\"digestion\"")})
    EXPECT_THROW(static_cast<void>(read_certificate(wrong, "c.json")), InputError) << wrong.substr(0, 200);
}

TEST(CertificateJson, RefusesNamesThatWouldPrintMoreThanANameDoes) {
  for (const std::string& name :
       {std::string("one 7 +- 1e-9\nother"), std::string("\x1b[2J"), std::string("\x7f"),
        std::string("\xc2\x9b"
                    "2J")}) {
    certificate::PolyhedronCertificate c = sample();
    c.pieces[1] = name;
    EXPECT_THROW(static_cast<void>(read_certificate(certificate_text(c, "radcert test"), "c.json")),
                 InputError);
  }
}

TEST(EllipsoidCertificateJson, ReadsBackAsItWas) {
  using certificate::EllipsoidCertificate;
  using certificate::OnEllipsoid;
  for (const OnEllipsoid of : {OnEllipsoid::mean, OnEllipsoid::values, OnEllipsoid::function}) {
    EllipsoidCertificate c;
    c.piece = "a/b~c";
    c.half_axes = {1, Rational(1, 3), Rational(17, 10)};
    c.reflectivity = {{{0, 0, 0}, Rational(1, 2)}, {{1, 2, 3}, Rational(-1, 7)}};
    c.emission = {{{64, 0, 0}, 5}};
    c.of = of;
    if (of == OnEllipsoid::values) c.points = {{1, 0, 0}, {0, Rational(-1, 3), 0}};
    c.degree = 2;
    c.cosines = {1, 0.1, -0x1p-40, 3, 1e-9, 7};
    c.sines = {0, 0, 0, 0.25, -1e-12, 1};
    c.largest_reflectivity = Rational(2, 3);
    c.residual = 1.5e-9;
    c.bound = Rational(3, 1000000000);
    if (of != OnEllipsoid::function)
      c.enclosures.push_back({Rational::exactly(0.1), Rational::exactly(1e-5)});
    if (of == OnEllipsoid::values) c.enclosures.push_back({2, 1});
    c.width = Rational(2);
    const std::string text = certificate_text(c, "radcert test");
    const ReadCertificate read = read_certificate(text, "c.json");
    EXPECT_TRUE(read.digest_holds);
    EXPECT_EQ(certificate_text(read.certificate, "radcert test"), text);
    const auto& back = std::get<EllipsoidCertificate>(read.certificate);
    EXPECT_EQ(back.piece, c.piece);
    EXPECT_EQ(back.half_axes, c.half_axes);
    EXPECT_EQ(back.emission[0].powers, c.emission[0].powers);
    EXPECT_EQ(back.reflectivity[1].coefficient, c.reflectivity[1].coefficient);
    EXPECT_EQ(back.points, c.points);
    EXPECT_EQ(back.cosines, c.cosines);
    EXPECT_EQ(back.sines, c.sines);
    EXPECT_EQ(back.largest_reflectivity, c.largest_reflectivity);
    EXPECT_EQ(back.residual, c.residual);
    EXPECT_EQ(back.bound, c.bound);
    EXPECT_EQ(back.enclosures.size(), c.enclosures.size());
    EXPECT_EQ(back.width, c.width);
  }
}

}  // namespace
}  // namespace radcert
