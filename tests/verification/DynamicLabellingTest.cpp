// Dynamic boundary labelling (DBL) with a wedge held on a ramp: walls that the fluid doesn't reach carry no pressure, and labels stay.

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/RunCase.h"

namespace mpsDem::test {

namespace {

constexpr Real spacing = 0.04;

/// The wedge of 0.5 m held with its top 0.01 m below 1 m of water. @param schemes  system/mpsSchemes.
RunCase& heldWedge(RunCase& run, std::string const& schemes = "")
{
    run.write("system/setParticlesDict", "geometry { bed { type polyline; points ((-0.6 1.6 0) (1 0 0) (2.2 0 0) (2.2 1.6 0)); } }\n"
                                         "regions ( boxToParticle { box (-0.6 0 0) (2.2 1 0); } );\nhydrostatic { surface 1; }");
    run.write("constant/rigidBodyProperties",
              "bodies { slide { shape { type polygon; points ((0.01 0.99 0) (0.51 0.49 0) (0.51 0.99 0)); }\n"
              "density 2036; releaseTime 1000; } }");
    run.write("system/mpsSchemes", schemes);
    return run.fixedSteps(1.5, 2e-3).make();
}

bool onRamp(ParticleSet const& particles, int i)
{
    return particles.body[i] < 0 && particles.normal[i].x() > 0.5 && particles.normal[i].y() > 0.5;
}

/// Wall particle of the ramp beneath the slide, two spacings away from the ends of the contact.
bool underSlide(ParticleSet const& particles, int i)
{
    Vector const& r = particles.r[i];
    return onRamp(particles, i) && r.y() > 0.49 + 2 * spacing && r.y() < 0.99 - 2 * spacing;
}

Real largestOnFace(Scene const& scene)
{
    WettedSurface const& surface = scene.solids()->couplings().front().surface();
    Real largest = 0;
    for (std::size_t s = 0; s < surface.position().size(); ++s)
        if (surface.normal()[s].x() < -0.5 && surface.normal()[s].y() < -0.5) largest = std::max(largest, std::abs(surface.pressure()[s]));
    return largest;
}

/// Consecutive steps in which each wall particle has had a new label, and the longest such run.
class LabelChanges
{
public:
    void observe(ParticleSet const& particles)
    {
        std::vector<std::uint8_t> now(particles.wet.begin(), particles.wet.begin() + particles.wall().last);
        if (before_.size() == now.size())
        {
            run_.resize(now.size(), 0);
            for (std::size_t k = 0; k < now.size(); ++k)
            {
                run_[k] = now[k] != before_[k] ? run_[k] + 1 : 0;
                longest_ = std::max(longest_, run_[k]);
            }
        }
        before_ = std::move(now);
    }
    [[nodiscard]] int longest() const { return longest_; }

private:
    std::vector<std::uint8_t> before_;
    std::vector<int> run_;
    int longest_ = 0;
};

} // namespace

TEST(DynamicLabelling, keepsDryWallsWithoutPressure)
{
    RunCase run(spacing);
    heldWedge(run);
    Real face = 0, under = 0, above = 0;
    int underCount = 0, aboveCount = 0;
    StillWater water(1, Vector(1.1, 0.1, 0), 0.75);
    LabelChanges changes;
    run.run([&](Scene const& scene, Step const& step) {
        ParticleSet const& particles = scene.particles();
        face = std::max(face, largestOnFace(scene));
        underCount = aboveCount = 0;
        for (int const i : particles.wall())
        {
            if (underSlide(particles, i))
            {
                under = std::max(under, std::abs(particles.p[i]));
                ++underCount;
            }
            if (onRamp(particles, i) && particles.r[i].y() > 1 + 2 * spacing)
            {
                above = std::max(above, std::abs(particles.p[i]));
                ++aboveCount;
            }
        }
        water.observe(scene, step);
        changes.observe(particles);
    });
    EXPECT_GT(underCount, 10);
    EXPECT_GT(aboveCount, 10);
    expectBelow("DBL (a): largest |p| on the contact face [Pa]", face, 0);
    expectBelow("DBL (a): largest |p| of the ramp under it [Pa]", under, 0);
    expectBelow("DBL (b): largest |p| of the ramp above water [Pa]", above, 0);
    expectBelow("DBL (c): RMS of p on walls / rho g H", water.wall.mean(), 0.01);
    expectBelow("DBL (d): successive changes of one label", changes.longest(), 3);
}

// Without DBL the same walls carry pressure; the fluid itself is as good with it as without.
TEST(DynamicLabelling, matters)
{
    RunCase with(spacing), without(spacing);
    heldWedge(with);
    heldWedge(without, "boundarySchemes { labelling off; }");
    StillWater waterWith(1, Vector(1.1, 0.1, 0), 0.75), waterWithout = waterWith;
    Series under;
    with.run([&](Scene const& scene, Step const& step) { waterWith.observe(scene, step); });
    without.run([&](Scene const& scene, Step const& step) {
        waterWithout.observe(scene, step);
        if (step.time < 0.75) return;
        ParticleSet const& particles = scene.particles();
        for (int const i : particles.wall())
            if (underSlide(particles, i)) under.add(particles.p[i]);
    });
    expectBetween("without DBL: mean p of the ramp under the slide [Pa]", under.mean(), 500, 10000);
    expectBelow("DBL (e): RMS of p / rho g H with DBL", waterWith.fluid.mean(), 0.012);
    expectBelow("DBL (e): RMS with DBL over that without", waterWith.fluid.mean() / waterWithout.fluid.mean(), 1.2);
}

// Contact faces: the vertical force of still water on a block held on the floor. Dry, water presses on its upper sides only;
// vented, the force is the buoyancy, as it is where water gets below.
TEST(ContactFace, ventedCarriesBuoyancy)
{
    for (std::string const face : {"dry", "vented"})
    {
        RunCase run(spacing);
        run.write("system/setParticlesDict", "geometry { tank { type polyline; points ((0 1.2 0) (0 0 0) (2 0 0) (2 1.2 0)); } }\n"
                                             "regions ( boxToParticle { box (0 0 0) (2 0.8 0); } );\nhydrostatic { surface 0.8; }");
        run.write("constant/rigidBodyProperties",
                  "bodies { slide { shape { type polygon; points ((0.6 0 0) (1.4 0 0) (1.2 0.2 0) (0.8 0.2 0)); }\n"
                  "density 2000; releaseTime 1000; } }");
        run.write("system/mpsSolution", "coupling { type strong; contactFace " + face + "; }");
        run.fixedSteps(0.6, 2e-3).make();
        Series force; // share of the buoyancy
        run.run([&](Scene const& scene, Step const& step) {
            if (step.time > 0.3) force.add(scene.bodies()[0]->fluid.force.y() / (1000 * 9.81 * 0.12));
        });
        // Dry: -(0.6 0.4 + 0.7 0.4) / 0.12: depth over the top, mean depth over the two sides, each times its width.
        Real const expected = face == "dry" ? -0.52 / 0.12 : 1;
        expectBetween("contact face " + face + ": vertical force / buoyancy", force.mean(), expected - 0.1, expected + 0.1);
    }
}

} // namespace mpsDem::test
