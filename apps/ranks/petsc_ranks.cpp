// SPDX-License-Identifier: GPL-3.0-or-later

// The module radcert_petsc: MPI's processes as ranks, and PETSc's star forests as exchanges. The program
// loads it under mpirun alone, so that radcert without PETSc is the same program.
#include <petsc/private/vecimpl.h>
#include <petscksp.h>
#include <petscsf.h>

#include <algorithm>
#include <climits>
#include <cmath>
#include <exception>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "radcert/core/ranks/krylov_engine.h"
#include "ranks_module.h"

namespace radcert::app {
namespace {

/// Throws where PETSc or MPI says no.
void require(int error, const char* what) {
  if (error != 0)
    throw std::runtime_error(std::string(what) + " fails with the error " + std::to_string(error));
}

/// Before each call that all ranks make together they agree that none has come to its end.
class Agreement {
public:
  /// Throws EndedElsewhere where a rank has.
  void go_on() {
    if (!someone_ends(false)) return;
    ending_ = exchanged({});
    // One that has done its part waits for the others in end(): here it would leave them alone.
    if (ending_->code == 0) ending_ = Ending{3, "a rank has ended before the others"};
    throw EndedElsewhere(ending_->code, ending_->text);
  }
  Ending end(const Ending& own) {
    if (ending_) return *ending_;
    // The others come here too, or learn of it at their next step.
    someone_ends(true);
    return exchanged(own);
  }

private:
  static bool someone_ends(bool here) {
    int own = here ? 1 : 0;
    int any = 0;
    require(MPI_Allreduce(&own, &any, 1, MPI_INT, MPI_MAX, PETSC_COMM_WORLD), "MPI_Allreduce");
    return any != 0;
  }
  /// What the ranks say that end, and nothing from those that would go on.
  static Ending exchanged(const Ending& own) {
    int count = 0;
    MPI_Comm_size(PETSC_COMM_WORLD, &count);
    std::vector<int> codes(static_cast<std::size_t>(count));
    require(MPI_Allgather(&own.code, 1, MPI_INT, codes.data(), 1, MPI_INT, PETSC_COMM_WORLD),
            "MPI_Allgather");
    const auto found = std::find_if(codes.begin(), codes.end(), [](int code) { return code != 0; });
    if (found == codes.end()) return {};
    const int rank = static_cast<int>(found - codes.begin());
    int here = 0;
    MPI_Comm_rank(PETSC_COMM_WORLD, &here);
    int length = static_cast<int>(own.text.size());
    require(MPI_Bcast(&length, 1, MPI_INT, rank, PETSC_COMM_WORLD), "MPI_Bcast");
    std::string text = here == rank ? own.text : std::string(static_cast<std::size_t>(length), ' ');
    require(MPI_Bcast(text.data(), length, MPI_CHAR, rank, PETSC_COMM_WORLD), "MPI_Bcast");
    return {*found, text};
  }

  std::optional<Ending> ending_;
};

class StarForest final : public Exchange {
public:
  StarForest(Agreement& agreement, std::size_t held, std::span<const RemoteNumber> wanted)
      : agreement_(agreement) {
    require(PetscSFCreate(PETSC_COMM_WORLD, &forest_), "PetscSFCreate");
    if (held > PETSC_MAX_INT || wanted.size() > PETSC_MAX_INT)
      throw std::runtime_error(
          "PETSc's indices are too short for the numbers of a rank: more ranks are needed");
    PetscSFNode* nodes = nullptr;
    require(PetscMalloc(wanted.size() * sizeof(PetscSFNode), &nodes), "PetscMalloc");
    for (std::size_t i = 0; i < wanted.size(); ++i)
      nodes[i] = {static_cast<PetscInt>(wanted[i].rank), static_cast<PetscInt>(wanted[i].place)};
    require(PetscSFSetGraph(forest_, static_cast<PetscInt>(held), static_cast<PetscInt>(wanted.size()),
                            nullptr, PETSC_OWN_POINTER, nodes, PETSC_OWN_POINTER),
            "PetscSFSetGraph");
    require(PetscSFSetUp(forest_), "PetscSFSetUp");
    PetscInt ranks = 0;
    const PetscMPIInt* numbers = nullptr;
    const PetscInt* offsets = nullptr;
    require(PetscSFGetLeafRanks(forest_, &ranks, &numbers, &offsets, nullptr), "PetscSFGetLeafRanks");
    int here = 0;
    MPI_Comm_rank(PETSC_COMM_WORLD, &here);
    for (PetscInt i = 0; i < ranks; ++i)
      if (numbers[i] != here)
        sent_ += static_cast<std::uint64_t>(offsets[i + 1] - offsets[i]) * sizeof(double);
  }
  ~StarForest() override { PetscSFDestroy(&forest_); }

