// No allocation in the time loop: every call of malloc in this program is seen, operator new and Eigen's temporaries included.

#include <array>
#include <atomic>
#include <csignal>
#include <cstddef>

#include <execinfo.h>

#include "mpsDemFoam/StopRequest.h"
#include "support/Channel.h"

namespace {

std::atomic<bool> watching = false;
std::atomic<long> allocations = 0;
std::array<void*, 24> firstCallers{};
int firstDepth = 0;

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__)
constexpr bool canCount = true;
#else
constexpr bool canCount = false;
#endif

[[maybe_unused]] void count()
{
    if (!watching || allocations++ > 0) return;
    watching = false;
    firstDepth = backtrace(firstCallers.data(), static_cast<int>(firstCallers.size()));
    watching = true;
}

} // namespace

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__)

// What glibc's own functions are called underneath; free stays glibc's.
extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t number, std::size_t size);
void* __libc_realloc(void* block, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);

void* malloc(std::size_t size) noexcept
{
    count();
    return __libc_malloc(size);
}
void* calloc(std::size_t number, std::size_t size) noexcept
{
    count();
    return __libc_calloc(number, size);
}
void* realloc(void* block, std::size_t size) noexcept
{
    count();
    return __libc_realloc(block, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept
{
    count();
    return __libc_memalign(alignment, size);
}
}

#endif

namespace mpsDem::test {

namespace {

/// Allocations in `steps` steps of a started run: the loop of mpsDemFoam, its log included.
long allocationsIn(RunCase& run, int steps)
{
    Scene& scene = run.start();
    StopRequest requests(run.root());
    for (int const signal : {SIGUSR1, SIGUSR2, SIGTERM, SIGINT}) std::signal(signal, SIG_DFL);
    allocations = 0;
    watching = true;
    for (int k = 0; k < steps; ++k)
    {
        Step const step = run.step();
        scene.logStep(step, 0, 0);
        requests.serve(scene, 0);
    }
    watching = false;
    if (allocations > 0) backtrace_symbols_fd(firstCallers.data(), firstDepth, 2);
    return allocations;
}

void expectNoAllocation(std::string const& name, RunCase& run, int warmUp, int steps)
{
    std::array<void*, 4> unused{};
    backtrace(unused.data(), 4); // loads what it needs
    allocationsIn(run, 0);
    for (int k = 0; k < warmUp; ++k) run.scene().logStep(run.step(), 0, 0);
    expectBelow(name + ": allocations in " + std::to_string(steps) + " steps", static_cast<Real>(allocationsIn(run, steps)), 0);
}

} // namespace

TEST(Allocation, isSeenByThisTest)
{
    if (!canCount) GTEST_SKIP() << "malloc cannot be watched here";
    allocations = 0;
    watching = true;
    std::vector<double> const some(3, 1.0);
    Eigen::MatrixXd const more(3, static_cast<Eigen::Index>(some.size()));
    watching = false;
    EXPECT_EQ(allocations, 2) << more.size();
}

TEST(Allocation, isAbsentInADamBreak)
{
    if (!canCount) GTEST_SKIP() << "malloc cannot be watched here";
    RunCase run(0.02);
    run.write("system/setParticlesDict", "geometry { tank { type polyline; points ((0 1.2 0) (0 0 0) (2 0 0) (2 1.2 0)); } }\n"
                                         "regions ( boxToParticle { box (0 0 0) (0.5 0.5 0); } );\n");
    run.control(2, 2e-3).make();
    expectNoAllocation("dam break, 625 particles", run, 250, 120);
}

TEST(Allocation, isAbsentInAViscousPeriodicFlow)
{
    if (!canCount) GTEST_SKIP() << "malloc cannot be watched here";
    RunCase run(0.05);
    writeChannel(run, "type implicit; ");
    run.fixedSteps(6, 2.5e-3).make();
    expectNoAllocation("periodic channel, implicit viscosity", run, 500, 120);
}

TEST(Allocation, isAbsentWhereAWedgeSlides)
{
    if (!canCount) GTEST_SKIP() << "malloc cannot be watched here";
    RunCase run(0.05);
    run.write("system/setParticlesDict", "geometry { bed { type polyline; points ((-0.6 1.6 0) (1 0 0) (2.2 0 0) (2.2 1.6 0)); } }\n"
                                         "regions ( boxToParticle { box (-0.6 0 0) (2.2 1 0); } );\nhydrostatic { surface 1; }");
    run.write("constant/rigidBodyProperties", "bodies { slide { shape { type polygon; points ((0.1 0.9 0) (0.6 0.4 0) (0.6 0.9 0)); } "
                                              "density 2036; report true; } }");
    run.write("constant/contactProperties", "mu 0.0105;");
    run.write("system/mpsSolution", "coupling { type strong; }");
    run.control(2, 2e-3, "functions { momentum { type momentumBudget; writeControl none; } }").make();
    expectNoAllocation("sliding wedge, strong coupling", run, 150, 70);
    EXPECT_GT(run.body().velocity().norm(), 0.1);
    EXPECT_GT(run.scene().solids()->contacts()->contactCount(), 0u);
}

} // namespace mpsDem::test
