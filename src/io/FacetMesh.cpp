#include <algorithm>

#include "io/FacetShells.h"

namespace mpsDem {

namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

bool before(FacetMesh::Side const& s, FacetMesh::Side const& t)
{
    return s.low != t.low ? s.low < t.low : s.high != t.high ? s.high < t.high : s.triangle < t.triangle;
}

} // namespace

void FacetMesh::add(TriSurface::Corners const& corners, int ofFacet)
{
    triangles.push_back(corners);
    facet.push_back(ofFacet);
}

void FacetMesh::erase(std::vector<char> const& marked)
{
    std::size_t kept = 0;
    for (std::size_t t = 0; t < triangles.size(); ++t)
    {
        if (marked[t] != 0) continue;
        triangles[kept] = triangles[t];
        facet[kept++] = facet[t];
    }
    triangles.resize(kept);
    facet.resize(kept);
}

Real FacetMesh::height(TriSurface::Corners const& corners) const
{
    Vector const &a = points[at(corners[0])], &b = points[at(corners[1])], &c = points[at(corners[2])];
    Real const longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
    return longest > 0 ? (b - a).cross(c - a).norm() / longest : 0;
}

std::vector<FacetMesh::Side> FacetMesh::sides() const
{
    std::vector<Side> all;
    all.reserve(3 * triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (int k = 0; k < 3; ++k)
        {
            int const a = triangles[t][at(k)], b = triangles[t][at((k + 1) % 3)];
            all.push_back({std::min(a, b), std::max(a, b), static_cast<int>(t), a < b});
        }
    std::sort(all.begin(), all.end(), before);
    return all;
}

std::pair<int, int> FacetMesh::acrossLongest(std::vector<Side> const& sides, int triangle) const
{
    TriSurface::Corners const& c = triangles[at(triangle)];
    int longest = 0;
    Real length = -1;
    for (int k = 0; k < 3; ++k)
    {
        Real const own = (points[at(c[at((k + 1) % 3)])] - points[at(c[at(k)])]).norm();
        if (own <= length) continue;
        length = own;
        longest = k;
    }
    int const a = c[at(longest)], b = c[at((longest + 1) % 3)];
    Side const first{std::min(a, b), std::max(a, b), -1, true};
    int others = 0, other = -1;
    for (auto side = std::lower_bound(sides.begin(), sides.end(), first, before);
         side != sides.end() && side->low == first.low && side->high == first.high; ++side)
        if (side->triangle != triangle)
        {
            ++others;
            other = side->triangle;
        }
    return {c[at((longest + 2) % 3)], others == 1 ? other : -1};
}

void FacetMesh::split(int triangle, int line, int point)
{
    TriSurface::Corners const whole = triangles[at(triangle)], gone = triangles[at(line)];
    auto const shared = [&](int p) { return p != point && std::find(gone.begin(), gone.end(), p) != gone.end(); };
    int k = 0;
    while (k < 2 && !(shared(whole[at(k)]) && shared(whole[at((k + 1) % 3)]))) ++k;
    int const p = whole[at(k)], q = whole[at((k + 1) % 3)], d = whole[at((k + 2) % 3)];
    triangles[at(triangle)] = {p, point, d};
    triangles[at(line)] = {point, q, d};
    facet[at(line)] = facet[at(triangle)];
}

Vector FacetMesh::middle(Side const& side) const { return (points[at(side.low)] + points[at(side.high)]) / 2; }

std::string placeText(Vector const& r) { return "(" + shortNumber(r.x()) + " " + shortNumber(r.y()) + " " + shortNumber(r.z()) + ")"; }

} // namespace mpsDem
