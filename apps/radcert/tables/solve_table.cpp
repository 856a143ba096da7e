// SPDX-License-Identifier: GPL-3.0-or-later
#include "tables/solve_table.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "output.h"
#include "radcert/formats/table/order_text.h"
#include "radcert/scalar/enclosing_text.h"
#include "radcert/solve/estimated_contraction.h"
#include "radcert/study/collocation/graded_levels.h"
#include "radcert/study/collocation/matrix_form.h"
#include "radcert/study/errors/error_order.h"
#include "tables/number_cells.h"

namespace radcert::app {

namespace {

std::string ratio_text(const std::optional<double>& ratio) {
  return ratio && std::isfinite(*ratio) ? nearest_text(*ratio, DecimalForm::fixed(2)) : "-";
}

/// Whether some level has one with a radius.
template <class Has>
bool any_level(const Result& result, const Has& has) {
  return std::any_of(result.levels.begin(), result.levels.end(), has);
}

std::string level_table(const Result& result, bool with_errors) {
  const bool sample_has_radius = any_level(result, [](const LevelResult& level) {
    return level.uniform_error && level.uniform_error->has_radius();
  });
  const bool norm_has_radius =
      any_level(result, [](const LevelResult& level) { return level.norm_K.has_radius(); });
  std::vector<std::string> head = {"level", "elements", "unknowns", "h"};
  if (with_errors) {
    head.insert(head.end(), {"|K(I-P_n)u|", "+-", "ratio", "|u-u_n| nodes", "+-", "ratio", "|u-u_n| sample"});
    if (sample_has_radius) head.emplace_back("+-");
  }
  head.emplace_back("norm K");
  if (norm_has_radius) head.emplace_back("+-");
  std::vector<std::vector<std::string>> rows = {head};
  for (const LevelResult& level : result.levels) {
    std::vector<std::string> row = {std::to_string(level.level), std::to_string(level.elements),
                                    std::to_string(level.unknowns),
                                    nearest_text(level.mesh_size, DecimalForm::general(4))};
    if (with_errors) {
      push(row, level.discretisation_error);
      row.push_back(ratio_text(level.discretisation_ratio));
      push(row, level.node_error);
      row.push_back(ratio_text(level.node_ratio));
      push(row, level.uniform_error, DecimalForm::scientific(4));
      if (!sample_has_radius) row.pop_back();
    }
    push(row, level.norm_K, DecimalForm::general(6));
    if (!norm_has_radius) row.pop_back();
    if (!level.norm_K.guaranteed) row[row.size() - (norm_has_radius ? 2 : 1)] += " (estimate)";
    rows.push_back(row);
  }
  // A radius and a ratio stay with their error.
  std::set<std::size_t> with_the_left;
  for (std::size_t column = 0; column < head.size(); ++column)
    if (head[column] == "+-" || head[column] == "ratio") with_the_left.insert(column);
  return aligned(rows, with_the_left);
}

/// The errors in means, which are those that Galerkin's method is made for: each with its order between
/// levels.
std::string mean_error_table(const Result& result) {
  if (!std::holds_alternative<Galerkin>(result.problem.method) ||
      !any_level(result, [](const LevelResult& level) { return level.l2_error || level.mean_error; }))
    return {};
  std::vector<std::vector<std::string>> rows = {
      {"level", "|u-u_n| in L2", "+-", "order", "of the means", "+-", "order"}};
  const auto order = [&](std::size_t k, std::optional<Approximation> LevelResult::*figure) -> std::string {
    if (k == 0) return "-";
    const LevelResult& before = result.levels[k - 1];
    const LevelResult& now = result.levels[k];
    return ratio_text(error_order(before.*figure, before.mesh_size, now.*figure, now.mesh_size));
  };
  for (std::size_t k = 0; k < result.levels.size(); ++k) {
    std::vector<std::string> row = {std::to_string(result.levels[k].level)};
    push(row, result.levels[k].l2_error);
    row.push_back(order(k, &LevelResult::l2_error));
    push(row, result.levels[k].mean_error);
    row.push_back(order(k, &LevelResult::mean_error));
    rows.push_back(row);
  }
  return aligned(rows, {2, 3, 5, 6}) + "\n";
}

/// The means of u_n over the pieces, a row a level, with one radius for all of them.
std::string means_table(const Result& result) {
  std::vector<std::vector<std::string>> rows = {{"level"}};
  if (!result.levels.empty())
    for (const auto& [piece, mean] : result.levels.front().piece_means) rows.front().push_back(piece);
  rows.front().emplace_back("+-");
  const bool known = std::all_of(result.levels.begin(), result.levels.end(), [](const LevelResult& level) {
    return std::all_of(level.piece_means.begin(), level.piece_means.end(),
                       [](const auto& mean) { return mean.second.has_radius(); });
  });
  for (const LevelResult& level : result.levels) {
    std::vector<std::string> row = {std::to_string(level.level)};
    std::string radius = "-";
    Rational largest = -1;
    for (const auto& [piece, mean] : level.piece_means) {
      if (!known) {
        row.push_back(nearest_text(mean.value, DecimalForm::general(8)));
        continue;
      }
      const EnclosingText text = enclosing_text(mean.value, mean.radius, DecimalForm::general(8));
      row.push_back(text.value);
      const Rational shown = Rational::parse(text.radius).value();
      if (largest < shown) {
        largest = shown;
        radius = text.radius;
      }
    }
    row.push_back(radius);
    rows.push_back(row);
  }
  return std::string("Means of u_n over the pieces") +
         (known ? ", with an estimate of their radius:\n" : "; no radius of theirs is known:\n") +
         aligned(rows);
}

/// The iterated solution v = E + K u_n, a row a level.
std::string iterated_table(const Result& result, bool with_errors) {
  std::vector<std::vector<std::string>> rows = {{"level", "points"}};
  std::set<std::size_t> with_the_left;
  const auto head = [&](const std::vector<std::string>& names) {
    for (const std::string& name : names) {
      if (name == "+-" || name == "ratio" || name == "order") with_the_left.insert(rows.front().size());
      rows.front().push_back(name);
    }
  };
  if (with_errors) head({"|u-v|", "+-", "ratio", "order", "|u-u_n|", "+-", "ratio", "order"});
  if (with_errors) head({"|u-v| nodes", "+-"});
  head({"|v-u_n|", "+-"});
  for (const LevelResult& level : result.levels) {
    if (!level.iterated) continue;
    const IteratedReport& iterated = *level.iterated;
    std::vector<std::string> row = {std::to_string(level.level), std::to_string(iterated.check_points)};
    if (with_errors) {
      push(row, level.iterated_error);
      row.insert(row.end(), {ratio_text(iterated.ratio), ratio_text(iterated.order)});
      push(row, iterated.u_n_error);
      row.insert(row.end(), {ratio_text(iterated.u_n_ratio), ratio_text(iterated.u_n_order)});
      push(row, iterated.node_error);
    }
    push(row, iterated.difference);
    rows.push_back(row);
  }
  return "The iterated solution v = E + K u_n, maxima over check points inside the elements:\n" +
         aligned(rows, with_the_left);
}

std::string numbers(const std::vector<int>& levels) {
  std::string out;
  for (const int level : levels) out += (out.empty() ? "" : ", ") + std::to_string(level);
  return out;
}

std::string order_line(const OrderFit& fit) {
  const std::string name = fit.quantity == "node_error"       ? "|u-u_n| at the nodes"
                           : fit.quantity == "iterated_error" ? "|u-v| at the check points"
                           : fit.quantity == "u_n_error"      ? "|u-u_n| at the check points"
                           : fit.quantity == "l2_error"       ? "|u-u_n| in L2"
                           : fit.quantity == "mean_error"     ? "the means"
                                                              : "|K(I-P_n)u|";
  std::string out = "Order of " + name + " in h: ";
  const bool is_unsteady = !fit.order && fit.levels.empty() && !fit.pre_asymptotic.empty();
  out +=
      fitted_order_text(fit, " +- ")
          .value_or(is_unsteady ? "not fitted, the slopes from level to level are not steady" : "not fitted");
  if (!fit.levels.empty()) out += " (levels " + numbers(fit.levels) + ")";
  if (!fit.pre_asymptotic.empty() && !is_unsteady)
    out += "; left out as pre-asymptotic: " + numbers(fit.pre_asymptotic);
  if (!fit.left_out.empty())
    out += "; left out, because the radius exceeds 5 % of the error: " + numbers(fit.left_out);
  return out + "\n";
}

/// What was taken at which levels where the problem leaves it open, "gmres" or "direct (levels 0, 1), gmres
/// (levels 2)".
std::string taken(const Result& result, std::string LevelResult::*what) {
  std::vector<std::pair<std::string, std::vector<int>>> by_name;
  for (const LevelResult& level : result.levels) {
    if (by_name.empty() || by_name.back().first != level.*what) by_name.push_back({level.*what, {}});
    by_name.back().second.push_back(level.level);
  }
  if (by_name.size() == 1) return by_name.front().first;
  std::string out;
  for (const auto& [name, levels] : by_name)
    out += (out.empty() ? "" : ", ") + name + (levels.size() == 1 ? " (level " : " (levels ") +
           numbers(levels) + ")";
  return out;
}

/// What `auto` has chosen; empty where it was not asked for, or where the choice is the common one.
std::string choice_lines(const Result& result) {
  std::string out;
  if (result.problem.matrix.name == "auto" &&
      std::any_of(result.levels.begin(), result.levels.end(),
                  [](const LevelResult& level) { return level.matrix_form != "dense"; }))
    out += "Operator: " + taken(result, &LevelResult::matrix_form) + "\n";
  if (result.problem.solver.name == "auto" &&
      std::any_of(result.levels.begin(), result.levels.end(),
                  [](const LevelResult& level) { return !level.iteration; }))
    out += "Solver: " + taken(result, &LevelResult::solver) + "\n";
  for (const LevelResult& level : result.levels)
    if (level.matrix_form == "dense" && takes_clusters(result.problem, level.unknowns))
      out += "Level " + std::to_string(level.level) +
             ": no contraction was found for the operator h2, which has no error bound then; the matrix was "
             "taken dense, with the solver " +
             level.solver + ".\n";
  return out;
}

/// How an iterative solver came to u_n, level by level; empty for another.
std::string iteration_line(const Result& result) {
  std::string iterations;
  std::string solver;
  double contraction = 0;
  double error_bound = 0;
  // The rounding of couplings is estimated.
  bool is_proved = true;
  for (const LevelResult& level : result.levels) {
    if (!level.iteration) continue;
    if (solver != gmres_by_estimate) solver = level.solver;
    iterations += (iterations.empty() ? "" : ", ") + std::to_string(level.iteration->iterations);
    contraction = std::max(contraction, level.iteration->contraction);
    error_bound = std::max(error_bound, level.iteration->error_bound);
    is_proved = is_proved && level.matrix_form == "dense";
  }
  if (iterations.empty()) return {};
  const std::string iterated = "Iterations of " + solver + ": " + iterations;
  // Then 1 - 1/N stands for a contraction.
  if (solver == gmres_by_estimate)
    return iterated +
           "; no contraction is found: by the inverses of coarser levels the norm of the inverse is " +
           "estimated at " + nearest_text(1 / (1 - contraction), DecimalForm::general(3)) +
           ", and the error of the linear system at " + upper_text(error_bound) + "\n";
  // What the integrals are off by, which is estimated, moves the least eigenvalue of the system.
  if (std::holds_alternative<Galerkin>(result.problem.method))
    return iterated + "; rho at most " + upper_text_below_one(contraction, 3) +
           ", error of the linear system about " + upper_text(error_bound) + " in the 2-norm\n";
  const std::string theta = contraction < 1 ? upper_text_below_one(contraction, 3) : upper_text(contraction);
  return iterated + "; contraction at most " + theta +
         (is_proved ? ", error of the linear system at most " : ", error of the linear system about ") +
         upper_text(error_bound) + "\n";
}

/// Whether the errors at the nodes are proved on every level, and u_n itself.
bool nodes_are_guaranteed(const Result& result) {
  return !result.levels.empty() &&
         std::all_of(result.levels.begin(), result.levels.end(), [](const LevelResult& level) {
           const auto proved = [](const std::optional<Approximation>& figure) {
             return !figure || figure->guaranteed;
           };
           return level.verified && proved(level.discretisation_error) && proved(level.node_error);
         });
}

/// What is proved and what is not, in words.
std::string guarantee_text(const Result& result) {
  std::string out =
      "Guaranteed: at every level the collocation equations have one solution, and u_n at the nodes is known "
      "within\n  ";
  for (std::size_t i = 0; i < result.levels.size(); ++i)
    out += (i == 0 ? "" : ", ") + upper_text(result.levels[i].solution_radius.value()) + " (level " +
           std::to_string(result.levels[i].level) + ")";
  out += ".\n";
  if (const std::vector<int> levels = rounded_levels(result.problem, surface_of(result.problem));
      !levels.empty())
    out += "  Vertices are those of the grading rounded to double (levels " + numbers(levels) +
           "): what is proved is about the triangulation with these.\n";
  if (result.problem.solution)
    out +=
        "  |K(I-P_n)u| and |u-u_n| at the nodes lie within the radii (+-), all errors and the printed digits "
        "included.\n";
  out += "Not guaranteed: ";
  if (result.problem.solution) out += "the error on the sample, the ratios, the orders, ";
  out += "the means";
  if (std::any_of(result.levels.begin(), result.levels.end(),
                  [](const LevelResult& level) { return !level.norm_K.guaranteed; }))
    out += ", the norm of K";
  return out + ".\n";
}

}  // namespace

std::string solve_table(const Result& result) {
  const bool with_errors = result.problem.solution.has_value();
  std::string out =
      level_table(result, with_errors) + "\n" + mean_error_table(result) + means_table(result) + "\n";
  if (result.problem.iterated) out += iterated_table(result, with_errors) + "\n";
  for (const OrderFit& fit : result.orders)
    if (with_errors && (!fit.levels.empty() || !fit.left_out.empty() || !fit.pre_asymptotic.empty()))
      out += order_line(fit);
  out += choice_lines(result) + iteration_line(result);
  if (!with_errors) out += "No solution is given, so there are no errors to show.\n";
  if (nodes_are_guaranteed(result))
    out += guarantee_text(result);
  else if (with_errors)
    out +=
        "The radii (+-) of errors are estimates, not proofs; they include the rounding of the printed "
        "digits.\n";
  return out;
}

}  // namespace radcert::app
