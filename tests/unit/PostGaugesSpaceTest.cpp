#include <cmath>
#include <sstream>

#include <gtest/gtest.h>

#include "postGauges/BodySkin.h"
#include "postGauges/ColourBar.h"
#include "postGauges/ParticleColours.h"
#include "postGauges/Slice.h"
#include "postGauges/SpaceAxes.h"
#include "postGauges/SpaceImage.h"
#include "support/Measured.h"

namespace mpsDem::postGauges {
namespace {

using test::expectBetween;

/// Looks along -z, orthographic: the picture plane is x-y.
CameraControls faceOn()
{
    CameraControls controls;
    controls.azimuth = controls.elevation = 0;
    controls.perspective = false;
    return controls;
}

SpaceBox const unitBox{Vector::Zero(), Vector::Ones()};
std::vector<Colour> const red{{1, 0, 0}}, blue{{0, 0, 1}};

struct Pixel
{
    int red, green, blue;
};

/// Of a picture of 40 x 40 pixels, from the lower left corner.
Pixel pixel(std::string const& bytes, int x, int y)
{
    auto const at = [&](int c) {
        return static_cast<int>(static_cast<unsigned char>(bytes[static_cast<std::size_t>(3 * (40 * y + x) + c)]));
    };
    return {at(0), at(1), at(2)};
}

struct Plate
{
    std::vector<Vector> points;
    std::vector<std::array<int, 3>> triangles{{0, 1, 2}, {0, 2, 3}};

