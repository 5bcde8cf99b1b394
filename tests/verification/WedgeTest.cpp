// The wedge of Heinrich (1992) per metre of width: 0.5 m high, 2036 kg/m3, on a ramp of 45 degrees, its top 0.01 m below 1 m of water.

#include <array>
#include <cmath>

#include "support/Curve.h"
#include "support/RunCase.h"

namespace mpsDem::test {

namespace {

void writeWedge(RunCase& run, std::string const& motion, Real length)
{
    std::string const end = std::to_string(length);
    run.write("system/setParticlesDict", "geometry { ramp { type polyline; points ((-0.6 1.6 0) (1 0 0)); }\n"
                                         " tank { type polyline; points ((1 0 0) (" +
                                             end + " 0 0) (" + end +
                                             " 1.6 0)); } }\n"
                                             "regions ( boxToParticle { box (-0.6 0 0) (" +
                                             end + " 1 0); } );\nhydrostatic { surface 1; }");
    run.write("constant/rigidBodyProperties",
              "bodies { slide { shape { type polygon; points ((0.01 0.99 0) (0.51 0.49 0) (0.51 0.99 0)); } density 2036; " + motion +
                  " } }");
}

void writeContact(RunCase& run)
{
    run.write("constant/contactProperties",
              "mu 0.0104724; e 0.2;\n"
              "stoppers { foot { type latch; body slide; point (0.95 0.05 0); normal (-0.70710678 0.70710678 0); } }");
}

/// The water settles so long around the held wedge [s].
constexpr Real hold = 0.2;

/// Fall of the centre of the wedge over the time since its release, to its stop 5 cm above the floor, and the noise of its force.
struct Fall
{
    Curve z;
    Real stop = 0, jump = 0;
};

Fall fall(Real spacing, std::string const& set)
{
    RunCase run(spacing);
    writeWedge(run, "releaseTime 0.2;", 4);
    writeContact(run);
    run.write("system/mpsSolution", "coupling { type strong; }");
    run.write("system/mpsSchemes", "schemeSet " + set + ";");
    run.control(1.1 + hold, 1e-3).make();
    Fall result;
    Jump jump;
    Series force;
    Scene& scene = run.start();
    RigidBody const& slide = *scene.bodies()[0];
    Real const top = slide.centre().y();
    while (scene.time().running() && result.stop == 0)
    {
        Real const time = run.step().time - hold;
        if (time < 0) continue;
        result.z.add(time, top - slide.centre().y());
        if (slide.locked())
        {
            result.stop = time;
            continue;
        }
        jump.add(slide.fluid.force);
        force.add(slide.fluid.force.norm());
    }
    result.jump = jump.value() / force.mean();
    return result;
}

constexpr int samples = 9;

/// The times at which paths are compared: 0.1 .. 0.9 s after the release.
Real sampleTime(int k) { return 0.1 * (k + 1); }

/// Falls at these times [m], and the time of the stop [s].
struct Reference
{
    std::array<Real, samples> z;
    Real stop;
};

/// This program at 0.02 m with the set standard: WedgeGate.
constexpr Reference medium{{.0094, .0361, .0764, .1271, .1835, .2434, .3058, .3700, .4364}, .906};

Reference sampled(Fall const& found)
{
    Reference result{{}, found.stop};
    for (int k = 0; k < samples; ++k) result.z[k] = found.z.at(sampleTime(k));
    return result;
}

/// Largest difference of two falls at the sample times [m].
Real largestDifference(Reference const& one, Reference const& other)
{
    Real worst = 0;
    for (int k = 0; k < samples; ++k) worst = std::max(worst, std::abs(one.z[k] - other.z[k]));
    return worst;
}

void compare(std::string const& name, Fall const& found, Reference const& reference)
{
    Reference const here = sampled(found);
    for (int k = 0; k < samples; ++k)
        std::printf("    t = %.1f s: z = %.4f m, reference %.4f m\n", sampleTime(k), here.z[k], reference.z[k]);
    expectBelow(name + ": z(t), largest difference over 0.49 m", largestDifference(here, reference) / 0.49, 0.03);
    expectBelow(name + ": time of the stop, relative difference", found.stop / reference.stop - 1, 0.03);
    expectBelow(name + ": step jump of the force over its mean", found.jump, 0.12);
}

/// Values at spacings that are halved have an order only where both differences are of one sign.
void printOrder(char const* what, std::array<Real, 3> const& value)
{
    Real const ratio = (value[1] - value[0]) / (value[2] - value[1]);
    if (ratio > 0)
        std::printf("    observed order of %s: %.2f\n", what, std::log2(ratio));
    else
        std::printf("    no order of %s: its differences, %g and %g, change their sign\n", what, value[1] - value[0], value[2] - value[1]);
}

/// The path must lie in the envelope that a motion with one degree of freedom gives for any plausible added mass and drag: of the width
/// between its lower and its upper curve the least and the largest part that lies below the path, each 0.05 s up to the stop.
void expectInEnvelope(std::string const& name, Fall const& found)
{
    Curve const low = reference("wedgeEnvelope.dat", "t", "low"), high = reference("wedgeEnvelope.dat", "t", "high");
    Series share;
    int rows = 0;
    for (auto const& [time, least] : low.points())
    {
        Real const width = high.at(time) - least;
        if (time > found.stop || width <= 0) continue;
        share.add((found.z.at(time) - least) / width);
        ++rows;
    }
    ASSERT_GT(rows, 15);
    expectBetween(name + ": least place in the envelope", share.least(), 0, 1);
    expectBetween(name + ": largest place in the envelope", share.largest(), 0, 1);
}

} // namespace

// The exact force is that on the vertical side: rho g (0.51^2 - 0.01^2)/2 to the left; the contact face is dry.
TEST(Wedge, heldInStillWaterFeelsHydrostaticPressure)
{
    RunCase run(0.04);
    writeWedge(run, "releaseTime 1000;", 2.2);
    run.fixedSteps(1, 2e-3).make();
    Series force;
    Jump jump;
    run.run([&](Scene const& scene, Step const& step) {
        if (step.time < 0.5) return;
        force.add(scene.bodies()[0]->fluid.force.x());
        jump.add(scene.bodies()[0]->fluid.force);
    });
    Real const exact = -0.5 * 1000 * 9.81 * (0.51 * 0.51 - 0.01 * 0.01);
    expectBelow("held wedge, spacing 0.04: F_x, relative error", force.mean() / exact - 1, 0.025);
    expectBelow("held wedge, spacing 0.04: step jump of the force over F_x", jump.value() / std::abs(exact), 0.02);
}

TEST(Wedge, slidesAsAtTwiceTheResolution)
{
    Fall const found = fall(0.04, "standard");
    compare("sliding wedge, spacing 0.04", found, medium);
    expectInEnvelope("sliding wedge, spacing 0.04", found);
}

namespace {

void expectConvergence(std::string const& set)
{
    std::array<Real, 3> const spacings{0.04, 0.02, 0.01};
    std::array<Fall, 3> falls;
    std::array<Reference, 3> found;
    for (std::size_t k = 0; k < falls.size(); ++k)
    {
        falls[k] = fall(spacings[k], set);
        found[k] = sampled(falls[k]);
    }
    std::printf("    z [m] at the spacings  %12g %12g %12g\n", spacings[0], spacings[1], spacings[2]);
    for (int k = 0; k < samples; ++k)
        std::printf("    t = %.1f s              %12.4f %12.4f %12.4f\n", sampleTime(k), found[0].z[k], found[1].z[k], found[2].z[k]);
    std::printf("    stop [s]               %12.4f %12.4f %12.4f\n", found[0].stop, found[1].stop, found[2].stop);
    Real const coarse = largestDifference(found[0], found[1]), fine = largestDifference(found[1], found[2]);
    std::printf("    largest difference of z: %.4f m from 0.04 to 0.02, %.4f m from 0.02 to 0.01\n", coarse, fine);
    printOrder("z(0.5 s)", {found[0].z[4], found[1].z[4], found[2].z[4]});
    printOrder("the stop", {found[0].stop, found[1].stop, found[2].stop});

    std::string const name = "sliding wedge, " + set;
    compare(name + ", spacing 0.02 against 0.01", falls[1], found[2]);
    expectBelow(name + ": difference 0.02 - 0.01 over 0.04 - 0.02", fine / coarse, 1);
    expectBelow(name + ": difference 0.02 - 0.01 over 0.04 - 0.02 of z(0.5 s)",
                (found[2].z[4] - found[1].z[4]) / (found[1].z[4] - found[0].z[4]), std::sqrt(0.5));
    expectInEnvelope(name + ", spacing 0.02", falls[1]);
    expectInEnvelope(name + ", spacing 0.01", falls[2]);
}

} // namespace

// Six minutes of one core each.
TEST(WedgeGate, convergesWithTheSpacing) { expectConvergence("standard"); }

TEST(WedgeGate, convergesWithTheSpacingAndTheSchemesForWaves) { expectConvergence("waves"); }

} // namespace mpsDem::test
