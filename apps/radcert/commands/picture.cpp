// SPDX-License-Identifier: GPL-3.0-or-later

// radcert picture NAME: a figure of [psg10] as an SVG or PNG file.
#include <charconv>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "command.h"
#include "output.h"
#include "progress.h"
#include "radcert/core/errors.h"
#include "radcert/core/text.h"
#include "radcert/core/version.h"
#include "radcert/formats/json/json_document.h"
#include "radcert/formats/json/json_reader.h"
#include "radcert/formats/plot/svg_plot.h"
#include "radcert/picture/png.h"
#include "verification/claims/psg10/figures/figure.h"

namespace radcert::app {

namespace {

using verification::psg10::Figure;
using verification::psg10::figure_kinds;
using verification::psg10::FigureKind;
using verification::psg10::FigureWish;

constexpr std::size_t least_side = 64;
constexpr std::size_t most_side = 4096;
constexpr std::size_t most_samples = 8;

struct PictureOptions {
  std::string name;
  std::string out;
  std::string size;
  std::string samples;
  std::string separation;
  std::string seed;
  std::string direct;
  std::string white;
};

std::optional<std::uint64_t> whole(std::string_view text) {
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

const FigureKind& kind_of(const std::string& name) {
  std::vector<std::string> names;
  for (const FigureKind& kind : figure_kinds()) {
    if (kind.name == name) return kind;
    names.emplace_back(kind.name);
  }
  throw InputError({.source = "picture",
                    .value = name,
                    .problem = with_nearest_word("is no picture", name, names),
                    .allowed = listed(names)});
}

/// A positive number as the user wrote it, or nothing where he wrote none.
std::optional<double> positive(const std::string& option, const std::string& text) {
  if (text.empty()) return std::nullopt;
  const std::optional<double> number = parse_double(text);
  if (!number || !(*number > 0))
    throw InputError({.source = option, .value = text, .allowed = "a positive number"});
  return number;
}

bool is_svg(const std::string& file) { return file.ends_with(".svg"); }

FigureWish wish_of(const Common& common, const PictureOptions& options, const FigureKind& kind) {
  FigureWish wish{.width = kind.width,
                  .height = kind.height,
                  .memory = common.memory_limit(),
                  .has_words = is_svg(options.out)};
  if (!options.size.empty()) {
    const std::size_t sign = options.size.find('x');
    const auto width = whole(std::string_view(options.size).substr(0, sign));
    const auto height =
        sign == std::string::npos ? std::nullopt : whole(std::string_view(options.size).substr(sign + 1));
    const auto fits = [](std::optional<std::uint64_t> side) {
      return side && *side >= least_side && *side <= most_side;
    };
    if (!fits(width) || !fits(height))
      throw InputError({.source = "--size",
                        .value = options.size,
                        .allowed = "WIDTHxHEIGHT in pixels, each a whole number from " +
                                   std::to_string(least_side) + " to " + std::to_string(most_side)});
    wish.width = static_cast<std::size_t>(*width);
    wish.height = static_cast<std::size_t>(*height);
  }
  if (!options.samples.empty()) {
    const auto samples = whole(options.samples);
    if (!samples || *samples < 1 || *samples > most_samples)
      throw InputError({.source = "--samples",
                        .value = options.samples,
                        .allowed = "a whole number from 1 to " + std::to_string(most_samples)});
    wish.samples = static_cast<std::size_t>(*samples);
  }
  wish.separation = positive("--separation", options.separation);
  if (!options.seed.empty()) {
    const auto seed = whole(options.seed);
    if (!seed)
      throw InputError(
          {.source = "--seed", .value = options.seed, .allowed = "a whole number from 0 to 2^64 - 1"});
    wish.seed = *seed;
  }
  if (!options.direct.empty() && options.direct != "basis" && options.direct != "exact")
    throw InputError({.source = "--direct", .value = options.direct, .allowed = "basis, exact"});
  wish.exact_direct = options.direct == "exact";
  wish.white = positive("--white", options.white);
  return wish;
}

/// Files are SVG or PNG by their ending, PNG where they have none; plots are no raster.
void require_format(const PictureOptions& options, const FigureKind& kind) {
  if (options.out.empty())
    throw InputError(
        {.source = "picture", .problem = "without --out", .allowed = "--out FILE.svg, --out FILE.png"});
  const std::filesystem::path ending = std::filesystem::path(options.out).extension();
  if (!is_svg(options.out) && !ending.empty() && ending != ".png")
    throw InputError({.source = "--out",
                      .value = options.out,
                      .problem = "has no ending of a picture that is written",
                      .allowed = kind.has_rays ? "FILE.svg, FILE.png" : "FILE.svg"});
  if (!kind.has_rays && !is_svg(options.out))
    throw InputError({.source = "--out",
                      .value = options.out,
                      .problem = std::string(kind.name) + " is plots, not a raster",
                      .allowed = "--out FILE.svg"});
}

/// An option that says nothing of this picture is a mistake.
void require_meaning(const PictureOptions& options, const FigureKind& kind) {
  const auto require = [&](bool has_meaning, const std::string& option, const std::string& text,
                           auto member) {
    if (has_meaning || text.empty()) return;
    std::vector<std::string> names;
    for (const FigureKind& other : figure_kinds())
      if (other.*member) names.emplace_back(other.name);
    throw InputError({.source = option,
                      .value = text,
                      .problem = "means nothing for " + std::string(kind.name),
                      .allowed = "with " + listed(names)});
  };
  require(kind.has_separation, "--separation", options.separation, &FigureKind::has_separation);
  require(kind.has_seed, "--seed", options.seed, &FigureKind::has_seed);
  require(kind.has_direct, "--direct", options.direct, &FigureKind::has_direct);
  require(kind.has_white, "--white", options.white, &FigureKind::has_white);
  require(kind.has_rays, "--samples", options.samples, &FigureKind::has_rays);
  require(kind.has_rays, "--size", options.size, &FigureKind::has_rays);
}

JsonValue picture_json(const Common& common, const PictureOptions& options, const FigureWish& wish,
                       const Figure& picture) {
  JsonValue out = document_head("picture", common.command);
  out.set("picture", options.name);
  out.set("shows", picture.shows);
  out.set("file", options.out);
  if (picture.sheet) {
    out.set("width", wish.width);
    out.set("height", wish.height);
  }
  out.set("facts", json_array(picture.facts, [](const auto& fact) {
            return JsonValue::object({{"name", fact.first}, {"value", fact.second}});
          }));
  return out;
}

std::string picture_text(const PictureOptions& options, const FigureWish& wish, const Figure& picture) {
  std::vector<std::vector<std::string>> rows{{"file", options.out}};
  if (picture.sheet)
    rows.push_back({"size", std::to_string(wish.width) + " x " + std::to_string(wish.height) + " pixels"});
  for (const auto& [name, value] : picture.facts)
    rows.push_back({name, value.string() != nullptr ? *value.string() : value.compact()});
  return picture.shows + "\n" + aligned_left(rows);
}

std::string content(const Figure& picture, const FigureWish& wish) {
  if (!picture.sheet) return svg_text(picture.plots);
  return wish.has_words ? picture.sheet->svg_text(picture.shows)
                        : png_bytes(picture.sheet->image, picture.shows);
}

ExitCode make_picture(const Common& common, const PictureOptions& options) {
  const FigureKind& kind = kind_of(options.name);
  require_meaning(options, kind);
  const FigureWish wish = wish_of(common, options, kind);
  require_format(options, kind);
  Outputs outputs(common);
  outputs.file("--out", options.out);
  const auto limit = common.limit_threads();
  const Figure picture = [&] {
    ProgressDisplay progress(common.quiet);
    Figure made = kind.make(wish, [&](double part, const std::string& begins) { progress.at(part, begins); });
    if (!kind.has_rays) return made;
    made.facts.insert(made.facts.begin(), {"rays a pixel", wish.samples * wish.samples});
    if (!wish.has_words)
      for (const std::string& title : made.sheet->titles())
        made.facts.emplace_back("panel, without its title in a PNG file", title);
    return made;
  }();
  print_result(common, outputs, picture_text(options, wish, picture),
               picture_json(common, options, wish, picture).pretty() + "\n",
               {{options.out, content(picture, wish)}});
  return ExitCode::done;
}

}  // namespace

void add_picture(Program& program) {
  Subcommand command = program.add("picture", "A figure of psg10 as an SVG or PNG file");
  auto options = std::make_shared<PictureOptions>();
  command.word("NAME", options->name, "Which picture; see below");
  command.option("--out", options->out,
                 "Write the picture to this file: .svg with titles and scales, .png the pixels alone",
                 "FILE.svg");
  command.option("--size", options->size,
                 "Width and height in pixels, each from 64 to 4096; default: the picture's own", "WxH");
  command.option("--samples", options->samples, "N x N rays a pixel; from 1 to 8, default: 2", "N");
  command.option("--separation", options->separation,
                 "The least distance of sites; default: 0.2 in the room, 3 for the sphere over the disk",
                 "LENGTH");
  command.option("--seed", options->seed, "Of the sites; default: 1", "NUMBER");
  command.option("--direct", options->direct,
                 "figure_8: basis, direct light in the basis as all other, as the paper has it (the "
                 "default), or exact, with sharp shadows",
                 "HOW");
  command.option("--white", options->white,
                 "The radiance that is shown white; default: 1, for figure_7 0.008", "RADIANCE");
  std::string footer = "Pictures:\n";
  for (const FigureKind& kind : figure_kinds())
    footer += "  " + std::string(kind.name) + std::string(19 - kind.name.size(), ' ') +
              std::string(kind.summary) + "\n";
  footer +=
      "The scene of figures 3, 5, 7 and 8 is a room of radcert's own, as the paper gives none: 4 x 4 x 3, "
      "two "
      "blocks,\na column, a lamp under a shade. Radiance is shown by the curve of sRGB. The iteration "
      "diverges "
      "for the Gaussian\nbasis as the paper has it: figure_8_gaussian takes a quarter of the radii and "
      "coefficients that interpolate. Where\nit diverges even so, which depends on the sites, no picture is "
      "made. Magenta: the basis has no value there.\n"
      "An SVG file is a sheet with titles and scales as text around the raster. A PNG file is the raster "
      "alone, and the titles are "
      "printed.\nfigure_6 is plots, for SVG alone.";
  command.footer(footer);
  command.runs([&common = program.common(), options] { return make_picture(common, *options); });
}

}  // namespace radcert::app
