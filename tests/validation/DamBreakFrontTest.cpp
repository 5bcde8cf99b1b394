// A column of width a and height 2a collapses on a dry floor: its front against experiments and other codes over
// 0.5 <= tau <= 3, tau = t (2 g / a)^(1/2). The water has no viscosity, walls slip; there is no gate and no air.

#include "validation/DamBreak.h"

namespace mpsDem::test {

namespace {

constexpr Real a = 0.15; // m; without viscosity and surface tension the result does not depend on it
constexpr Real from = 0.5, to = 3;
constexpr Real bound = 0.05;

/// Front over a, over tau: largest x of the fluid, half a spacing beyond the centre of its particle. Particles that are alone or in
/// pairs (n below 0.3) do not count.
Curve front(Real spacing)
{
    RunCase run(spacing);
    Real const unit = std::sqrt(a / (2 * 9.81));
    makeColumn(run, {.width = a, .height = 2 * a, .spacing = spacing}, to * unit);
    Curve curve;
    curve.add(0, 1);
    run.run([&](Scene const& scene, Step const& step) {
        ParticleSet const& particles = scene.particles();
        Real x = 0;
        for (int const i : particles.fluid())
            if (particles.n[i] > 0.3) x = std::max(x, particles.r[i].x());
        curve.add(step.time / unit, (x + spacing / 2) / a);
    });
    return curve;
}

/// (Z - Z_reference) / Z_reference at the points of the reference, the one that is largest in magnitude.
/// @param late  By so much the clock of the reference started too early [tau].
Real difference(Curve const& computed, Curve const& known, Real late = 0)
{
    Real worst = 0;
    for (auto const& [time, value] : known.points())
    {
        if (time < from || time > to) continue;
        Real const part = computed.at(time - late) / value - 1;
        if (std::abs(part) > std::abs(worst)) worst = part;
    }
    return worst;
}

/// Start of the reference's clock that makes the largest difference smallest, in steps of 0.01 [tau].
Real lateness(Curve const& computed, Curve const& known)
{
    Real best = 0;
    for (int k = 1; k <= 50; ++k)
        if (std::abs(difference(computed, known, 0.01 * k)) < std::abs(difference(computed, known, best))) best = 0.01 * k;
    return best;
}

Curve table(std::string const& file) { return reference(file, "tau", "Z"); }

void expectNearCodes(std::string const& name, Curve const& computed)
{
    expectBelow(name + ", MPS of 1996: difference", difference(computed, table("frontKoshizukaOka1996Mps.dat")), bound);
    expectBelow(name + ", SOLA-VOF of 1981: difference", difference(computed, table("frontHirtNichols1981.dat")), bound);
}

/// With the one unknown of the experiment, the time the gate takes, fitted. That of Martin and Moyce was a diaphragm melted by a current;
/// 0.35 tau would be 19 ms and 13 ms with their two columns.
void expectNearWithGate(std::string const& name, Curve const& computed, std::string const& file)
{
    Real const late = lateness(computed, table(file));
    expectBetween(name + ", fitted delay of the gate [tau]", late, 0, 0.35);
    expectBelow(name + ", difference with that delay", difference(computed, table(file), late), bound);
}

void expectNearWithGates(std::string const& name, Curve const& computed)
{
    expectNearWithGate(name + ", Martin and Moyce 1.125 in", computed, "frontMartinMoyce1952Small.dat");
    expectNearWithGate(name + ", Martin and Moyce 2.25 in", computed, "frontMartinMoyce1952.dat");
}

} // namespace

TEST(DamBreakFront, meetsOtherCodesAndExperimentsWithTheirGate)
{
    Curve const computed = front(a / 30);
    expectNearCodes("front, a/30", computed);
    expectNearWithGates("front, a/30", computed);
}

TEST(DamBreakFrontGate, meetsThemWithAFinerSpacing)
{
    Curve const computed = front(a / 60);
    expectNearCodes("front, a/60", computed);
    expectNearWithGates("front, a/60", computed);
}

// Measured with a/60: 0.234, 0.212, 0.191; with a/30 0.227, 0.201, 0.181. The experiments lag from the start, by 0.09 to 0.15 at tau = 0.8, and the
// two columns of Martin and Moyce by a constant time from then on: gates take time; see etc/doc/validation.md.
TEST(DamBreakFrontGate, DISABLED_meetsExperimentsWithoutTheirGate)
{
    Curve const computed = front(a / 60);
    for (char const* file : {"frontKoshizukaOka1995.dat", "frontMartinMoyce1952Small.dat", "frontMartinMoyce1952.dat"})
        expectBelow(std::string("front, a/60, ") + file, difference(computed, table(file)), bound);
}

// Measured with a/60: delay 0.31, difference 0.087. Between tau = 1.54 and 2.72 this front advances by 0.94 a a unit of tau, the computed ones
// by 1.34, that of Martin and Moyce by 1.37 (tau = 1.6 to 2.95): it is slower than all others, not only later.
TEST(DamBreakFrontGate, DISABLED_meetsKoshizukaWithTheGate)
{
    expectNearWithGate("front, a/60, Koshizuka et al.", front(a / 60), "frontKoshizukaOka1995.dat");
}

} // namespace mpsDem::test
