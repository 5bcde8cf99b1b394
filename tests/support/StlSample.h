#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/Errors.h"
#include "core/OnceLog.h"
#include "io/StlFile.h"
#include "support/TemporaryFolder.h"

namespace mpsDem::test {

using Facets = std::vector<FacetSoup::Facet>;

inline Facets facetsOf(TriSurface const& surface)
{
    Facets facets;
    for (auto const& t : surface.triangles()) facets.push_back({surface.point(t, 0), surface.point(t, 1), surface.point(t, 2)});
    return facets;
}

inline Facets boxFacets(Vector const& low = {0, 0, 0}, Vector const& high = {1, 2, 3})
{
    return facetsOf(TriSurface::box("box", low, high));
}

inline std::string binaryOf(Facets const& facets, std::string head = "box")
{
    head.resize(80, ' ');
    auto const count = static_cast<std::uint32_t>(facets.size());
    head.append(reinterpret_cast<char const*>(&count), 4);
    for (auto const& facet : facets)
    {
        head.append(12, '\0');
        for (Vector const& r : facet)
        {
            Eigen::Vector3f const single = r.cast<float>();
            head.append(reinterpret_cast<char const*>(single.data()), 12);
        }
        head.append(2, '\0');
    }
    return head;
}

inline std::string textOf(Facets const& facets)
{
    std::ostringstream out;
    out.precision(17);
    out << "solid box of the test\n";
    for (auto const& facet : facets)
    {
        out << "  facet normal 0 0 0\n    outer loop\n";
        for (Vector const& r : facet) out << "      vertex " << r.x() << ' ' << r.y() << ' ' << r.z() << '\n';
        out << "    endloop\n  endfacet\n";
    }
    out << "endsolid box\n";
    return out.str();
}

/// A file of its own, and what reading it says.
class StlSample : public ::testing::Test
{
protected:
    TriSurface read(std::string const& bytes, StlOptions const& options = {})
    {
        std::ofstream(path_, std::ios::binary) << bytes;
        return readStl(path_, "box", options);
    }
    TriSurface readClosed(std::string const& bytes)
    {
        StlOptions options;
        options.skin = Skin::Closed;
        return read(bytes, options);
    }
    /// What the log says while a surface is read.
    std::string notesOf(std::string const& bytes, StlOptions const& options = {})
    {
        forgetShown();
        ::testing::internal::CaptureStdout();
        ::testing::internal::CaptureStderr();
        static_cast<void>(read(bytes, options));
        std::string const warnings = ::testing::internal::GetCapturedStderr();
        return ::testing::internal::GetCapturedStdout() + warnings;
    }
    void expectRefused(std::string const& bytes, std::string const& fragment, Skin skin = Skin::Open, int line = 0)
    {
        try
        {
            StlOptions options;
            options.skin = skin;
            static_cast<void>(read(bytes, options));
            ADD_FAILURE() << "accepted, wanted: " << fragment;
        }
        catch (CaseError const& error)
        {
            EXPECT_EQ(error.code(), ExitCode::BadInput);
            EXPECT_NE(std::string(error.what()).find(fragment), std::string::npos) << error.what();
            EXPECT_EQ(error.where().file, path_.string());
            EXPECT_EQ(error.where().line, line) << error.what();
        }
    }

    TemporaryFolder folder_;
    std::filesystem::path path_ = folder_ / "box.stl";
};

} // namespace mpsDem::test
