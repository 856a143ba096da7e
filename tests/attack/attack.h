// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tests/scalar/draw.h"

/// A standing attack on values that are called proved, or that carry a radius: random instances that are
/// nasty on purpose, each held against a judge that shares nothing with what computed the value. A kind of
/// value is a file of this folder.
///
///   ./run test                                        a fixed number of instances of each kind, from a fixed
///   seed: about a minute RADCERT_ATTACK=3600 build/release/bin/test_attack as many as an hour allows, shared
///   among the kinds that run (--gtest_filter) RADCERT_ATTACK_SEED=7 ...                         other
///   instances; the report of a violation names seed and number
namespace radcert::attack {

/// What became of an instance.
struct Judgement {
  enum class Kind {
    held,      ///< the value lies within its radius
    refused,   ///< no value was given, and the refusal was named
    violated,  ///< the truth lies outside
  };
  Kind kind = Kind::held;
  std::string text{};      ///< of a violation: value, radius, truth
  std::size_t values = 0;  ///< how many were held against the truth; 0: not counted

  static Judgement held(std::size_t values = 0) { return {.kind = Kind::held, .text = {}, .values = values}; }
  static Judgement refused() { return {.kind = Kind::refused, .text = {}}; }
  static Judgement violated(std::string text) { return {.kind = Kind::violated, .text = std::move(text)}; }
};

/// How many instances of a kind were tried, and what became of them.
struct Count {
  std::size_t instances = 0;
  std::size_t refused = 0;
  std::size_t violated = 0;
  std::size_t values = 0;  ///< within their radii, of the instances that held
};

/// A kind of value under attack.
template <class Instance>
struct Attack {
  std::string_view name;
  std::size_t usual_instances = 0;  ///< in ./run test: what takes a few seconds
  std::function<Instance(Draw&)> make;
  /// An exception that leaves it is a violation; what counts as a refusal, the judge says.
  std::function<Judgement(const Instance&)> judge;
  std::function<std::string(const Instance&)> text;
  /// Instances that are smaller, best first: the report shows one that violates and has no smaller one that
  /// does.
  std::function<std::vector<Instance>(const Instance&)> smaller = [](const Instance&) {
    return std::vector<Instance>{};
  };
};

namespace detail {

/// When a kind has had its share: of instances, or of the seconds asked for.
class Share {
public:
  explicit Share(std::size_t usual_instances);
  /// The number of the next instance; none when the share is used up.
  std::optional<std::size_t> next();
  [[nodiscard]] std::uint64_t seed() const { return seed_; }

private:
  std::size_t usual_;
  double until_ = 0;  ///< seconds on the steady clock; 0: count
  std::size_t done_ = 0;
  std::uint64_t seed_;
};

/// Of the stream that makes instance k.
std::uint64_t seed_of(std::uint64_t seed, std::string_view kind, std::size_t k);
void report(std::string_view kind, std::uint64_t seed, std::size_t k, const std::string& instance,
            const std::string& violation);
void summary(std::string_view kind, const Count& count);

template <class Instance>
Judgement judged(const Attack<Instance>& attack, const Instance& instance) {
  try {
    return attack.judge(instance);
  } catch (const std::exception& error) {
    return Judgement::violated(std::string("not foreseen: ") + error.what());
  }
}

}  // namespace detail

/// Runs a kind's share of instances; each violation, at most ten, fails the test and prints its smallest
/// instance.
template <class Instance>
Count hold(const Attack<Instance>& attack) {
  constexpr std::size_t most_reports = 10;
  constexpr int most_steps = 1000;
  detail::Share share(attack.usual_instances);
  Count count;
  while (const std::optional<std::size_t> k = share.next()) {
    Draw draw(detail::seed_of(share.seed(), attack.name, *k));
    Instance instance = attack.make(draw);
    Judgement judgement = detail::judged(attack, instance);
    ++count.instances;
    count.values += judgement.values;
    count.refused += judgement.kind == Judgement::Kind::refused ? 1 : 0;
    if (judgement.kind != Judgement::Kind::violated) continue;
    if (++count.violated > most_reports) continue;
    bool shrinks = true;
    for (int step = 0; shrinks && step < most_steps;) {
      shrinks = false;
      for (Instance& candidate : attack.smaller(instance)) {
        ++step;
        Judgement smaller = detail::judged(attack, candidate);
        if (smaller.kind != Judgement::Kind::violated) continue;
        instance = std::move(candidate);
        judgement = std::move(smaller);
        shrinks = true;
        break;
      }
    }
    detail::report(attack.name, share.seed(), *k, attack.text(instance), judgement.text);
  }
  detail::summary(attack.name, count);
  return count;
}

}  // namespace radcert::attack
