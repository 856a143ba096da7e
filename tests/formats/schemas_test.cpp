// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/schema/schemas.h"

#include <gtest/gtest.h>

#include "radcert/core/contract.h"
#include "radcert/formats/json/json_document.h"
#include "radcert/surface/catalogue.h"

namespace radcert {
namespace {

TEST(Schemas, AreJsonWithTheNameOfTheirFileType) {
  for (const std::string& name : schema_names()) {
    const std::string text = schema_text(name);
    const JsonValue json = parse_json(text, name);
    EXPECT_EQ(*json.find("properties")->find("schema")->find("const")->string(), "radcert/" + name + "/1");
    for (const char* gap : {"$catalogue", "$part"}) EXPECT_EQ(text.find(gap), std::string::npos) << name;
    // A relative $id would become the base of every $ref beside it, which validators resolve differently.
    EXPECT_EQ(json.find("$id"), nullptr);
  }
  EXPECT_THROW((void)schema_text("problems"), ContractViolation);
}

TEST(ProblemSchema, NamesTheSurfacesOfTheCatalogueAndTheirParameters) {
  const std::string text = schema_text("problem");
  const JsonValue json = parse_json(text, "");
  std::vector<std::string> named;
  const JsonValue& surface = *json.find("properties")->find("surface");
  for (const JsonValue& name : *surface.find("properties")->find("name")->find("enum")->elements())
    named.push_back(*name.string());
  std::vector<std::string> there;
  for (const SurfaceDescription& description : surface_catalogue()) {
    if (!description.unoccluded) continue;  // no problem can name it
    there.push_back(description.name);
    for (const ParameterDescription& parameter : description.parameters)
      EXPECT_NE(text.find("\"" + parameter.name + "\": {"), std::string::npos) << parameter.name;
  }
  EXPECT_EQ(named, there);
}

TEST(ExperimentSchema, HasThePartsOfAProblemOnceAndInLists) {
  const JsonValue problem = parse_json(schema_text("problem"), "");
  const JsonValue experiment = parse_json(schema_text("experiment"), "");
  // Of an experiment as a whole: labels and fit_from beside base and vary. Of a problem alone: emission,
  // guarantee, iterated.
  const std::vector<std::string> of_the_whole = {"schema", "emission", "guarantee",
                                                 "label",  "fit_from", "iterated"};
  std::vector<std::string> parts;
  for (const auto& [key, part] : *problem.find("properties")->members())
    if (std::find(of_the_whole.begin(), of_the_whole.end(), key) == of_the_whole.end()) parts.push_back(key);
  for (const char* place : {"base", "vary"}) {
    std::vector<std::string> keys;
    for (const auto& [key, value] :
         *experiment.find("properties")->find(place)->find("properties")->members()) {
      keys.push_back(key);
      const JsonValue& part = place == std::string("base") ? value : *value.find("items");
      EXPECT_EQ(part.compact(), problem.find("properties")->find(key)->compact());
    }
    EXPECT_EQ(keys, parts) << place;
  }
}

}  // namespace
}  // namespace radcert
