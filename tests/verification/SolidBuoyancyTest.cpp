// Pressure integrated over bodies in still water (eqs 15-16) in 3-D against Archimedes; a body that turns because water stands on one side.

#include <numbers>

#include "support/RunCase.h"

namespace mpsDem::test {

namespace {

constexpr Real weight = 1000 * 9.81; ///< rho g [N/m3]

/// Water 0.48 m deep in a tank of 0.72 x 0.72 m with a body that is held in it.
RunCase& heldInTank(RunCase& run, std::string const& shape)
{
    run.threeDimensions();
    run.write("system/setParticlesDict", "geometry { tank { type searchableBox; min (0 0 0); max (0.72 0.72 0.72); open (top); } }\n"
                                         "regions ( boxToParticle { box (0 0 0) (0.72 0.48 0.72); } );\n");
    return run.write("constant/rigidBodyProperties", "bodies { body { shape { " + shape + " } density 1000; releaseTime 1000; } }");
}

/// Mean load of the second half of 0.3 s.
struct MeanLoad
{
    Vector force = Vector::Zero(), moment = Vector::Zero();
    Real volume = 0;

    [[nodiscard]] Real liftError() const { return force.y() / (weight * volume) - 1; }
};

MeanLoad loadOf(std::string const& shape, Real spacing)
{
    RunCase run(spacing);
    heldInTank(run, shape).fixedSteps(0.3, 1e-3).make();
    MeanLoad mean;
    int count = 0;
    run.run([&](Scene const& scene, Step const& step) {
        if (step.time < 0.15) return;
        mean.force += scene.bodies()[0]->fluid.force;
        mean.moment += scene.bodies()[0]->fluid.moment;
        ++count;
    });
    mean.force /= count;
    mean.moment /= count;
    mean.volume = run.body().massProperties().volume;
    return mean;
}

std::string const box = "type box; min (0.24 0.12 0.24); max (0.48 0.36 0.48);";
std::string const wedge = "type polygon; points ((0.24 0.36 0) (0.48 0.12 0) (0.48 0.36 0)); zRange (0.24 0.48);";
std::string const ball = "type sphere; centre (0.36 0.24 0.36); radius 0.12;";

} // namespace

TEST(SolidBuoyancy, liftsABoxOfEightSpacings) { expectBelow("box, 8 spacings: lift, relative error", loadOf(box, 0.03).liftError(), 0.03); }

TEST(SolidBuoyancy, liftsAWedgeOfEightSpacings)
{
    MeanLoad const load = loadOf(wedge, 0.03);
    expectBelow("wedge, legs of 8 spacings: lift, relative error", load.liftError(), 0.03);
    expectBelow("wedge: force aside over the lift", load.force.z() / load.force.y(), 0.02);
}

TEST(SolidBuoyancy, liftsABallOfEightSpacings)
{
    expectBelow("ball, 8 spacings: lift, relative error", loadOf(ball, 0.03).liftError(), 0.03);
}

TEST(SolidBuoyancyGate, liftsBodiesOfSixteenSpacings)
{
    expectBelow("box, 16 spacings: lift, relative error", loadOf(box, 0.015).liftError(), 0.015);
    expectBelow("wedge, legs of 16 spacings: lift, relative error", loadOf(wedge, 0.015).liftError(), 0.015);
    expectBelow("ball, 16 spacings: lift, relative error", loadOf(ball, 0.015).liftError(), 0.015);
}

} // namespace mpsDem::test