  void bring(std::span<const double> held, std::span<double> wanted) const override {
    agreement_.go_on();
    require(PetscSFBcastBegin(forest_, MPI_DOUBLE, held.data(), wanted.data(), MPI_REPLACE),
            "PetscSFBcastBegin");
    require(PetscSFBcastEnd(forest_, MPI_DOUBLE, held.data(), wanted.data(), MPI_REPLACE), "PetscSFBcastEnd");
  }
  [[nodiscard]] std::uint64_t bytes_sent() const override { return sent_; }

private:
  Agreement& agreement_;
  PetscSF forest_ = nullptr;
  std::uint64_t sent_ = 0;
};

/// PETSc's Krylov methods on vectors whose sums over the ranks do not depend on how many there are, and whose
/// sums of vectors are plain loops: a BLAS may round the last entries of a part otherwise.
class PetscKrylov final : public KrylovEngine {
public:
  /// Says of options that begin with -ksp or -pc which of them PETSc does not know, before any work.
  static void take_options() {
    const Solver solver(1);
    require(KSPSetFromOptions(solver.ksp), "KSPSetFromOptions");
  }

  explicit PetscKrylov(std::string options) : options_(std::move(options)) {}

  [[nodiscard]] std::string options() const override { return options_; }

  std::size_t solve(const Product& a, const Dot& dot, double relative, std::span<double> r) const override {
    const auto n = static_cast<PetscInt>(r.size());
    Work work(a, dot);
    const Solver solver(n);
    Vectors vectors;
    Vec& b = vectors.b;
    Vec& x = vectors.x;
    require(VecCreateMPI(PETSC_COMM_WORLD, n, PETSC_DETERMINE, &b), "VecCreateMPI");
    give_operations(b);
    require(VecDuplicate(b, &x), "VecDuplicate");
    write(b, [&](std::span<double> to) { std::copy(r.begin(), r.end(), to.begin()); });
    require(KSPSetTolerances(solver.ksp, relative, 0, PETSC_DEFAULT, restart), "KSPSetTolerances");
    require(KSPSetFromOptions(solver.ksp), "KSPSetFromOptions");
    require(PetscPushErrorHandler(PetscReturnErrorHandler, nullptr), "PetscPushErrorHandler");
    const int error = KSPSolve(solver.ksp, b, x);
    require(PetscPopErrorHandler(), "PetscPopErrorHandler");
    if (work.failure) std::rethrow_exception(work.failure);
    if (error != 0) {
      const char* text = nullptr;
      PetscErrorMessage(error, &text, nullptr);
      throw KrylovFailure("KSPSolve: " + std::string(text != nullptr ? text : "fails"));
    }
    PetscInt iterations = 0;
    require(KSPGetIterationNumber(solver.ksp, &iterations), "KSPGetIterationNumber");
    const std::span<const double> found = read(x);
    std::copy(found.begin(), found.end(), r.begin());
    return static_cast<std::size_t>(iterations);
  }

private:
  const std::string options_;
  static constexpr int restart = 64;
  static constexpr const char* split_sums =
      "a Krylov method that splits its sums over the ranks does not give the same bits on any number "
      "of them";

  /// What the functions below work with: PETSc hands them vectors alone.
  struct Work {
    Work(const Product& a, const Dot& of_vectors) : product(a), dot(of_vectors) { current() = this; }
    ~Work() { current() = nullptr; }
    Work(const Work&) = delete;
    Work& operator=(const Work&) = delete;
    const Product& product;
    const Dot& dot;
    std::exception_ptr failure;
  };
  /// Right-hand side and solution.
  struct Vectors {
    Vectors() = default;
    ~Vectors() {
      VecDestroy(&x);
      VecDestroy(&b);
    }
    Vectors(const Vectors&) = delete;
    Vectors& operator=(const Vectors&) = delete;
    Vec b = nullptr;
    Vec x = nullptr;
  };
  static Work*& current() {
    static Work* work = nullptr;
    return work;
  }

