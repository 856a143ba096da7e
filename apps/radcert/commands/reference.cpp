// SPDX-License-Identifier: GPL-3.0-or-later

// radcert reference NAME, or --all: numbers in proved enclosures; sphere_over_disk: with estimated radii.
#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "command.h"
#include "origin.h"
#include "output.h"
#include "progress.h"
#include "radcert/core/digest.h"
#include "radcert/core/files/result_store.h"
#include "radcert/core/interrupt.h"
#include "radcert/core/version.h"
#include "radcert/formats/json/json_document.h"
#include "radcert/formats/json/json_reader.h"
#include "radcert/formats/result/reference_json.h"
#include "radcert/reference/reference_value.h"
#include "records/continuous_records.h"
#include "records/reference_records.h"
#include "verification/claims/psg10/figures/sphere_over_disk_records.h"

namespace radcert::app {

namespace {

namespace psg10 = verification::psg10;

/// The digits where none are asked for; an empty word is a wrong number of them.
constexpr const char* not_given = "20, or what a certificate proves";

struct ReferenceOptions {
  std::string name;
  std::string digits = not_given;
  std::vector<std::string> settings;
  bool all = false;
  std::string out;
  std::vector<std::string> at;
  std::string curve;
  std::string points;
};

constexpr int usual_digits = 20;

int digits_of(const std::string& text) {
  if (text == not_given) return usual_digits;
  int digits = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), digits);
  if (error != std::errc() || end != text.data() + text.size() || digits < 1 ||
      digits > reference::most_reference_digits)
    throw InputError(
        {.source = "--digits",
         .value = text,
         .allowed = "a whole number from 1 to " + std::to_string(reference::most_reference_digits)});
  return digits;
}

/// The words "name=value" of --set.
std::vector<Setting> settings_of(const std::vector<std::string>& words) {
  std::vector<Setting> out;
  for (const std::string& word : words) {
    const std::size_t sign = word.find('=');
    if (sign == std::string::npos)
      throw InputError({.source = "--set", .value = word, .allowed = "NAME=VALUE"});
    out.push_back({word.substr(0, sign), word.substr(sign + 1)});
  }
  return out;
}

std::string text_of(const ReferenceRecord& record) {
  const BallDecimal decimal = reference_decimal(record.routes.front().value, record.digits);
  std::string parameters;
  for (const auto& [name, value] : record.parameters)
    parameters += (parameters.empty() ? "" : ", ") + name + " = " + value;
  std::vector<std::vector<std::string>> rows = {
      {"value", decimal.midpoint},
      {"radius", decimal.radius + (record.guaranteed ? " (proved)" : " (estimated)")},
      {"formula", record.formula}};
  if (!parameters.empty()) rows.push_back({"parameters", parameters});
  rows.push_back({"source", record.source});
  for (const ReferenceRoute& route : record.routes) {
    const BallDecimal found = reference_decimal(route.value, record.digits);
    rows.push_back(
        {&route == &record.routes.front() ? "route" : "checked by", route.how + ", radius " + found.radius});
  }
  return record.name + "\n" + aligned_left(rows);
}

/// A value's name as part of a file's: "h_1/2" is h_1_over_2.
std::string file_name(const std::string& name) {
  std::string out;
  for (const char c : name) out += c == '/' ? std::string("_over_") : std::string(1, c);
  return out;
}

/// What the balls of a record's routes depend on.
std::string key_of(const reference::NamedValue& value, int digits) {
  return "reference\n" + std::string(source_digest()) + "\n" + value.name + "\n" + std::to_string(digits);
}

JsonValue binary(const BinaryNumber& number) {
  return json_array(std::array{number.mantissa, number.exponent});
}

/// The routes of a record, each ball exactly.
std::string routes_text(const ReferenceRecord& record) {
  return json_array(record.routes,
                    [](const ReferenceRoute& route) {
                      return JsonValue::object({{"how", route.how},
                                                {"midpoint", binary(route.value.midpoint_binary())},
                                                {"radius", binary(route.value.radius_binary())}});
                    })
      .compact();
}

