// SPDX-License-Identifier: GPL-3.0-or-later

// The figures of [psg10] as pictures of radcert's own: the scene of figures 3, 5, 7 and 8 is lit_room(), for the paper gives none.
#include "paper_pictures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <span>

#include "radcert/core/contract.h"
#include "radcert/core/errors.h"
#include "radcert/core/parallel.h"
#include "radcert/core/text.h"
#include "radcert/expression/parse.h"
#include "radcert/meshless/light_solution.h"
#include "radcert/meshless/radial_element.h"
#include "radcert/meshless/sampling.h"
#include "radcert/picture/curve_panel.h"
#include "radcert/picture/drawing.h"
#include "radcert/picture/lit_room.h"
#include "radcert/picture/rendering.h"
#include "radcert/solve/elimination.h"

namespace radcert::app {

namespace {

constexpr Colour ink{0.02, 0.02, 0.02};
constexpr Colour dark_line = grey(0);
constexpr Colour mark_colour{0.8, 0.05, 0.02};

double as_double(std::size_t n) { return static_cast<double>(n); }
std::size_t pixels(double length) { return static_cast<std::size_t>(std::max(1.0, std::round(length))); }

/// Panels in rows and columns, each with its title above, and a strip to the right of all.
class Sheet {
public:
  Sheet(const PictureWish& wish, std::size_t columns, std::size_t rows, bool with_scale)
      : image(wish.width, wish.height),
        text(std::clamp(std::min(as_double(wish.height / rows) / 34, as_double(wish.width / columns) / 42),
                        5.0, 36.0)),
        columns_(columns),
        rows_(rows),
        strip_(with_scale ? pixels(7 * text) : 0) {}

  /// Where the panel of a place is shown; its title is written.
  ImageRegion panel(std::size_t column, std::size_t row, std::string_view title) {
    const std::size_t gap = pixels(text);
    const std::size_t above = pixels(2.4 * text);
    const std::size_t width = part(image.width() - strip_, (columns_ + 1) * gap, columns_);
    const std::size_t height = part(image.height(), gap + rows_ * above, rows_);
    const ImageRegion region{.x = std::min(gap + column * (width + gap), image.width() - width),
                             .y = std::min(row * (height + above) + above, image.height() - height),
                             .width = width,
                             .height = height};
    if (text_width(text, title) <= as_double(width))
      draw_text(image, {as_double(region.x), as_double(region.y) - 0.7 * text}, text, title, ink);
    return region;
  }

  /// The colours of a scale, in the strip, as high as the panels.
  void scale(const ImageRegion& beside, const ColourScale& scale) {
    const std::size_t x = image.width() - strip_;
    draw_scale(image, {.x = x, .y = beside.y, .width = image.width() - x, .height = beside.height}, scale,
               text);
  }

