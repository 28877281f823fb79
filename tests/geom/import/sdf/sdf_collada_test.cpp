#include "import/sdf/sdf_collada.h"

#include <gtest/gtest.h>

#include "support/collada_text.h"
#include "support/reading.h"

namespace geom {
namespace {

using support::collada;

const std::string kUp = "<up_axis>Z_UP</up_axis>";

std::string problem(const std::string& text) {
  const std::string source = "m.dae";
  const XmlElement root = parse_xml(text, source);
  return support::refusal_of([&] { require_simulators_agree({&root, &source}); });
}

// The file with `from` replaced by `to` where it stands first.
std::string problem_with(const std::string& from, const std::string& to) {
  std::string text = collada();
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return problem(text.replace(at, from.size(), to));
}

TEST(SdfCollada, SimulatorsAgreeOnZUpInAnyUnit) {
  EXPECT_EQ(problem(collada()), "");
  EXPECT_EQ(problem(collada("<unit name='inch' meter='0.0254'/><up_axis> Z_UP\n</up_axis>")), "");
}

TEST(SdfCollada, TheyDoNotOnOtherAxesNorOnNone) {
  EXPECT_EQ(problem(collada("<up_axis>Y_UP</up_axis>")),
            "m.dae:3: expected <up_axis>Z_UP</up_axis>: write the mesh with z up, found Y_UP");
  for (const char* asset : {"", "<up_axis/>", "<up_axis>X_UP</up_axis>", "<up_axis>z_up</up_axis>",
                            "<x:up_axis xmlns:x='u'>Z_UP</x:up_axis>"}) {
    EXPECT_NE(problem(collada(asset)), "") << asset;
  }
  EXPECT_NE(problem(collada(kUp + kUp)), "") << "twice";
  EXPECT_NE(problem("<COLLADA/>"), "");
  EXPECT_NE(problem("<collada>" + kUp + "</collada>"), "");
}

TEST(SdfCollada, AxesAndUnitsOfPartsAreReadByNoneAlike) {
  EXPECT_NE(problem_with("<geometry id=\"g\">",
                         "<geometry id=\"g\"><asset><up_axis>Y_UP</up_axis></asset>"),
            "");
  EXPECT_NE(problem(collada(kUp + "<unit meter='1'/><unit meter='2'/>")), "");
}

TEST(SdfCollada, NodesAreOneMatrixOrMoveTurnAndScaleInThisOrder) {
  const std::string matrix = "<matrix>1 0 0 5 0 1 0 0 0 0 1 0 0 0 0 1</matrix>";
  const std::string move = "<translate>1 2 3</translate>";
  const std::string turn = "<rotate>0 0 1 90</rotate>";
  const std::string scale = "<scale>1 2 1</scale>";
  for (const std::string& place :
       {matrix, move, turn, scale, turn + turn, move + scale, move + turn + turn + turn + scale,
        turn + scale, std::string("<rotate>0 0 0 0</rotate>")}) {
    EXPECT_EQ(problem(collada(kUp, place)), "") << place;
  }
  for (const std::string& place :
       {matrix + matrix, matrix + move, move + matrix, turn + move, scale + turn, scale + move,
        move + move, scale + scale, scale + matrix,
        std::string("<lookat>0 0 0 1 0 0 0 0 1</lookat>"), std::string("<rotate>0 0 2 90</rotate>"),
        std::string("<rotate>0 0 1</rotate>"), std::string("<rotate>0 0 nan 1</rotate>")}) {
    EXPECT_NE(problem(collada(kUp, place)), "") << place;
  }
}

TEST(SdfCollada, WhatMovesOrStandsInTwoPlacesIsShownInDifferentWays) {
  for (const char* place : {"<instance_geometry url='#g'/>", "<instance_node url='#n'/>",
                            "<instance_node url='#gone'/>", "<instance_controller url='#c'/>"}) {
    EXPECT_NE(problem(collada(kUp, place)), "") << place;
  }
  EXPECT_NE(problem_with("<library_visual_scenes>",
                         "<library_animations><animation id='z'/></library_animations>"
                         "<library_visual_scenes>"),
            "");
  EXPECT_EQ(problem_with("<library_visual_scenes>", "<library_animations/><library_visual_scenes>"),
            "");
}

TEST(SdfCollada, PositionsAreXYZInThreesFromTheFirstNumber) {
  for (const auto& [from, to] :
       {std::pair<const char*, const char*>{"stride=\"3\"", "stride=\"4\""},
        {"stride=\"3\"", ""},
        {"stride=\"3\"", "stride=\"3\" offset=\"1\""},
        {"name=\"X\"", "name=\"Y\""},
        {"name=\"X\"", ""},
        {"source=\"#a\"", "source=\"#b\""},
        {"<float_array", "<float_array id=\"b\"/><float_array"},
        {"source=\"#p\"", "source=\"#q\""}}) {
    EXPECT_NE(problem_with(from, to), "") << to;
  }
  EXPECT_EQ(problem_with("stride=\"3\"", "stride=\"3\" offset=\"0\""), "");
}

TEST(SdfCollada, IdsOfTrianglesStandOnce) {
  EXPECT_NE(problem_with("<vertices id=\"v\">", "<vertices id=\"p\">"), "");
  EXPECT_NE(problem_with("<geometry id=\"g\">", "<geometry id=\"g\"/><geometry id=\"g\">"), "");
  EXPECT_EQ(problem_with("<node id=\"n\">", "<node id=\"g\">"), "") << "no one looks for nodes";
}

TEST(SdfCollada, WhatProgramsAddForThemselvesDoesNotMatter) {
  EXPECT_EQ(problem_with("<library_visual_scenes>",
                         "<library_physics_models><physics_model><rigid_body><shape>"
                         "<instance_geometry url='#g'/></shape></rigid_body></physics_model>"
                         "</library_physics_models><library_visual_scenes>"),
            "");
  EXPECT_EQ(problem(collada(kUp, "<extra><x:y xmlns:x='u'/><up_axis>Y_UP</up_axis></extra>")), "");
  EXPECT_NE(problem(collada(kUp, "<x:node xmlns:x='u'/>")), "");
}

// As SketchUp writes it: a library of nodes, each placed once.
TEST(SdfCollada, ANodeOfTheLibraryMayStandInOnePlace) {
  const auto placed = [](const std::string& scene, const std::string& more = "") {
    std::string text = collada(kUp);
    const std::string node = "<instance_geometry url=\"#g\"/></node>";
    text.replace(text.find(node), node.size(), scene + "</node>");
    const std::string library = "<library_visual_scenes>";
    return problem(text.insert(text.find(library),
                               "<library_nodes><node id='k'><instance_geometry "
                               "url='#g'/></node>" +
                                   more + "</library_nodes>"));
  };
  EXPECT_EQ(placed("<instance_node url='#k'/>"), "");
  EXPECT_NE(placed("<instance_node url='#k'/><instance_node url='#k'/>"), "");
  EXPECT_NE(placed("<instance_node url='#k'/></node><node><instance_node url='#k'/>"), "");
  EXPECT_NE(placed("<instance_node url='#k'/>", "<node id='k'/>"), "") << "which of the two?";
  EXPECT_NE(placed("<instance_node url='#n'/>"), "") << "it is in the scene already";
}

}  // namespace
}  // namespace geom
