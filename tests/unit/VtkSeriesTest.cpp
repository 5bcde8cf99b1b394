#include <fstream>

#include <gtest/gtest.h>

#include "core/Errors.h"
#include "core/Log.h"
#include "io/OutputFile.h"
#include "io/VtkSeries.h"
#include "io/WriteFault.h"
#include "support/TemporaryFolder.h"

namespace mpsDem {
namespace {

std::vector<Vector> const onePoint = {Vector(1, 2, 0)};

PointCloud cloud()
{
    PointCloud cloud;
    cloud.position = onePoint;
    return cloud;
}

std::vector<Real> timesOf(std::filesystem::path const& series)
{
    std::vector<Real> times;
    for (SeriesEntry const& entry : readSeries(series)) times.push_back(entry.time);
    return times;
}

TEST(VtkSeries, NumbersFilesAndListsTimes)
{
    TemporaryFolder const folder;
    VtkSeries series(folder.path(), "particles");
    for (Real const time : {0.0, 0.1, 0.2}) series.write(time, cloud());
    EXPECT_EQ(readBytes(folder / "VTK/particles.vtp.series"), "{\"file-series-version\":\"1.0\",\"files\":[\n"
                                                              "{\"name\":\"particles/particles_000000.vtp\",\"time\":0},\n"
                                                              "{\"name\":\"particles/particles_000001.vtp\",\"time\":0.1},\n"
                                                              "{\"name\":\"particles/particles_000002.vtp\",\"time\":0.2}\n]}\n");
    for (SeriesEntry const& entry : readSeries(series.seriesFile())) EXPECT_EQ(readPointCloud(entry.file).time, entry.time);
}

TEST(VtkSeries, ConstructionTouchesNothing)
{
    TemporaryFolder const folder;
    VtkSeries const series(folder.path(), "particles");
    EXPECT_FALSE(std::filesystem::exists(folder / "VTK"));
    EXPECT_THROW(VtkSeries(folder.path(), "a/b"), CaseError);
}

TEST(VtkSeries, RestartDropsLaterEntriesAndGoesOnCounting)
{
    TemporaryFolder const folder;
    {
        VtkSeries series(folder.path(), "particles");
        for (int i = 0; i <= 5; ++i) series.write(0.1 * i, cloud());
    }
    VtkSeries series(folder.path(), "particles");
    series.startAt(0.3); // 0.1 * 3 is a little more than 0.3: the same time
    EXPECT_EQ(timesOf(series.seriesFile()), (std::vector<Real>{0, 0.1, 0.2, 0.1 * 3}));
    EXPECT_TRUE(std::filesystem::exists(folder / "VTK/particles/particles_000003.vtp"));
    EXPECT_FALSE(std::filesystem::exists(folder / "VTK/particles/particles_000004.vtp"));
    EXPECT_FALSE(std::filesystem::exists(folder / "VTK/particles/particles_000005.vtp"));
    series.write(0.45, cloud());
    EXPECT_EQ(readSeries(series.seriesFile()).back().file, folder / "VTK/particles/particles_000004.vtp");
}

TEST(VtkSeries, AFreshRunReplacesTheOldOne)
{
    TemporaryFolder const folder;
    for (int run = 0; run < 2; ++run)
    {
        VtkSeries series(folder.path(), "particles");
        series.write(0.0, cloud());
        EXPECT_EQ(timesOf(series.seriesFile()), std::vector<Real>{0});
        series.write(0.1, cloud());
    }
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder / "VTK/particles"), {}), 2);
}

TEST(VtkSeries, OnlyOwnFilesAreRemoved)
{
    TemporaryFolder const folder;
    VtkSeries(folder.path(), "a").write(1, cloud());
    std::ofstream(folder / "precious_1.vtp") << "x";
    atomicWrite(folder / "VTK/a.vtp.series", R"({"file-series-version":"1.0","files":[{"name":"../precious_1.vtp","time":5}]})");
    VtkSeries(folder.path(), "a").startAt(1);
    EXPECT_TRUE(std::filesystem::exists(folder / "precious_1.vtp"));
}

TEST(VtkSeries, ADamagedSeriesFileIsAWarning)
{
    TemporaryFolder const folder;
    atomicWrite(folder / "VTK/a.vtp.series", "{\"files\":[{");
    EXPECT_THROW(readSeries(folder / "VTK/a.vtp.series"), CaseError);
    muteLog(true);
    int const before = warningCount();
    VtkSeries series(folder.path(), "a");
    series.write(1, cloud());
    muteLog(false);
    EXPECT_EQ(warningCount(), before + 1);
    EXPECT_EQ(timesOf(series.seriesFile()), std::vector<Real>{1});
}

TEST(VtkSeries, SurfaceSeries)
{
    TemporaryFolder const folder;
    std::vector<Vector> const points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    SurfaceCells outline;
    outline.points = points;
    outline.polygons = {{0, 1, 2}};
    VtkSeries series(folder.path(), "slide");
    series.write(0.5, outline);
    EXPECT_EQ(readSurface(readSeries(series.seriesFile()).front().file).polygons, outline.polygons);
}

TEST(VtkSeries, AFailedWriteLeavesTheSeriesReadable)
{
    TemporaryFolder const folder;
    for (int n = 1;; ++n)
    {
        std::string const name = "a" + std::to_string(n);
        VtkSeries series(folder.path(), name);
        series.write(0, cloud());
        bool failed = false;
        setWriteFault(n);
        try
        {
            series.write(1, cloud());
        }
        catch (CaseError const& error)
        {
            failed = true;
            EXPECT_EQ(error.code(), ExitCode::InputOutput);
            EXPECT_NE(std::string(error.what()).find(name), std::string::npos);
        }
        setWriteFault(0);
        for (SeriesEntry const& entry : readSeries(series.seriesFile())) EXPECT_EQ(readPointCloud(entry.file).time, entry.time);
        if (!failed)
        {
            EXPECT_EQ(n, 9); // open, write, close, rename of two files fail one after the other
            break;
        }
    }
}

} // namespace
} // namespace mpsDem
