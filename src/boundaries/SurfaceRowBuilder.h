#pragma once

#include <span>
#include <vector>

#include "boundaries/BoundaryRows.h"
#include "boundaries/JoinedSurfaces.h"
#include "boundaries/PlacedPoints.h"
#include "boundaries/TriangleTree.h"
#include "core/TriSurface.h"

namespace mpsDem {

/// Puts the particles of rows behind triangle surfaces one after the other, where the rules (SurfaceRows.h) allow it.
class SurfaceRowBuilder
{
public:
    struct Candidate
    {
        Vector position; ///< [m]
        Vector normal;   ///< Of the surface it was made for.
        int face;        ///< Number of a face of that surface.
        int row;         ///< Depth (row + 1/2) l0.
        int beyond = 0;  ///< Number past the edge, 0 within the surface.
        int tag = -1;    ///< Particles of one lattice have the same one.
    };

    SurfaceRowBuilder(std::span<TriSurface const> surfaces, std::span<int const> ghostRows, Real spacing);

    [[nodiscard]] JoinedSurfaces const& surfaces() const { return joined_; }
    [[nodiscard]] TriangleTree const& tree() const { return tree_; }
    [[nodiscard]] PlacedPoints const& placed() const { return placed_; }
    [[nodiscard]] Real spacing() const { return spacing_; }
    [[nodiscard]] int ghostRows(int face) const { return ghostRows_[static_cast<std::size_t>(joined_.face(face).surface)]; }
    /// Depth of a row [m].
    [[nodiscard]] Real depth(int row) const { return (row + 0.5) * spacing_; }

    /// Number of the face of a nearest place.
    [[nodiscard]] int faceOf(TriangleTree::Nearest const& near) const
    {
        return firstFace_[static_cast<std::size_t>(near.surface)] + near.triangle;
    }

    /// How a place of a row stands to all surfaces.
    enum class Standing
    {
        InRow,  ///< In the row of its own surface.
        Buried, ///< Its foot on the surface lies behind another surface, but near the line where they meet.
        Outside ///< In the fluid, too near to a surface, or far behind.
    };
    /// @param foot  Where the particle's own surface is, and @param normal  its normal there.
    [[nodiscard]] Standing standing(Candidate const& c, Vector const& foot, Vector const& normal) const;

    /// Tries a particle of a row within a plane; buried ones are kept for addBuried().
    void addInRow(Candidate const& c);
    void keepBuried(Candidate const& c) { buried_.push_back(c); }
    /// Tries a particle that completes a corner, with 0.7 l0 to others, or goes on past an edge (beyond > 0).
    void addBeyond(Candidate const& c);
    /// Tries a particle on the bisector of two surfaces that cut through each other.
    void addInJunction(Candidate const& c);
    /// Tries the buried ones.
    void addBuried();
    /// Looks for holes around the buried ones: along the lines where surfaces cut through each other.
    void addInHolesOfJunctions(Real least, Real leastOfWall);
    /// Tries a particle where its row (to which it is moved if it is near) has no other one within `least` spacings; a wall particle also
    /// where only ghosts are.
    void addInHole(Candidate c, Real least, Real leastOfWall);
    /// Puts a particle that was found to stand in its row, unless another one is within 0.7 l0.
    void put(Candidate const& c, Vector const& normal, ParticleType type);

    BoundaryRows rows;

private:
    [[nodiscard]] bool coveredByRows(Vector const& r, TriangleTree::Nearest const& near) const;
    [[nodiscard]] bool isHole(Candidate const& c, Real least, Real leastOfWall) const;
    [[nodiscard]] bool exposed(Vector const& foot, Vector const& normal) const;

    JoinedSurfaces joined_;
    TriangleTree tree_;
    PlacedPoints placed_, walls_;
    std::vector<int> ghostRows_;
    std::vector<int> firstFace_; ///< Of each surface.
    Real spacing_;
    std::vector<Candidate> buried_;
};

} // namespace mpsDem
