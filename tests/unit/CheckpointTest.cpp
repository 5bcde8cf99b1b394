#include <fstream>

#include <gtest/gtest.h>

#include "core/Errors.h"
#include "io/Crc32c.h"
#include "io/OutputFile.h"
#include "support/CheckpointSample.h"
#include "support/TemporaryFolder.h"

namespace mpsDem {
namespace {

TEST(Crc32c, KnownVectors)
{
    EXPECT_EQ(crc32c("123456789"), 0xE3069283u);
    EXPECT_EQ(crc32c(""), 0u);
    EXPECT_EQ(crc32c(std::string(32, '\0')), 0x8A9136AAu); // RFC 3720, B.4
    EXPECT_EQ(crc32c(std::string(32, '\xFF')), 0x62A8AB43u);
    EXPECT_EQ(crcText(0x00A8AB43u), "00a8ab43");
}

TEST(Crc32c, ContinuesOverPieces)
{
    std::string const text = "a text that is longer than eight bytes";
    for (std::size_t cut = 0; cut <= text.size(); ++cut) EXPECT_EQ(crc32c(text.substr(cut), crc32c(text.substr(0, cut))), crc32c(text));
}

TEST(Checkpoint, RoundTripKeepsEveryBit)
{
    TemporaryFolder const folder;
    auto const path = writeCheckpoint(folder / "checkpoint", "1200", sampleState(), sampleInfo(1200, 1.0 / 3));
    EXPECT_EQ(path, folder / "checkpoint" / "1200");
    Checkpoint const back = readCheckpoint(path);
    EXPECT_TRUE(sameBits(back.state, sampleState()));
    EXPECT_FALSE(sameBits(back.state, sampleState(2)));
    EXPECT_EQ(back.info.step, 1200);
    EXPECT_EQ(back.info.time, 1.0 / 3);
    EXPECT_EQ(back.info.codeVersion, "1.0");
    EXPECT_EQ(back.info.inputHash, "0123abcd");
    EXPECT_EQ(back.info.effects, sampleInfo(0, 0).effects);
}

TEST(Checkpoint, EmptyStateAndEmptyTexts)
{
    TemporaryFolder const folder;
    CheckpointInfo info;
    info.time = -0.25;
    Checkpoint const back = readCheckpoint(writeCheckpoint(folder.path(), "0", State(), info));
    EXPECT_TRUE(back.state.blocks().empty());
    EXPECT_EQ(back.info.time, -0.25);
    EXPECT_EQ(back.info.codeVersion, "");
    EXPECT_TRUE(back.info.effects.empty());
}

TEST(Checkpoint, SameStateGivesTheSameBytes)
{
    TemporaryFolder const folder;
    auto const a = writeCheckpoint(folder / "a", "1", sampleState(), sampleInfo(1, 0.1));
    auto const b = writeCheckpoint(folder / "b", "1", sampleState(), sampleInfo(1, 0.1));
    EXPECT_EQ(readBytes(a / "state.0"), readBytes(b / "state.0"));
    EXPECT_EQ(readBytes(a / "MANIFEST"), readBytes(b / "MANIFEST"));
}

TEST(Checkpoint, NoneIsNoError)
{
    TemporaryFolder const folder;
    EXPECT_FALSE(findLatest(folder / "checkpoint"));
    EXPECT_TRUE(listCheckpoints(folder / "checkpoint").empty());
}

TEST(Checkpoint, KeepsTheNewestButAtLeastTwo)
{
    TemporaryFolder const folder;
    for (int step = 1; step <= 5; ++step)
        writeCheckpoint(folder.path(), std::to_string(step), sampleState(step), sampleInfo(step, step), 3);
    ASSERT_EQ(listCheckpoints(folder.path()).size(), 3u);
    EXPECT_EQ(listCheckpoints(folder.path()).back().info.step, 3);
    writeCheckpoint(folder.path(), "6", sampleState(6), sampleInfo(6, 6), 1);
    ASSERT_EQ(listCheckpoints(folder.path()).size(), 2u);
    EXPECT_EQ(*findLatest(folder.path()), folder / "6");
    for (int step = 7; step <= 9; ++step) writeCheckpoint(folder.path(), std::to_string(step), sampleState(), sampleInfo(step, step), 0);
    EXPECT_EQ(listCheckpoints(folder.path()).size(), 5u);
}

TEST(Checkpoint, ARunBegunAgainIsNewerThanLaterStepsOfTheOldOne)
{
    TemporaryFolder const folder;
    writeCheckpoint(folder.path(), "100", sampleState(100), sampleInfo(100, 10));
    writeCheckpoint(folder.path(), "200", sampleState(200), sampleInfo(200, 20));
    writeCheckpoint(folder.path(), "10", sampleState(10), sampleInfo(10, 1));
    EXPECT_EQ(*findLatest(folder.path()), folder / "10");
    EXPECT_FALSE(std::filesystem::exists(folder / "100"));
    EXPECT_TRUE(std::filesystem::exists(folder / "200"));
}

TEST(Checkpoint, SameNameIsReplaced)
{
    TemporaryFolder const folder;
    writeCheckpoint(folder.path(), "5", sampleState(1), sampleInfo(5, 1));
    writeCheckpoint(folder.path(), "5", sampleState(2), sampleInfo(5, 1));
    EXPECT_TRUE(sameBits(readCheckpoint(folder / "5").state, sampleState(2)));
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(Checkpoint, InitialStateLeavesOtherFiles)
{
    TemporaryFolder const folder;
    std::filesystem::create_directory(folder / "0");
    std::ofstream(folder / "0/U") << "given field";
    writeInitialState(folder / "0", sampleState(1), sampleInfo(0, 0));
    writeInitialState(folder / "0", sampleState(2), sampleInfo(0, 0));
    EXPECT_TRUE(sameBits(readCheckpoint(folder / "0").state, sampleState(2)));
    EXPECT_EQ(readBytes(folder / "0/U"), "given field");
    EXPECT_FALSE(std::filesystem::exists(folder / "0.part"));
}

TEST(Checkpoint, AnotherFormatVersionIsNamed)
{
    TemporaryFolder const folder;
    auto const path = writeCheckpoint(folder.path(), "5", sampleState(), sampleInfo(5, 1));
    std::string text = readBytes(path / "MANIFEST");
    std::string const version = "formatVersion 1";
    text.replace(text.find(version), version.size(), "formatVersion 9");
    text.resize(text.rfind("crc32c"));
    text += "crc32c " + crcText(crc32c(text)) + "\n";
    atomicWrite(path / "MANIFEST", text);
    try
    {
        readCheckpoint(path);
        FAIL();
    }
    catch (CaseError const& error)
    {
        EXPECT_EQ(error.code(), ExitCode::InputOutput);
        EXPECT_NE(std::string(error.what()).find("format version 9"), std::string::npos);
    }
}

} // namespace
} // namespace mpsDem
