// A box that floats in water 0.5 m deep is held 0.04 m too high and let go: heave decay against linear theory with radiated waves.
//
// Theory: the velocity potential around a box of draft d and half width a in water of depth h, matched eigenfunctions beneath and beside
// it (the method of Yeung 1981, Appl. Ocean Res. 3), gives the added mass m_a(w) and damping b(w) of a section, waves outgoing on both
// sides. The box let go at x0 from rest then moves as (Cummins 1962, in the frequency domain)
//     x(t) = x0 (2 c/pi) int_0^inf Im G(w) cos(w t)/w dw,    G = 1/(c - w^2 (m + m_a) - i w b),    c = rho g 2a,
// whose integral at t = 0 must be 1.

#include <cmath>
#include <complex>
#include <cstdio>
#include <numbers>
#include <vector>

#include <Eigen/Dense>

#include "support/RunCase.h"

namespace mpsDem::test {

namespace {

constexpr Real g = 9.81, pi = std::numbers::pi;
constexpr Real halfWidth = 0.1, draft = 0.2, depth = 0.5, lift = 0.04;

using Complex = std::complex<Real>;

Complex sinc(Complex x) { return std::abs(x) < 1e-8 ? Complex(1) : std::sin(x) / x; }

/// Roots of k tan(k h) = -w^2/g: -i k0 of the travelling wave, then those of the local modes.
std::vector<Complex> wavenumbers(Real frequency, std::size_t count)
{
    Real const nu = frequency * frequency / g;
    Real travelling = std::max(nu, std::sqrt(nu / depth));
    for (int i = 0; i < 50; ++i)
    {
        Real const t = std::tanh(travelling * depth);
        travelling -= (travelling * t - nu) / (t + travelling * depth * (1 - t * t));
    }
    std::vector<Complex> k{Complex(0, -travelling)};
    for (std::size_t m = 1; m < count; ++m)
    {
        Real low = (static_cast<Real>(m) - 0.5) * pi / depth, high = static_cast<Real>(m) * pi / depth;
        for (int i = 0; i < 60; ++i)
        {
            Real const middle = 0.5 * (low + high);
            (middle * std::sin(middle * depth) + nu * std::cos(middle * depth) > 0) == (m % 2 == 1) ? low = middle : high = middle;
        }
        k.emplace_back(0.5 * (low + high));
    }
    return k;
}

/// m_a + i b/w [kg/m]: rho times the integral of the potential of unit velocity over the bottom of the box.
Complex radiation(Real frequency)
{
    constexpr int modes = 24;
    Real const s = depth - draft, a = halfWidth;
    std::vector<Complex> const k = wavenumbers(frequency, modes);
    Eigen::MatrixXcd C(modes, modes);
    for (int m = 0; m < modes; ++m)
    {
        Complex const norm = std::sqrt(0.5 * (1.0 + sinc(2.0 * k[m] * depth)));
        for (int n = 0; n < modes; ++n) C(n, m) = 0.5 * (sinc(k[m] * s - n * pi) + sinc(k[m] * s + n * pi)) / norm;
    }
    // Beneath: phi = ((z+h)^2 - x^2)/(2s) + sum A_n cosh(q_n x)/cosh(q_n a) cos(q_n (z+h)); beside: sum B_m exp(-k_m (x-a)) Z_m(z).
    // Velocity at x = a: -k_m B_m = s/h sum_n C_nm (flux_n A_n - delta_n0 a/s); pressure: own_n A_n + p_n = sum_m C_nm B_m.
    Eigen::VectorXcd source(modes);
    Eigen::VectorXd flux(modes), own(modes);
    for (int n = 0; n < modes; ++n)
    {
        Real const q = n * pi / s;
        flux[n] = q * std::tanh(q * a);
        own[n] = n == 0 ? 1 : 0.5;
        source[n] = n == 0 ? s / 6 - a * a / (2 * s) : (n % 2 == 0 ? 1 : -1) / (q * q * s);
    }
    Eigen::VectorXcd inverse(modes);
    for (int m = 0; m < modes; ++m) inverse[m] = -(s / depth) / k[m];
    Eigen::MatrixXcd const beside = C * inverse.asDiagonal() * C.transpose();
    Eigen::MatrixXcd system = -beside * flux.asDiagonal().toDenseMatrix();
    system.diagonal() += own;
    Eigen::VectorXcd const A = system.partialPivLu().solve(-source - beside.col(0) * (a / s));
    Complex sum = s * a - a * a * a / (3 * s) + 2 * a * A[0];
    for (int n = 1; n < modes; ++n) sum += A[n] * (n % 2 == 0 ? 2.0 : -2.0) * std::tanh(n * pi * a / s) * s / (n * pi);
    return 1000.0 * sum;
}

/// x(t)/x0 of linear theory.
class LinearHeave
{
public:
    LinearHeave()
    {
        Real const c = 1000 * g * 2 * halfWidth, m = 1000 * 2 * halfWidth * draft;
        for (int i = 0; i < count; ++i)
        {
            Real const w = (i + 0.5) * step;
            Complex const r = radiation(w);
            Complex const G = 1.0 / (c - w * w * (m + r.real()) - Complex(0, 1) * w * w * r.imag());
            density_.push_back(2 * c / pi * G.imag() / w * step);
        }
    }
    [[nodiscard]] Real operator()(Real time) const
    {
        Real sum = 0;
        for (int i = 0; i < count; ++i) sum += density_[static_cast<std::size_t>(i)] * std::cos((i + 0.5) * step * time);
        return sum;
    }

private:
    static constexpr int count = 400;
    static constexpr Real step = 0.05; ///< [rad/s].
    std::vector<Real> density_;
};

/// Times at which the velocity of a body changes its sign.
class Turns
{
public:
    void add(Real time, Real velocity)
    {
        if (begun_ && (last_ < 0) != (velocity < 0)) times.push_back(lastTime_ - last_ * (time - lastTime_) / (velocity - last_));
        begun_ = true;
        last_ = velocity;
        lastTime_ = time;
    }
    std::vector<Real> times;

private:
    bool begun_ = false;
    Real last_ = 0, lastTime_ = 0;
};

} // namespace

// The period is the time from the release to the first return to the top. It does not depend on where the box comes to rest, and the waves
// that the ends of the tank send back reach the box after it.
TEST(HeaveDecay, hasThePeriodOfLinearTheory)
{
    LinearHeave const theory;
    expectBelow("heave, linear theory: x(0)/x0 - 1", theory(0) - 1, 1e-4);
    Real const release = 0.3;
    RunCase run(0.02);
    run.write("system/setParticlesDict", "geometry { tank { type polyline; points ((0 0.8 0) (0 0 0) (3 0 0) (3 0.8 0)); } }\n"
                                         "regions ( boxToParticle { box (0 0 0) (3 0.5 0); } );\nhydrostatic { surface 0.5; }");
    run.write("constant/rigidBodyProperties",
              "bodies { box { shape { type box; min (1.4 0.34 0); max (1.6 0.68 0); } mass 40; releaseTime 0.3;\n"
              "constraints { heave { sixDoFRigidBodyMotionConstraint line; direction (0 1 0); }\n"
              " noTurn { sixDoFRigidBodyMotionConstraint orientation; } } } }");
    run.control(release + 1.3, 2e-3).make();
    Turns found, linear;
    Real const top = run.start().bodies()[0]->centre().y();
    Real least = 1, highest = 0;
    run.run([&](Scene const& scene, Step const& step) {
        Real const t = step.time - release;
        if (t < 0.1) return;
        found.add(t, scene.bodies()[0]->velocity().y());
        linear.add(t, theory(t + 1e-4) - theory(t - 1e-4));
        Real const x = 1 + (scene.bodies()[0]->centre().y() - top) / lift;
        least = std::min(least, x);
        if (found.times.size() == 1) highest = std::max(highest, x);
    });
    ASSERT_GE(found.times.size(), 2U);
    ASSERT_GE(linear.times.size(), 2U);
    std::printf("    first turn %.3f s (theory %.3f s), second turn %.3f s (%.3f s); heights there %.3f (%.3f), %.3f (%.3f) of x0\n",
                found.times[0], linear.times[0], found.times[1], linear.times[1], least, theory(linear.times[0]), highest,
                theory(linear.times[1]));
    expectBelow("heave decay: period, relative error", found.times[1] / linear.times[1] - 1, 0.05);
    expectBelow("heave decay: half period, relative error", found.times[0] / linear.times[0] - 1, 0.05);
}

} // namespace mpsDem::test
