#pragma once

#include "dem/ContactSurface.h"
#include "dem/Facets.h"
#include "dem/SegmentGrid.h"

namespace mpsDem {

/// A polyline as contact surface: faces and corners without double forces.
///
/// A side touches a sphere whose centre projects on it; a ridge or a free end touches one that lies in the fan of normals there. In a
/// valley both sides touch. A centre behind the surface belongs to the nearest side (and to the other one of a valley).
class PolylineSurface final : public ContactSurface
{
public:
    /// @param depth    How far behind the surface a centre is still found [m]; the spacing.
    /// @param others   Surfaces at rest like this one, on which its ends may lie, see joinEnds.
    PolylineSurface(Polyline const& line, Real depth, std::vector<Polyline> const& others = {});

    void collect(std::span<Sphere const> spheres, Real reach, std::vector<ContactFeature>& features) const override;
    void findNear(std::span<Sphere const> spheres, Real reach, std::vector<int>& numbers) const override;

    [[nodiscard]] std::vector<Facet> const& facets() const { return facets_; }

private:
    struct Candidate
    {
        ContactFeature feature;
        Real height;    ///< Of the centre over the side; negative behind it [m].
        int facet;      ///< Index of the side; of the one before a corner.
        bool corner;    ///< A ridge or a free end.
        Vector nearest; ///< Corner point.
    };

    void addSide(int index, Sphere const& sphere, Real limit, std::vector<Candidate>& candidates) const;
    void addCorners(int index, Sphere const& sphere, Real limit, std::vector<Candidate>& candidates) const;
    void dropHidden(std::vector<Candidate>& candidates, Real reach) const;
    [[nodiscard]] bool valleyBetween(int first, int second) const;
    void keepDistinct(std::vector<Candidate>& candidates) const;

    std::vector<Facet> facets_;
    SegmentGrid grid_;
    Real depth_;
};

} // namespace mpsDem
