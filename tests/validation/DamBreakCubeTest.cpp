// A cube stands in a dry flume and is hit by the water of a dam that breaks: place of its centre along the flume against an experiment. 3-D.
//
// Flume 0.7 m wide, water 0.4 m deep behind a gate at x = 0, cube of 0.15 m and 800 kg/m3 with its front 1.7 m from the gate: Canelas, Ferreira,
// Crespo and Dominguez (2016), Computer Physics Communications 202, 131-140. The measured values below are from a figure as digitised by D. Adepu
// (github.com/dineshadepu/rfc_old, "Canelas_exp"), every second point or fewer, rounded to 1 mm. The paper itself was not at hand: density and
// friction are those of programs that cite it. They disagree on the length of the reservoir, 3.5 m or 4.5 m. Here it is 1 m: by shallow-water
// theory the end of a reservoir longer than 0.61 m is not felt at the cube before 1.55 s. The gate, lifted at 3.5 m/s, is left out.

#include "validation/BodyPath.h"

namespace mpsDem::test {

namespace {

constexpr Real bound = 0.10; ///< Of the travel.

/// The slow creep before 0.6 s, when the water is not there yet, can be no motion of the cube.
MeasuredPath const& experiment()
{
    static MeasuredPath const path{{0.001, 1.771}, {0.168, 1.777}, {0.325, 1.787}, {0.495, 1.806}, {0.569, 1.813}, {0.608, 1.822},
                                   {0.650, 1.845}, {0.696, 1.861}, {0.751, 1.884}, {0.781, 1.897}, {0.815, 1.920}, {0.847, 1.959},
                                   {0.883, 2.001}, {0.938, 2.060}, {0.974, 2.096}, {1.031, 2.155}, {1.068, 2.227}, {1.123, 2.334},
                                   {1.176, 2.445}, {1.239, 2.582}, {1.277, 2.667}, {1.338, 2.801}, {1.380, 2.870}, {1.419, 2.928},
                                   {1.463, 3.004}, {1.508, 3.088}, {1.548, 3.160}};
    return path;
}

/// @param face  contactFace: what presses on the cube from below while it stands or slides on the floor.
Curve hit(Real spacing, std::string const& face)
{
    RunCase run(spacing);
    run.threeDimensions();
    run.write("constant/transportProperties", "nu 1e-6; rho 1000;");
    run.write("constant/rigidBodyProperties",
              "bodies { cube { shape { type box; min (1.7 0 0.275); max (1.85 0.15 0.425); } density 800; } }");
    run.write("constant/contactProperties", "mu 0.35; e 0.2; youngsModulus 3e9; poissonsRatio 0.3;"); // e is assumed
    run.write("system/mpsSolution", "coupling { type strong; contactFace " + face + "; }");
    run.write("system/setParticlesDict", "geometry { flume { type searchableBox; min (-1 0 0); max (4 0.7 0.7); open (top); } }\n"
                                         "regions ( boxToParticle { box (-1 0 0) (0 0.4 0.7); } );");
    run.control(experiment().end(), 4e-3).make();
    return pathOfBody(run, 0);
}

} // namespace

// Measured: -0.36 at 1.55 s; with 6 spacings -0.30; without friction -0.14; with the set waves -0.65. See etc/doc/validation.md. Nothing looser is asked:
// before 0.8 s the cube has moved less than the bound.
TEST(DamBreakCubeGate, DISABLED_isCarriedAsMeasured)
{
    expectBelow("cube hit by a dam break, 3 spacings: difference / travel", experiment().difference(hit(0.05, "pore")), bound);
}

} // namespace mpsDem::test
