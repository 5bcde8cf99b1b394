#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/Dictionary.h"

// Every file of tests/faults/dictionaries is broken in one way. Its first line names a part of the message and the line that the message must
// name: `// expect: <text> @ <line>` (line 0: any). No file may be accepted, crash the reader or keep it busy.

namespace {

namespace fs = std::filesystem;
using mpsDem::CaseError;
using mpsDem::Dictionary;

fs::path folder() { return fs::path(MPSDEM_TEST_DATA) / "faults" / "dictionaries"; }

struct Expectation
{
    std::string fragment;
    int line;
};

Expectation expectationOf(fs::path const& file)
{
    std::ifstream stream(file);
    std::string first;
    std::getline(stream, first);
    if (!first.empty() && first.back() == '\r') first.pop_back();
    std::string const mark = "// expect: ";
    std::size_t const begin = first.find(mark) + mark.size();
    std::size_t const end = first.rfind(" @ ");
    return {first.substr(begin, end - begin), std::stoi(first.substr(end + 3))};
}

/// What a program with a small set of entries would ask of the file.
void readAll(Dictionary const& dictionary)
{
    if (dictionary.found("deltaT")) static_cast<void>(dictionary.getInRange("deltaT", 0, 1e300));
    if (dictionary.found("n")) static_cast<void>(dictionary.get<int>("n"));
    if (dictionary.found("flag")) static_cast<void>(dictionary.get<bool>("flag"));
    if (dictionary.found("type")) static_cast<void>(dictionary.getWord("type", {"slide", "wedge"}, "types"));
    if (dictionary.found("origin")) static_cast<void>(dictionary.get<mpsDem::Vector>("origin"));
    if (dictionary.found("values")) static_cast<void>(dictionary.get<std::vector<mpsDem::Real>>("values"));
    if (dictionary.found("nu")) static_cast<void>(dictionary.getDimensioned("nu", {0, 2, -1, 0, 0, 0, 0}));
    if (dictionary.found("sub")) static_cast<void>(dictionary.subDict("sub").getOr<int>("n", 0));
    if (dictionary.found("regions"))
        for (auto const& [name, region] : dictionary.getDictList("regions")) static_cast<void>(region.get<int>("n"));
    dictionary.requireAllRead();
}

std::vector<fs::path> corpus()
{
    std::vector<fs::path> files;
    for (auto const& entry : fs::directory_iterator(folder()))
        if (entry.is_regular_file()) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

TEST(DictionaryCorpus, everyBrokenFileIsRefusedAtItsPlaceWithItsReason)
{
    setenv("MPSDEM_ETC", folder().parent_path().c_str(), 1);
    double slowest = 0;
    for (fs::path const& file : corpus())
    {
        SCOPED_TRACE(file.filename().string());
        Expectation const expected = expectationOf(file);
        auto const begin = std::chrono::steady_clock::now();
        try
        {
            readAll(Dictionary::fromFile(file, folder()));
            ADD_FAILURE() << "was accepted";
        }
        catch (CaseError const& error)
        {
            EXPECT_NE(std::string(error.what()).find(expected.fragment), std::string::npos) << error.what();
            bool const rightLine = expected.line == 0 || error.where().line == expected.line;
            EXPECT_TRUE(rightLine) << error.what();
            EXPECT_FALSE(error.where().file.empty());
        }
        slowest = std::max(slowest, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    }
    double const bound = 30;
    std::printf("%-48s %14.6g  bound %g\n", "slowest refusal of a dictionary [s]", slowest, bound);
    EXPECT_LT(slowest, bound);
}

TEST(DictionaryCorpus, holdsEnoughFiles) { EXPECT_GE(corpus().size(), 60U); }

} // namespace
