#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/ProgramRun.h"

/// Every dictionary of every tutorial is read without an unknown word.

namespace {

namespace fs = std::filesystem;
using namespace mpsDem::test;

std::vector<fs::path> tutorials()
{
    std::vector<fs::path> cases;
    for (auto const& entry : fs::recursive_directory_iterator(fs::path(MPSDEM_TEST_DATA).parent_path() / "tutorials"))
        if (entry.path().filename() == "controlDict") cases.push_back(entry.path().parent_path().parent_path());
    return cases;
}

TEST(TutorialDictionaries, AreReadWithoutUnknownWords)
{
    ASSERT_GE(tutorials().size(), 8u);
    for (fs::path const& tutorial : tutorials())
    {
        mpsDem::TemporaryFolder const folder;
        fs::path const copy = folder / "case";
        fs::create_directories(copy);
        for (char const* part : {"system", "constant", "0.orig"})
            if (fs::exists(tutorial / part)) fs::copy(tutorial / part, copy / part, fs::copy_options::recursive);
        ProgramResult const made = runProgram("setParticles", copy);
        ASSERT_EQ(made.exitCode, 0) << tutorial << '\n' << made.error;
        ProgramResult const read = runProgram("mpsDemFoam", copy, {"-dry-run"});
        EXPECT_EQ(read.exitCode, 0) << tutorial << '\n' << read.error;
        EXPECT_NE(read.output.find("The case is valid"), std::string::npos) << tutorial;
        EXPECT_FALSE(fs::exists(copy / "VTK")) << tutorial << ": a dry run writes nothing";
    }
}

} // namespace
