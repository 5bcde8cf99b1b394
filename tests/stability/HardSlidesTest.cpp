// Hard cases of the slide: it hits its end stop, enters still water, leaves a cavity that closes, rides on a thin film of water.

#include <cstdio>

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
void rideOnFilm(std::string const& labelling, Real gap)
{
    RunCase run(0.04);
    run.write("system/mpsSchemes", "boundarySchemes { labelling " + labelling + "; }");
    std::string const name = "film of " + std::to_string(std::lround(1000 * gap)) + " mm, labelling " + labelling;
    Watch const watch = runSlide(run, {.top = 0.9, .water = 1, .gap = gap, .stop = "type latch;"}, 0.8);
    expectInBand(name, run, watch, {.height = 1});
    EXPECT_TRUE(run.body().locked());
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
    expectBelow(name + ": largest overlap [spacings]", watch.deepest, 0.05);
    expectBelow(name + ": speed of the slide at the end [m/s]", run.body().velocity().norm(), 1);
}

TEST(HardSlides, hitsALatchAtThreeMetresPerSecond)
{
    RunCase run(0.04);
    Watch const watch = runSlide(run, {.top = 0.6, .water = 1, .speed = 3, .stop = "type latch;", .stopAt = 0}, 0.4);
    expectInBand("latch at 3 m/s", run, watch, {.height = 1});
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
    expectInBand("entry into water", run, watch, {.height = 1, .momentum = 0.035});
    expectBelow("entry into water: momentum along x, share", watch.residual.x(), 0.02);
    expectBelow("entry into water: force in the air [N]", before, 0);
    Real const still = 0.5 * 1000 * 9.81 * 0.35 * 0.35; // on the front when the slide has stopped
    expectBetween("entry into water: largest force over that of still water", largest / still, 1, 10);
    EXPECT_TRUE(run.body().locked());
}

// Measured: energy 0.004, momentum 0.003. Water that stands in rows does not swell with these (theory.md, n0 as a measure of volume).
TEST(HardSlides, entersStillWaterWithSetWaves)
{
    RunCase run(0.04);
    run.write("system/mpsSchemes", "schemeSet waves;");
    Watch const watch = runSlide(run, entry, 1.5);
    expectInBand("entry into water, waves", run, watch, {.height = 1});
}

// Measured 0.029 in 1.5 s, along y; 0.028 to 0.035 from five heights. The sum of pressure forces on the water falls short of those of the floor.
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
    expectInBand("cavity", run, watch, {.height = 1.4, .energy = 0.02, .momentum = 0.035});
    expectBelow("cavity: water over the slide when it stops, share", open, 0.05);
    expectBetween("cavity: water over the slide at the end, share", covered(run.scene()), 0.9, 1.1);
}

// Measured: energy 0.001, momentum 0.006.
TEST(HardSlides, cavityClosesBehindWithSetWaves)
{
    RunCase run(0.04);
    run.write("system/mpsSchemes", "schemeSet waves;");
    Watch const watch = runSlide(run, plunge, 1.5);
    expectInBand("cavity, waves", run, watch, {.height = 1.4});
    expectBetween("cavity, waves: water over the slide at the end, share", covered(run.scene()), 0.9, 1.1);
}

// Measured 0.003; from seven heights (top 1.36 to 1.44 m) 0.002 to 0.034, mean 0.009: the corrected gradient adds energy to a jet now and
// then. With eq 4 for particles whose moment matrix has a determinant below 0.35 instead of 0.2: 0.002 to 0.006, mean 0.003; but the same
// changes other runs as much the other way (dam break 0.009 with 0.4).
TEST(HardSlides, DISABLED_cavityClosesBehindWithoutGainOfEnergy)
{
    Series rise;
    for (Real const top : {1.36, 1.38, 1.39, 1.4, 1.41, 1.42, 1.44})
    {
        RunCase run(0.04);
        SlideCase slide = plunge;
        slide.top = top;
        Watch const watch = runSlide(run, slide, 1.5);
        rise.add(watch.rise / watch.start);
        std::printf("    top at %g m: rise of energy %g\n", top, watch.rise / watch.start);
    }
    expectBelow("cavity, seven heights: mean rise of energy over that of the start", rise.mean(), 0.005);
}

// Measured 0.024 in one run, while the hole closes (0.047 when wall points under the sharp tip of the slide were taken for wet).
TEST(HardSlides, DISABLED_cavityClosesBehindKeepingMomentum)
{
    RunCase run(0.04);
    expectMomentum("cavity", runSlide(run, plunge, 1.5));
}

// H4. Less than a spacing: no particle is in the gap, and the slide falls shut on the slope.
TEST(HardSlides, closesAThinFilm) { rideOnFilm("dynamic", 0.024); }
TEST(HardSlides, closesAThinFilmWithoutLabelling) { rideOnFilm("off", 0.024); }

// H4. One row of particles is in the gap and is pressed out slowly. Momentum: 0.005 to 0.012 with seven gaps of 54 to 66 mm.
TEST(HardSlides, ridesOnAThickFilm) { rideOnFilm("dynamic", 0.06); }
TEST(HardSlides, ridesOnAThickFilmWithoutLabelling) { rideOnFilm("off", 0.06); }

} // namespace mpsDem::test
