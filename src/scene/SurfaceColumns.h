#pragma once

#include <vector>

#include "core/TriSurface.h"
#include "core/Types.h"

namespace mpsDem {

/// Where straight lines along one direction cross a closed surface: inside or outside, and how far to go to get out.
///
/// Triangles are sorted by the cells of a plane grid across the direction, so that a question costs the few triangles over one cell. An edge
/// is crossed on the same side for both of its triangles, to the last bit: no line slips through between two of them. Points on the surface
/// count as inside on its low sides and as outside on its high ones, as in a half-open box. Where shells overlap, inside of any is inside.
class SurfaceColumns
{
public:
    /// @param surface    Closed, normals outwards; kept as a copy of its points.
    /// @param direction  Unit vector.
    SurfaceColumns(TriSurface const& surface, Vector const& direction);

    [[nodiscard]] Vector const& direction() const { return direction_; }
    [[nodiscard]] bool inside(Vector const& r) const;
    /// Way along the direction until a point is outside for the first time [m]; 0 for one that is not inside.
    [[nodiscard]] Real exitDistance(Vector const& r) const;

private:
    template <class Visit>
    void forEachCrossingAbove(Vector const& local, Visit visit) const;
    [[nodiscard]] int winding(TriSurface::Corners const& corners, Vector const& local) const;
    [[nodiscard]] Real heightAt(TriSurface::Corners const& corners, Vector const& local) const;
    void sortTriangles();

    /// A triangle over a cell, and the box it fills.
    struct Item
    {
        Real lowX, highX, lowY, highY, highZ;
        int triangle;
    };

    Vector direction_;
    Tensor toLocal_; ///< Rows: two axes across the direction, the direction.
    Field<Vector> points_;
    Field<TriSurface::Corners> triangles_;
    Vector low_, high_; ///< Local.
    Real cell_ = 1;
    int countX_ = 1, countY_ = 1;
    Field<int> first_; ///< Item of each cell.
    Field<Item> items_;
};

} // namespace mpsDem