    Plate(Vector const& low, Vector const& high) : points{low, {high.x(), low.y(), low.z()}, high, {low.x(), high.y(), high.z()}} {}
    [[nodiscard]] DrawnMesh mesh(std::vector<Colour> const& colour) const { return {points, {}, triangles, colour}; }
};

/// Polygons of a box, normals outwards.
std::vector<std::vector<Vector>> boxSkin(Vector const& low, Vector const& high)
{
    SpaceBox const box{low, high};
    std::vector<std::vector<Vector>> sides;
    for (auto const& side :
         std::vector<std::array<int, 4>>{{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}})
    {
        sides.emplace_back();
        for (int const corner : side) sides.back().push_back(box.corner(corner));
    }
    return sides;
}

TEST(PostGaugesCamera, HoldsTheBoxInItsWindow)
{
    for (Real const azimuth : {-120.0, -25.0, 0.0, 70.0, 180.0})
        for (Real const elevation : {-30.0, 0.0, 35.0, 90.0})
            for (bool const perspective : {false, true})
            {
                CameraControls controls;
                controls.azimuth = azimuth;
                controls.elevation = elevation;
                controls.perspective = perspective;
                SpaceBox const box{Vector(-1, 2, 3), Vector(4, 3, 3.5)};
                Camera const camera(controls, Vector::UnitY(), box);
                Window const& w = camera.window();
                for (int i = 0; i < 8; ++i)
                {
                    auto const p = camera.project(box.corner(i));
                    EXPECT_TRUE(p.u >= w.xLow - 1e-12 && p.u <= w.xHigh + 1e-12 && p.v >= w.yLow - 1e-12 && p.v <= w.yHigh + 1e-12);
                    Vector const place = camera.place(p.u, p.v, p.nearness), r = box.corner(i) - 0.5 * (box.low + box.high);
                    EXPECT_NEAR((place - Vector(r.dot(camera.right()), r.dot(camera.upward()), r.dot(camera.backward()))).norm(), 0, 1e-12);
                }
            }
}

TEST(PostGaugesCamera, TurnsAboutTheVertical)
{
    CameraControls controls = faceOn();
    Camera const along(controls, Vector::UnitY(), unitBox);
    EXPECT_NEAR((along.right() - Vector::UnitX()).norm(), 0, 1e-12);
    EXPECT_NEAR((along.backward() - Vector::UnitZ()).norm(), 0, 1e-12);
    controls.azimuth = 90;
    Camera const side(controls, Vector::UnitY(), unitBox);
    EXPECT_NEAR((side.backward() - Vector::UnitX()).norm(), 0, 1e-12);
    EXPECT_NEAR((side.right() + Vector::UnitZ()).norm(), 0, 1e-12);
    Camera const heightIsZ(faceOn(), Vector::UnitZ(), unitBox);
    EXPECT_NEAR((heightIsZ.backward() + Vector::UnitY()).norm(), 0, 1e-12);
    EXPECT_NEAR((heightIsZ.upward() - Vector::UnitZ()).norm(), 0, 1e-12);
}

TEST(PostGaugesSpaceImage, NearerThingsHideFartherOnesInAnyOrder)
{
    Plate const far({0, 0, 0.2}, {1, 1, 0.2}), near({0.5, 0, 0.8}, {1, 1, 0.8});
    Camera const camera(faceOn(), Vector::UnitY(), unitBox);
    for (bool const farFirst : {true, false})
    {
        SpaceImage image(camera, camera.window(), 40, 40);
        image.addSolid((farFirst ? far : near).mesh(farFirst ? red : blue), SpaceImage::Faces::Both);
        image.addSolid((farFirst ? near : far).mesh(farFirst ? blue : red), SpaceImage::Faces::Both);
        auto const bytes = image.bytes();
        Pixel const left = pixel(bytes, 5, 20), right = pixel(bytes, 35, 20);
        EXPECT_GT(left.red, 3 * left.blue);
        EXPECT_GT(right.blue, 3 * right.red);
    }
}

TEST(PostGaugesSpaceImage, WallsAreSeenFromTheirFrontOnly)
{
    Plate plate({0, 0, 0.2}, {1, 1, 0.2});
    Camera const camera(faceOn(), Vector::UnitY(), unitBox);
    for (bool const front : {true, false})
    {
        SpaceImage image(camera, camera.window(), 40, 40);
        if (!front) plate.triangles = {{0, 2, 1}, {0, 3, 2}};
        image.addSolid(plate.mesh(red), SpaceImage::Faces::TowardsViewer);
        EXPECT_EQ(pixel(image.bytes(), 20, 20).green > 200, !front) << "white is what is left out";
    }
}

TEST(PostGaugesSpaceImage, SpheresHaveTheirSizeAndDepth)
{
    Camera const camera(faceOn(), Vector::UnitY(), unitBox);
    SpaceImage image(camera, camera.window(), 40, 40);
    image.addSphere({0.5, 0.5, 0.5}, 0.25, red.front());
    Plate const cut({0, 0, 0.7}, {1, 1, 0.7}); // the sphere reaches to 0.75
    image.addSolid(cut.mesh(blue), SpaceImage::Faces::Both);
    auto const bytes = image.bytes();
    EXPECT_GT(pixel(bytes, 20, 20).red, pixel(bytes, 20, 20).blue) << "its top stands out of the plate";
    EXPECT_GT(pixel(bytes, 27, 20).blue, pixel(bytes, 27, 20).red) << "its side lies below";
    int wide = 0;
    for (int x = 0; x < 40; ++x) wide += pixel(bytes, x, 20).red > pixel(bytes, x, 20).blue ? 1 : 0;
    EXPECT_EQ(wide, 12) << "2 sqrt(0.25^2 - 0.2^2) = 0.3 of 40 pixels";
}

TEST(PostGaugesSpaceImage, DeepWaterHidesMore)
{
    Camera const camera(faceOn(), Vector::UnitY(), unitBox);
    Plate const back({0, 0, 0}, {1, 1, 0});
    auto const redBehind = [&](Real thickness) {
        SpaceImage image(camera, camera.window(), 40, 40);
        image.addSolid(back.mesh(red), SpaceImage::Faces::Both);
        SurfaceMesh const box = smoothSkin(boxSkin({0.1, 0.1, 0.5 - thickness}, {0.9, 0.9, 0.5}));
        image.addWater({box.points, box.normals, box.triangles, blue}, {0.2, 3});
        return pixel(image.bytes(), 20, 20).red / 255.0;
    };
    // What is left of the plate is (1 - opacity) exp(-absorption * thickness), beside a constant part of the light on the water.
    Real const thin = redBehind(0.05), middle = redBehind(0.2), thick = redBehind(0.45);
    Real const expected = (std::exp(-0.15) - std::exp(-0.6)) / (std::exp(-0.15) - std::exp(-1.35));
    expectBetween("share of light lost between two thicknesses, less the law", (thin - middle) / (thin - thick) - expected, -0.02, 0.02);
}

TEST(PostGaugesBodySkin, PlaneCutsABoxIntoARectangle)
{
    auto const chains = cutChains(boxSkin({0, 0, 0}, {2, 1, 1}), {Vector(0, 0, 0.3), Vector::UnitZ()});
    ASSERT_EQ(chains.size(), 1U);
    Real area = 0;
    auto const& chain = chains.front();
    for (std::size_t i = 0; i < chain.size(); ++i) area += 0.5 * chain[i].cross(chain[(i + 1) % chain.size()]).dot(Vector::UnitZ());
    EXPECT_NEAR(std::abs(area), 2, 1e-12);
    EXPECT_TRUE(cutChains(boxSkin({0, 0, 0}, {2, 1, 1}), {Vector(0, 0, 3), Vector::UnitZ()}).empty());
    auto two = boxSkin({0, 0, 0}, {1, 1, 1});
    for (auto const& side : boxSkin({3, 0, 0}, {4, 1, 1})) two.push_back(side);
    EXPECT_EQ(cutChains(two, {Vector(0, 0.5, 0), Vector::UnitY()}).size(), 2U);
}

TEST(PostGaugesBodySkin, EdgesOfABoxStaySharp)
{
    SurfaceMesh const skin = smoothSkin(boxSkin({0, 0, 0}, {1, 2, 3}));
    ASSERT_EQ(skin.triangles.size(), 12U);
    EXPECT_NEAR(skin.volume(), 6, 1e-12);
    for (Vector const& normal : skin.normals) EXPECT_NEAR(normal.cwiseAbs().maxCoeff(), 1, 1e-12);
}

/// Particles in layers z = 0.5, 1.5 ... 7.5 of spacing 1.
ParticleFrame layers()
{
    ParticleFrame frame;
    for (int k = 0; k < 8; ++k) frame.data.position.emplace_back(1, 2, 7.5 - k);
    frame.type.assign(8, 0);
    return frame;
}

TEST(PostGaugesSlice, ShowsTheMiddleFarParticlesFirst)
{
    PostCase postCase;
    postCase.spacing = 1;
    postCase.dimensions = 3;
    Slice const slice = Slice::read(Dictionary::fromText("")).completed(postCase, layers());
    EXPECT_EQ(slice.particles(layers()), (std::vector<std::size_t>{4, 3})) << "z = 3.5, then 4.5";
    EXPECT_EQ(slice.place({1, 2, 3}), Vector(1, 2, 3));
    EXPECT_EQ(slice.xLabel(), "x [m]");
    postCase.dimensions = 2;
    EXPECT_EQ(Slice::read(Dictionary::fromText("")).completed(postCase, layers()).particles(layers()).size(), 8U);
}

TEST(PostGaugesSlice, LooksAgainstItsNormal)
{
    PostCase postCase;
    postCase.spacing = 1;
    postCase.dimensions = 3;
    Slice const side =
        Slice::read(Dictionary::fromText("slice { normal (2 0 0); point (1 0 0); thickness 0.5; }")).completed(postCase, layers());
    EXPECT_EQ(side.particles(layers()).size(), 8U);
    EXPECT_NEAR((side.place({1, 2, 3}) - Vector(-3, 2, 1)).norm(), 0, 1e-12) << "z runs to the left";
    EXPECT_EQ(side.xLabel(), "z [m]");
    EXPECT_EQ(side.tics({-3, 0, 0, 1}).substr(0, 16), "set xtics ('3' -");
    Slice const range = Slice::read(Dictionary::fromText("slice (3 5);")).completed(postCase, layers());
    EXPECT_EQ(range.particles(layers()).size(), 2U);
    EXPECT_THROW((void)Slice::read(Dictionary::fromText("slice { normal (0 0 0); }")), CaseError);
}

TEST(PostGaugesColourBar, ColoursAndRange)
{
    ColourBar bar;
    bar.palette = "grey";
    RangeFinder finder;
    EXPECT_TRUE(finder.empty());
    finder.add({0.1, 7.3, 3});
    finder.set(bar, std::nullopt, true);
    EXPECT_EQ(bar.range, std::pair(0.0, 8.0));
    EXPECT_NEAR(bar.colour(4)[0], (0x20 + 0xf0) / 510.0, 1e-6) << "half-way";
    EXPECT_EQ(bar.colour(99), paletteColour("grey", 1));
    EXPECT_FALSE(bar.above);
    finder.set(bar, std::pair(0.0, 5.0), true);
    EXPECT_TRUE(bar.above);
    EXPECT_FALSE(bar.below);
    EXPECT_EQ(niceTics(0, 1.6, 4), (std::vector<Real>{0, 0.5, 1, 1.5}));
}

/// How often the word stands in the text.
int countOf(std::string const& text, std::string const& word)
{
    int count = 0;
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++count;
    return count;
}

TEST(PostGaugesColourBar, HasAsManyNumbersAsThereIsRoomFor)
{
    ColourBar bar;
    bar.range = {0.03, 0.11};
    bar.above = true;
    for (auto const& [window, numbers] : std::vector<std::pair<Window, int>>{{{0, 10, 0, 10}, 9}, {{0, 10, 0, 2}, 4}, {{0, 10, 0, 0.6}, 1}})
    {
        SheetLayout const sheet = layOut(1, 1, window, 1200, 1200, 13, 110);
        std::ostringstream script;
        bar.writeScale(script, sheet, 13);
        EXPECT_EQ(countOf(script.str(), "' 0.") - 1, numbers) << script.str(); // one of them has no text
        EXPECT_EQ(countOf(script.str(), "'\u2265 0.11' 0.11"), 1) << "the end that cuts values is always told";
    }
    EXPECT_EQ(ticsAbove(10, 13), 1);
    EXPECT_EQ(ticsAbove(4000, 13), 10);
}

} // namespace
} // namespace mpsDem::postGauges
