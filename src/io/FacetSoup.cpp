#include "io/FacetSoup.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/OnceLog.h"
#include "io/FacetCrossings.h"
#include "io/FacetShells.h"

namespace mpsDem {

namespace {

constexpr Real farthest = 1e9;          ///< Coordinates, magnitude [m].
constexpr Real smallestExtent = 1e-9;   ///< [m]
constexpr Real weldingTolerance = 1e-9; ///< In extents.
constexpr Real flatness = 1e-7;         ///< Height of a triangle that counts as a line, in extents: the digits of a file of floats.

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Number of the point of each corner, three a facet. Sorted along a skew line, along which points seldom share their place unless they
/// coincide, so that only neighbours have to be compared. Points are numbered as the facets name them first.
std::vector<int> weld(FacetSoup const& soup, Real tolerance, std::vector<Vector>& points)
{
    Vector const along = Vector(0.5411961, 0.6180340, 0.5702217).normalized();
    Vector const origin = soup.facets.front()[0];
    std::size_t const count = 3 * soup.facets.size();
    auto const corner = [&](int i) -> Vector const& { return soup.facets[at(i) / 3][at(i) % 3]; };
    std::vector<std::pair<Real, int>> order(count);
    for (std::size_t i = 0; i < count; ++i) order[i] = {along.dot(corner(static_cast<int>(i)) - origin), static_cast<int>(i)};
    std::sort(order.begin(), order.end());

    std::vector<int> same(count);            // the corner that stands for each one
    std::vector<std::pair<Real, int>> found; // those that stand
    for (auto const& [key, i] : order)
    {
        same[at(i)] = i;
        for (std::size_t k = found.size(); k-- > 0 && key - found[k].first <= 2 * tolerance;)
            if ((corner(i) - corner(found[k].second)).norm() <= tolerance)
            {
                same[at(i)] = found[k].second;
                break;
            }
        if (same[at(i)] == i) found.emplace_back(key, i);
    }
    std::vector<int> number(count, -1), numbers(count);
    for (std::size_t i = 0; i < count; ++i)
    {
        int& own = number[at(same[i])];
        if (own < 0)
        {
            own = static_cast<int>(points.size());
            points.push_back(corner(same[i]));
        }
        numbers[i] = own;
    }
    return numbers;
}

/// Joins one soup; see joinFacets().
class Joiner
{
public:
    Joiner(FacetSoup const& soup, std::string const& name) : soup_(soup), name_(name) {}

    TriSurface run(Skin skin)
    {
        checkCorners();
        weldCorners();
        dropRepeated();
        for (int pass = 0; pass < 10 && splitNeighboursOfLines(pass == 9); ++pass)
        {}
        requireFacets();
        tell(collapsed_, "without area left out or joined to their neighbours");
        tell(repeated_, "given twice left out");
        orientFacets(mesh_, soup_, skin != Skin::Open, name_);
        if (skin == Skin::Body) requireNoCrossing(mesh_, soup_, name_, flatness * extent_);
        try
        {
            return TriSurface(name_, mesh_.points, mesh_.triangles);
        }
        catch (CaseError const& error)
        {
            throw CaseError(error.code(), soup_.file, error.what());
        }
    }

private:
    struct Count
    {
        int number = 0;
        int first = 0; ///< Facet.
        void add(int facet)
        {
            if (number++ == 0) first = facet;
        }
    };

    void tell(Count const& count, std::string const& what) const
    {
        if (count.number == 0) return;
        infoOnce("Surface \"" + name_ + "\": " + std::to_string(count.number) + " of " + std::to_string(soup_.facets.size()) + " facets " +
                 what + ", the first one facet " + std::to_string(count.first + 1) + " of " + soup_.file.file);
    }

    void requireFacets() const
    {
        require(!mesh_.triangles.empty(), soup_.file, "surface \"" + name_ + "\" has no facet with an area", "one or more");
    }

