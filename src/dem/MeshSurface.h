#pragma once

#include <span>
#include <utility>
#include <vector>

#include "dem/ContactSurface.h"
#include "dem/MeshFaces.h"
#include "dem/TriangleGrid.h"

namespace mpsDem {

/// A triangle surface as contact surface: faces, edges and vertices without double forces.
///
/// A face touches a sphere whose centre projects on it; a ridge, a rim or a vertex touches one whose centre has there the nearest point
/// of the surface around. So the distance is continuous over all joints of facets, and joints within a plane are not felt. In a valley both faces touch.
/// A centre behind the surface belongs to the nearest face (and to those beyond a valley of it).
///
/// Of the features of one sphere an edge or a vertex is dropped where its point lies on a face that touches, and of features whose
/// normals agree within 5 degrees only the first stays: faces before edges before vertices, the deepest first.
/// Keys: the plane patch for a face, numbers above all patches for edges, above those for vertices.
/// Source of the rule: S. Luding, Granular Matter 10 (2008), 4; Hu et al., Powder Technology 246 (2013): one force for one touching place.
class MeshSurface final : public ContactSurface
{
public:
    /// @param depth    How far behind the surface a centre is still found [m]; the spacing.
    /// @param all      Surfaces at rest, this one among them, on which its rims may lie, see rimCovers. @param own  Number of this one.
    MeshSurface(std::span<TriSurface const> all, std::size_t own, Real depth);
    /// One alone: the skin of a body.
    MeshSurface(TriSurface const& surface, Real depth) : MeshSurface(std::span<TriSurface const>(&surface, 1), 0, depth) {}

    void collect(std::span<Sphere const> spheres, Real reach, std::vector<ContactFeature>& features) const override;
    void findNear(std::span<Sphere const> spheres, Real reach, std::vector<int>& numbers) const override;

    /// Numbers of triangles near a place, for whoever measures the inside of a body.
    [[nodiscard]] TriangleGrid const& grid() const { return grid_; }
    [[nodiscard]] std::vector<MeshFace> const& faces() const { return faces_; }

private:
    enum class Kind
    {
        Face,
        Edge,
        Vertex
    };
    struct Candidate
    {
        ContactFeature feature;
        Real height; ///< Of the centre over the face, distance to the edge or vertex; negative behind a face [m].
        int number;  ///< Of the face, edge or vertex.
        int patch;   ///< Of the face; -1 else.
        Kind kind;
        Vector nearest; ///< Point of the edge or vertex.
    };
    struct VertexRole
    {
        int edges;        ///< Begin of its entries in directions_.
        int owner;        ///< Lowest number of a face that has it; -1 where it can touch nothing.
        bool innerCorner; ///< Valleys end here, and nothing else but joints within a plane.
        Vector normal;    ///< Sum of the normals around it, weighted by angles; its length does not matter.
    };
    /// Scratch of one query; one for each thread.
    struct Query
    {
        std::vector<int> near;
        std::vector<Candidate> candidates;
    };

    void findValleys();
    void findVertices(TriSurface const& surface);
    [[nodiscard]] RimCover const* coverAt(int edge, Real along) const;
    [[nodiscard]] bool inside(MeshFace const& face, Vector const& r, Real height) const;
    [[nodiscard]] bool beyondAValley(MeshFace const& face, Vector const& r) const;
    void addFace(int number, Sphere const& sphere, Real limit, Query& query) const;
    void addEdges(int number, Sphere const& sphere, Real limit, Query& query) const;
    void addVertices(int number, Sphere const& sphere, Real limit, Query& query) const;
    void dropHidden(Query& query, Real reach) const;
    [[nodiscard]] bool liesOn(Vector const& point, int patch, std::vector<int> const& near) const;
    void keepDistinct(Query& query) const;

    Real depth_;
    Real near_; ///< Length that rounding may amount to [m].
    std::vector<MeshFace> faces_;
    std::vector<MeshEdge> edges_;
    std::vector<RimCover> covers_;
    std::vector<VertexRole> vertices_;
    std::vector<Vector> points_;
    std::vector<Vector> directions_;           ///< Of the edges at each vertex, away from it.
    std::vector<std::pair<int, int>> valleys_; ///< Patches that meet in a valley; sorted.
    int patches_ = 0;
    bool solid_ = false; ///< Closed with the solid inside: nothing outside of its box can be behind it.
    TriangleGrid grid_;
};

} // namespace mpsDem