BinaryNumber binary(const JsonReader& reader) {
  const std::vector<JsonReader> parts = reader.elements("mantissa and exponent");
  if (parts.size() != 2) reader.refuse("is no binary number", "mantissa and exponent");
  return {parts[0].string("a mantissa"), parts[1].string("an exponent")};
}

/// The routes that such a text states; none where it does not.
std::vector<ReferenceRoute> routes_in(const std::string& text) try {
  std::vector<ReferenceRoute> out;
  const JsonValue document = parse_json(text, "the store");
  for (const JsonReader& route : JsonReader(document).elements("routes")) {
    const auto ball =
        Ball::from_binary(binary(route.at("midpoint", "a number")), binary(route.at("radius", "a number")));
    if (!ball) return {};
    out.push_back({route.at("how", "words").string("words"), *ball});
  }
  return out;
} catch (const InputError&) {
  return {};
}

/// The record of a value, its balls from the store or computed and put there.
ReferenceRecord kept_record(const reference::NamedValue& value, int digits, ResultStore& store) {
  const std::string key = key_of(value, digits);
  if (const std::optional<std::string> kept = store.get(key))
    if (std::vector<ReferenceRoute> routes = routes_in(*kept); !routes.empty())
      return record_with(member(value), digits, std::move(routes));
  ReferenceRecord record = record_of(member(value), digits);
  static_cast<void>(store.put(key, routes_text(record)));
  return record;
}

ExitCode print_one(const Common& common, const ReferenceOptions& options, int digits) {
  const Outputs outputs(common);
  const ReferenceRecord record = record_of(
      wanted_reference(options.name, settings_of(options.settings), OptionStyle::command_line), digits);
  print_result(common, outputs, text_of(record), reference_json(record, common.command).pretty() + "\n");
  return ExitCode::done;
}

/// A mean of the solution of the continuous equation has the digits that its certificate proves.
ExitCode print_continuous(const Common& common, const ReferenceOptions& options,
                          const reference::ContinuousMean& mean, int digits) {
  if (!options.settings.empty())
    throw InputError({.source = "--set",
                      .value = options.settings.front(),
                      .problem = "is for a family, and " + mean.name + " is one value"});
  Outputs outputs(common);
  outputs.folder("--out", options.out);
  const ReferenceRecord record = continuous_record(mean);
  if (options.digits != not_given && digits > record.digits)
    throw AccuracyNotReached(mean.name, "a radius of 1e-" + std::to_string(digits) +
                                            " is not proved by its certificate, 1e-" +
                                            std::to_string(record.digits) + " is");
  Files files;
  if (!options.out.empty())
    files = certificate_files(*reference::find_continuous_scene(mean.scene), options.out);
  print_result(common, outputs, text_of(record), reference_json(record, common.command).pretty() + "\n",
               std::move(files));
  return ExitCode::done;
}

ExitCode give_sphere_over_disk(const Common& common, const ReferenceOptions& options, int digits) {
  psg10::SphereOverDiskWish wish{.arguments = {},
                                 .at = options.at,
                                 .curve = options.curve,
                                 .points = options.points.empty() ? "201" : options.points,
                                 .digits = digits};
  const auto parameters = psg10::sphere_over_disk_parameters();
  for (const reference::ValueParameter& parameter : parameters)
    wish.arguments.push_back(Rational::parse(parameter.default_text).value());
  apply(settings_of(options.settings), psg10::sphere_over_disk_name, parameters, wish.arguments,
        OptionStyle::command_line);
  if (wish.at.empty() && wish.curve.empty())
    throw InputError({.source = "reference",
                      .problem = std::string(psg10::sphere_over_disk_name) + " without a point",
                      .allowed = "--at B:LATITUDE, --at D:DISTANCE, --curve FILE.csv"});
  if (!common.json.empty() && wish.at.empty())
    throw InputError({.source = "--json", .problem = "without --at", .allowed = "--at with it"});
  Outputs outputs(common);
  outputs.file("--curve", wish.curve);
  // Before anything is written: a point that is not allowed leaves no file behind.
  std::vector<ReferenceRecord> records;
  if (!wish.at.empty()) records = psg10::sphere_over_disk_records(wish);
  Files files;
  if (!wish.curve.empty()) files.emplace_back(wish.curve, psg10::sphere_over_disk_csv(wish));
  if (records.empty()) {
    outputs.write(files);
    return ExitCode::done;
  }
  std::string text;
  for (const ReferenceRecord& record : records) text += (text.empty() ? "" : "\n") + text_of(record);
  const JsonValue json = records.size() == 1 ? reference_json(records.front(), common.command)
                                             : references_json(records, common.command);
  print_result(common, outputs, text, json.pretty() + "\n", std::move(files));
  return ExitCode::done;
}