    void checkCorners()
    {
        require(!soup_.facets.empty(), soup_.file, "surface \"" + name_ + "\" has no facet", "one or more");
        require(soup_.facets.size() < 500'000'000, soup_.file, "surface \"" + name_ + "\" has too many facets", "fewer than 500 million");
        Vector low = soup_.facets[0][0], high = low;
        for (std::size_t f = 0; f < soup_.facets.size(); ++f)
            for (Vector const& r : soup_.facets[f])
            {
                require(r.allFinite(), soup_.place(f), "facet " + std::to_string(f + 1) + " has a corner that is not finite", "numbers");
                require(r.cwiseAbs().maxCoeff() <= farthest, soup_.place(f),
                        "facet " + std::to_string(f + 1) + " has a corner at " + placeText(r) + " m", "coordinates within 1e9 m");
                low = low.cwiseMin(r);
                high = high.cwiseMax(r);
            }
        Real const extent = (high - low).maxCoeff();
        require(extent >= smallestExtent, soup_.file, "surface \"" + name_ + "\" measures " + shortNumber(extent) + " m", "1e-9 m or more");
        extent_ = extent;
    }

    void weldCorners()
    {
        std::vector<int> const number = weld(soup_, weldingTolerance * extent_, mesh_.points);
        for (std::size_t f = 0; f < soup_.facets.size(); ++f)
        {
            TriSurface::Corners const c{number[3 * f], number[3 * f + 1], number[3 * f + 2]};
            if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0])
                collapsed_.add(static_cast<int>(f));
            else
                mesh_.add(c, static_cast<int>(f));
        }
        requireFacets();
    }

    /// Of facets with the same corners the first one stays; two that face each other's back are no surface.
    void dropRepeated()
    {
        struct Sorted
        {
            TriSurface::Corners corner;
            int triangle;
            bool even; ///< The winding, in rising order of the corners.
        };
        std::vector<Sorted> sorted;
        for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
        {
            TriSurface::Corners c = mesh_.triangles[t];
            bool const even = (c[0] < c[1]) + (c[1] < c[2]) + (c[2] < c[0]) == 2;
            std::sort(c.begin(), c.end());
            sorted.push_back({c, static_cast<int>(t), even});
        }
        std::sort(sorted.begin(), sorted.end(),
                  [](Sorted const& a, Sorted const& b) { return a.corner != b.corner ? a.corner < b.corner : a.triangle < b.triangle; });
        std::vector<char> drop(mesh_.triangles.size(), 0);
        for (std::size_t k = 1, first = 0; k < sorted.size(); ++k)
        {
            if (sorted[k].corner != sorted[first].corner)
            {
                first = k;
                continue;
            }
            int const one = mesh_.facet[at(sorted[first].triangle)], other = mesh_.facet[at(sorted[k].triangle)];
            require(sorted[k].even == sorted[first].even, soup_.place(at(other)),
                    "facet " + std::to_string(other + 1) + " lies on the back of facet " + std::to_string(one + 1),
                    "a solid with a thickness");
            drop[at(sorted[k].triangle)] = 1;
            repeated_.add(other);
        }
        mesh_.erase(drop);
    }

    /// A triangle whose corners lie in a line: the neighbour along its longest side is split at the third
    /// corner and the triangle is no more. One without a neighbour there, or all that are left, go. @return whether there was one.
    bool splitNeighboursOfLines(bool last)
    {
        std::vector<int> lines;
        for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
            if (mesh_.height(mesh_.triangles[t]) <= flatness * extent_) lines.push_back(static_cast<int>(t));
        if (lines.empty()) return false;
        std::vector<FacetMesh::Side> const sides = mesh_.sides();
        std::vector<char> drop(mesh_.triangles.size(), 0), touched(mesh_.triangles.size(), 0);
        for (int const t : lines)
        {
            auto const [apex, other] = mesh_.acrossLongest(sides, t);
            bool const goes = other < 0 || last;
            if (touched[at(t)] != 0 || (!goes && touched[at(other)] != 0)) continue; // the next pass
            collapsed_.add(mesh_.facet[at(t)]);
            touched[at(t)] = 1;
            if (goes)
                drop[at(t)] = 1;
            else
            {
                touched[at(other)] = 1;
                mesh_.split(other, t, apex);
            }
        }
        mesh_.erase(drop);
        return true;
    }

    FacetSoup const& soup_;
    std::string const& name_;
    FacetMesh mesh_;
    Real extent_ = 0;
    Count collapsed_, repeated_;
};

} // namespace

Location FacetSoup::place(std::size_t facet) const
{
    Location where = file;
    if (facet < lines.size()) where.line = lines[facet];
    return where;
}

TriSurface joinFacets(FacetSoup const& soup, std::string const& name, Skin skin) { return Joiner(soup, name).run(skin); }

} // namespace mpsDem
