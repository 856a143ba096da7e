// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/schema/schemas.h"

#include <gtest/gtest.h>

#include "radcert/formats/json/json_document.h"
#include "radcert/surface/catalogue.h"

namespace radcert {
namespace {

TEST(Schemas, AreJsonWithTheNameOfTheirFileType) {
  for (const Schema& schema : schemas()) {
    const JsonValue json = parse_json(schema.text, std::string(schema.name));
    EXPECT_EQ(*json.find("properties")->find("schema")->find("const")->string(),
              "radcert/" + std::string(schema.name) + "/1");
    // A relative $id would become the base of every $ref beside it, which validators resolve differently.
    EXPECT_EQ(json.find("$id"), nullptr);
    EXPECT_EQ(find_schema(schema.name), &schema);
  }
  EXPECT_EQ(find_schema("problems"), nullptr);
}

TEST(ProblemSchema, NamesTheSurfacesOfTheCatalogueAndTheirParameters) {
  const std::string_view text = find_schema("problem")->text;
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
      EXPECT_NE(text.find("\"" + parameter.name + "\": {"), std::string_view::npos) << parameter.name;
  }
  EXPECT_EQ(named, there);
}

}  // namespace
}  // namespace radcert
