// Hard cases of the slide: it hits its end stop, enters still water, leaves a cavity that closes, rides on a thin film of water.

#include "stability/SlideCase.h"

namespace mpsDem::test {

namespace {

/// Writes and runs a slide. @param eachStep  Called after each step.
Watch runSlide(RunCase& run, SlideCase const& slide, Real endTime, RunCase::EachStep const& eachStep = {})
{
    writeSlide(run, slide);
    run.control(endTime, 1e-3, budgetEntry).make();
    Watch watch;
    run.run([&](Scene const& scene, Step const& step) {
        watch.observe(scene, step);
        if (eachStep) eachStep(scene, step);
    });
    return watch;
}

SlideCase const entry{.top = 1, .water = 0.4, .stop = "type latch;"};
SlideCase const plunge{.top = 1.4, .water = 0.8, .stop = "type latch;"};

/// Share of a layer of 0.12 m above the slide's upper side that water fills.
Real covered(Scene const& scene)
{
    constexpr Real width = 0.5, height = 0.12;
    Vector const corner = scene.bodies()[0]->centre() + Vector(-width * 2 / 3, width / 3, 0);
    int count = 0;
    for (int const i : scene.particles().fluid())
    {
        Vector const r = scene.particles().r[i] - corner;
        count += r.x() > 0 && r.x() < width && r.y() > 0 && r.y() < height;
    }
    Real const spacing = scene.particles().lattice().spacing;
    return count * spacing * spacing / (width * height);
}

/// A film of the thickness `gap` [m] under the slide, at the spacing 0.04 m.
void rideOnFilm(std::string const& labelling, Real gap, bool momentum)
{
    RunCase run(0.04);
    run.write("system/mpsSchemes", "boundarySchemes { labelling " + labelling + "; }");
    std::string const name = "film of " + std::to_string(std::lround(1000 * gap)) + " mm, labelling " + labelling;
    Watch const watch = runSlide(run, {.top = 0.9, .water = 1, .gap = gap, .stop = "type latch;"}, 0.8);
    expectInBand(name, run, watch, {.height = 1});
    EXPECT_TRUE(run.body().locked());
    if (momentum) expectMomentum(name, watch);
}

} // namespace

// H1. A stop is made for the speed it must stand: a corner at impactSpeed sinks in by 0.05 spacings.
TEST(HardSlides, hitsAStopperAtThreeMetresPerSecond)
{
    RunCase run(0.04);
    std::string const name = "stopper at 3 m/s";
    Watch const watch =
        runSlide(run, {.top = 0.6, .water = 1, .speed = 3, .stop = "type stopper; e 0.1; impactSpeed 3;", .stopAt = 0}, 0.4);
    expectInBand(name, run, watch, {.height = 1});
    expectMomentum(name, watch);
    expectBelow(name + ": largest overlap [spacings]", watch.deepest, 0.05);
    expectBelow(name + ": speed of the slide at the end [m/s]", run.body().velocity().norm(), 1);
}

TEST(HardSlides, hitsALatchAtThreeMetresPerSecond)
{
    RunCase run(0.04);
    Watch const watch = runSlide(run, {.top = 0.6, .water = 1, .speed = 3, .stop = "type latch;", .stopAt = 0}, 0.4);
    expectInBand("latch at 3 m/s", run, watch, {.height = 1});
    expectMomentum("latch at 3 m/s", watch);
    EXPECT_TRUE(run.body().locked());
}

// H2. The wedge falls from its place in the air, 0.1 m above water of 0.4 m.
TEST(HardSlides, entersStillWater)
{
    RunCase run(0.04);
    Real before = 0, largest = 0; // pressure force before the first touch, and at its largest
    Watch const watch = runSlide(run, entry, 1.5, [&](Scene const& scene, Step const& step) {
        Real const force = scene.bodies()[0]->fluid.force.norm();
        if (step.time < 0.1) before = std::max(before, force);
        largest = std::max(largest, force);
    });
    expectInBand("entry into water", run, watch, {.height = 1});
    expectBelow("entry into water: momentum along x, share", watch.residual.x(), 0.02);
    expectBelow("entry into water: force in the air [N]", before, 0);
    Real const still = 0.5 * 1000 * 9.81 * 0.35 * 0.35; // on the front when the slide has stopped
    expectBetween("entry into water: largest force over that of still water", largest / still, 1, 10);
    EXPECT_TRUE(run.body().locked());
}

// Measured 0.040 in 1.5 s, along y; 0.038 at 0.02 m. The sum of pressure forces on the water falls short of those of the floor.
TEST(HardSlides, DISABLED_entersStillWaterKeepingMomentum)
{
    RunCase run(0.04);
    expectMomentum("entry into water", runSlide(run, entry, 1.5));
}

// H3. The wedge comes from 0.6 m above and leaves a hole behind, which is open when it stops and closed at the end.
TEST(HardSlides, cavityClosesBehind)
{
    RunCase run(0.04);
    Real open = 1;
    Watch const watch = runSlide(run, plunge, 1.5, [&](Scene const& scene, Step const&) {
        if (scene.bodies()[0]->locked()) open = std::min(open, covered(scene));
    });
    expectInBand("cavity", run, watch, {.height = 1.4, .energy = 0.02});
    expectBelow("cavity: momentum along x, share", watch.residual.x(), 0.02);
    expectBelow("cavity: water over the slide when it stops, share", open, 0.05);
    expectBetween("cavity: water over the slide at the end, share", covered(run.scene()), 0.9, 1.1);
}

// Measured 0.011; from five heights of the slide 0.006 in the mean, 0.010 without redo of steps. 0.028 at 0.02 m, 0.001 with the symmetric
// gradient: the corrected gradient adds energy to the jets.
TEST(HardSlides, DISABLED_cavityClosesBehindWithoutGainOfEnergy)
{
    RunCase run(0.04);
    Watch const watch = runSlide(run, plunge, 1.5);
    expectInBand("cavity", run, watch, {.height = 1.4});
}

// H4. Less than a spacing: no particle is in the gap, and the slide falls shut on the slope.
TEST(HardSlides, closesAThinFilm) { rideOnFilm("dynamic", 0.024, true); }
TEST(HardSlides, closesAThinFilmWithoutLabelling) { rideOnFilm("off", 0.024, true); }

// H4. One row of particles is in the gap and is pressed out slowly.
TEST(HardSlides, ridesOnAThickFilm) { rideOnFilm("dynamic", 0.06, false); }
TEST(HardSlides, ridesOnAThickFilmWithoutLabelling) { rideOnFilm("off", 0.06, false); }

// Measured 0.05 in 0.8 s, 0.008 while the gap is wider than half a spacing: then 5 particles hold the slide up with up to 60 kPa.
TEST(HardSlides, DISABLED_ridesOnAThickFilmKeepingMomentum) { rideOnFilm("dynamic", 0.06, true); }

} // namespace mpsDem::test
