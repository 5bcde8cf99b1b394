#include "io/FacetShells.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/OnceLog.h"

namespace mpsDem {

namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Beyond each side of a triangle: the neighbour and whether both wind the same way around.
struct Neighbours
{
    std::array<int, 3> triangle{-1, -1, -1};
    std::array<bool, 3> agrees{};
    int count = 0;

    void add(int other, bool same)
    {
        triangle[at(count)] = other;
        agrees[at(count++)] = same;
    }
};

/// A connected piece of surface: triangles in the order in which they were reached.
struct Shell
{
    std::vector<int> triangles;
    Vector low = Vector::Zero(), high = Vector::Zero(); ///< Corners of its box [m], of a closed one.
};

class Orienter
{
public:
    Orienter(FacetMesh& mesh, FacetSoup const& soup, std::string const& name) : mesh_(mesh), soup_(soup), name_(name) {}

    void run(bool closed)
    {
        findNeighbours(closed);
        findShells();
        for (Shell& shell : shells_) settle(shell, closed);
        requireOneWinding();
        for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
            if (turned_[t] == 1) std::swap(mesh_.triangles[t][1], mesh_.triangles[t][2]);
        tell();
        if (!closed) return;
        requireApart();
        if (shells_.size() > 1 && soup_.solids <= 1) // of several solids the reader of the file tells
            infoOnce("Surface \"" + name_ + "\": its " + std::to_string(shells_.size()) +
                     " shells, which do not touch, are taken as one solid");
    }

private:
    [[nodiscard]] std::string facetText(int triangle) const { return "facet " + std::to_string(mesh_.facet[at(triangle)] + 1); }
    [[nodiscard]] Location place(int triangle) const { return soup_.place(at(mesh_.facet[at(triangle)])); }

    void findNeighbours(bool closed)
    {
        neighbours_.resize(mesh_.triangles.size());
        std::vector<FacetMesh::Side> const sides = mesh_.sides();
        int rims = 0;
        FacetMesh::Side const* rim = nullptr;
        for (std::size_t i = 0; i < sides.size();)
        {
            std::size_t end = i + 1;
            while (end < sides.size() && sides[end].low == sides[i].low && sides[end].high == sides[i].high) ++end;
            if (end - i > 2) refuseEdge(sides, i, end);
            if (end - i == 2)
            {
                bool const same = sides[i].forwards != sides[i + 1].forwards;
                neighbours_[at(sides[i].triangle)].add(sides[i + 1].triangle, same);
                neighbours_[at(sides[i + 1].triangle)].add(sides[i].triangle, same);
            }
            else if (rims++ == 0)
                rim = &sides[i];
            i = end;
        }
        if (!closed || rims == 0) return;
        throw CaseError(ExitCode::BadInput, place(rim->triangle),
                        "surface \"" + name_ + "\" is open: " + std::to_string(rims) +
                            " edges belong to one facet only, the first one at " + placeText(mesh_.middle(*rim)) + " m to " +
                            facetText(rim->triangle),
                        "a closed surface");
    }

    [[noreturn]] void refuseEdge(std::vector<FacetMesh::Side> const& sides, std::size_t begin, std::size_t end) const
    {
        std::string text = facetText(sides[begin].triangle);
        for (std::size_t k = begin + 1; k < std::min(end, begin + 6); ++k)
            text += ", " + std::to_string(mesh_.facet[at(sides[k].triangle)] + 1);
        throw CaseError(ExitCode::BadInput, place(sides[begin].triangle),
                        "surface \"" + name_ + "\": the edge at " + placeText(mesh_.middle(sides[begin])) + " m belongs to " +
                            std::to_string(end - begin) + " facets: " + text,
                        "two, or one at a rim; surfaces that meet in a line: a file each");
    }

    void findShells()
    {
        turned_.assign(mesh_.triangles.size(), -1);
        for (std::size_t start = 0; start < mesh_.triangles.size(); ++start)
        {
            if (turned_[start] >= 0) continue;
            turned_[start] = 0;
            Shell shell;
            shell.triangles.push_back(static_cast<int>(start));
            for (std::size_t next = 0; next < shell.triangles.size(); ++next) reachFrom(shell.triangles[next], shell);
            shells_.push_back(std::move(shell));
        }
    }

    void reachFrom(int t, Shell& shell)
    {
        Neighbours const& beside = neighbours_[at(t)];
        for (int k = 0; k < beside.count; ++k)
        {
            int const other = beside.triangle[at(k)];
            signed char const wanted = beside.agrees[at(k)] ? turned_[at(t)] : static_cast<signed char>(1 - turned_[at(t)]);
            if (turned_[at(other)] < 0)
            {
                turned_[at(other)] = wanted;
                shell.triangles.push_back(other);
            }
            require(turned_[at(other)] == wanted, place(other),
                    "surface \"" + name_ + "\" has no two sides: " + facetText(other) + " cannot be turned to agree with " + facetText(t) +
                        " and all others",
                    "a surface with an inside and an outside");
        }
    }

