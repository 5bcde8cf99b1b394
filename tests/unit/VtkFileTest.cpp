#include <fstream>

#include <gtest/gtest.h>

#include "core/Errors.h"
#include "io/OutputFile.h"
#include "io/VtkFile.h"
#include "support/TemporaryFolder.h"

namespace mpsDem {
namespace {

/// Particles with an array of each kind; the views point into the object.
struct Sample
{
    std::vector<Vector> position, velocity;
    std::vector<Real> pressure;
    std::vector<int> type;
    std::vector<std::int64_t> id;
    std::vector<std::uint8_t> surface;

    explicit Sample(int n)
    {
        for (int i = 0; i < n; ++i)
        {
            position.emplace_back(0.1 * i, 1.0 / (i + 1), 0.0);
            velocity.emplace_back(-i, 0.5 * i, 0.0);
            pressure.push_back(1000.0 / 3 * i);
            type.push_back(i % 3 - 1);
            id.push_back((std::int64_t{1} << 53) + 1 + i);
            surface.push_back(static_cast<std::uint8_t>(i % 2));
        }
    }

    [[nodiscard]] PointCloud cloud() const
    {
        PointCloud cloud;
        cloud.position = position;
        cloud.vectors.emplace_back("U", velocity);
        cloud.scalars.emplace_back("p", pressure);
        cloud.integers.emplace_back("type", std::span<int const>(type));
        cloud.integers.emplace_back("id", std::span<std::int64_t const>(id));
        cloud.integers.emplace_back("freeSurface", std::span<std::uint8_t const>(surface));
        return cloud;
    }
};

TEST(VtkFile, DoublePrecisionRoundTripIsExact)
{
    TemporaryFolder const folder;
    Sample const sample(5000); // more than one compressed block
    writePointCloud(folder / "a.vtp", sample.cloud(), 0.1, VtkPrecision::Double);
    PointCloudData const back = readPointCloud(folder / "a.vtp");
    EXPECT_EQ(back.time, 0.1);
    EXPECT_EQ(back.position, sample.position);
    EXPECT_EQ(back.vectors.at("U"), sample.velocity);
    EXPECT_EQ(back.scalars.at("p"), sample.pressure);
    EXPECT_EQ(back.integers.at("id"), sample.id);
    EXPECT_EQ(back.integers.at("type"), std::vector<std::int64_t>(sample.type.begin(), sample.type.end()));
    EXPECT_EQ(back.integers.at("freeSurface"), std::vector<std::int64_t>(sample.surface.begin(), sample.surface.end()));
}

TEST(VtkFile, SinglePrecisionKeepsSevenDigits)
{
    TemporaryFolder const folder;
    Sample const sample(100);
    writePointCloud(folder / "a.vtp", sample.cloud(), 1.0 / 3);
    PointCloudData const back = readPointCloud(folder / "a.vtp");
    EXPECT_EQ(back.time, 1.0 / 3); // the time keeps all digits
    ASSERT_EQ(back.scalars.at("p").size(), sample.pressure.size());
    for (std::size_t i = 0; i < sample.pressure.size(); ++i)
    {
        EXPECT_NEAR(back.scalars.at("p")[i], sample.pressure[i], 6e-8 * sample.pressure[i]); // half a unit of 24 bits
        EXPECT_NEAR((back.position[i] - sample.position[i]).norm(), 0, 1.2e-7 * sample.position[i].norm());
    }
}

TEST(VtkFile, WritesWhatEveryReaderTakes)
{
    TemporaryFolder const folder;
    Sample const sample(10);
    writePointCloud(folder / "a.vtp", sample.cloud(), 0.1);
    std::string const text = readBytes(folder / "a.vtp");
    EXPECT_NE(text.find("vtkZLibDataCompressor"), std::string::npos);
    EXPECT_NE(text.find("format=\"binary\""), std::string::npos);
    EXPECT_EQ(text.find("AppendedData"), std::string::npos);
    EXPECT_NE(text.find("NumberOfVerts=\"10\""), std::string::npos);
    EXPECT_NE(text.find("TimeValue"), std::string::npos);
    EXPECT_NE(text.find("<DataArray type=\"Float32\" Name=\"p\""), std::string::npos);
}

TEST(VtkFile, NoParticlesIsFine)
{
    TemporaryFolder const folder;
    writePointCloud(folder / "a.vtp", Sample(0).cloud(), 2);
    PointCloudData const back = readPointCloud(folder / "a.vtp");
    EXPECT_EQ(back.time, 2);
    EXPECT_TRUE(back.position.empty());
}

TEST(VtkFile, SurfaceWithCellArrays)
{
    TemporaryFolder const folder;
    std::vector<Vector> const points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 1.5, 0}};
    std::vector<Real> const load = {1, 2, 3};
    SurfaceCells surface;
    surface.points = points;
    surface.lines = {{0, 1}};
    surface.polygons = {{0, 1, 2, 3}, {3, 2, 4}};
    surface.scalars.emplace_back("load", load);
    writeSurface(folder / "slide.vtp", surface, 0.5, VtkPrecision::Double);
    SurfaceData const back = readSurface(folder / "slide.vtp");
    EXPECT_EQ(back.time, 0.5);
    EXPECT_EQ(back.points, points);
    EXPECT_EQ(back.lines, surface.lines);
    EXPECT_EQ(back.polygons, surface.polygons);
    EXPECT_EQ(back.scalars.at("load"), load); // lines first
}

TEST(VtkFile, ArraysOfAnotherLengthAreRefused)
{
    TemporaryFolder const folder;
    Sample sample(3);
    sample.pressure.pop_back();
    EXPECT_THROW(writePointCloud(folder / "a.vtp", sample.cloud(), 0), std::logic_error);
    EXPECT_FALSE(std::filesystem::exists(folder / "a.vtp"));
}

TEST(VtkFile, UnreadableFilesAreErrors)
{
    TemporaryFolder const folder;
    EXPECT_THROW(readPointCloud(folder / "none.vtp"), CaseError);
    std::ofstream(folder / "text.vtp") << "no XML at all";
    EXPECT_THROW(readPointCloud(folder / "text.vtp"), CaseError);
    writePointCloud(folder / "a.vtp", Sample(100).cloud(), 0);
    std::filesystem::resize_file(folder / "a.vtp", std::filesystem::file_size(folder / "a.vtp") / 2);
    EXPECT_THROW(readPointCloud(folder / "a.vtp"), CaseError);
}

} // namespace
} // namespace mpsDem
