#include <cstdio>
#include <fstream>
#include <random>

#include <gtest/gtest.h>

#include "core/Errors.h"
#include "core/Log.h"
#include "io/OutputFile.h"
#include "support/CheckpointSample.h"
#include "support/TemporaryFolder.h"

namespace mpsDem {
namespace {

/// Two checkpoints; the newer one gets damaged and must be refused, the older one must be taken.
class CheckpointDamage : public testing::Test
{
protected:
    void SetUp() override
    {
        muteLog(true);
        older = writeCheckpoint(folder.path(), "1", sampleState(1), sampleInfo(1, 0.1));
        newer = writeCheckpoint(folder.path(), "2", sampleState(2), sampleInfo(2, 0.2));
        files = {{newer / "state.0", readBytes(newer / "state.0")}, {newer / "MANIFEST", readBytes(newer / "MANIFEST")}};
        ASSERT_EQ(*findLatest(folder.path()), newer);
    }
    void TearDown() override { muteLog(false); }

    static void put(std::filesystem::path const& path, std::string const& bytes) { std::ofstream(path, std::ios::binary) << bytes; }

    /// Counts a damage that goes unnoticed, or that does not lead to the older checkpoint.
    void judge()
    {
        bool refused = false;
        try
        {
            readCheckpoint(newer);
        }
        catch (CaseError const& error)
        {
            refused = error.code() == ExitCode::InputOutput;
        }
        auto const latest = findLatest(folder.path());
        bool const fallsBack = latest && *latest == older && sameBits(readCheckpoint(*latest).state, sampleState(1));
        if (!refused) ++silent;
        if (!fallsBack) ++lost;
    }

    void restore()
    {
        for (auto const& [path, bytes] : files) put(path, bytes);
    }

    void report(char const* what) const
    {
        std::printf("%-48s %14.6g  bound %g\n", (std::string(what) + ", silent loads").c_str(), Real(silent), 0.0);
        std::printf("%-48s %14.6g  bound %g\n", (std::string(what) + ", no way back").c_str(), Real(lost), 0.0);
        EXPECT_EQ(silent, 0);
        EXPECT_EQ(lost, 0);
    }

    TemporaryFolder folder;
    std::filesystem::path older, newer;
    std::vector<std::pair<std::filesystem::path, std::string>> files;
    std::mt19937 random{2024};
    int silent = 0;
    int lost = 0;
};

TEST_F(CheckpointDamage, FlippedBits)
{
    for (int i = 0; i < 500; ++i)
    {
        auto [path, bytes] = files[i % 2];
        std::size_t const bit = random() % (8 * bytes.size());
        bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ (1 << (bit % 8)));
        put(path, bytes);
        judge();
        restore();
    }
    report("500 flipped bits");
    EXPECT_EQ(*findLatest(folder.path()), newer);
}

TEST_F(CheckpointDamage, Truncations)
{
    for (int i = 0; i < 50; ++i)
    {
        auto const& [path, bytes] = files[i % 2];
        std::size_t const length = i < 2 ? 0 : i < 4 ? bytes.size() - 1 : random() % bytes.size();
        put(path, bytes.substr(0, length));
        judge();
        restore();
    }
    report("50 truncations");
}

TEST_F(CheckpointDamage, FilesOfAnotherCheckpoint)
{
    for (char const* name : {"state.0", "MANIFEST"})
    {
        put(newer / name, readBytes(older / name));
        judge();
        restore();
    }
    put(newer / "state.0", files[1].second); // the two files of one checkpoint swapped
    put(newer / "MANIFEST", files[0].second);
    judge();
    restore();
    report("swapped files");
}

TEST_F(CheckpointDamage, MissingAndAppended)
{
    for (auto const& [path, bytes] : files)
    {
        std::filesystem::remove(path);
        judge();
        put(path, bytes + '\0');
        judge();
        restore();
    }
    report("missing files, bytes appended");
}

TEST_F(CheckpointDamage, BlocksOfAForgedManifestDoNotExhaustMemory)
{
    StateFileSummary const huge{files[0].second.size(), 0, 1, 1};
    std::string bytes = files[0].second;
    for (std::size_t i = 8; i < 32; ++i) bytes[i] = '\x7F'; // number of blocks, length of the first name
    put(newer / "state.0", bytes);
    EXPECT_THROW(readStateFile(newer / "state.0", huge), CaseError);
}

TEST_F(CheckpointDamage, NamedInAWarning)
{
    put(newer / "state.0", std::string(files[0].second.size(), 'x'));
    int const before = warningCount();
    EXPECT_EQ(*findLatest(folder.path()), older);
    EXPECT_EQ(warningCount(), before + 1);
    std::filesystem::remove(older / "MANIFEST");
    EXPECT_FALSE(findLatest(folder.path()));
    EXPECT_EQ(warningCount(), before + 3);
}

TEST_F(CheckpointDamage, UnfinishedOnesAreNotLookedAt)
{
    std::filesystem::rename(newer, folder / "2.part");
    int const before = warningCount();
    EXPECT_EQ(*findLatest(folder.path()), older);
    EXPECT_EQ(warningCount(), before);
}

} // namespace
} // namespace mpsDem