constexpr const char* certificate_folder = "certificates";

/// The names of files below a folder, with what tells their contents from others.
JsonValue file_list(const Files& files, const std::filesystem::path& folder) {
  std::vector<std::pair<std::string, JsonValue>> named;
  for (const auto& [path, content] : files) {
    const std::string name = path.lexically_relative(folder).generic_string();
    named.emplace_back(name, JsonValue::object({{"file", name},
                                                {"bytes", static_cast<std::int64_t>(content.size())},
                                                {"sha256", sha256(content)}}));
  }
  std::sort(named.begin(), named.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  return json_array(named, [](const auto& each) { return each.second; });
}

/// Of radcert, and with it of what it writes as its own data.
constexpr const char* licence = "GPL-3.0-or-later";

JsonValue manifest(const Common& common, const std::vector<ReferenceRecord>& records, int digits,
                   const Files& files, const std::filesystem::path& folder) {
  JsonValue out = document_head("manifest", common.command);
  out.set("licence", licence);
  out.set("digits", digits);
  out.set("table", "references.csv");
  out.set("values", json_array(records, [](const ReferenceRecord& record) {
            JsonValue value =
                JsonValue::object({{"name", record.name}, {"file", file_name(record.name) + ".json"}});
            JsonValue certificates = JsonValue::array();
            for (const ReferenceRoute& route : record.routes)
              if (!route.certificate.empty())
                certificates.push(std::string(certificate_folder) + "/" + route.certificate);
            if (!certificates.elements()->empty()) value.set("certificates", std::move(certificates));
            return value;
          }));
  out.set("files", file_list(files, folder));
  return out;
}

ExitCode write_all(const Common& common, const ReferenceOptions& options, int digits) {
  Outputs outputs(common);
  const std::filesystem::path folder = options.out;
  const std::filesystem::path certificates = folder / certificate_folder;
  outputs.folder("--out", options.out, {"manifest.json"});
  outputs.folder("--out", certificates);
  const auto named = reference::named_values();
  const auto scenes = reference::continuous_scenes();
  const std::size_t all = named.size() + reference::continuous_means().size();
  ResultStore store = common.store();
  std::vector<ReferenceRecord> records;
  Files files;
  {
    ProgressDisplay progress(common.quiet);
    for (const reference::NamedValue& value : named) {
      throw_if_interrupted();
      progress.counted(records.size(), all, value.name);
      records.push_back(kept_record(value, digits, store));
    }
    for (const reference::ContinuousScene& scene : scenes) {
      throw_if_interrupted();
      progress.counted(records.size(), all, scene.name);
      for (ReferenceRecord& record : continuous_records(scene)) records.push_back(std::move(record));
      for (auto& file : certificate_files(scene, certificates)) files.push_back(std::move(file));
    }
  }
  say_where_nothing_is_kept(store);
  for (const ReferenceRecord& record : records)
    files.emplace_back(folder / (file_name(record.name) + ".json"),
                       reference_json(record, common.command).pretty() + "\n");
  files.emplace_back(folder / "references.csv", reference_csv(records));
  const std::string contents = manifest(common, records, digits, files, folder).pretty() + "\n";
  files.emplace_back(folder / "manifest.json", contents);
  print_result(common, outputs,
               std::to_string(named.size()) + " values with radii <= 1e-" + std::to_string(digits) +
                   ", and " + std::to_string(records.size() - named.size()) +
                   " means and values of continuous solutions with the radii of their certificates, in " +
                   options.out + "\n",
               contents, std::move(files));
  return ExitCode::done;
}

ExitCode give_reference(const Common& common, const ReferenceOptions& options) {
  const int digits = digits_of(options.digits);
  if (options.all == !options.name.empty())
    throw InputError({.source = "reference",
                      .problem = options.all ? "both a NAME and --all" : "neither a NAME nor --all",
                      .allowed = "one of them; the names are those of radcert list references"});
  if (options.all && options.out.empty())
    throw InputError({.source = "reference", .problem = "--all without --out", .allowed = "--all --out DIR"});
  if (!options.points.empty() && options.curve.empty())
    throw InputError({.source = "--points",
                      .value = options.points,
                      .problem = "is for a curve",
                      .allowed = "--curve FILE.csv of " + std::string(psg10::sphere_over_disk_name)});
  const reference::ContinuousMean* mean = reference::find_continuous_mean(options.name);
  if (!options.all && mean == nullptr && !options.out.empty())
    throw InputError({.source = "reference", .problem = "--out without --all", .allowed = "--json FILE"});
  if (options.all && !options.settings.empty())
    throw InputError({.source = "--set", .value = options.settings.front(), .problem = "is for one family"});
  const auto limit = common.limit_threads();
  if (options.name == psg10::sphere_over_disk_name) return give_sphere_over_disk(common, options, digits);
  if (!options.at.empty() || !options.curve.empty())
    throw InputError({.source = options.at.empty() ? "--curve" : "--at",
                      .value = options.at.empty() ? options.curve : options.at.front(),
                      .problem = "is for " + std::string(psg10::sphere_over_disk_name)});
  if (mean != nullptr) return print_continuous(common, options, *mean, digits);
  return options.all ? write_all(common, options, digits) : print_one(common, options, digits);
}

}  // namespace