  Image image;
  double text;  ///< height of capital letters

private:
  static std::size_t part(std::size_t whole, std::size_t taken, std::size_t count) {
    return whole > taken + count ? (whole - taken) / count : 1;
  }
  std::size_t columns_;
  std::size_t rows_;
  std::size_t strip_;
};

/// The pose with an angle so wide that a panel which is narrower than the scene wants it still shows all from left to right.
CameraPose fitted_to(CameraPose pose, const ImageRegion& panel) {
  constexpr double wanted = 4.0 / 3;  // width over height
  const double least = wanted * as_double(panel.height) / as_double(panel.width);
  pose.vertical_angle = 2 * std::atan(std::max(1.0, least) * std::tan(pose.vertical_angle / 2));
  return pose;
}

RayCaster caster_of(const LitRoom& room) { return RayCaster::make(room.scene.surface()).value(); }

/// The same number for every thread: a function that needs no room of its own.
std::function<PointValue()> shared(PointValue value) {
  return [value = std::move(value)] { return value; };
}

/// As if lit from the eye: the albedo, darker where a surface is seen aslant.
std::function<PointValue()> seen_by_headlight(const LightScene& scene, const Vector<double>& eye) {
  return shared([&scene, eye](const LitPoint& at) -> std::optional<double> {
    const Vector<double> step = eye - at.site.point;
    constexpr double least = 0.25;
    return scene.albedo(at.chart) * (least + (1 - least) * dot(step, at.site.normal) / norm(step));
  });
}

/// An X on the surface about a point, `size` from its middle to its ends.
void mark(Image& image, const ImageRegion& panel, const CameraPose& pose, const Site<double>& site,
          double size) {
  const PinholeCamera camera(fitted_to(pose, panel));
  const bool lies = std::abs(site.normal.z) > std::max(std::abs(site.normal.x), std::abs(site.normal.y));
  const Vector<double> along = cross(site.normal, lies ? Vector<double>{0, 1, 0} : Vector<double>{0, 0, 1});
  const Vector<double> first = (size / norm(along)) * along;
  const Vector<double> second = cross(site.normal, first);
  for (const Vector<double>& end : {first + second, first - second}) {
    const auto a = camera.image_of(site.point - end, panel);
    const auto b = camera.image_of(site.point + end, panel);
    if (!a || !b) continue;
    const std::array<ImagePoint, 2> line{*a, *b};
    const double width = std::max(1.5, as_double(panel.height) / 160);
    draw_line(image, panel, line, 2 * width, grey(1));
    draw_line(image, panel, line, width, mark_colour);
  }
}

/// Sites as dots, those that are not seen small and pale.
void draw_sites(Image& image, const ImageRegion& panel, const CameraPose& pose, const RayCaster& caster,
                const SiteSet& sites, std::size_t& seen) {
  const PinholeCamera camera(fitted_to(pose, panel));
  const double radius = std::max(1.0, as_double(panel.height) / 200);
  std::vector<std::size_t> in_front;
  for (std::size_t i = 0; i < sites.size(); ++i) {
    if (caster.sees(camera.position(), sites[i])) {
      in_front.push_back(i);
      continue;
    }
    if (const auto at = camera.image_of(sites.points[i], panel))
      draw_disc(image, panel, *at, 0.8 * radius, {0.2, 0.4, 0.8}, 0.75);
  }
  for (const std::size_t i : in_front)
    if (const auto at = camera.image_of(sites.points[i], panel))
      draw_disc(image, panel, *at, radius, mark_colour);
  seen = in_front.size();
}

void draw_lamp(Image& image, const ImageRegion& panel, const LitRoom& room, const RayCaster& caster) {
  const PinholeCamera camera(fitted_to(room.camera, panel));
  const auto at = camera.image_of(room.lamp.at, panel);
  const auto hit = caster.first(camera.position(), room.lamp.at);
  if (!at || (hit && hit->distance < 1)) return;
  const double radius = std::max(1.5, as_double(panel.height) / 90);
  draw_disc(image, panel, *at, radius, grey(0.3));
  draw_disc(image, panel, *at, 0.8 * radius, grey(1));
}

/// What the rays found, for the record.
void add_counts(PaperPicture& picture, const std::string& name, const Seen& seen) {
  const double all = as_double(std::max<std::size_t>(seen.values, 1));
  picture.facts.emplace_back(name + ", least value", seen.least);
  picture.facts.emplace_back(name + ", largest value", seen.largest);
  picture.facts.emplace_back(name + ", part above the scale", as_double(seen.above) / all);
  picture.facts.emplace_back(name + ", part below it", as_double(seen.below) / all);
  picture.facts.emplace_back(name + ", part without a value", as_double(seen.without_value) / all);
}

double room_separation(const PictureWish& wish) { return wish.separation.value_or(0.2); }

/// Value, or InputError: sites and bases refuse what the user's separation brought about.
template <class T>
T accepted(Outcome<T> outcome, const PictureWish& wish) {
  if (!outcome)
    throw InputError({.source = "--separation",
                      .value = wish.separation ? std::optional(shortest(*wish.separation)) : std::nullopt,
                      .problem = "gives no picture: " + outcome.reason(),
                      .allowed = "another separation or seed"});
  return std::move(outcome).value();
}

/// Refuses sites whose transfer matrix does not fit, twice: the series is made of a copy.
void require_memory(const LightScene& scene, const PoissonDiskSites& sites, const PictureWish& wish) {
  transfer_memory(accepted(poisson_disk_sites(scene.surface(), sites), wish).size(), 2).require(wish.memory);
}

PaperPicture figure_3(const PictureWish& wish, ProgressDisplay& progress) {
  const LitRoom room = lit_room();
  const RayCaster caster = caster_of(room);
  Sheet sheet(wish, 1, 2, false);
  progress.at(0.1, "the scene");
  const ImageRegion upper = sheet.panel(0, 0, "the scene");
  const Paint plain{.outline = 0.8, .outline_colour = dark_line};
  (void)show(
      sheet.image,
      {.camera = fitted_to(room.camera, upper), .picture = upper, .samples = wish.samples, .smooth = true},
      caster, seen_by_headlight(room.scene, room.camera.position), plain);
  progress.at(0.6, "the sites");
  constexpr std::size_t count = 1000;
  const SiteSet sites = uniform_sites(room.scene.surface(), {.count = count, .seed = wish.seed}).value();
  const ImageRegion lower = sheet.panel(0, 1, "1000 sites anywhere on it; pale: on what is not seen");
  const Paint faint{.scale = {.low = -12, .high = 1}, .outline = 0.5, .outline_colour = dark_line};
  (void)show(
      sheet.image,
      {.camera = fitted_to(room.camera, lower), .picture = lower, .samples = wish.samples, .smooth = true},
      caster, seen_by_headlight(room.scene, room.camera.position), faint);
  std::size_t seen = 0;
  draw_sites(sheet.image, lower, room.camera, caster, sites, seen);
  return {
      .image = std::move(sheet.image),
      .shows = "psg10, figure 3: a scene and sites that are anywhere on it with equal chance by area",
      .facts = {{"scene", "lit_room"}, {"sites", sites.size()}, {"sites seen", seen}, {"seed", wish.seed}}};
}

PaperPicture figure_5(const PictureWish& wish, ProgressDisplay& progress) {
  const LitRoom room = lit_room();
  const RayCaster caster = caster_of(room);
  const Site<double> q{.point = {2.375, 4, 1.25}, .normal = {0, -1, 0}};
  const auto euclidean = [q](const LitPoint& at) -> std::optional<double> {
    return 1 / (1 + norm(at.site.point - q.point));
  };
  const auto normal_sensitive = [q](const LitPoint& at) -> std::optional<double> {
    // Infinite where the normals are not within 90 degrees.
    const double cosine = std::max(0.0, dot(at.site.normal, q.normal));
    return cosine == 0 ? 0 : 1 / (1 + norm(at.site.point - q.point) / cosine);
  };
  const Paint paint{.scale = {.kind = ColourScale::Kind::map, .low = 0, .high = 1},
                    .outline = 0.6,
                    .outline_colour = grey(0.5)};
  Sheet sheet(wish, 2, 1, true);
  PaperPicture picture{.image = Image(1, 1),
                       .shows =
                           "psg10, figure 5: 1/(1 + distance from X), Euclidean and by (15), with points "
                           "in its numerator",
                       .facts = {{"scene", "lit_room"}, {"X", "(2.375, 4, 1.25), on the back wall"}}};
  progress.at(0.1, "Euclidean");
  const ImageRegion left = sheet.panel(0, 0, "1/(1+d), d the Euclidean distance from X");
  add_counts(
      picture, "Euclidean",
      show(sheet.image,
           {.camera = fitted_to(room.camera, left), .picture = left, .samples = wish.samples, .smooth = true},
           caster, shared(euclidean), paint));
  mark(sheet.image, left, room.camera, q, 0.08);
  progress.at(0.55, "normal-sensitive");
  const ImageRegion right = sheet.panel(1, 0, "the same by (15), sensitive to normals");
  add_counts(picture, "normal-sensitive",
             show(sheet.image,
                  {.camera = fitted_to(room.camera, right),
                   .picture = right,
                   .samples = wish.samples,
                   .smooth = true},
                  caster, shared(normal_sensitive), paint));
  mark(sheet.image, right, room.camera, q, 0.08);
  sheet.scale(right, paint.scale);
  picture.image = std::move(sheet.image);
  return picture;
}

/// One of the bases of figure 6.
struct LineBasis {
  std::string_view title;
  std::function<std::vector<double>(double x)> elements;
};

PaperPicture figure_6(const PictureWish& wish, ProgressDisplay& progress) {
  constexpr std::array<double, 4> values{1, 3, 2, 4};
  constexpr double radius = 2;
  constexpr double low_x = -0.5;
  constexpr double high_x = 3.5;
  constexpr double low_y = -1.25;
  constexpr double high_y = 5.25;
  const auto site = [](double x) { return Site<double>{.point = {x, 0, 0}, .normal = {0, 0, 1}}; };
  std::vector<Site<double>> sites;
  for (std::size_t i = 0; i < values.size(); ++i) sites.push_back(site(as_double(i)));
  const std::vector<double> radii(sites.size(), radius);
  const auto shepard = [&](double x) {
    std::vector<double> squares;
    for (const Site<double>& p : sites) squares.push_back((p.point.x - x) * (p.point.x - x));
    return shepard_values<double>(squares);
  };
  const auto gauss = [&](double x) { return basis_values<double>(gaussian_basis(), sites, radii, site(x)); };
  const auto lehtinen = [&](double x) {
    return basis_values<double>(lehtinen_basis(), sites, radii, site(x));
  };
  const std::array<LineBasis, 3> bases{{{"Shepard", shepard}, {"Gauss", gauss}, {"Lehtinen", lehtinen}}};
  constexpr std::array<Colour, 4> light{
      {{0.35, 0.6, 0.95}, {0.95, 0.6, 0.3}, {0.4, 0.75, 0.45}, {0.75, 0.55, 0.9}}};

  Image image(wish.width, wish.height);
  PaperPicture picture{
      .image = Image(1, 1),
      .shows =
          "psg10, figure 6: the elements of three bases at four sites of a line (light), and "
          "what interpolates four values (dark)",
      .facts = {{"sites", "0, 1, 2, 3"}, {"values", "1, 3, 2, 4"}, {"radii", radius}}};
  for (std::size_t k = 0; k < bases.size(); ++k) {
    progress.at(as_double(k) / as_double(bases.size()), std::string(bases[k].title));
    // The system that solve_by_elimination takes is I - K.
    Matrix<double> k_matrix(sites.size(), sites.size());
    for (std::size_t i = 0; i < sites.size(); ++i) {
      const std::vector<double> at_site = bases[k].elements(as_double(i));
      for (std::size_t j = 0; j < sites.size(); ++j) k_matrix(i, j) = (i == j ? 1 : 0) - at_site[j];
    }
    const std::vector<double> coefficients =
        solve_by_elimination<double>(k_matrix, {values.begin(), values.end()});
    CurvePanel panel{.title = std::string(bases[k].title),
                     .x_name = "x",
                     .y_name = "elements light, f dark",
                     .low_x = low_x,
                     .high_x = high_x,
                     .low_y = low_y,
                     .high_y = high_y};
    std::vector<PanelCurve> curves;
    for (const Colour& colour : light) curves.push_back({.points = {}, .colour = colour, .width = 0.8});
    curves.push_back({.points = {}, .colour = ink, .width = 1.1});
    // More than the pixels of any picture.
    constexpr std::size_t steps = 8000;
    for (std::size_t s = 0; s <= steps; ++s) {
      const double x = low_x + (high_x - low_x) * as_double(s) / as_double(steps);
      const std::vector<double> elements = bases[k].elements(x);
      double f = 0;
      for (std::size_t j = 0; j < elements.size(); ++j) {
        curves[j].points.push_back({x, elements[j]});
        f += coefficients[j] * elements[j];
      }
      curves.back().points.push_back({x, f});
    }
    panel.curves = std::move(curves);
    for (std::size_t i = 0; i < values.size(); ++i) panel.marks.push_back({as_double(i), values[i]});
    std::string text;
    for (const double c : coefficients) text += (text.empty() ? "" : ", ") + shortest(c);
    picture.facts.emplace_back("coefficients, " + std::string(bases[k].title), text);
    const std::size_t height = image.height() / bases.size();
    draw_panel(image, {.x = 0, .y = k * height, .width = image.width(), .height = height}, panel);
  }
  picture.image = std::move(image);
  return picture;
}

/// How far the weights of a picture are integrated: errors below what a pixel shows.
constexpr IntegrationDemand for_pictures{.relative_error = 1e-2, .most_points = 400'000};

PaperPicture figure_7(const PictureWish& wish, ProgressDisplay& progress) {
  const LitRoom room = lit_room();
  const RayCaster caster = caster_of(room);
  progress.at(0, "the sites");
  const RadialBasis basis = accepted(
      RadialBasis::make(accepted(poisson_disk_sites(room.scene.surface(),
                                                    {.separation = room_separation(wish), .seed = wish.seed}),
                                 wish),
                        lehtinen_basis()),
      wish);
  const SiteSet& sites = basis.sites();
  // The site of the left wall that is nearest to a point of it.
  const Vector<double> wanted{0, 1.5, 1.25};
  std::size_t column = 0;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < sites.size(); ++i)
    if (const double d = norm(sites.points[i] - wanted); sites.normals[i].x > 0.5 && d < nearest)
      nearest = d, column = i;
  progress.at(0.05, "the weights");
  const std::vector<double> weights = integrate_basis(basis, room.scene.surface(), for_pictures).weights;
  progress.at(0.3, "the transfer matrix");
  transfer_memory(sites.size(), 1).require(wish.memory);
  const Matrix<double> matrix = point_light_transfer(room.scene, sites, weights);
  const auto lit = matrix.column(column);
  const double white = wish.white.value_or(0.008);
  progress.at(0.6, "rays");
  Sheet sheet(wish, 2, 1, false);
  PaperPicture picture{
      .image = Image(1, 1),
      .shows =
          "psg10, figure 7: a scene, and its radiance by light that the element at X sends out, "
          "scattered once: a column of the transfer matrix",
      .facts = {{"scene", "lit_room"},
                {"basis", "Lehtinen"},
                {"separation", room_separation(wish)},
                {"seed", wish.seed},
                {"sites", sites.size()},
                {"column", column},
                {"weight of the element", weights[column]},
                {"white", white}}};
  const ImageRegion left = sheet.panel(0, 0, "the scene");
  (void)show(
      sheet.image,
      {.camera = fitted_to(room.camera, left), .picture = left, .samples = wish.samples, .smooth = true},
      caster, seen_by_headlight(room.scene, room.camera.position),
      {.outline = 0.8, .outline_colour = dark_line});
  mark(sheet.image, left, room.camera, sites[column], 0.08);
  const ImageRegion right = sheet.panel(1, 0, "light of the element at X, scattered once");
  add_counts(picture, "radiance",
             show(sheet.image,
                  {.camera = fitted_to(room.camera, right),
                   .picture = right,
                   .samples = wish.samples,
                   .smooth = true},
                  caster, combination(basis, lit), {.scale = {.high = white}}));
  mark(sheet.image, right, room.camera, sites[column], 0.08);
  picture.image = std::move(sheet.image);
  return picture;
}

/// What figure 8 shows of the light.
struct LightShown {
  std::string_view title;
  RadialBasisChoice basis;
  CoefficientRule coefficients = CoefficientRule::as_values;
  std::string_view remark;  ///< where it is not as the paper has it
  bool direct_alone = false;
};

LightShown direct_light() {
  return {.title = "direct light", .basis = lehtinen_basis(), .remark = "", .direct_alone = true};
}
LightShown by_shepard() { return {.title = "Shepard's basis", .basis = shepard_basis(), .remark = ""}; }
LightShown by_gauss() {
  // G(4 r), up to r = 1: radii of a quarter.
  RadialBasisChoice basis = gaussian_basis();
  basis.mother =
      expression_mother(parse_expression("exp(-8*r^2)", ExpressionVariables::radius).value(), Rational(1));
  basis.radius.too_few = TooFewNeighbours::farthest;
  return {.title = "Gaussian basis, radii/4, interpolated",
          .basis = std::move(basis),
          .coefficients = CoefficientRule::interpolated,
          .remark =
              "radii are a quarter of the paper's and coefficients interpolate: with the paper's the "
              "iteration diverges"};
}
LightShown by_lehtinen() { return {.title = "Lehtinen's basis", .basis = lehtinen_basis(), .remark = ""}; }

/// Draws a panel of figure 8.
void show_light(Sheet& sheet, const ImageRegion& panel, const LightShown& shown, const LitRoom& room,
                const PictureWish& wish, PaperPicture& picture) {
  const RayCaster caster = caster_of(room);
  const double white = wish.white.value_or(1);
  const std::string title(shown.title);
  const PoissonDiskSites sites{.separation = room_separation(wish), .seed = wish.seed};
  std::function<PointValue()> value;
  if (shown.direct_alone && wish.exact_direct) {
    value =
        shared([&](const LitPoint& at) { return std::optional(direct_radiance(room.scene, room.lamp, at)); });
  } else if (shown.direct_alone) {
    const RadialBasis basis = accepted(
        RadialBasis::make(accepted(poisson_disk_sites(room.scene.surface(), sites), wish), shown.basis),
        wish);
    std::vector<double> emission(basis.size());
    parallel_for(basis.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        emission[i] = direct_radiance(room.scene, room.lamp,
                                      {.site = basis.sites()[i], .chart = basis.sites().at[i].chart});
    });
    picture.facts.emplace_back(title + ", sites", basis.size());
    value = combination(basis, emission);
  } else {
    const TransferChoice choice{.meshless = {.basis = shown.basis, .sites = sites},
                                .coefficients = shown.coefficients,
                                .integration = for_pictures};
    require_memory(room.scene, sites, wish);
    const LightTransfer transfer = accepted(LightTransfer::make(room.scene, choice), wish);
    const LightSolution solution = accepted(transfer.solve(room.lamp), wish);
    picture.facts.emplace_back(title + ", sites", transfer.basis().size());
    picture.facts.emplace_back(title + ", spectral radius", transfer.sums().spectral_radius);
    picture.facts.emplace_back(title + ", reflections", solution.reflections);
    if (!shown.remark.empty()) picture.facts.emplace_back(title, std::string(shown.remark));
    if (wish.exact_direct) {
      value = [make = combination(transfer.basis(), solution.indirect), &room] {
        return [indirect = make(), &room](const LitPoint& at) {
          std::optional<double> radiance = indirect(at);
          if (radiance) *radiance += direct_radiance(room.scene, room.lamp, at);
          return radiance;
        };
      };
    } else {
      value = combination(transfer.basis(), solution.total);
    }
  }
  add_counts(picture, title,
             show(sheet.image,
                  {.camera = fitted_to(room.camera, panel),
                   .picture = panel,
                   .samples = wish.samples,
                   .smooth = !wish.exact_direct},
                  caster, value, {.scale = {.high = white}}));
  draw_lamp(sheet.image, panel, room, caster);
}

PaperPicture figure_8_of(const PictureWish& wish, ProgressDisplay& progress,
                         std::span<const LightShown> all) {
  const LitRoom room = lit_room();
  const std::size_t columns = all.size() > 1 ? 2 : 1;
  Sheet sheet(wish, columns, all.size() / columns, false);
  PaperPicture picture{.image = Image(1, 1),
                       .shows = "psg10, figure 8: a room lit by a lamp, ",
                       .facts = {{"scene", "lit_room"},
                                 {"separation", room_separation(wish)},
                                 {"seed", wish.seed},
                                 {"white", wish.white.value_or(1)},
                                 {"direct light", wish.exact_direct ? "exact" : "in the basis"}}};
  for (std::size_t k = 0; k < all.size(); ++k) {
    progress.at(as_double(k) / as_double(all.size()), std::string(all[k].title));
    show_light(sheet, sheet.panel(k % columns, k / columns, all[k].title), all[k], room, wish, picture);
    picture.shows += (k == 0 ? "" : "; ") + std::string(all[k].title);
  }
  picture.image = std::move(sheet.image);
  return picture;
}

PaperPicture figure_8(const PictureWish& wish, ProgressDisplay& progress) {
  const std::array<LightShown, 4> all{direct_light(), by_shepard(), by_gauss(), by_lehtinen()};
  return figure_8_of(wish, progress, all);
}
PaperPicture figure_8_direct(const PictureWish& wish, ProgressDisplay& progress) {
  return figure_8_of(wish, progress, std::array{direct_light()});
}
PaperPicture figure_8_shepard(const PictureWish& wish, ProgressDisplay& progress) {
  return figure_8_of(wish, progress, std::array{by_shepard()});
}
PaperPicture figure_8_gaussian(const PictureWish& wish, ProgressDisplay& progress) {
  return figure_8_of(wish, progress, std::array{by_gauss()});
}
PaperPicture figure_8_lehtinen(const PictureWish& wish, ProgressDisplay& progress) {
  return figure_8_of(wish, progress, std::array{by_lehtinen()});
}

PaperPicture figure_9(const PictureWish& wish, ProgressDisplay& progress) {
  const LightScene scene = sphere_over_disk_light_scene().value();
  const std::array<RoundBlocker, 2> bodies{
      {{.shape = BallBlocker{.centre = {0, 0, 20}, .radius = 5}, .piece = "sphere"},
       {.shape = DiskBlocker{.centre = {0, 0, 0}, .normal = {0, 0, 1}, .radius = 40}, .piece = "disk"}}};
  const RayCaster caster = RayCaster::make(scene.surface(), bodies).value();
  const CameraPose pose{
      .position = {0, -95, 45}, .look_at = {0, 0, 5}, .vertical_angle = std::numbers::pi / 4.5};
  const double separation = wish.separation.value_or(3);
  const ParallelLight light{.towards = {0, 0, 1}, .power = 0.9};
  progress.at(0, "the solution");
  const TransferChoice choice{
      .meshless = {.basis = lehtinen_basis(),
                   .sites = PoissonDiskSites{.separation = separation, .seed = wish.seed}},
      .integration = for_pictures};
  require_memory(scene, {.separation = separation, .seed = wish.seed}, wish);
  const LightTransfer transfer = accepted(LightTransfer::make(scene, choice), wish);
  const LightSolution solution = accepted(transfer.solve(light), wish);
  const double white = wish.white.value_or(1);
  Sheet sheet(wish, 2, 1, false);
  PaperPicture picture{
      .image = Image(1, 1),
      .shows = "psg10, figure 9: the sphere over the disk, and sites with a least distance from each other",
      .facts = {{"scene", "sphere_over_disk"},
                {"separation", separation},
                {"seed", wish.seed},
                {"sites", transfer.basis().size()},
                {"white", white},
                {"light", "direct exact, the rest in Lehtinen's basis"}}};
  progress.at(0.5, "rays");
  const ImageRegion left = sheet.panel(0, 0, "lit from above");
  const auto make = [indirect = combination(transfer.basis(), solution.indirect), &scene, &light] {
    return [of_point = indirect(), &scene, &light](const LitPoint& at) {
      std::optional<double> radiance = of_point(at);
      if (radiance) *radiance += direct_radiance(scene, light, at);
      return radiance;
    };
  };
  const Colour night = grey(0.02);
  add_counts(picture, "radiance",
             show(sheet.image, {.camera = fitted_to(pose, left), .picture = left, .samples = wish.samples},
                  caster, make, {.scale = {.high = white}, .background = night}));
  const ImageRegion right = sheet.panel(1, 0, "its sites; pale: not seen");
  (void)show(sheet.image,
             {.camera = fitted_to(pose, right), .picture = right, .samples = wish.samples, .smooth = true},
             caster, seen_by_headlight(scene, pose.position),
             {.scale = {.low = -12, .high = 1}, .outline = 0.7, .outline_colour = dark_line});
  std::size_t seen = 0;
  draw_sites(sheet.image, right, pose, caster, transfer.basis().sites(), seen);
  picture.facts.emplace_back("sites seen", seen);
  picture.image = std::move(sheet.image);
  return picture;
}

}  // namespace

