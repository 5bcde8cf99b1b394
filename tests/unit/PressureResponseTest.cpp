#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "particles/NumberDensity.h"
#include "pressure/PressureEquation.h"
#include "support/RunCase.h"

namespace mpsDem::test {

namespace {

/// A tank of 12 by 8 particles over one row of wall, its top on the surface.
ParticleSet tank(Lattice const& lattice)
{
    Field<Vector> position, normal;
    Field<ParticleType> type;
    for (int j = -1; j < 8; ++j)
        for (int i = 0; i < 12; ++i)
        {
            position.emplace_back((i + 0.5) * lattice.spacing, (j + 0.5) * lattice.spacing, 0);
            type.push_back(j < 0 ? ParticleType::Wall : ParticleType::Fluid);
            normal.push_back(j < 0 ? Vector(0, 1, 0) : Vector(0, 0, 0));
        }
    Field<Vector> const zero(position.size(), Vector::Zero());
    ParticleSet particles(lattice);
    particles.assign(position, zero, Field<Real>(position.size(), 0), type, Field<int>(position.size(), -1), normal);
    for (int i : particles.owned())
    {
        particles.wet[i] = 1;
        bool const top = particles.r[i].y() > 7 * lattice.spacing;
        particles.surface[i] = top ? SurfaceLabel::Surface : SurfaceLabel::Interior;
    }
    return particles;
}

/// Largest |p(u* + dt a) - p(u*) - response(a)| over the largest response: eq 8 is linear in u* of the walls.
Real mismatch(std::string const& source)
{
    Lattice const lattice{2, 0.1, 1};
    ParticleSet particles = tank(lattice);
    NeighbourList neighbours({0.21, 0.21}, false);
    neighbours.update(particles);
    ReferenceConstants const constants = referenceConstants(lattice, 0.21);
    numberDensity(particles, neighbours, constants);
    PressureSource const right(Dictionary::fromText(source), SchemeSet::Standard, lattice, 0.21, 1000);
    PressureEquation equation(Dictionary::fromText("tolerance 1e-10;"), right, nullptr, lattice, 1000, constants, constants);
    Step const step{1000, 1, 1e-3, false};
    PeriodicImages const images;
    equation.assemble(particles, neighbours, images);
    for (int i : particles.owned()) particles.uStar[i] = Vector(0, -0.01, 0);
    equation.solve(particles, neighbours, step);
    Field<Real> const before = particles.p;

    Field<Vector> acceleration(static_cast<std::size_t>(particles.boundary().last), Vector(0, 3, 0));
    for (int i : particles.boundary()) particles.uStar[i] += step.dt * acceleration[i];
    equation.solve(particles, neighbours, step);
    Field<Real> response;
    equation.response(particles, neighbours, step, acceleration, response);
    Real worst = 0, largest = 1e-300;
    for (int i : particles.owned())
    {
        worst = std::max(worst, std::abs(particles.p[i] - before[i] - response[i]));
        largest = std::max(largest, std::abs(response[i]));
    }
    return worst / largest;
}

} // namespace

// Residual of the response: 1e-3. Without the factor 1 - gamma the difference would be gamma.
TEST(PressureResponse, isTheChangeOfThePressureForEachSource)
{
    expectBelow("response, gamma 0: mismatch", mismatch("type divergence;"), 0.01);
    expectBelow("response, gamma 0.3: mismatch", mismatch("type mixed; gamma 0.3; rampSteps 0;"), 0.01);
    expectBelow("response, divergence corrected: mismatch", mismatch("divergence corrected; density smooth;"), 0.01);
    expectBelow("response, gamma dt/tau = 0.02: mismatch", mismatch("type mixed; relaxationTime 0.05;"), 0.01);
}

} // namespace mpsDem::test
