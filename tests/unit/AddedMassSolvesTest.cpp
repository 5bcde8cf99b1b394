// Strong coupling: one solve of the added mass for each direction in which the body is free.

#include <string>

#include "support/RunCase.h"

namespace mpsDem::test {

namespace {

/// Solves that a step asks for. @param constraints  Of the body. @param inSpace  A cube in 3-D, else a square of the x-y plane.
int solves(std::string const& constraints, bool inSpace)
{
    RunCase run(0.1);
    if (inSpace) run.threeDimensions();
    std::string const range = inSpace ? "zRange (0 1); sideWalls yes; " : "";
    run.write("system/setParticlesDict", "geometry { tank { type polyline; points ((0 1.4 0) (0 0 0) (1 0 0) (1 1.4 0)); " + range +
                                             "} }\nregions ( boxToParticle { box (0 0 0) (1 1 1); } );\nhydrostatic { surface 1; }");
    run.write("constant/rigidBodyProperties", std::string("bodies { block { shape { type box; ") +
                                                  (inSpace ? "min (0.3 0.3 0.3); max (0.7 0.7 0.7)" : "min (0.3 0.3 0); max (0.7 0.7 0)") +
                                                  "; } density 800; " + constraints + "} }");
    run.write("system/mpsSolution", "coupling { type strong; }");
    run.fixedSteps(0.01, 1e-3).make();
    Scene const& scene = run.start();
    Step const step = run.step();

    ParticleSet const& particles = scene.particles();
    Surface const outline = inSpace ? Surface(TriSurface::box("block", Vector::Constant(-0.2), Vector::Constant(0.2)))
                                    : Surface(Polyline("block", {{-0.2, -0.2, 0}, {0.2, -0.2, 0}, {0.2, 0.2, 0}, {-0.2, 0.2, 0}}, true,
                                                       Polyline::FluidSide::Right));
    FluidBodyCoupling coupling(*scene.bodies()[0], 0, outline, particles,
                               FluidBodyCoupling::readControls(Dictionary::fromText("type strong;"), particles.lattice(), true),
                               Vector(0, -9.81, 0), 1000);
    NeighbourList neighbours(scene.fluid()->neighbours().radii(), false);
    neighbours.update(particles);
    int count = 0;
    coupling.load(particles, neighbours, step, [&](Field<Vector> const&, Field<Real>& pressure) {
        pressure.assign(static_cast<std::size_t>(particles.owned().last), 0);
        ++count;
    });
    return count;
}

} // namespace

TEST(AddedMassSolves, areAsManyAsTheFreeDirections)
{
    std::string const point = "pin { sixDoFRigidBodyMotionConstraint point; } ";
    std::string const axis = "about { sixDoFRigidBodyMotionConstraint axis; axis (0 0 1); } ";
    std::string const plane = "along { sixDoFRigidBodyMotionConstraint plane; normal (0 0 1); } ";
    EXPECT_EQ(solves("", true), 6) << "free in 3-D";
    EXPECT_EQ(solves("constraints { " + plane + axis + "} ", true), 3) << "two ways and a turn";
    EXPECT_EQ(solves("constraints { " + point + "} ", true), 3) << "turns only";
    EXPECT_EQ(solves("constraints { " + point + axis + "} ", true), 1) << "a hinge";
    EXPECT_EQ(solves("", false), 3) << "free in 2-D";
}

} // namespace mpsDem::test