const std::vector<PictureKind>& picture_kinds() {
  const auto in_the_room = [](std::string_view name, std::string_view summary, auto* make) {
    return PictureKind{.name = name,
                       .summary = summary,
                       .width = 800,
                       .height = 620,
                       .has_separation = true,
                       .has_seed = true,
                       .has_direct = true,
                       .has_white = true,
                       .has_rays = true,
                       .make = make};
  };
  static const std::vector<PictureKind> all = [&] {
    std::vector<PictureKind> kinds{
        {"figure_3", "a scene and 1000 sites on it", 640, 1000, false, true, false, false, true, figure_3},
        {"figure_5", "the two distances of sites, as 1/(1+d)", 1200, 460, false, false, false, false, true,
         figure_5},
        {"figure_6", "the elements of the three bases on a line, and what interpolates four values", 640,
         1080, false, false, false, false, false, figure_6},
        {"figure_7", "a scene, and a column of its transfer matrix", 1200, 480, true, true, false, true, true,
         figure_7},
        in_the_room("figure_8", "a room lit by a lamp: the four pictures that follow, together", figure_8),
        in_the_room("figure_8_direct", "its direct light", figure_8_direct),
        in_the_room("figure_8_shepard", "all its light by Shepard's basis", figure_8_shepard),
        in_the_room("figure_8_gaussian", "the same by the Gaussian basis, changed as below",
                    figure_8_gaussian),
        in_the_room("figure_8_lehtinen", "the same by Lehtinen's basis", figure_8_lehtinen),
        {"figure_9", "the sphere over the disk, and its sites", 1200, 480, true, true, false, true, true,
         figure_9}};
    kinds[4].width = 1200;
    kinds[4].height = 960;
    return kinds;
  }();
  return all;
}

}  // namespace radcert::app