void add_reference(Program& program) {
  Subcommand command = program.add("reference", "A reference value as midpoint and radius, by two routes");
  auto options = std::make_shared<ReferenceOptions>();
  command.optional_word("NAME", options->name, "A value or a family of radcert list references");
  command.option("--digits", options->digits,
                 "The radius is at most 10^-DIGITS; from 1 to 1000. Default: " + std::string(not_given),
                 "DIGITS");
  command.repeated("--set", options->settings, "A parameter of a family, as NAME=VALUE; may be repeated",
                   "NAME=VALUE");
  command.flag("--all", options->all, "Every value that has a name of its own, with --out");
  command.option(
      "--out", options->out,
      "With --all: a JSON file a value, references.csv, manifest.json and the certificates; with the "
      "mean or value of a continuous solution its certificates, for radcert check",
      "DIR");
  command.repeated(
      "--at", options->at,
      "sphere_over_disk: B:LATITUDE in radians on the sphere, or D:DISTANCE from the axis on the disk; "
      "may be repeated. The total radiance; at the shadow's rim that of the lit side",
      "PLACE");
  command.option("--curve", options->curve, "sphere_over_disk: both curves, B by latitude and D by distance",
                 "FILE.csv");
  command.option("--points", options->points, "How many points each curve has. Default: 201", "N");
  command.fresh_flag(program.common());
  command.footer(
      "What is printed encloses the value: the radius is rounded up after the midpoint has been rounded. "
      "Radii are "
      "proved,\nthose of sphere_over_disk estimated, as the word beside them says.\n"
      "With --all, values that are finished are kept in $RADCERT_STORE, else ~/.cache/radcert: an "
      "interrupted "
      "run goes on\nthere.");
  command.runs([&common = program.common(), options] { return give_reference(common, *options); });
}

}  // namespace radcert::app
