#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/TriSurface.h"
#include "core/Types.h"

namespace mpsDem {

/// The triangles of several surfaces as one set: points within 1e-9 of the extent are one point, and rims of two surfaces that run along
/// the same two points in opposite directions (fluid on the same side) are one edge.
class JoinedSurfaces
{
public:
    struct Face
    {
        std::array<int, 3> corner; ///< Numbers of corners.
        std::array<int, 3> edge;   ///< Edge k runs from corner k to corner k + 1.
        Vector normal;             ///< Unit vector into the fluid.
        int surface;               ///< Number of the surface.
        int triangle;              ///< Number of the triangle in it.
        int component;             ///< Faces that hang together by edges have the same one.
    };

    struct Edge
    {
        std::array<int, 2> corner;
        int left, right; ///< Faces; right is -1 at a rim.
        Vector normal;   ///< Sum of the faces' normals.
        [[nodiscard]] bool rim() const { return right < 0; }
    };

    /// A point within one component.
    struct Corner
    {
        Vector point;                   ///< [m]
        Vector normal = Vector::Zero(); ///< Sum of the faces' normals, weighted with their angles at the point (Baerentzen & Aanaes 2005).
        bool rim = false;               ///< A rim begins here.
    };

    JoinedSurfaces() = default;
    explicit JoinedSurfaces(std::span<TriSurface const> surfaces);

    [[nodiscard]] std::vector<Face> const& faces() const { return faces_; }
    [[nodiscard]] std::vector<Edge> const& edges() const { return edges_; }
    [[nodiscard]] std::vector<Corner> const& corners() const { return corners_; }
    [[nodiscard]] int components() const { return components_; }
    /// Longest side of the box that holds all points [m].
    [[nodiscard]] Real extent() const { return extent_; }
    /// Points nearer than this are one [m].
    [[nodiscard]] Real tolerance() const { return 1e-9 * extent_; }
    [[nodiscard]] Face const& face(int f) const { return faces_[static_cast<std::size_t>(f)]; }
    [[nodiscard]] Edge const& edge(int e) const { return edges_[static_cast<std::size_t>(e)]; }
    [[nodiscard]] Corner const& corner(int c) const { return corners_[static_cast<std::size_t>(c)]; }
    [[nodiscard]] Vector const& point(Face const& f, int k) const { return corner(f.corner[static_cast<std::size_t>(k)]).point; }

private:
    void gather(std::span<TriSurface const> surfaces);
    void joinEdges();
    void numberComponents();
    void splitCorners();
    void sumNormals();

    std::vector<Face> faces_;
    std::vector<Edge> edges_;
    std::vector<Corner> corners_;
    int components_ = 0;
    Real extent_ = 0;
};

} // namespace mpsDem
