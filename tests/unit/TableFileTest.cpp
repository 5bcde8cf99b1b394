#include <fstream>

#include <gtest/gtest.h>

#include "core/Errors.h"
#include "io/OutputFile.h"
#include "io/Table.h"
#include "io/TableFile.h"
#include "support/TemporaryFolder.h"

namespace mpsDem {
namespace {

/// What readTable says about this content.
std::string complaint(std::string const& content)
{
    TemporaryFolder const folder;
    std::ofstream(folder / "t.csv", std::ios::binary) << content;
    try
    {
        readTable(folder / "t.csv");
    }
    catch (CaseError const& error)
    {
        EXPECT_EQ(error.code(), ExitCode::BadInput);
        std::string const text = error.what();
        return text.substr(text.find("t.csv"));
    }
    return {};
}

Table tableOf(std::string const& content)
{
    TemporaryFolder const folder;
    std::ofstream(folder / "t.csv", std::ios::binary) << content;
    return readTable(folder / "t.csv");
}

TEST(TableFile, WritesHeaderAndRows)
{
    TemporaryFolder const folder;
    TableFile table(folder.path(), "gauges", "0", "interfaceHeight", {"eta1[m]", "eta2[m]"}, {{"gauge 1 at (0.1 0 0)"}, 3});
    table.add(0.5, std::vector<Real>{1.0 / 3, -2e-9});
    EXPECT_EQ(table.path(), folder / "postProcessing/gauges/0/interfaceHeight.dat");
    EXPECT_EQ(readBytes(table.path()), "# gauge 1 at (0.1 0 0)\n"
                                       "# Time      eta1[m]     eta2[m]\n"
                                       "0.5         0.333       -2e-09\n"); // on disk while the file is still open
}

TEST(TableFile, RoundTripToTheGivenDigits)
{
    TemporaryFolder const folder;
    TableFile table(folder.path(), "forces", "0.1", "force", {"Fx", "Fy"}, {{}, 17});
    std::vector<Real> const values = {1.0 / 3, -1e300};
    table.add(0.1, values);
    table.add(0.2, std::vector<Real>{0, 5e-324});
    Table const back = readTable(table.path());
    EXPECT_EQ(back.names, (std::vector<std::string>{"Time", "Fx", "Fy"}));
    EXPECT_EQ(back.rows(), 2u);
    EXPECT_EQ(back.column("Fx")[0], values[0]);
    EXPECT_EQ(back.column("Fy")[0], values[1]);
    EXPECT_EQ(back.column("Fy")[1], 5e-324);
}

TEST(TableFile, TenDigitsByDefault)
{
    TemporaryFolder const folder;
    TableFile table(folder.path(), "probes", "0", "p", {"p0"});
    table.add(1, std::vector<Real>{1.0 / 3});
    EXPECT_NEAR(readTable(table.path()).column("p0")[0], 1.0 / 3, 0.5e-10);
}

TEST(TableFile, ARerunLeavesTheFirstFile)
{
    TemporaryFolder const folder;
    std::vector<std::string> names;
    for (int run = 0; run < 4; ++run)
    {
        TableFile table(folder.path(), "probes", "0.5", "p", {"p0"});
        table.add(1, std::vector<Real>{Real(run)});
        names.push_back(table.path().filename());
        EXPECT_EQ(readTable(table.path()).column("p0")[0], run);
    }
    EXPECT_EQ(names, (std::vector<std::string>{"p.dat", "p_0.5.dat", "p_0.5_2.dat", "p_0.5_3.dat"}));
}

TEST(TableFile, WithoutRowsThereIsNoFile)
{
    TemporaryFolder const folder;
    {
        TableFile const table(folder.path(), "probes", "0", "p", {"p0"});
    }
    EXPECT_FALSE(std::filesystem::exists(folder / "postProcessing"));
    EXPECT_THROW(TableFile(folder.path(), "probes", "0", "p", {"two words"}), std::logic_error);
}

TEST(Table, ReadsCsvWithHeading)
{
    Table const table = tableOf("\xEF\xBB\xBF# digitised from figure 7\r\n\"t [s]\", eta\r\n0, 1e-3\r\n\r\n0.5,+2e-3\r\n");
    EXPECT_EQ(table.names, (std::vector<std::string>{"t [s]", "eta"}));
    EXPECT_EQ(table.column("t [s]"), (std::vector<Real>{0, 0.5}));
    EXPECT_EQ(table.column("eta"), (std::vector<Real>{1e-3, 2e-3}));
    EXPECT_FALSE(table.has("Time"));
}

TEST(Table, ColumnsWithoutNamesAreNumbered)
{
    Table const table = tableOf("# a remark of several words\n1 2\n3\t4");
    EXPECT_EQ(table.names, (std::vector<std::string>{"column1", "column2"}));
    EXPECT_EQ(table.column("column2"), (std::vector<Real>{2, 4}));
}

TEST(Table, ErrorsNameTheLine)
{
    EXPECT_EQ(complaint("t,eta\n0,1\n1,x\n").substr(0, 28), "t.csv:3: \"x\" is no number\n  ");
    EXPECT_EQ(complaint("t,eta\n0,1\n1\n"), "t.csv:3: the row has 1 numbers, the lines before have 2");
    EXPECT_EQ(complaint("t,eta\n0,1,2\n"), "t.csv:2: the row has 3 numbers, the lines before have 2");
    EXPECT_EQ(complaint("0,1\n1,\n").substr(0, 25), "t.csv:2: \"\" is no number\n");
    EXPECT_EQ(complaint("0 1\n1 0x10\n").substr(0, 29), "t.csv:2: \"0x10\" is no number\n");
    EXPECT_EQ(complaint("0 1\nt eta\n").substr(0, 26), "t.csv:2: \"t\" is no number\n");
    EXPECT_EQ(complaint("# nothing\n"), "t.csv: the table has no rows");
}

TEST(Table, UnknownColumnNamesTheNearest)
{
    Table const table = tableOf("# Time eta1\n0 1\n");
    try
    {
        (void)table.column("eta2");
        FAIL();
    }
    catch (CaseError const& error)
    {
        EXPECT_NE(std::string(error.what()).find("known columns: Time, eta1   (did you mean eta1?)"), std::string::npos);
    }
}

TEST(Table, MissingFileIsAnError)
{
    TemporaryFolder const folder;
    EXPECT_THROW(readTable(folder / "none.dat"), CaseError);
    EXPECT_THROW(readTable(folder.path()), CaseError);
}

} // namespace
} // namespace mpsDem