  struct Solver {
    explicit Solver(PetscInt n) {
      require(MatCreateShell(PETSC_COMM_WORLD, n, n, PETSC_DETERMINE, PETSC_DETERMINE, nullptr, &matrix),
              "MatCreateShell");
      require(MatShellSetOperation(matrix, MATOP_MULT, reinterpret_cast<void (*)()>(multiply)),
              "MatShellSetOperation");
      require(KSPCreate(PETSC_COMM_WORLD, &ksp), "KSPCreate");
      require(KSPSetOperators(ksp, matrix, matrix), "KSPSetOperators");
      require(KSPSetType(ksp, KSPGMRES), "KSPSetType");
      require(KSPGMRESSetRestart(ksp, restart), "KSPGMRESSetRestart");
      require(KSPGMRESSetCGSRefinementType(ksp, KSP_GMRES_CGS_REFINE_ALWAYS), "KSPGMRESSetCGSRefinementType");
      PC pc = nullptr;
      require(KSPGetPC(ksp, &pc), "KSPGetPC");
      require(PCSetType(pc, PCNONE), "PCSetType");
    }
    ~Solver() {
      KSPDestroy(&ksp);
      MatDestroy(&matrix);
    }
    Solver(const Solver&) = delete;
    Solver& operator=(const Solver&) = delete;
    Mat matrix = nullptr;
    KSP ksp = nullptr;
  };

  static std::size_t size_of(Vec x) {
    PetscInt n = 0;
    require(VecGetLocalSize(x, &n), "VecGetLocalSize");
    return static_cast<std::size_t>(n);
  }
  /// The entries here; they stay where they are while the vector lives.
  static std::span<const double> read(Vec x) {
    const double* from = nullptr;
    require(VecGetArrayRead(x, &from), "VecGetArrayRead");
    const std::span<const double> entries(from, size_of(x));
    require(VecRestoreArrayRead(x, &from), "VecRestoreArrayRead");
    return entries;
  }
  template <class Body>
  static void write(Vec x, const Body& body) {
    double* to = nullptr;
    require(VecGetArray(x, &to), "VecGetArray");
    body(std::span<double>(to, size_of(x)));
    require(VecRestoreArray(x, &to), "VecRestoreArray");
  }
  /// Runs what may throw: an exception goes round PETSc.
  template <class Body>
  static PetscErrorCode guarded(const Body& body) {
    try {
      body();
      return 0;
    } catch (...) {
      if (current() != nullptr && !current()->failure) current()->failure = std::current_exception();
      return PETSC_ERR_USER;
    }
  }