    /// The side that most facets of the piece have, with `closed` the outside.
    void settle(Shell& shell, bool closed)
    {
        std::size_t others = 0;
        for (int const t : shell.triangles) others += at(turned_[at(t)]);
        bool const base = 2 * others > shell.triangles.size(); // most facets lie as those marked 1
        bool const inward = closed && (volume(shell) < 0) != base;
        for (int const t : shell.triangles)
        {
            bool const minority = (turned_[at(t)] == 1) != base;
            if (minority && mixed_++ == 0) firstMixed_ = t;
            turned_[at(t)] = minority != inward ? 1 : 0;
        }
        if (inward && inward_++ == 0) firstInward_ = shell.triangles.front();
    }

    /// Signed, with the turns so far; refuses a shell that has none [m3].
    [[nodiscard]] Real volume(Shell& shell) const
    {
        Vector const& first = mesh_.points[at(mesh_.triangles[at(shell.triangles.front())][0])];
        shell.low = shell.high = first;
        Real sum = 0, area = 0;
        for (int const t : shell.triangles)
        {
            std::array<Vector, 3> r;
            for (int k = 0; k < 3; ++k)
            {
                Vector const& point = mesh_.points[at(mesh_.triangles[at(t)][at(k)])];
                r[at(k)] = point - first;
                shell.low = shell.low.cwiseMin(point);
                shell.high = shell.high.cwiseMax(point);
            }
            sum += (turned_[at(t)] == 1 ? -1 : 1) * r[0].dot(r[1].cross(r[2])) / 6;
            area += (r[1] - r[0]).cross(r[2] - r[0]).norm() / 2;
        }
        require(std::abs(sum) > 1e-9 * std::pow(area, 1.5), place(shell.triangles.front()),
                "surface \"" + name_ + "\": the shell of " + facetText(shell.triangles.front()) + " has no volume",
                "a solid with a thickness");
        return sum;
    }

    void tell() const
    {
        if (inward_ > 0)
            infoOnce("Surface \"" + name_ + "\": " + std::to_string(inward_) + " of " + std::to_string(shells_.size()) +
                     " shells had their normals on the inside and are turned, the first one that of facet " +
                     std::to_string(mesh_.facet[at(firstInward_)] + 1) + " of " + soup_.file.file);
    }

    /// Which side was meant is not known where neighbours disagree.
    void requireOneWinding() const
    {
        require(mixed_ == 0, place(firstMixed_),
                "surface \"" + name_ + "\": " + std::to_string(mixed_) + " of " + std::to_string(mesh_.triangles.size()) +
                    " facets wind the other way than their neighbours, the first one " + facetText(firstMixed_),
                "facets that all wind one way: a mesh tool calls it to unify or to orient normals");
    }

    /// 1 within a closed shell, 0 outside: the sum of the solid angles of its triangles over 4 pi (van Oosterom and Strackee 1983).
    [[nodiscard]] Real windingNumber(Shell const& shell, Vector const& r) const
    {
        Real sum = 0;
        for (int const t : shell.triangles)
        {
            TriSurface::Corners const& corner = mesh_.triangles[at(t)];
            Vector const a = mesh_.points[at(corner[0])] - r, b = mesh_.points[at(corner[1])] - r, c = mesh_.points[at(corner[2])] - r;
            Real const na = a.norm(), nb = b.norm(), nc = c.norm();
            sum += 2 * std::atan2(a.dot(b.cross(c)), na * nb * nc + a.dot(b) * nc + b.dot(c) * na + c.dot(a) * nb);
        }
        return sum / (4 * std::numbers::pi);
    }

    /// No shell within another one.
    void requireApart() const
    {
        for (Shell const& outer : shells_)
            for (Shell const& inner : shells_)
            {
                if (&inner == &outer || (inner.low.array() < outer.low.array()).any() || (inner.high.array() > outer.high.array()).any())
                    continue;
                int const t = inner.triangles.front();
                Vector const& r = mesh_.points[at(mesh_.triangles[at(t)][0])];
                require(windingNumber(outer, r) < 0.75, place(t),
                        "surface \"" + name_ + "\": the shell of " + facetText(t) + " at " + placeText(r) + " m lies within that of " +
                            facetText(outer.triangles.front()),
                        "shells side by side; a hollow body: its outer shell and its mass");
            }
    }

    FacetMesh& mesh_;
    FacetSoup const& soup_;
    std::string const& name_;
    std::vector<Neighbours> neighbours_;
    std::vector<Shell> shells_;
    std::vector<signed char> turned_; ///< -1 not reached, 1 to be turned.
    int mixed_ = 0, firstMixed_ = 0, inward_ = 0, firstInward_ = 0;
};

} // namespace

void orientFacets(FacetMesh& mesh, FacetSoup const& soup, bool closed, std::string const& name) { Orienter(mesh, soup, name).run(closed); }

} // namespace mpsDem
