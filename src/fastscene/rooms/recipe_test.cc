#include "fastscene/rooms/recipe.h"

#include <gtest/gtest.h>

#include <string>

#include "fastscene/base/error.h"
#include "fastscene/rooms/room_type.h"

namespace fastscene {
namespace {

std::string recipe_error(const std::string& text) {
    try {
        const toml::table document = parse_toml(text, "room_types/mine.toml");
        (void)read_recipe(TomlTable(document, "room_types/mine.toml", "", {"recipe"}), "recipe");
    } catch (const Error& e) {
        return e.what();
    }
    return "no error";
}

void expect_recipe_error(const std::string& text, const std::string& error) {
    const std::string found = recipe_error(text);
    EXPECT_TRUE(found.starts_with("room_types/mine.toml:" + error)) << found;
}

TEST(Recipe, ErrorsNameFileLineAndKey) {
    EXPECT_EQ(recipe_error("[[recipe]]\ndo = \"wall\"\nthing = \"wardrobe\"\nprobability = 0.85\n"), "no error");
    expect_recipe_error("[[recipe]]\ndo = \"hover\"\n", "2: [[recipe]]: do: expected one of wall, free");
    expect_recipe_error("[[recipe]]\nthing = \"sofa\"\n", "1: [[recipe]]: do: expected one of wall, free");
    expect_recipe_error("[[recipe]]\ndo = \"wall\"\n",
                        "1: [[recipe]] wall: thing: expected a thing of the catalogue, found none");
    expect_recipe_error("[[recipe]]\ndo = \"wall\"\nthing = \"spaceship\"\n",
                        "3: [[recipe]] wall: thing: expected a thing of the catalogue, found \"spaceship\"");
    expect_recipe_error("[[recipe]]\ndo = \"wall\"\nthing = \"sofa\"\nif_asked = [\"bed\",\n  \"wall\"]\n",
                        "5: [[recipe]] wall: if_asked: expected a thing of the catalogue, found \"wall\"");
    expect_recipe_error("[[recipe]]\ndo = \"wall\"\nthing = \"sofa\"\nseats = 2\n",
                        "4: unknown key \"seats\" in [[recipe]] wall");
    expect_recipe_error("[[recipe]]\ndo = \"wall\"\nthing = \"sofa\"\nprobability = 1.5\n",
                        "4: [[recipe]] wall: probability: expected a number from 0 to 1, found 1.5");
    expect_recipe_error("[[recipe]]\ndo = \"wall\"\nthing = \"sofa\"\ncorner = 1\n",
                        "4: [[recipe]] wall: corner: expected true or false, found 1");
    expect_recipe_error("[[recipe]]\ndo = \"above\"\nthing = \"picture\"\n",
                        "1: [[recipe]] above: at: expected the things at which \"above\" may place its thing");
    expect_recipe_error("[[recipe]]\ndo = \"wall\"\nthing = \"sofa\"\nthen = [\n{ do = \"top\", thing = \"soffa\" }]\n",
                        "5: [[then]] top: thing: expected a thing of the catalogue, found \"soffa\"");
    expect_recipe_error("[[recipe]]\ndo = \"rows\"\nthing = \"cinema_seat\"\npitch_m = 1\nrise_m = 0.9\n",
                        "5: [[recipe]] rows: rise_m: expected a number from 0 to 0.5, found 0.9");
    expect_recipe_error("[[recipe]]\ndo = \"rows\"\nthing = \"cinema_seat\"\nrise_m = 0.3\n",
                        "1: [[recipe]] rows: pitch_m: expected how far apart the rows are that rise_m lifts");
    expect_recipe_error("[[recipe]]\ndo = \"tables\"\nthing = \"dining_table\"\nrise_m = 0.3\n",
                        "4: unknown key \"rise_m\" in [[recipe]] tables");
}

TEST(Recipe, StepsHaveWhatTheirFileSays) {
    const toml::table document = parse_toml(
        "[[recipe]]\ndo = \"wall\"\nthing = \"sideboard\"\nneeded = true\nwindow_pull = -1\nunless_asked = [\"sofa\"]\n"
        "then = [{ do = \"above\", thing = \"mirror\", other = \"picture\", thing_share = 0.25 }]\n",
        "mine.toml");
    const auto steps = read_recipe(TomlTable(document, "mine.toml", "", {"recipe"}), "recipe");
    ASSERT_EQ(steps.size(), 1u);
    EXPECT_EQ(steps[0].thing, "sideboard");
    EXPECT_TRUE(steps[0].needed);
    EXPECT_EQ(steps[0].window_pull, -1.f);
    EXPECT_EQ(steps[0].when.unless_asked, std::vector<std::string>{"sofa"});
    ASSERT_EQ(steps[0].then.size(), 1u);
    EXPECT_EQ(steps[0].then[0].other, "picture");
    EXPECT_EQ(steps[0].then[0].thing_share, 0.25f);
}

TEST(Recipe, ATypeMayShareTheRecipeOfAnother) {
    EXPECT_EQ(&recipe_of("attic"), &room_type("bedroom").recipe);
    EXPECT_EQ(&recipe_of("kitchen"), &room_type("kitchen").recipe);
}

}  // namespace
}  // namespace fastscene
