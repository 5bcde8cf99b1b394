// Linear and nonlinear potential flow (support/PotentialFlow.h) against known solutions, and the waves that the block of Sue, Nokes and
// Walters (2006) makes in it when it moves as measured: the rows "potential flow" in the README of tutorials/landslide/sueEllipse2D.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>

#include "support/Curve.h"
#include "support/Measured.h"
#include "support/PotentialFlow.h"
#include "support/WaveCrest.h"
#include "validation/SueFlume.h"
#include "verification/Oscillation.h"

namespace mpsDem::test {

namespace {

using Array = PotentialFlow::Array;

constexpr Real pi = std::numbers::pi, g = PotentialFlow::gravity;

std::string nameOf(SurfaceCondition condition) { return condition == SurfaceCondition::linear ? "linear" : "nonlinear"; }

/// omega [1/s] of linear dispersion, omega^2 = g k tanh(k h).
Real angularFrequency(Real k, Real depth) { return std::sqrt(g * k * std::tanh(k * depth)); }

PotentialFlow::Bed levelBed(Real depth)
{
    return [depth](Array const& x, Real) -> Array { return Array::Constant(x.size(), -depth); };
}

/// Standing wave of 0.1 mm, half a wave length of 0.5 m in the tank: period / period of linear dispersion - 1.
Real periodError(SurfaceCondition condition, int columns, int layers)
{
    Real const depth = 0.435, length = 0.5, k = pi / length, period = 2 * pi / angularFrequency(k, depth);
    PotentialFlow flow(length, columns, layers, levelBed(depth), condition);
    flow.setSurface(1e-4 * (k * flow.x()).cos(), Array::Zero(flow.x().size()));
    Oscillation oscillation;
    while (flow.time() < 2.8 * period)
    {
        flow.advance(0.01 * period);
        oscillation.add(flow.time(), flow.elevation(0.0));
    }
    return oscillation.period() / period - 1;
}

/// Third-order solitary wave of height e [m] on a depth of 1 m (Grimshaw 1971, formulas in SolitaryWaveTest.cpp): eta, and psi by the
/// trapezoidal rule from d psi/dx = u + w eta_x on the surface, w = (u - c) eta_x.
void setSolitaryWave(PotentialFlow& flow, Real e, Real centre)
{
    Real const e2 = e * e, e3 = e2 * e, alpha = std::sqrt(0.75 * e) * (1 - 0.625 * e + 71.0 / 128 * e2);
    Array const s2 = (alpha * (flow.x() - centre)).cosh().square().inverse(), s4 = s2.square(), s6 = s4 * s2, t2 = 1 - s2;
    Array const eta = e * s2 - 0.75 * e2 * s2 * t2 + e3 * (0.625 * s2 * t2 - 101.0 / 80 * s4 * t2), z2 = (1 + eta).square();
    Array const f0 = e * s2 - e2 * (s4 - 0.25 * s2) - e3 * (19.0 / 40 * s2 + 0.2 * s4 - 1.2 * s6);
    Array const f2 = -e2 * (1.5 * s2 - 2.25 * s4) - e3 * (-1.5 * s2 - 3.75 * s4 + 7.5 * s6);
    Array const f4 = -e3 * (-0.375 * s2 + 45.0 / 16 * (s4 - s6));
    Array const u = std::sqrt(g) * (f0 + f2 * z2 + f4 * z2.square());
    Eigen::Index const n = eta.size();
    Real const width = flow.x()(1) - flow.x()(0);
    Array slope = Array::Zero(n), psi = Array::Zero(n);
    slope.segment(1, n - 2) = (eta.tail(n - 2) - eta.head(n - 2)) / (2 * width);
    Array const psiX = u + (u - solitaryCelerity(1, e)) * slope.square();
    for (Eigen::Index k = 1; k < n; ++k) psi(k) = psi(k - 1) + 0.5 * width * (psiX(k - 1) + psiX(k));
    flow.setSurface(eta, psi);
}

/// Vertex of the parabola through the highest node and its neighbours.
Crest crestOf(PotentialFlow const& flow)
{
    Array const eta = flow.elevation();
    Eigen::Index k = 0;
    eta.maxCoeff(&k);
    k = std::clamp<Eigen::Index>(k, 1, eta.size() - 2);
    Real const curvature = eta(k - 1) - 2 * eta(k) + eta(k + 1), slope = 0.5 * (eta(k + 1) - eta(k - 1));
    return {flow.x()(k) - slope / curvature * (flow.x()(1) - flow.x()(0)), eta(k) - 0.5 * slope * slope / curvature};
}

/// From x = 10 to 30 depths; celerity and heights between 20 and 30.
void expectSolitaryWave(Real e, Real heightBound)
{
    PotentialFlow flow(42, 420, 8, levelBed(1), SurfaceCondition::nonlinear);
    setSolitaryWave(flow, e, 10);
    Real const volume = flow.integral(flow.elevation()), energy = flow.energy();
    CrestPath path;
    Curve heights;
    for (Crest crest = crestOf(flow); crest.place < 30; crest = crestOf(flow))
    {
        if (crest.place > 20) path.add(flow.time(), crest.place), heights.add(flow.time(), crest.height);
        flow.advance(0.02);
    }
    ASSERT_FALSE(heights.points().empty());
    Real const first = heights.points().front().second, last = heights.points().back().second;
    std::string const name = "solitary wave of " + std::to_string(e).substr(0, 3) + " depths: ";
    expectBelow(name + "height at 20 depths / initial - 1", first / e - 1, heightBound);
    expectBelow(name + "height at 30 / at 20 depths - 1", last / first - 1, 0.003);
    expectBelow(name + "celerity / third order - 1", path.celerity() / solitaryCelerity(1, 0.5 * (first + last)) - 1, 0.0015);
    expectBelow(name + "volume / initial - 1", flow.integral(flow.elevation()) / volume - 1, 1e-12);
    expectBelow(name + "energy / initial - 1", flow.energy() / energy - 1, 5e-5);
}

/// At x = 1.5 and 2.5 m.
using FirstWaves = std::array<FirstWave, 2>;
constexpr std::array<char const*, 2> gauges{"1.5", "2.5"};

/// @param bed  For 2.7 or 3 s, which is before a wave comes back from the end of the tank.
FirstWaves wavesOf(SueFlume const& bed, Real end, SurfaceCondition condition)
{
    PotentialFlow flow(5, 500, 14, bed, condition);
    Real const water = flow.integral(flow.depth());
    std::array<Curve, 2> elevation;
    while (flow.time() < end)
    {
        flow.advance(0.005);
        for (std::size_t k = 0; k < 2; ++k) elevation[k].add(flow.time(), flow.elevation(std::stod(gauges[k])));
    }
    expectBelow("change of the water's area [m2]", flow.integral(flow.depth()) - water, 1e-4);
    return {firstWave(elevation[0]), firstWave(elevation[1])};
}

void print(std::string const& name, FirstWaves const& waves)
{
    std::printf("%-34s", (name + ", [mm] at [s]:").c_str());
    for (FirstWave const& wave : waves)
        std::printf("  %7.2f at %.3f  %7.2f at %.3f", 1000 * wave.crest, wave.crestTime, 1000 * wave.trough, wave.troughTime);
    std::printf("\n");
}

void expectNear(std::string const& name, Real value, Real expected)
{
    Real const margin = 0.02 * std::abs(expected);
    expectBetween(name, value, expected - margin, expected + margin);
}

/// @param expected  Heights [mm] and times [s] of the README.
void expectWaves(std::string const& run, Gap gap, Real end, FirstWaves const& expected)
{
    std::string const name = "Sue, " + run + (gap == Gap::filled ? ", gap filled" : ", gap displaced");
    FirstWaves const found = wavesOf(SueFlume(run, gap), end, SurfaceCondition::nonlinear);
    FirstWaves measured;
    for (std::size_t k = 0; k < 2; ++k)
        measured[k] = firstWave(reference("wavesSue2006_" + run + ".dat", "t", std::string("x") + gauges[k]));
    print(name, found);
    print("Sue, " + run + ", measured", measured);
    for (std::size_t k = 0; k < 2; ++k)
    {
        std::string const at = std::string(" at ") + gauges[k] + " m ";
        expectNear(name + ": crest" + at + "[mm]", 1000 * found[k].crest, expected[k].crest);
        expectNear(name + ": crest" + at + "[s]", found[k].crestTime, expected[k].crestTime);
        expectNear(name + ": trough" + at + "[mm]", 1000 * found[k].trough, expected[k].trough);
        expectNear(name + ": trough" + at + "[s]", found[k].troughTime, expected[k].troughTime);
    }
}

} // namespace

// Measured: -0.156, -0.039 and -0.010 % with either condition.
TEST(PotentialFlow, standingWaveHasThePeriodOfDispersionToSecondOrder)
{
    for (SurfaceCondition const condition : {SurfaceCondition::linear, SurfaceCondition::nonlinear})
    {
        std::string const name = "standing wave, " + nameOf(condition) + ": ";
        Real const coarse = periodError(condition, 25, 8), middle = periodError(condition, 50, 16), fine = periodError(condition, 100, 32);
        expectBelow(name + "period error, 25 columns", coarse, 0.002);
        expectBelow(name + "period error, 50 columns", middle, 5e-4);
        expectBelow(name + "period error, 100 columns", fine, 1.5e-4);
        expectBetween(name + "order, 25 to 50 columns", std::log2(coarse / middle), 1.8, 2.2);
        expectBetween(name + "order, 50 to 100 columns", std::log2(middle / fine), 1.8, 2.2);
    }
}

// A bed of shape A cos(kx) rises within tau. Linear theory at x = 0: eta = A / (tau omega cosh(kh)) (sin(omega t) - sin(omega (t - tau)))
// for t > tau. Measured: 0.72 % with either condition.
TEST(PotentialFlow, risingBedMakesTheWaveOfLinearTheory)
{
    Real const depth = 0.435, length = 0.5, k = pi / length, omega = angularFrequency(k, depth), rise = 1e-4, tau = 0.1;
    Real const amplitude = rise / (tau * omega * std::cosh(k * depth));
    auto const bed = [=](Array const& x, Real t) -> Array { return rise * std::clamp(t / tau, 0.0, 1.0) * (k * x).cos() - depth; };
    for (SurfaceCondition const condition : {SurfaceCondition::linear, SurfaceCondition::nonlinear})
    {
        PotentialFlow flow(length, 50, 16, bed, condition);
        Real worst = 0, highest = 0;
        while (flow.time() < 1)
        {
            flow.advance(0.0025);
            Real const t = flow.time(), exact = amplitude * (std::sin(omega * t) - (t > tau ? std::sin(omega * (t - tau)) : 0));
            highest = std::max(highest, std::abs(exact));
            worst = std::max(worst, std::abs(flow.elevation(0.0) - exact));
        }
        expectBelow("rising bed, " + nameOf(condition) + ": difference / amplitude", worst / highest, 0.01);
    }
}

// The wave of third order at the start is none that lasts: from 0.3 depths it falls by 2.2 % at once and leaves a small wave behind.
TEST(PotentialFlow, solitaryWaveKeepsHeightCelerityVolumeAndEnergy)
{
    expectSolitaryWave(0.1, 0.002);
    expectSolitaryWave(0.3, 0.03);
}

TEST(PotentialFlow, heavyBlockMakesTheWavesOfTheReadme)
{
    expectWaves("SG5", Gap::displaced, 2.7, {{{17.74, 1.195, -37.35, 1.685}, {16.59, 1.735, -40.96, 2.390}}});
    expectWaves("SG5", Gap::filled, 2.7, {{{16.46, 1.170, -33.32, 1.680}, {14.23, 1.740, -37.39, 2.390}}});
}

TEST(PotentialFlow, lightBlockMakesTheWavesOfTheReadme)
{
    expectWaves("SG1", Gap::displaced, 3, {{{7.13, 1.405, -18.96, 2.150}, {6.54, 1.970, -12.61, 2.845}}});
    expectWaves("SG1", Gap::filled, 3, {{{7.13, 1.405, -22.04, 2.130}, {6.23, 1.935, -13.41, 2.750}}});
}

// What the linear conditions leave out makes the trough at 1.5 m shallower and the crest at 2.5 m higher, by a part in proportion to the
// height of the block.
TEST(PotentialFlowGate, nonlinearityGrowsAsTheHeightOfTheBlock)
{
    for (Real const scale : {0.25, 0.5, 1.0})
    {
        SueFlume const bed("SG5", Gap::filled, scale);
        std::string const name = "Sue, SG5, height " + std::to_string(scale).substr(0, 4);
        FirstWaves const linear = wavesOf(bed, 2.7, SurfaceCondition::linear), nonlinear = wavesOf(bed, 2.7, SurfaceCondition::nonlinear);
        print(name + ", linear", linear);
        print(name + ", nonlinear", nonlinear);
        expectBetween(name + ": (trough at 1.5 m / linear - 1) / height", (nonlinear[0].trough / linear[0].trough - 1) / scale, -0.13,
                      -0.1);
        expectBetween(name + ": (crest at 2.5 m / linear - 1) / height", (nonlinear[1].crest / linear[1].crest - 1) / scale, 0.08, 0.11);
    }
}

} // namespace mpsDem::test
