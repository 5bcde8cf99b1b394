#include <csignal>
#include <cstdio>

#include <gtest/gtest.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/Errors.h"
#include "core/Log.h"
#include "io/OutputFile.h"
#include "io/WriteFault.h"
#include "support/CheckpointSample.h"
#include "support/TemporaryFolder.h"

namespace mpsDem {
namespace {

/// Code and text of the error that `action` ends with; code Done for none.
template <class Action>
std::pair<ExitCode, std::string> outcome(Action action)
{
    try
    {
        action();
    }
    catch (CaseError const& error)
    {
        return {error.code(), error.what()};
    }
    return {ExitCode::Done, {}};
}

State bigState() // about 240 kB
{
    State state = sampleState();
    state.set("big", std::vector<Real>(30000, 0.5));
    return state;
}

/// Fails the nth operation of writing a third checkpoint, for all n. Returns how often no checkpoint could be loaded afterwards.
int casesLost(std::string const& name, bool andAfter, int& operations)
{
    int lost = 0;
    for (int n = 1;; ++n)
    {
        TemporaryFolder const folder;
        writeCheckpoint(folder.path(), "1", sampleState(1), sampleInfo(1, 0.1));
        writeCheckpoint(folder.path(), "2", sampleState(2), sampleInfo(2, 0.2));
        setWriteFault(n, andAfter);
        auto const [code, text] = outcome([&] { writeCheckpoint(folder.path(), name, sampleState(3), sampleInfo(3, 0.3)); });
        bool const reached = writeOperations() >= n;
        setWriteFault(0);
        EXPECT_TRUE(code == ExitCode::Done || code == ExitCode::InputOutput) << text;
        EXPECT_TRUE(code == ExitCode::Done || text.find(folder.path()) != std::string::npos) << text;
        auto const latest = findLatest(folder.path());
        std::int64_t const step = latest ? readCheckpoint(*latest).info.step : 0;
        bool const good = (step == 2 || step == 3) && sameBits(readCheckpoint(*latest).state, sampleState(static_cast<int>(step)));
        bool const claimKept = code != ExitCode::Done || step == 3;
        if (!good || !claimKept) ++lost;
        writeCheckpoint(folder.path(), "4", sampleState(4), sampleInfo(4, 0.4)); // and the next write succeeds
        EXPECT_TRUE(sameBits(readCheckpoint(folder / "4").state, sampleState(4)));
        operations = n - 1;
        if (!reached) return lost;
    }
}

TEST(CheckpointWriteFault, EachOperationFailsOnce)
{
    muteLog(true);
    for (bool const andAfter : {false, true})
    {
        for (std::string const name : {"3", "2"}) // a new one; one in the place of the newest
        {
            int operations = 0;
            int const lost = casesLost(name, andAfter, operations);
            std::printf("%-48s %14.6g  bound %g\n", ("cases lost of " + std::to_string(operations) + " failed operations").c_str(),
                        Real(lost), 0.0);
            EXPECT_EQ(lost, 0);
            EXPECT_GT(operations, 20);
        }
    }
    muteLog(false);
}

TEST(CheckpointWriteFault, InitialStateIsOldOrNewOrRefused)
{
    for (int n = 1;; ++n)
    {
        TemporaryFolder const folder;
        writeInitialState(folder / "0", sampleState(1), sampleInfo(0, 0));
        setWriteFault(n);
        auto const code = outcome([&] { writeInitialState(folder / "0", sampleState(2), sampleInfo(0, 0)); }).first;
        bool const reached = writeOperations() >= n;
        setWriteFault(0);
        State state;
        auto const reading = outcome([&] { state = readCheckpoint(folder / "0").state; }).first;
        EXPECT_TRUE(reading == ExitCode::InputOutput || sameBits(state, sampleState(1)) || sameBits(state, sampleState(2))) << n;
        EXPECT_TRUE(code != ExitCode::Done || sameBits(state, sampleState(2))) << n;
        if (!reached) break;
    }
}

TEST(CheckpointWriteFault, FullDevice)
{
    auto const [code, text] = outcome([] {
        OutputFile file("/dev/full");
        file.write("some text");
    });
    EXPECT_EQ(code, ExitCode::InputOutput);
    EXPECT_NE(text.find("/dev/full: cannot write after 0 bytes: No space left on device"), std::string::npos) << text;
    EXPECT_EQ(outcome([] { atomicWrite("/dev/full", "text"); }).first, ExitCode::InputOutput); // and never put a file in its place
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
}

TEST(CheckpointWriteFault, FileSizeLimit)
{
    TemporaryFolder const folder;
    writeCheckpoint(folder.path(), "1", sampleState(1), sampleInfo(1, 0.1));
    auto const before = std::signal(SIGXFSZ, SIG_IGN);
    rlimit old{};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &old), 0);
    rlimit const small{100000, old.rlim_max};
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
    auto const [code, text] = outcome([&] { writeCheckpoint(folder.path(), "2", bigState(), sampleInfo(2, 0.2)); });
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &old), 0);
    std::signal(SIGXFSZ, before);
    EXPECT_EQ(code, ExitCode::InputOutput);
    EXPECT_NE(text.find("2.part/state.0: cannot write after 100000 bytes: File too large"), std::string::npos) << text;
    EXPECT_FALSE(std::filesystem::exists(folder / "2.part"));
    EXPECT_EQ(*findLatest(folder.path()), folder / "1");
}

