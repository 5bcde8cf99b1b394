#pragma once

#include <span>
#include <utility>
#include <vector>

#include "bodies/RigidBody.h"
#include "dem/ContactSurface.h"

namespace mpsDem {

/// Which bodies may touch one another before any of them has moved by more than its margin.
///
/// Boxes around the bodies, each grown by its margin, are sorted along the axis along which the bodies are spread most, and only those that
/// overlap there are compared (sweep and prune). What it finds depends on positions and margins; whether two bodies touch doesn't, for as long as
/// covers() is true no other two can.
/// Source: D. Baraff, Dynamic simulation of non-penetrating rigid bodies, thesis (1992), 2.4.
class BroadPhase
{
public:
    /// Adds a body. @param box    Around all of it, in body axes, the centre of mass at the origin.
    ///                @param reach  Largest distance of a point of it from the centre of mass [m].
    void add(Box const& box, Real reach);

    /// Looks for pairs at the present poses. @param margins  For each body [m].
    void update(std::span<RigidBody* const> bodies, std::vector<Real> const& margins);
    /// True as long as no point of any body has moved by more than its margin since update().
    [[nodiscard]] bool covers(std::span<RigidBody* const> bodies) const;

    /// Pairs found, the lower number first, sorted.
    [[nodiscard]] std::vector<std::pair<int, int>> const& pairs() const { return pairs_; }
    [[nodiscard]] Real margin(std::size_t body) const { return records_[body].margin; }
    [[nodiscard]] Real reach(std::size_t body) const { return records_[body].reach; }
    /// Pairs of boxes that the last update() compared.
    [[nodiscard]] std::size_t comparisons() const { return comparisons_; }

private:
    struct Record
    {
        Box local;
        Real reach;
        Real margin = -1; ///< Below zero before the first update.
        Vector centre = Vector::Zero();
        Tensor rotation = Tensor::Identity();
        Box grown = {}; ///< In space.
    };

    [[nodiscard]] int widestAxis() const;

    std::vector<Record> records_;
    std::vector<int> order_;
    std::vector<std::pair<int, int>> pairs_;
    std::size_t comparisons_ = 0;
};

} // namespace mpsDem
