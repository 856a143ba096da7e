// SPDX-License-Identifier: GPL-3.0-or-later

// radcert edge: the exponents of the solution at an edge, and what they ask of a mesh.
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "command.h"
#include "output.h"
#include "progress.h"
#include "radcert/formats/result/reference_json.h"
#include "radcert/scalar/enclosing_text.h"
#include "records/edge_records.h"

namespace radcert::app {

namespace {

std::string rounded(double x) { return nearest_text(x, DecimalForm::fixed(4)); }

std::string text_of(const EdgeRecord& answer) {
  const EdgeRequest& request = answer.request;
  std::string out = "edge of " + request.angle.to_text() + " degrees, reflectivities " +
                    request.rho.to_text() + " and " + request.rho_other.to_text() + "\n";
  if (!request.has_singular_part()) {
    out += request.faces_see_each_other()
               ? "Neither face reflects: u = E, and no exponent belongs to this edge.\n"
               : "The faces do not see each other: no exponent belongs to this edge. There u is as smooth on "
                 "either\nface as E and what else the face sees let it.\n";
    return out + "A uniform mesh loses no order at this edge.\n";
  }
  if (!answer.smallest) {
    out +=
        "One face reflects nothing: no power of r but whole ones. On the other u has terms r^n log r, n >= "
        "1.\n";
  } else if (!answer.not_counted.empty()) {
    out += "smallest exponent  " + reference_decimal(*answer.smallest, request.digits).midpoint + " +- " +
           reference_decimal(*answer.smallest, request.digits).radius + " (proved)\n";
  } else if (answer.exponents.empty()) {
    out += "No exponent is as small as " + request.up_to.to_text() + " (proved).\n";
  } else {
    std::vector<std::vector<std::string>> rows{{"", "exponent", "radius", "second route", "radius"}};
    const auto row = [&](const std::string& head, const Ball& value, const Ball& again) {
      const int second = digits_of_second_route(request);
      const BallDecimal first = reference_decimal(value, request.digits);
      const BallDecimal other = reference_decimal(again, second);
      rows.push_back({head, first.midpoint, first.radius, other.midpoint, other.radius});
    };
    for (const ConfirmedExponent& c : answer.exponents) {
      row(c.exponent.symmetric ? "symmetric" : "antisymmetric", c.exponent.value.real(), c.again.real());
      if (!c.exponent.value.is_real()) row("  +- i", c.exponent.value.imag(), c.again.imag());
    }
    out += aligned(rows) + "All exponents with 0 < Re b <= " + request.up_to.to_text() +
           ": their number is " + "proved, and each of them on both routes.\n";
  }
  std::vector<std::vector<std::string>> rows{{"degree", "order, uniform mesh", "grading for degree + 1"}};
  for (int degree = 0; degree <= most_degree_at_edges; ++degree)
    rows.push_back({std::to_string(degree), rounded(answer.uniform_order(degree)),
                    rounded(answer.wanted_grading(degree))});
  out += "\n" + aligned(rows);
  if (!answer.smallest) out += "Orders up to a factor |log h|.\n";
  return out;
}

ExitCode show_edge(const Common& common, const EdgeWish& wish) {
  const EdgeRequest request = edge_request(wish, OptionStyle::command_line);
  const Outputs outputs(common);
  const EdgeRecord answer = [&] {
    ProgressDisplay progress(common.quiet);
    return edge_record(request, {.counted = [&](double part) { progress.at(part, "exponents are counted"); },
                                 .confirmed =
                                     [&](std::size_t done, std::size_t all) {
                                       progress.counted(done, all, "exponents by the second route");
                                     }});
  }();
  print_result(common, outputs, text_of(answer), edge_json(answer, common.command).pretty() + "\n");
  if (answer.not_counted.empty()) return ExitCode::done;
  complain(answer.not_counted);
  return ExitCode::differs;
}

}  // namespace

void add_edge(Program& program) {
  Subcommand command = program.add("edge", "The exponents of the solution at an edge, proved");
  auto options = std::make_shared<EdgeWish>();
  command.option("--angle", options->angle, "The dihedral angle, in (0, 360)", "DEGREES");
  command.option("--rho", options->rho, "The reflectivity of one face, in [0, 1)", "RHO");
  command.option("--rho-other", options->rho_other, "That of the other face. Default: the same", "RHO");
  command.option_with_default("--up-to", options->up_to, "The exponents whose real part is at most this");
  command.option_with_default("--digits", options->digits, "Radii of at most 10^-DIGITS");
  command.footer(
      "At an edge u is u_0 + c r^b + ..., r the distance from it: each b is a zero of rho rho' k(b)^2 = 1,\n"
      "k the symbol of the operator between two half planes. Exit code 0: all exponents are proved, and\n"
      "their number; 1: they were not counted; 2: no such angle or reflectivity.");
  command.runs([&common = program.common(), options] { return show_edge(common, *options); });
}

}  // namespace radcert::app
