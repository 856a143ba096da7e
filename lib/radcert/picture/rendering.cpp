// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/picture/rendering.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/core/parallel.h"
#include "radcert/picture/colour_map.h"

namespace radcert {
namespace {

constexpr std::size_t most_samples = 16;
/// Of pixels; one more is looked at below them, for the outlines.
constexpr std::size_t rows_together = 8;
constexpr std::size_t no_face = std::numeric_limits<std::size_t>::max();

Seen empty_count() {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return {.least = infinity, .largest = -infinity};
}

Seen both(const Seen& a, const Seen& b) {
  return {.nothing = a.nothing + b.nothing,
          .values = a.values + b.values,
          .without_value = a.without_value + b.without_value,
          .below = a.below + b.below,
          .above = a.above + b.above,
          .least = std::min(a.least, b.least),
          .largest = std::max(a.largest, b.largest)};
}

/// Some rows of a picture.
class Rows {
public:
  Rows(const View& view, const RayCaster& caster, const PointValue& value, const Paint& paint)
      : view_(view), caster_(caster), value_(value), paint_(paint), camera_(view.camera) {}

  Seen show(Image& image, std::size_t begin, std::size_t end) {
    const std::size_t s = view_.samples;
    // A pixel more to the right and below, where faces alone matter.
    const std::size_t columns = (view_.picture.width + 1) * s;
    const std::size_t rows = (end - begin + 1) * s;
    const bool outlined = paint_.outline > 0;
    std::vector<std::size_t> faces(outlined ? rows * columns : 0);
    std::vector<Colour> colours(view_.picture.width * (end - begin));
    const double share = 1 / static_cast<double>(s * s);
    for (std::size_t y = 0; y <= end - begin; ++y)
      for (std::size_t x = 0; x <= view_.picture.width; ++x) {
        const bool shown = x < view_.picture.width && y < end - begin;
        if (!shown && !outlined) continue;
        of_pixel_.clear();
        // The ray nearest to the middle first: where the view is smooth it speaks for others.
        for (std::size_t k = 0; k < s * s; ++k) {
          const std::size_t of_grid = (k + s * s / 2 + s / 2) % (s * s);
          const std::size_t i = x * s + of_grid % s;
          const std::size_t j = y * s + of_grid / s;
          const auto hit = caster_.first(camera_.position(), through(i, begin * s + j));
          if (outlined) faces[j * columns + i] = hit ? hit->face : no_face;
          if (!shown) continue;
          Colour& pixel = colours[y * view_.picture.width + x];
          pixel = pixel + share * colour_of(hit);
        }
      }
    for (std::size_t y = 0; y < end - begin; ++y)
      for (std::size_t x = 0; x < view_.picture.width; ++x) {
        const std::size_t column = view_.picture.x + x;
        const std::size_t row = view_.picture.y + begin + y;
        image.set(column, row, screen_pixel(colours[y * view_.picture.width + x]));
        if (!outlined) continue;
        std::size_t edges = 0;
        for (std::size_t j = y * s; j < (y + 1) * s; ++j)
          for (std::size_t i = x * s; i < (x + 1) * s; ++i) {
            const std::size_t here = faces[j * columns + i];
            if (here != faces[j * columns + i + s] || here != faces[(j + s) * columns + i]) ++edges;
          }
        image.mix(column, row, screen_pixel(paint_.outline_colour),
                  paint_.outline * (share * static_cast<double>(edges)));
      }
    return seen_;
  }

private:
  [[nodiscard]] Vector<double> through(std::size_t i, std::size_t j) const {
    const auto place = [s = static_cast<double>(view_.samples)](std::size_t first, std::size_t k) {
      return static_cast<double>(first) + (static_cast<double>(k) + 0.5) / s;
    };
    return camera_.through({place(view_.picture.x, i), place(view_.picture.y, j)}, view_.picture);
  }

  Colour colour_of(const std::optional<RayHit>& hit) {
    if (!hit) {
      ++seen_.nothing;
      return paint_.background;
    }
    if (!view_.smooth) return colour_at(hit->at);
    for (const FaceColour& known : of_pixel_)
      if (known.face == hit->face) return known.colour;
    of_pixel_.push_back({hit->face, colour_at(hit->at)});
    return of_pixel_.back().colour;
  }

  Colour colour_at(const LitPoint& at) {
    ++seen_.values;
    const std::optional<double> value = value_(at);
    if (!value) {
      ++seen_.without_value;
      return paint_.without_value;
    }
    expects(std::isfinite(*value), "a finite value", named("value", *value));
    seen_.least = std::min(seen_.least, *value);
    seen_.largest = std::max(seen_.largest, *value);
    if (*value < paint_.scale.low) ++seen_.below;
    if (*value > paint_.scale.high) ++seen_.above;
    const Colour colour = paint_.scale.colour(*value);
    return {std::clamp(colour.red, 0.0, 1.0), std::clamp(colour.green, 0.0, 1.0),
            std::clamp(colour.blue, 0.0, 1.0)};
  }

  const View& view_;
  const RayCaster& caster_;
  const PointValue& value_;
  const Paint& paint_;
  PinholeCamera camera_;
  struct FaceColour {
    std::size_t face;
    Colour colour;
  };
  std::vector<FaceColour> of_pixel_;  ///< colours that are known, where the view is smooth
  Seen seen_ = empty_count();
};

}  // namespace

Colour ColourScale::colour(double value) const {
  const double x = (value - low) / (high - low);
  return kind == Kind::light ? grey(x) : map_colour(x);
}

Seen show(Image& image, const View& view, const RayCaster& caster, const std::function<PointValue()>& make,
          const Paint& paint) {
  expects(view.samples >= 1 && view.samples <= most_samples, "1 to 16 samples each way",
          named("samples", view.samples));
  expects(image.contains(view.picture), "a region of the image", named("width", view.picture.width),
          named("height", view.picture.height));
  expects(paint.scale.low < paint.scale.high && std::isfinite(paint.scale.high - paint.scale.low),
          "low < high", named("low", paint.scale.low), named("high", paint.scale.high));
  expects(paint.outline >= 0 && paint.outline <= 1, "an opacity in [0,1]", named("outline", paint.outline));
  Seen seen = parallel_reduce_ordered(
      view.picture.height, rows_together, empty_count(),
      [&](std::size_t begin, std::size_t end) {
        const PointValue value = make();
        return Rows(view, caster, value, paint).show(image, begin, end);
      },
      both);
  if (!(seen.least <= seen.largest)) seen.least = seen.largest = 0;
  return seen;
}

std::function<PointValue()> combination(const RadialBasis& basis, std::span<const double> coefficients) {
  expects(coefficients.size() == basis.size(), "a coefficient for each site",
          named("coefficients", coefficients.size()), named("sites", basis.size()));
  auto numbers = std::make_shared<const std::vector<double>>(coefficients.begin(), coefficients.end());
  return [basis, numbers] {
    auto room = std::make_shared<BasisValues>();
    return [basis, numbers, room](const LitPoint& at) -> std::optional<double> {
      if (!basis.evaluate(at.site, *room)) return std::nullopt;
      double sum = 0;
      for (std::size_t k = 0; k < room->size(); ++k) sum += room->values()[k] * (*numbers)[room->sites()[k]];
      return sum;
    };
  };
}

}  // namespace radcert
