// SPDX-License-Identifier: GPL-3.0-or-later
#include "requests/reference_request.h"

#include <memory>
#include <string>
#include <vector>

#include "c/call.h"
#include "radcert/core/errors.h"
#include "radcert/formats/result/reference_json.h"
#include "radcert/scalar/approximation.h"

/// A reference value with what is read from it.
struct radcert_reference {
  explicit radcert_reference(radcert::ReferenceRecord found)
      : record(std::move(found)),
        decimal(radcert::reference_decimal(record.routes.front().value, record.digits)),
        json(radcert::reference_json(record, "radcert_reference_make").pretty() + "\n") {
    for (const radcert::ReferenceRoute& route : record.routes) routes.push_back(route.how);
    route_pointers = radcert::c::pointers(routes);
    const radcert::Ball& ball = record.routes.front().value;
    const radcert::Approximation rounded = radcert::enclosing(ball);
    value = {.name = record.name.c_str(),
             .midpoint = decimal.midpoint.c_str(),
             .radius = decimal.radius.c_str(),
             .lower = ball.lower_double(),
             .upper = ball.upper_double(),
             .value = rounded.value,
             .error = rounded.radius,
             .guaranteed = record.guaranteed ? 1 : 0,
             .digits = record.digits,
             .formula = record.formula.c_str(),
             .source = record.source.c_str(),
             .route_count = route_pointers.size(),
             .routes = route_pointers.data()};
  }
  radcert_reference(const radcert_reference&) = delete;
  radcert_reference& operator=(const radcert_reference&) = delete;

  radcert::ReferenceRecord record;
  radcert::BallDecimal decimal;
  std::string json;
  std::vector<std::string> routes;
  std::vector<const char*> route_pointers;
  radcert_reference_value value{};
};

namespace radcert::c {

namespace {

std::vector<app::Setting> settings_of(const radcert_parameter* parameters, std::size_t count) {
  if (count > 0) static_cast<void>(given(parameters, "parameters"));
  std::vector<app::Setting> out;
  for (std::size_t i = 0; i < count; ++i) {
    const std::string place = "parameters/" + std::to_string(i);
    out.push_back(
        {text_at(parameters[i].name, place + "/name"), text_at(parameters[i].value, place + "/value")});
  }
  return out;
}

/// All names and pointers to them, for the whole life of the process.
const std::vector<const char*>& names() {
  static const auto* texts = new std::vector<std::string>(app::reference_names());
  static const auto* all = new std::vector<const char*>(pointers(*texts));
  return *all;
}

}  // namespace

}  // namespace radcert::c

extern "C" {

radcert_status radcert_reference_make(const char* name, const radcert_parameter* parameters,
                                      size_t parameter_count, int64_t digits, const radcert_run* run,
                                      radcert_reference** reference) {
  using namespace radcert;
  return c::guarded([&] {
    c::given(reference, "reference");
    const std::string wanted = c::text_at(name, "name");
    const std::vector<app::Setting> settings = c::settings_of(parameters, parameter_count);
    const c::Run how(run);
    std::unique_ptr<radcert_reference> made;
    c::compute(how, [&](app::Progress&) {
      made = std::make_unique<radcert_reference>(app::requested_reference(
          wanted, settings, digits == 0 ? std::nullopt : std::optional<std::int64_t>(digits)));
    });
    *reference = made.release();
  });
}

radcert_status radcert_reference_read(const radcert_reference* reference,
                                      const radcert_reference_value** value) {
  using namespace radcert;
  return c::guarded([&] { c::given(value, "value") = &c::given(reference, "reference").value; });
}

radcert_status radcert_reference_json(const radcert_reference* reference, const char** text) {
  using namespace radcert;
  return c::guarded([&] { c::given(text, "text") = c::given(reference, "reference").json.c_str(); });
}

void radcert_reference_free(radcert_reference* reference) { delete reference; }

radcert_status radcert_reference_names(const char* const** list, size_t* count) {
  using namespace radcert;
  return c::guarded([&] {
    c::given(list, "names");
    c::given(count, "count");
    *list = c::names().data();
    *count = c::names().size();
  });
}
}
