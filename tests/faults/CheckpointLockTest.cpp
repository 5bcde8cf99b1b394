#include <csignal>
#include <memory>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/Errors.h"
#include "io/CaseLock.h"
#include "support/TemporaryFolder.h"

namespace mpsDem {
namespace {

TEST(CaseLock, ASecondOneIsRefusedAndNamesTheProcess)
{
    TemporaryFolder const folder;
    auto lock = std::make_unique<CaseLock>(folder.path());
    try
    {
        CaseLock const second(folder.path());
        FAIL() << "two runs in one case";
    }
    catch (CaseError const& error)
    {
        EXPECT_EQ(error.code(), ExitCode::Locked);
        EXPECT_NE(std::string(error.what()).find("process " + std::to_string(::getpid()) + " on "), std::string::npos) << error.what();
    }
    EXPECT_TRUE(std::filesystem::exists(folder / ".mpsDem.lock")) << "the one that was refused left it alone";
    lock.reset();
    EXPECT_FALSE(std::filesystem::exists(folder / ".mpsDem.lock"));
    EXPECT_NO_THROW(CaseLock{folder.path()});
}

TEST(CaseLock, OtherCasesAreFree)
{
    TemporaryFolder const a, b;
    CaseLock const lockA(a.path());
    EXPECT_NO_THROW(CaseLock{b.path()});
    EXPECT_THROW(CaseLock{a / "none"}, CaseError);
}

TEST(CaseLock, GoesWithAKilledProcess)
{
    TemporaryFolder const folder;
    int ready[2];
    ASSERT_EQ(::pipe(ready), 0);
    pid_t const child = ::fork();
    if (child == 0)
    {
        CaseLock const lock(folder.path());
        bool const told = ::write(ready[1], "x", 1) == 1;
        if (told) ::pause();
        ::_exit(1);
    }
    char byte = 0;
    ASSERT_EQ(::read(ready[0], &byte, 1), 1);
    EXPECT_THROW(CaseLock{folder.path()}, CaseError);
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    EXPECT_NO_THROW(CaseLock{folder.path()});
    ::close(ready[0]);
    ::close(ready[1]);
}

} // namespace
} // namespace mpsDem