TEST(CheckpointWriteFault, FullDisk)
{
    TemporaryFolder const folder;
    if (::mount("tmpfs", folder.path().c_str(), "tmpfs", 0, "size=128k") != 0) GTEST_SKIP() << "NOT TESTED: no right to mount a tmpfs";
    writeCheckpoint(folder.path(), "1", sampleState(1), sampleInfo(1, 0.1));
    auto const [code, text] = outcome([&] { writeCheckpoint(folder.path(), "2", bigState(), sampleInfo(2, 0.2)); });
    EXPECT_EQ(code, ExitCode::InputOutput);
    EXPECT_NE(text.find("No space left on device"), std::string::npos) << text;
    EXPECT_TRUE(sameBits(readCheckpoint(*findLatest(folder.path())).state, sampleState(1)));
    EXPECT_EQ(*findLatest(writeCheckpoint(folder.path(), "3", sampleState(3), sampleInfo(3, 0.3)).parent_path()),
              folder / "3"); // room again
    EXPECT_EQ(::umount(folder.path().c_str()), 0);
}

/// Writes checkpoints until it is killed.
[[noreturn]] void writeForever(std::filesystem::path const& folder)
{
    State const state = bigState();
    for (std::int64_t step = 1;; ++step) writeCheckpoint(folder, std::to_string(step % 7), state, sampleInfo(step, 0.1));
}

TEST(CheckpointWriteFault, KilledAtAnyMoment)
{
    int lost = 0;
    int const warningsBefore = warningCount();
    TemporaryFolder const folder;
    writeCheckpoint(folder.path(), "0", bigState(), sampleInfo(0, 0));
    for (int i = 0; i < 20; ++i)
    {
        pid_t const child = ::fork();
        if (child == 0) writeForever(folder.path());
        ::usleep(static_cast<useconds_t>(3000 + 1371 * i));
        ::kill(child, SIGKILL);
        ::waitpid(child, nullptr, 0);
        auto const latest = findLatest(folder.path());
        if (!latest || !sameBits(readCheckpoint(*latest).state, bigState())) ++lost;
    }
    std::printf("%-48s %14.6g  bound %g\n", "cases lost of 20 kills while writing", Real(lost), 0.0);
    EXPECT_EQ(lost, 0);
    writeCheckpoint(folder.path(), "end", bigState(), sampleInfo(1, 0));
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 2); // no litter
    EXPECT_EQ(warningCount(), warningsBefore);                                           // nothing half-written was ever visible
}

} // namespace
} // namespace mpsDem
