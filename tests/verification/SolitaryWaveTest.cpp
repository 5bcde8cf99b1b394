// A solitary wave runs along a channel of even depth h with its height H and the celerity of Grimshaw's third-order solution.
//
// With e = H/h, a = sqrt(3e/4)(1 - 5e/8 + 71e^2/128), s = 1/cosh(a x/h), t = tanh(a x/h), y from the bottom (Grimshaw 1971, J. Fluid
// Mech. 46; formulas as in Lee, Yates & Wu 1989, J. Fluid Mech. 199):
//     eta/h = e s^2 - 3/4 e^2 s^2 t^2 + e^3 (5/8 s^2 t^2 - 101/80 s^4 t^2),   c^2 = g h (1 + e - e^2/20 - 3 e^3/70).

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "support/RunCase.h"
#include "support/WaveCrest.h"

namespace mpsDem::test {

namespace {

constexpr Real g = 9.81, depth = 0.3, e = 0.3;
constexpr Real start = 2.4; ///< Place of the crest at first, and its distance from the end at last [m].

Real const celerity = solitaryCelerity(depth, e* depth);

/// Shape s^2 of the wave at a distance x from its crest [m].
Real shape(Real x)
{
    Real const alpha = std::sqrt(0.75 * e) * (1 - 0.625 * e + 71.0 / 128 * e * e);
    return 1 / std::pow(std::cosh(alpha * x / depth), 2);
}

Real elevation(Real x)
{
    Real const s2 = shape(x), t2 = 1 - s2;
    return depth * (e * s2 - 0.75 * e * e * s2 * t2 + e * e * e * (0.625 * s2 * t2 - 101.0 / 80 * s2 * s2 * t2));
}

/// Coefficients of u = sqrt(g h) (f0 + f2 (y/h)^2 + f4 (y/h)^4).
std::array<Real, 3> velocityProfile(Real x)
{
    Real const s2 = shape(x), s4 = s2 * s2, s6 = s4 * s2, e2 = e * e, e3 = e2 * e;
    return {e * s2 - e2 * (-0.25 * s2 + s4) - e3 * (19.0 / 40 * s2 + 0.2 * s4 - 1.2 * s6),
            -e2 * (1.5 * s2 - 2.25 * s4) - e3 * (-1.5 * s2 - 3.75 * s4 + 7.5 * s6), -e3 * (-0.375 * s2 + 45.0 / 16 * (s4 - s6))};
}

/// The vertical velocity from that of continuity: v(0) = 0.
Vector velocity(Real x, Real y)
{
    Real const step = 1e-4 * depth, z = y / depth;
    std::array<Real, 3> const f = velocityProfile(x), before = velocityProfile(x - step), after = velocityProfile(x + step);
    Real u = 0, v = 0, power = 1;
    for (std::size_t k = 0; k < 3; ++k)
    {
        u += f[k] * power;
        v -= (after[k] - before[k]) / (2 * step) * power * y / (2 * static_cast<Real>(k) + 1);
        power *= z * z;
    }
    return std::sqrt(g * depth) * Vector(u, v, 0);
}

/// Places of particles under the wave: columns of as many rows as fit best, each as wide as gives every particle its area.
std::vector<Vector> places(Real channel, Real spacing)
{
    std::vector<Vector> result;
    for (Real x = 0; x < channel - 0.5 * spacing;)
    {
        Real const water = depth + elevation(x + 0.5 * spacing - start), rows = std::round(water / spacing);
        Real const width = std::min(spacing * spacing * rows / water, channel - x);
        for (int k = 0; k < static_cast<int>(rows); ++k) result.emplace_back(x + 0.5 * width, (k + 0.5) * water / rows, 0);
        x += width;
    }
    return result;
}

/// Writes the channel. setParticles lays out as many particles as the wave has: the channel at rest and a layer on top; they are then moved.
void writeChannel(RunCase& run, Real spacing, Real length, std::size_t count)
{
    long const columns = std::lround(length / spacing);
    long const extra = static_cast<long>(count) - columns * std::lround(depth / spacing);
    std::string const end = std::to_string(length);
    std::string regions = "boxToParticle { box (0 0 0) (" + end + " " + std::to_string(depth) + " 0); }\n";
    for (long row = 0; row * columns < extra; ++row)
        regions += "boxToParticle { box (0 " + std::to_string(depth + spacing * static_cast<Real>(row)) + " 0) (" +
                   std::to_string(spacing * static_cast<Real>(std::min(columns, extra - row * columns))) + " " +
                   std::to_string(depth + spacing * static_cast<Real>(row + 1)) + " 0); }\n";
    run.write("system/setParticlesDict", "geometry { tank { type polyline; points ((0 0.9 0) (0 0 0) (" + end + " 0 0) (" + end +
                                             " 0.9 0)); } }\nregions ( " + regions + ");");
}

/// The wave runs `depths` depths at `rows` rows of particles in the depth.
///
/// Celerity: slope of the straight line of least squares through its place in time; height: mean over the last fifth of the way.
void keepsItsShape(Real depths, Real rows, std::string const& schemes = "")
{
    Real const spacing = depth / rows, travel = depths * depth, length = std::round((2 * start + travel) / spacing) * spacing;
    std::vector<Vector> const position = places(length, spacing);
    RunCase run(spacing);
    writeChannel(run, spacing, length, position.size());
    if (!schemes.empty()) run.write("system/mpsSchemes", schemes);
    run.control(travel / celerity, 5e-3).make([&](ParticleSet& particles) {
        ASSERT_EQ(static_cast<std::size_t>(particles.fluid().size()), position.size());
        for (int const i : particles.fluid())
        {
            Vector const& r = particles.r[i] = position[static_cast<std::size_t>(i - particles.fluid().first)];
            particles.u[i] = velocity(r.x() - start, r.y());
            particles.p[i] = 1000 * g * (depth + elevation(r.x() - start) - r.y());
        }
    });
    expectBelow("solitary wave: height at the start, relative error",
                findCrest(run.start().particles(), depth, 0, length, depth).height / (e * depth) - 1, 0.01);
    Series height;
    CrestPath path;
    Real next = 0;
    run.run([&](Scene const& scene, Step const& step) {
        if (step.time < next) return;
        next += 0.02;
        Crest const now = findCrest(scene.particles(), depth, 0, length, depth);
        if (step.time * celerity > 0.8 * travel) height.add(now.height);
        path.add(step.time, now.place);
    });
    std::string const name = "solitary wave, " + std::to_string(std::lround(depths)) + " depths: ";
    expectBelow(name + "celerity, relative error", path.celerity() / celerity - 1, 0.02);
    expectBelow(name + "height, relative error", height.mean() / (e * depth) - 1, 0.05);
    expectBelow(name + "particles lost", static_cast<Real>(run.scene().fluid()->escaped()), 0);
}

} // namespace

// Measured: celerity -0.2 %, height 0.0 %; with 18 rows -0.5 % and +2.7 %, with 12 rows -1.1 % and +5.4 %.
TEST(SolitaryWave, keepsHeightAndCelerityForSixDepths) { keepsItsShape(6, 15); }

// Measured: celerity +2.4 %, height -20 %. From seven depths on the front of the wave grows longer and its rear steeper, and the water at the floor becomes
// faster than that under the crest, which no irrotational flow does; kinetic energy falls by 8 %, the level of the channel rises by 1 %.
// Height with shifting 0.1 instead of 0.2: -13 %; relaxationTime 0.2 s: -8 %; without collisions or surface damping: the same;
// hybrid gradient: -31 %.
TEST(SolitaryWave, DISABLED_keepsHeightAndCelerityForFifteenDepths) { keepsItsShape(15, 15); }

// The forms of the source that do not take a strained lattice for a denser one. Measured with 12, 15, 18, 22 and 30 rows: height -0.4,
// -5.3, -3.4, -3.2 and -1.7 %, celerity -1.8, -1.7, -1.2, -0.9 and -0.6 %.
TEST(SolitaryWave, keepsHeightAndCelerityForFifteenDepthsWithSchemesForWaves)
{
    keepsItsShape(15, 22, "sourceSchemes { divergence corrected; density smooth; }");
}

} // namespace mpsDem::test
