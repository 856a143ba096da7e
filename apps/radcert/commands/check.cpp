// SPDX-License-Identifier: GPL-3.0-or-later

// radcert check FILE.json: a certificate verified again, by means that share no function with what made it.
#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "command.h"
#include "output.h"
#include "progress.h"
#include "radcert/certificate/certificate.h"
#include "radcert/core/errors.h"
#include "radcert/core/files/atomic_file.h"
#include "radcert/formats/json/json_document.h"
#include "radcert/formats/result/certificate_json.h"
#include "radcert/scalar/enclosing_text.h"
#include "radcert/scalar/rational.h"
#include "tables/enclosure_table.h"

namespace radcert::app {

namespace {

struct CheckOptions {
  std::string file;
  bool all = false;
  std::string part;
  std::string seed;
};

std::string coordinates_text(const Vector<Rational>& p) {
  return p.x.to_text() + "," + p.y.to_text() + "," + p.z.to_text();
}

/// How many of the elements are looked at.
std::size_t part_of(const CheckOptions& options, std::size_t count) {
  if (options.all && !options.part.empty())
    throw InputError({.source = "--part",
                      .value = options.part,
                      .problem = "stands beside --all",
                      .allowed = "one of them"});
  if (options.all) return count;
  Rational part(1, 20);
  constexpr std::size_t least = 8;
  if (options.part.empty())
    return std::min(count, std::max(least, static_cast<std::size_t>((part * Rational(count)).to_double())));
  const Outcome<Rational> given = Rational::parse(options.part);
  if (!given || given->sign() <= 0 || (*given >= Rational(1) && !given->is_integer()))
    throw InputError({.source = "--part",
                      .value = options.part,
                      .allowed = "a number of elements, or a part of them below 1: 100, 0.1, 1/3"});
  if (given->is_integer()) {
    const std::optional<long> number = given->to_long();
    return number ? std::min(count, static_cast<std::size_t>(*number)) : count;
  }
  return std::max<std::size_t>(1, static_cast<std::size_t>((*given * Rational(count)).to_double()));
}

struct Verdict {
  ReadCertificate read;
  std::size_t parts = 0;  ///< that there are
  certificate::Report report;
};

using Rows = std::vector<std::vector<std::string>>;

/// What a certificate is made of.
void add_size(const certificate::PolyhedronCertificate& c, Rows& rows) {
  rows.push_back(
      {"surface", std::to_string(c.faces.size()) + " faces, " + std::to_string(c.pieces.size()) + " pieces"});
  rows.push_back({"functions", std::to_string(c.functions()) + " of degree " + std::to_string(c.degree) +
                                   " on " + std::to_string(c.elements.size()) + " elements"});
}
void add_size(const certificate::EllipsoidCertificate& c, Rows& rows) {
  rows.push_back({"surface", "the ellipsoid with the half axes " + coordinates_text(c.half_axes)});
  rows.push_back({"function", "a polynomial of degree " + std::to_string(c.degree)});
}

/// What is looked at in parts, and what exactly.
struct PartWords {
  std::string of_all;
  std::string part;
};
PartWords part_words(const certificate::Certificate& certificate) {
  if (const auto* const c = std::get_if<certificate::PolyhedronCertificate>(&certificate))
    return {c->of_function() ? "the surface, the bounds that follow, and the claims on "
                             : std::string("the surface, the sums, the ") +
                                   (c->of_values() ? "values" : "means") + " and the claims on ",
            "elements"};
  return {"the reflectivity, what follows from the residual, and the residual at ", "rows of points"};
}

std::string enclosed_text(const certificate::Enclosure& enclosure) {
  const Approximation about{enclosure.midpoint.to_double(), enclosure.radius.to_double(), false};
  const EnclosingText text = enclosing_text(enclosure.midpoint, enclosure.radius, form_of(about));
  return text.value + " +- " + text.radius;
}

std::string summary(const CheckOptions& options, const Verdict& verdict) {
  const certificate::Certificate& c = verdict.read.certificate;
  Rows rows;
  rows.push_back({"certificate", options.file});
  rows.push_back({"digest", verdict.read.digest});
  std::visit([&](const auto& of_its_kind) { add_size(of_its_kind, rows); }, c);
  if (verdict.report.refusal) {
    rows.push_back({"refused", verdict.report.refusal->pointer + ": " + verdict.report.refusal->says});
    return aligned_left(rows);
  }
  const bool all = verdict.report.looked_at.size() == verdict.parts;
  const PartWords words = part_words(c);
  rows.push_back({"verified", words.of_all + (all ? "all" : std::to_string(verdict.report.looked_at.size())) +
                                  " " + words.part});
  if (!all) rows.push_back({"taken over", "the claims on the other " + words.part + "; --all looks at them"});
  bool is_first = true;
  for (const certificate::CertifiedNumber& number : certificate::numbers(c)) {
    const std::string what = number.at ? "values of u" : "means of u";
    rows.push_back({is_first ? what : "", (number.at ? coordinates_text(*number.at) : number.piece) + " " +
                                              enclosed_text(number.enclosure)});
    is_first = false;
  }
  if (const std::optional<certificate::BoundAtDistance> bound = certificate::function_bound(c))
    rows.push_back({"u", "within " + upper_text(bound->sup, DecimalForm::general(6)) + " of the function, " +
                             (bound->outside.sign() == 0
                                  ? "everywhere"
                                  : bound->outside.to_text() + " or more from every corner of a face")});
  return aligned_left(rows);
}

JsonValue report_json(const Verdict& verdict, const std::string& command) {
  JsonValue out = document_head("check", command);
  out.set("digest", verdict.read.digest);
  out.set("verified", !verdict.report.refusal.has_value());
  JsonValue refusal;
  if (verdict.report.refusal)
    refusal = JsonValue::object(
        {{"pointer", verdict.report.refusal->pointer}, {"says", verdict.report.refusal->says}});
  out.set("refusal", std::move(refusal));
  out.set("elements", verdict.parts);
  out.set("looked_at", json_array(verdict.report.looked_at));
  return out;
}

ExitCode check_file(const Common& common, const CheckOptions& options) {
  Outputs outputs(common);
  outputs.input(options.file);
  const auto limit = common.limit_threads();
  const std::string text =
      with_source(options.file, [&] { return read_file(options.file, json_size_limit); });
  Verdict verdict{.read = read_certificate(text, options.file), .report = {}};
  verdict.parts = certificate::part_count(verdict.read.certificate);
  if (verdict.read.digest_holds) {
    const std::size_t elements = part_of(options, verdict.parts);
    ProgressDisplay display(common.quiet);
    display.at(0, "surface and sums");
    verdict.report = certificate::check(
        verdict.read.certificate,
        {.elements = elements, .seed = options.seed.empty() ? verdict.read.digest : options.seed},
        [&](std::size_t done) {
          display.at(static_cast<double>(done) / static_cast<double>(elements),
                     std::to_string(done) + " of " + std::to_string(elements) + " parts");
        });
  } else {
    verdict.report.refusal = certificate::Refusal{"/digest", "is not that of the content"};
  }
  print_result(common, outputs, summary(options, verdict),
               report_json(verdict, common.command).pretty() + "\n");
  return verdict.report.refusal ? ExitCode::differs : ExitCode::done;
}

}  // namespace

void add_check(Program& program) {
  Subcommand command =
      program.add("check", "Verify a certificate that radcert solve --guarantee --certificate wrote");
  auto options = std::make_shared<CheckOptions>();
  command.word("FILE", options->file, "A certificate", "FILE.json");
  command.flag("--all", options->all, "Look at the claims on all elements");
  command.option("--part", options->part,
                 "Look at so many elements, or at this part of them. Default: a twentieth, at least eight",
                 "N or PART");
  command.option("--seed", options->seed,
                 "What the choice of elements follows from. Default: the digest of the content", "TEXT");
  command.footer(
      "Exit code 0: verified; 1: refused, with the first number that does not hold; 2: no certificate.\n"
      "Elements, or on an ellipsoid rows of points, are chosen by SHA-256 of seed and number: the same each\n"
      "time. All claims together prove what is enclosed; a part of them leaves the others to whoever made "
      "the\n"
      "file.");
  command.runs([&common = program.common(), options] { return check_file(common, *options); });
}

}  // namespace radcert::app
