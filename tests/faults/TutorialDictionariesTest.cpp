#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/ProgramRun.h"

/// Every dictionary of every tutorial is read without an unknown word.

namespace {

namespace fs = std::filesystem;
using namespace mpsDem::test;

fs::path const source = fs::path(MPSDEM_TEST_DATA).parent_path() / "tutorials";

/// Folders of all cases, relative to that of the tutorials.
std::vector<fs::path> tutorials()
{
    std::vector<fs::path> cases;
    for (auto const& entry : fs::recursive_directory_iterator(source))
        if (entry.path().filename() == "Allrun") cases.push_back(fs::relative(entry.path().parent_path(), source));
    return cases;
}

/// Copies what makes up a case, not what a run has left there.
void copyCase(fs::path const& from, fs::path const& to)
{
    fs::create_directories(to);
    for (char const* part : {"system", "constant", "0.orig", "Allrun.pre"})
        if (fs::exists(from / part)) fs::copy(from / part, to / part, fs::copy_options::recursive);
}

TEST(TutorialDictionaries, AreReadWithoutUnknownWords)
{
    ASSERT_GE(tutorials().size(), 8u);
    mpsDem::TemporaryFolder const folder;
    fs::copy(source / "resources", folder / "resources", fs::copy_options::recursive);
    for (fs::path const& tutorial : tutorials()) copyCase(source / tutorial, folder / tutorial);
    for (fs::path const& tutorial : tutorials())
    {
        fs::path const copy = folder / tutorial;
        // A variant takes most dictionaries from another case.
        std::string const before = "MPSDEM_ETC='" MPSDEM_ETC "' '" + (copy / "Allrun.pre").string() + "'";
        ASSERT_TRUE(!fs::exists(copy / "Allrun.pre") || std::system(before.c_str()) == 0) << tutorial;
        ProgramResult const made = runProgram("setParticles", copy);
        ASSERT_EQ(made.exitCode, 0) << tutorial << '\n' << made.error;
        ProgramResult const read = runProgram("mpsDemFoam", copy, {"-dry-run"});
        EXPECT_EQ(read.exitCode, 0) << tutorial << '\n' << read.error;
        EXPECT_NE(read.output.find("The case is valid"), std::string::npos) << tutorial;
        EXPECT_FALSE(fs::exists(copy / "VTK")) << tutorial << ": a dry run writes nothing";
    }
}

} // namespace
