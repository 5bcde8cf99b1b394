// setParticles in 3-D: a million particles within a closed surface from an STL file.

#include <ctime>
#include <filesystem>
#include <string>

#include "io/StlFile.h"
#include "support/Optimised.h"
#include "support/RunCase.h"

namespace mpsDem::test {

// A ball of water of 20 480 triangles, 1 m across, cut by the floor and two walls of a box: region, cut cells, walls and files.
TEST(FillingGate, setsAMillionParticlesWithinAClosedStlSurface)
{
    if (!optimised) GTEST_SKIP() << "this build is made for other things than speed";
    RunCase run(0.0079);
    run.threeDimensions();
    std::filesystem::create_directories(run.root() / "constant/triSurface");
    TriSurface const ball = TriSurface::sphere("pond", {0.45, 0.45, 0.5}, 0.5, 0.02);
    writeStl(run.root() / "constant/triSurface/pond.stl", ball);
    run.write("system/setParticlesDict", "geometry { tank { type searchableBox; min (0 0 0); max (1 1 1); open (top); } }\n"
                                         "regions ( surfaceToParticle { file \"pond.stl\"; } );\n");
    run.control(1, 1e-3);
    std::clock_t const begin = std::clock();
    int fluid = 0, all = 0;
    run.make([&](ParticleSet& particles) {
        fluid = particles.fluid().size();
        all = particles.owned().size();
    });
    std::printf("    %zu triangles, %d fluid particles, %d in all\n", ball.triangles().size(), fluid, all);
    expectBelow("setParticles in 3-D: less than a million fluid particles by", std::max(0, 1000000 - fluid), 0);
    expectBelow("setParticles in 3-D, a million particles: processor time [s]", static_cast<Real>(std::clock() - begin) / CLOCKS_PER_SEC,
                30);
}

} // namespace mpsDem::test
