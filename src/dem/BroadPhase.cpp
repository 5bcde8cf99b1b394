#include "dem/BroadPhase.h"

#include <algorithm>

namespace mpsDem {

void BroadPhase::add(Box const& box, Real reach)
{
    order_.push_back(static_cast<int>(records_.size()));
    records_.push_back({box, reach});
}

int BroadPhase::widestAxis() const
{
    Box centres;
    for (Record const& record : records_) centres.add(record.centre);
    Vector const spread = centres.high - centres.low;
    return spread.x() >= spread.y() && spread.x() >= spread.z() ? 0 : (spread.y() >= spread.z() ? 1 : 2);
}

void BroadPhase::update(std::span<RigidBody* const> bodies, std::vector<Real> const& margins)
{
    for (std::size_t i = 0; i < records_.size(); ++i)
    {
        Record& record = records_[i];
        record.margin = margins[i];
        record.centre = bodies[i]->centre();
        record.rotation = bodies[i]->rotation();
        Vector const middle = record.centre + record.rotation * (0.5 * (record.local.low + record.local.high));
        Vector const half = record.rotation.cwiseAbs() * (0.5 * (record.local.high - record.local.low)) + Vector::Constant(record.margin);
        record.grown.low = middle - half;
        record.grown.high = middle + half;
    }
    pairs_.clear();
    comparisons_ = 0;
    if (records_.empty()) return;
    int const axis = widestAxis();
    auto const at = [&](int i) -> Box const& { return records_[static_cast<std::size_t>(i)].grown; };
    std::sort(order_.begin(), order_.end(),
              [&](int a, int b) { return at(a).low[axis] != at(b).low[axis] ? at(a).low[axis] < at(b).low[axis] : a < b; });
    for (std::size_t i = 0; i < order_.size(); ++i)
        for (std::size_t k = i + 1; k < order_.size() && at(order_[k]).low[axis] <= at(order_[i]).high[axis]; ++k)
        {
            ++comparisons_;
            Box const &a = at(order_[i]), &b = at(order_[k]);
            if ((a.low.array() <= b.high.array()).all() && (b.low.array() <= a.high.array()).all())
                pairs_.emplace_back(std::minmax({order_[i], order_[k]}));
        }
    std::sort(pairs_.begin(), pairs_.end());
}

bool BroadPhase::covers(std::span<RigidBody* const> bodies) const
{
    for (std::size_t i = 0; i < records_.size(); ++i)
    {
        Record const& record = records_[i];
        Real const turned = (bodies[i]->rotation() - record.rotation).norm();
        if (!((bodies[i]->centre() - record.centre).norm() + turned * record.reach <= record.margin)) return false;
    }
    return true;
}

} // namespace mpsDem
