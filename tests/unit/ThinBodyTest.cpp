#include <string>

#include <gtest/gtest.h>

#include "core/Log.h"
#include "scene/InitialReport.h"
#include "support/RunCase.h"

namespace mpsDem::test {

namespace {

/// What setParticles says of a body in water of spacing 0.05 m.
std::string logFor(std::string const& shape)
{
    RunCase run(0.05);
    run.write("system/setParticlesDict", "geometry { tank { type polyline; points ((0 1.4 0) (0 0 0) (2 0 0) (2 1.4 0)); } }\n"
                                         "regions ( boxToParticle { box (0 0 0) (2 1 0); } );");
    run.write("constant/rigidBodyProperties", "bodies { plate { shape { " + shape + " } density 2000; } }");
    run.control(1, 1e-3);
    SceneDefinition const definition = readSceneDefinition(CaseFolder(run.root()), "system/setParticlesDict");
    InitialScene const scene = makeInitialScene(definition);
    muteLog(false);
    testing::internal::CaptureStdout();
    static_cast<void>(initialReport(definition, scene, {}));
    muteLog(true);
    return testing::internal::GetCapturedStdout();
}

} // namespace

TEST(ThinBody, isWarnedOfBelowTwoSpacings)
{
    std::string const log = logFor("type box; min (0.5 0.5 0); max (1.3 0.575 0);");
    EXPECT_NE(log.find("\"plate\" is 1.5 spacings thick"), std::string::npos) << log;
    EXPECT_EQ(logFor("type box; min (0.5 0.5 0); max (1.3 0.6 0);").find("spacings thick"), std::string::npos);
}

// Its least width counts, whatever box it fills.
TEST(ThinBody, isFoundWhereItStandsAskew)
{
    std::string const log = logFor("type polygon; points ((0.5 0.4 0) (0.9 0.8 0) (0.85 0.85 0) (0.45 0.45 0));");
    EXPECT_NE(log.find("\"plate\" is 1.41421 spacings thick"), std::string::npos) << log;
}

} // namespace mpsDem::test