  static PetscErrorCode multiply(Mat, Vec x, Vec y) {
    return guarded([&] { write(y, [&](std::span<double> to) { current()->product(read(x), to); }); });
  }
  static PetscErrorCode dot_of(Vec x, Vec y, PetscScalar* out) {
    return guarded([&] { *out = current()->dot(read(x), read(y)); });
  }
  static PetscErrorCode dots_of(Vec x, PetscInt count, const Vec y[], PetscScalar* out) {
    return guarded([&] {
      for (PetscInt j = 0; j < count; ++j) out[j] = current()->dot(read(x), read(y[j]));
    });
  }
  static PetscErrorCode norm_of(Vec x, NormType type, PetscReal* out) {
    return guarded([&] {
      if (type != NORM_2 && type != NORM_FROBENIUS) throw KrylovFailure("a norm that is not the 2-norm");
      *out = std::sqrt(current()->dot(read(x), read(x)));
    });
  }
  static PetscErrorCode dot_and_norm(Vec x, Vec y, PetscScalar* dot, PetscScalar* norm) {
    return guarded([&] {
      *dot = current()->dot(read(x), read(y));
      *norm = current()->dot(read(y), read(y));
    });
  }
  /// Methods that begin a sum over the ranks and go on before it is there would add in an order of their own.
  static PetscErrorCode refuse_split(Vec, Vec, PetscScalar*) {
    return guarded([] { throw KrylovFailure(split_sums); });
  }
  static PetscErrorCode refuse_split_norm(Vec, NormType, PetscReal*) {
    return guarded([] { throw KrylovFailure(split_sums); });
  }
  static PetscErrorCode refuse_split_dots(Vec, PetscInt, const Vec[], PetscScalar*) {
    return guarded([] { throw KrylovFailure(split_sums); });
  }
  /// y_i <- f(y_i, i)
  template <class F>
  static PetscErrorCode each(Vec y, const F& f) {
    return guarded([&] {
      write(y, [&](std::span<double> to) {
        for (std::size_t i = 0; i < to.size(); ++i) to[i] = f(to[i], i);
      });
    });
  }
  static PetscErrorCode scale(Vec x, PetscScalar a) {
    return each(x, [a](double value, std::size_t) { return a * value; });
  }
  static PetscErrorCode axpy(Vec y, PetscScalar a, Vec x) {
    const auto from = read(x);
    return each(y, [&](double value, std::size_t i) { return value + a * from[i]; });
  }
  static PetscErrorCode aypx(Vec y, PetscScalar a, Vec x) {
    const auto from = read(x);
    return each(y, [&](double value, std::size_t i) { return a * value + from[i]; });
  }
  static PetscErrorCode axpby(Vec y, PetscScalar a, PetscScalar b, Vec x) {
    const auto from = read(x);
    return each(y, [&](double value, std::size_t i) { return a * from[i] + b * value; });
  }
  static PetscErrorCode waxpy(Vec w, PetscScalar a, Vec x, Vec y) {
    const auto one = read(x);
    const auto other = read(y);
    return each(w, [&](double, std::size_t i) { return other[i] + a * one[i]; });
  }
  static PetscErrorCode axpbypcz(Vec z, PetscScalar a, PetscScalar b, PetscScalar c, Vec x, Vec y) {
    const auto one = read(x);
    const auto other = read(y);
    return each(z, [&](double value, std::size_t i) { return a * one[i] + b * other[i] + c * value; });
  }
  static PetscErrorCode maxpy(Vec y, PetscInt count, const PetscScalar* a, Vec* x) {
    for (PetscInt j = 0; j < count; ++j)
      if (const PetscErrorCode error = axpy(y, a[j], x[j]); error != 0) return error;
    return 0;
  }
  static void give_operations(Vec x) {
    struct _VecOps& ops = *x->ops;
    ops.dot = ops.tdot = dot_of;
    ops.mdot = ops.mtdot = dots_of;
    ops.norm = norm_of;
    ops.dotnorm2 = dot_and_norm;
    ops.dot_local = ops.tdot_local = refuse_split;
    ops.mdot_local = ops.mtdot_local = refuse_split_dots;
    ops.norm_local = refuse_split_norm;
    ops.scale = scale;
    ops.axpy = axpy;
    ops.aypx = aypx;
    ops.axpby = axpby;
    ops.waxpy = waxpy;
    ops.axpbypcz = axpbypcz;
    ops.maxpy = maxpy;
  }
};

class PetscRanks final : public RankedRun {
public:
  explicit PetscRanks(std::string options) : krylov_(std::move(options)) {
    int number = 0;
    MPI_Comm_size(PETSC_COMM_WORLD, &number);
    count_ = static_cast<std::size_t>(number);
    MPI_Comm_rank(PETSC_COMM_WORLD, &number);
    here_ = static_cast<std::size_t>(number);
    MPI_Comm machine = MPI_COMM_NULL;
    MPI_Comm_split_type(PETSC_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine);
    MPI_Comm_size(machine, &number);
    of_machine_ = static_cast<std::size_t>(number);
    MPI_Comm_free(&machine);
  }

  [[nodiscard]] std::size_t count() const override { return count_; }
  [[nodiscard]] std::size_t here() const override { return here_; }
  [[nodiscard]] std::size_t ranks_of_machine() const override { return of_machine_; }

  [[nodiscard]] std::vector<std::string> gather(std::string_view own) const override {
    agreement_.go_on();
    const std::vector<std::uint64_t> lengths = lengths_of(own);
    std::uint64_t total = 0;
    for (const std::uint64_t length : lengths) total += length;
    std::vector<std::string> all(count_);
    if (total > INT_MAX) {
      for (std::size_t rank = 0; rank < count_; ++rank) all[rank] = broadcast(own, rank, lengths[rank]);
      return all;
    }
    std::vector<int> counts;
    std::vector<int> places;
    int place = 0;
    for (const std::uint64_t length : lengths) {
      counts.push_back(static_cast<int>(length));
      places.push_back(place);
      place += counts.back();
    }
    std::string bytes(total, ' ');
    require(MPI_Allgatherv(own.data(), static_cast<int>(own.size()), MPI_CHAR, bytes.data(), counts.data(),
                           places.data(), MPI_CHAR, PETSC_COMM_WORLD),
            "MPI_Allgatherv");
    for (std::size_t rank = 0; rank < count_; ++rank)
      all[rank] = bytes.substr(static_cast<std::size_t>(places[rank]), lengths[rank]);
    return all;
  }

