#include <array>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/Errors.h"
#include "core/OnceLog.h"
#include "scene/InitialState.h"
#include "support/SmallCase.h"

/// Cases that are run with the other number of dimensions than they were made for.

namespace {

using namespace mpsDem;
using test::SmallCase;

// Flat boxes of a 2-D case that was given `dimensions 3`.
TEST(Dimensions, AFlatBoxInSpaceIsToldThatDimensions2MayBeMeant)
{
    std::string const tank = "geometry { tank { type searchableBox; min (0 0 0); max (2 1 2); } }\n";
    std::string const box = "bodies { block { shape { type box; min (1 0.2 0); max (1.2 0.4 0); } density 2000; } }";
    for (auto const& [setup, bodies, place] : std::vector<std::array<std::string, 3>>{
             {"geometry { tank { type searchableBox; min (0 0 0); max (2 1 0); } }", "", "system/setParticlesDict:4"},
             {tank + "regions ( boxToParticle { box (0 0 0) (1 1 0); } );", "", "system/setParticlesDict:5"},
             {tank, box, "constant/rigidBodyProperties:4"}})
    {
        SmallCase const testCase;
        testCase.write("constant/particleProperties", "dimensions 3; spacing 0.05;");
        testCase.write("system/setParticlesDict", setup);
        testCase.remove("constant/rigidBodyProperties");
        if (!bodies.empty()) testCase.write("constant/rigidBodyProperties", bodies);
        try
        {
            static_cast<void>(readSceneDefinition(CaseFolder(testCase.root()), "system/setParticlesDict"));
            ADD_FAILURE() << setup;
        }
        catch (CaseError const& error)
        {
            std::string const text = error.what();
            EXPECT_NE(text.find(place + ": a box without extent in z"), std::string::npos) << text;
            EXPECT_NE(text.find("or dimensions 2 in constant/particleProperties"), std::string::npos) << text;
        }
    }
}

// A 3-D case that was given `dimensions 2`: its boxes are deeper than the 1 m that a 2-D case stands for, or less deep. That is no error, for
// boxes of OpenFOAM's 2-D cases reach over any length in z; one as deep as `thickness`, or a region that reaches further, says the same as z = 0.
TEST(Dimensions, ABoxOfAnotherDepthThanTheThicknessIsWarnedOf)
{
    auto const warningsOf = [](std::string const& particles, std::string const& depthOfTank, std::string const& depthOfWater) {
        SmallCase const testCase;
        testCase.remove("constant/rigidBodyProperties");
        testCase.write("constant/particleProperties", particles);
        testCase.write("system/setParticlesDict", "geometry { tank { type searchableBox; min (0 0 0); max (2 1 " + depthOfTank +
                                                      "); open (top); } }\n" + "regions ( boxToParticle { box (0 0 0) (2 0.5 " +
                                                      depthOfWater + "); } );");
        testing::internal::CaptureStdout();
        forgetShown();
        static_cast<void>(readSceneDefinition(CaseFolder(testCase.root()), "system/setParticlesDict"));
        return testing::internal::GetCapturedStdout();
    };
    std::string const log = warningsOf("spacing 0.05;", "0.6", "0.6");
    for (std::string const place : {"system/setParticlesDict:4", "system/setParticlesDict:5"})
        EXPECT_NE(log.find(place + ": the box reaches over 0.6 m in z, which does not count"), std::string::npos) << log;
    EXPECT_NE(log.find("its thickness is 1 m: is dimensions 3 or another thickness meant"), std::string::npos) << log;
    EXPECT_EQ(warningsOf("spacing 0.05; thickness 0.6;", "0.6", "0.6"), "");
    EXPECT_EQ(warningsOf("spacing 0.05;", "0", "2"), "");
}

} // namespace
