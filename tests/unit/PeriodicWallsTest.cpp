// Walls that end at a periodic border: the images of their own particles go on there, and nothing else does.

#include "core/Errors.h"
#include "support/RunCase.h"

namespace mpsDem::test {

namespace {

/// Channel of 10 x 20 particles between two plates, periodic in x.
void writeChannel(RunCase& run)
{
    run.gravity(Vector::Zero());
    run.write("system/setParticlesDict", "geometry { below { type searchablePlate; origin (0 0 0); span (0.5 0 0); }\n"
                                         " above { type searchablePlate; origin (0.5 1 0); span (-0.5 0 0); } }\n"
                                         "regions ( boxToParticle { box (0 0 0) (0.5 1 0); } );\nhydrostatic { active no; }");
    run.write("system/mpsSchemes", "freeSurfaceSchemes { type none; } cyclic { min (0 0 0); max (0.5 0 0); }");
    run.fixedSteps(1, 1e-3);
}

} // namespace

TEST(PeriodicWalls, haveNoParticlesBeyondTheBox)
{
    RunCase run(0.05);
    writeChannel(run);
    run.make();
    run.start();
    EXPECT_EQ(run.particles().wall().size(), 2 * 10);
    EXPECT_EQ(run.particles().ghost().size(), 2 * 2 * 10);
}

TEST(PeriodicWalls, giveTheFluidTheLatticeBesideThem)
{
    RunCase run(0.05);
    writeChannel(run);
    run.make();
    run.start();
    run.step();
    Real density = 0, surfaceVector = 0;
    for (int const i : run.particles().fluid())
    {
        density = std::max(density, std::abs(run.particles().n[i] - 1));
        surfaceVector = std::max(surfaceVector, run.particles().F[i].norm());
    }
    expectBelow("periodic channel at rest: largest |n/n0 - 1|", density, 1e-12);
    expectBelow("periodic channel at rest: largest |F|", surfaceVector, 1e-12);
}

TEST(PeriodicWalls, areWettedByTheFreeSurfaceOnBothSidesOfTheBorder)
{
    RunCase run(0.05);
    run.threeDimensions();
    run.write("system/setParticlesDict",
              "geometry { basin { type polyline; points ((-0.3 0.9 0) (0.6 0 0) (1 0 0) (1 0.9 0)); zRange (0 0.3); } }\n"
              "regions ( boxToParticle { box (-0.3 0 0) (1 0.6 0.3); } );\nhydrostatic { surface 0.6; }");
    run.write("system/mpsSchemes", "cyclic { min (0 0 0); max (0 0 0.3); }");
    run.fixedSteps(0.1, 2e-3).make();
    run.run(); // the matrix of eq 8 must be symmetric: a wall and its image carry pressure both, or neither
    expectBelow("basin, periodic across: kinetic energy [J]", kineticEnergy(run.scene()), 1);
}

TEST(PeriodicWalls, madeForAnotherBoxAreRefused)
{
    RunCase run(0.05);
    writeChannel(run);
    run.make();
    run.write("system/mpsSchemes", "freeSurfaceSchemes { type none; } cyclic { min (0 0 0); max (0.4 0 0); }");
    try
    {
        run.start();
        FAIL() << "boundary particles outside of the box";
    }
    catch (CaseError const& error)
    {
        EXPECT_EQ(error.code(), ExitCode::BadInput);
        EXPECT_NE(std::string(error.what()).find("outside of the periodic box"), std::string::npos) << error.what();
    }
}

} // namespace mpsDem::test