  [[nodiscard]] std::vector<std::string> gather_at_first(std::string_view own) const override {
    agreement_.go_on();
    const std::vector<std::uint64_t> lengths = lengths_of(own);
    constexpr int tag = 1;
    std::vector<std::string> all;
    if (here_ > 0) {
      for (std::size_t sent = 0; sent < own.size(); sent += piece)
        require(MPI_Send(own.data() + sent, static_cast<int>(std::min(piece, own.size() - sent)), MPI_CHAR, 0,
                         tag, PETSC_COMM_WORLD),
                "MPI_Send");
      return all;
    }
    all.emplace_back(own);
    for (std::size_t rank = 1; rank < count_; ++rank) {
      std::string& text = all.emplace_back(lengths[rank], ' ');
      for (std::size_t got = 0; got < text.size(); got += piece)
        require(MPI_Recv(text.data() + got, static_cast<int>(std::min(piece, text.size() - got)), MPI_CHAR,
                         static_cast<int>(rank), tag, PETSC_COMM_WORLD, MPI_STATUS_IGNORE),
                "MPI_Recv");
    }
    return all;
  }

  [[nodiscard]] std::unique_ptr<const Exchange> exchange(
      std::size_t held, std::span<const RemoteNumber> wanted) const override {
    agreement_.go_on();
    return std::make_unique<StarForest>(agreement_, held, wanted);
  }

  [[nodiscard]] const KrylovEngine* krylov_engine() const override { return &krylov_; }

  [[nodiscard]] std::vector<std::string> options_left() const {
    PetscInt count = 0;
    char** names = nullptr;
    char** values = nullptr;
    require(PetscOptionsLeftGet(nullptr, &count, &names, &values), "PetscOptionsLeftGet");
    std::vector<std::string> out;
    for (PetscInt i = 0; i < count; ++i) out.push_back("-" + std::string(names[i]));
    require(PetscOptionsLeftRestore(nullptr, &count, &names, &values), "PetscOptionsLeftRestore");
    return out;
  }

  /// Which options PETSc's beginning leaves to solvers, and which not even these know.
  void take_options() {
    of_solver_ = options_left();
    PetscKrylov::take_options();
    not_taken_ = options_left();
  }
  [[nodiscard]] std::vector<std::string> options_of_solver() const override { return of_solver_; }
  [[nodiscard]] std::vector<std::string> options_not_taken() const override { return not_taken_; }

  Ending end(const Ending& own) override {
    Ending ending = agreement_.end(own);
    PetscFinalize();
    return ending;
  }

private:
  static constexpr std::size_t piece = std::size_t{1} << 30U;

  [[nodiscard]] std::vector<std::uint64_t> lengths_of(std::string_view own) const {
    const std::uint64_t length = own.size();
    std::vector<std::uint64_t> lengths(count_);
    require(MPI_Allgather(&length, 1, MPI_UINT64_T, lengths.data(), 1, MPI_UINT64_T, PETSC_COMM_WORLD),
            "MPI_Allgather");
    return lengths;
  }
  [[nodiscard]] std::string broadcast(std::string_view own, std::size_t from, std::uint64_t length) const {
    std::string text = here_ == from ? std::string(own) : std::string(length, ' ');
    for (std::size_t done = 0; done < length; done += piece)
      require(MPI_Bcast(text.data() + done, static_cast<int>(std::min<std::size_t>(piece, length - done)),
                        MPI_CHAR, static_cast<int>(from), PETSC_COMM_WORLD),
              "MPI_Bcast");
    return text;
  }

  mutable Agreement agreement_;
  PetscKrylov krylov_;
  std::vector<std::string> of_solver_;
  std::vector<std::string> not_taken_;
  std::size_t count_ = 1;
  std::size_t here_ = 0;
  std::size_t of_machine_ = 1;
};

}  // namespace
}  // namespace radcert::app

extern "C" radcert::app::RankedRun* radcert_begin_ranks(const std::vector<std::string>& options,
                                                        std::string& failure) {
  // radcert has handlers of its own.
  static std::vector<std::string> words{"radcert", "-no_signal_handler"};
  words.insert(words.end(), options.begin(), options.end());
  static std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  int count = static_cast<int>(pointers.size());
  pointers.push_back(nullptr);
  char** arguments = pointers.data();
  if (PetscInitialize(&count, &arguments, nullptr, nullptr) != 0) {
    failure = "PETSc cannot be begun";
    return nullptr;
  }
  std::string all;
  for (const std::string& option : options) all += option + "\n";
  static radcert::app::PetscRanks ranks(std::move(all));
  ranks.take_options();
  return &ranks;
}
