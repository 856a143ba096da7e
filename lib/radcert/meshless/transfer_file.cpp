// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/meshless/transfer_file.h"

#include <bit>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string_view>

#include "radcert/core/atomic_file.h"
#include "radcert/core/contract.h"
#include "radcert/core/digest.h"
#include "radcert/core/errors.h"
#include "radcert/core/memory_plan.h"
#include "radcert/core/version.h"

namespace radcert {
namespace {

static_assert(std::endian::native == std::endian::little, "entries are written as they lie in memory");

constexpr std::string_view title = "radcert transfer matrix ";
constexpr std::string_view format = "1";

template <class Number>
void append_bytes(std::string& text, const Number& number) {
  char bytes[sizeof number];
  std::memcpy(bytes, &number, sizeof number);
  text.append(bytes, sizeof number);
}

/// The lines before the entries, one after the other.
class Head {
public:
  Head(const std::filesystem::path& path, std::string_view content) : path_(path), rest_(content) {}

  /// What stands behind `word` and a space on the next line.
  std::string_view next(std::string_view word) {
    const std::size_t end = rest_.find('\n');
    if (end == std::string_view::npos || !rest_.substr(0, end).starts_with(word))
      throw wrong("is damaged: its head ends early");
    std::string_view line = rest_.substr(word.size(), end - word.size());
    rest_.remove_prefix(end + 1);
    return line;
  }
  /// The same, which has to be `expected`.
  void match(std::string_view word, std::string_view expected, const std::string& otherwise) {
    const std::string_view found = next(word);
    if (found != expected) throw wrong(otherwise, std::string(found), std::string(expected));
  }
  [[nodiscard]] std::string_view rest() const { return rest_; }
  [[nodiscard]] InputError wrong(const std::string& problem, std::optional<std::string> value = std::nullopt,
                                 const std::string& allowed = {}) const {
    return InputError(
        {.source = path_.string(), .value = std::move(value), .problem = problem, .allowed = allowed});
  }

private:
  const std::filesystem::path& path_;
  std::string_view rest_;
};

}  // namespace

std::string digest(const SiteSet& sites) {
  std::string bytes;
  for (std::size_t i = 0; i < sites.size(); ++i) {
    for (const Vector<double>& v : {sites.points[i], sites.normals[i]})
      append_bytes(bytes, v.x), append_bytes(bytes, v.y), append_bytes(bytes, v.z);
    append_bytes(bytes, static_cast<std::uint64_t>(sites.at[i].chart));
  }
  return digest_of(bytes);
}

void write_transfer(const std::filesystem::path& path, const TransferKey& key, const Matrix<double>& matrix) {
  const std::size_t n = matrix.rows();
  expects(n > 0 && matrix.columns() == n, "a square matrix", named("rows", n),
          named("columns", matrix.columns()));
  expects(key.choice.find('\n') == std::string::npos, "a choice of one line", named("choice", key.choice));
  const std::string_view entries(reinterpret_cast<const char*>(matrix.column(0).data()),
                                 n * n * sizeof(double));
  std::string text;
  text.append(title).append(format);
  text.append("\nversion ").append(version());
  text.append("\nscene ").append(key.scene);
  text.append("\nsites ").append(key.sites);
  text.append("\nchoice ").append(key.choice);
  text.append("\nsize ").append(std::to_string(n));
  text.append("\nentries ").append(digest_of(entries));
  text.append("\n\n").append(entries);
  write_atomically(path, text);
}

Matrix<double> read_transfer(const std::filesystem::path& path, const TransferKey& key) {
  const std::string content = read_file(path, available_memory());
  Head head(path, content);
  if (!std::string_view(content).starts_with(title)) throw head.wrong("is no transfer matrix of radcert");
  head.match(title, format, "is a transfer matrix in another format");
  head.match("version ", version(), "was written by another version of radcert");
  head.match("scene ", key.scene, "holds the transfer matrix of another scene");
  head.match("sites ", key.sites, "holds the transfer matrix of other sites");
  head.match("choice ", key.choice, "holds the transfer matrix of another choice");
  const std::string_view size = head.next("size ");
  std::size_t n = 0;
  const auto read = std::from_chars(size.data(), size.data() + size.size(), n);
  // 2^24 squared, eight bytes each, still fits into 64 bits.
  constexpr std::size_t most = std::size_t{1} << 24U;
  if (read.ec != std::errc() || read.ptr != size.data() + size.size() || n == 0 || n > most)
    throw head.wrong("is damaged: its size is no number of sites", std::string(size));
  const std::string_view digest_of_entries = head.next("entries ");
  head.match("", "", "is damaged: its head has a line too many");
  if (head.rest().size() != n * n * sizeof(double))
    throw head.wrong("is damaged: it has " + std::to_string(head.rest().size()) + " bytes of entries",
                     std::nullopt, std::to_string(n * n * sizeof(double)));
  if (digest_of(head.rest()) != digest_of_entries) throw head.wrong("is damaged: its entries were altered");
  Matrix<double> matrix = Matrix<double>::uninitialised(n, n);
  std::memcpy(matrix.column(0).data(), head.rest().data(), head.rest().size());
  return matrix;
}

}  // namespace radcert
