// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "radcert/core/matrix.h"
#include "radcert/meshless/site.h"

namespace radcert {

/// What a transfer matrix was made of: a file is of use only where all of it is the same.
struct TransferKey {
  std::string scene;   ///< LightScene::digest()
  std::string sites;   ///< digest(sites)
  std::string choice;  ///< one line of text: basis, weights, factor, coefficients
};

/// A short name of a set of sites: all bits of points, normals and charts.
[[nodiscard]] std::string digest(const SiteSet& sites);

/// Keeps a transfer matrix in a file.
/// Requires  a square matrix, not empty; a one-line choice; else ContractViolation
/// Result    text lines `radcert transfer matrix 1`, version, scene, sites, choice, size, entries, and an
///           empty one, then the entries column by column, eight bytes each, the lowest first. Written as a
///           whole or not at all, as write_atomically; a matrix read back has the same bits
/// Limits    holds the file in memory once more
void write_transfer(const std::filesystem::path& path, const TransferKey& key, const Matrix<double>& matrix);

/// The matrix of a file, if it is the one of this key.
/// Result    as written. InputError names the file and what is wrong: no transfer matrix, another format,
///           another version of radcert, another scene, other sites, another choice, cut short, altered
/// Limits    the check of the entries is against accidents, not against forgery
[[nodiscard]] Matrix<double> read_transfer(const std::filesystem::path& path, const TransferKey& key);

}  // namespace radcert
