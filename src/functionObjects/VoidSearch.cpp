#include "functionObjects/VoidSearch.h"

#include <algorithm>
#include <cmath>

namespace mpsDem {

namespace {

// Content of a cell. Group k has k + 1 in its cells and rimOf(k) in its rim.
constexpr int empty = 0;
constexpr int open = -1;    ///< Open air, behind walls or inside bodies.
constexpr int covered = -2; ///< By boundary particles alone.
constexpr int wet = -3;     ///< By fluid.

constexpr int rimOf(int group) { return -4 - group; }
constexpr int groupOf(int content) { return content > 0 ? content - 1 : -4 - content; }
constexpr bool belongs(int content) { return content > 0 || content <= rimOf(0); }

constexpr Real cellsPerParticle = 64; ///< A grid of more cells is made coarser.
constexpr Real cellsAlways = 1e6;     ///< So many are allowed beside.
constexpr Real openSearch = 2;        ///< Spacings around openAt.

} // namespace

VoidSearch::Controls VoidSearch::Controls::defaults(int dimensions)
{
    return dimensions == 2 ? Controls{0.9, 4, 1.5, {}} : Controls{1, 2, 1.5, {}};
}

std::vector<VoidSearch::Void> const& VoidSearch::find(ParticleSet const& particles)
{
    voids_.clear();
    if (particles.size() == 0) return voids_;
    layOut(particles);
    cover(particles);
    openAir();
    gather();
    if (groups_.empty()) return voids_;
    addRims();
    fill(particles);
    measure();
    return voids_;
}

void VoidSearch::layOut(ParticleSet const& particles)
{
    lattice_ = particles.lattice();
    int const dimensions = lattice_.dimensions;
    Vector low = particles.r.front(), high = low;
    for (Vector const& r : particles.r)
    {
        low = low.cwiseMin(r);
        high = high.cwiseMax(r);
    }
    Real const most = cellsPerParticle * particles.size() + cellsAlways;
    Real cells = 0;
    for (size_ = lattice_.spacing / controls_.resolution;; size_ *= 1.25)
    {
        reach_ = std::max(controls_.reach * lattice_.spacing, 0.75 * size_);
        cells = 1;
        for (int d = 0; d < dimensions; ++d) cells *= (high[d] - low[d] + 2 * reach_) / size_ + 6;
        if (cells <= most) break;
    }
    origin_.setZero();
    count_ = {1, 1, 1};
    for (int d = 0; d < dimensions; ++d)
    {
        origin_[d] = low[d] - reach_ - 2.5 * size_;
        count_[d] = static_cast<int>(std::ceil((high[d] - low[d] + 2 * reach_) / size_)) + 5;
    }
    content_.assign(static_cast<std::size_t>(count_[0]) * count_[1] * count_[2], empty);
    faces_.clear();
    neighbours_.clear();
    int const deep = dimensions == 3 ? 1 : 0;
    for (int k = -deep; k <= deep; ++k)
        for (int j = -1; j <= 1; ++j)
            for (int i = -1; i <= 1; ++i)
            {
                int const apart = std::abs(i) + std::abs(j) + std::abs(k), step = (k * count_[1] + j) * count_[0] + i;
                if (apart > 0) neighbours_.push_back(step);
                if (apart == 1) faces_.push_back(step);
            }
    closeRim();
}

/// Cells on the border of the grid are never left, so nobody looks across it.
void VoidSearch::closeRim()
{
    bool const deep = lattice_.dimensions == 3;
    forEachCell({0, 0, 0}, {count_[0] - 1, count_[1] - 1, count_[2] - 1}, [&](int cell, Cell const& c) {
        bool const border = c[0] == 0 || c[1] == 0 || c[0] == count_[0] - 1 || c[1] == count_[1] - 1;
        if (border || (deep && (c[2] == 0 || c[2] == count_[2] - 1))) content_[cell] = open;
    });
}

template <class Visit>
void VoidSearch::forEachCell(Cell const& low, Cell const& high, Visit visit) const
{
    for (int k = low[2]; k <= high[2]; ++k)
        for (int j = low[1]; j <= high[1]; ++j)
            for (int i = low[0]; i <= high[0]; ++i) visit(number({i, j, k}), Cell{i, j, k});
}

Vector VoidSearch::centreOf(int cell) const
{
    int const row = cell / count_[0];
    Vector c(cell % count_[0] + 0.5, row % count_[1] + 0.5, row / count_[1] + 0.5);
    if (lattice_.dimensions == 2) c.z() = 0;
    return origin_ + size_ * c;
}

void VoidSearch::cover(ParticleSet const& particles)
{
    for (int i = 0; i < particles.size(); ++i) coverAround(particles.r[i], particles.isFluid(i));
}

void VoidSearch::coverAround(Vector const& r, bool fluid)
{
    Vector const x = (r - origin_) / size_ - Vector::Constant(0.5); // in cells, from the centre of the first
    Real const reach = reach_ / size_;
    bool const deep = lattice_.dimensions == 3;
    int const lowZ = deep ? static_cast<int>(std::ceil(x.z() - reach)) : 0, highZ = deep ? static_cast<int>(std::floor(x.z() + reach)) : 0;
    int const lowY = static_cast<int>(std::ceil(x.y() - reach)), highY = static_cast<int>(std::floor(x.y() + reach));
    for (int k = lowZ; k <= highZ; ++k)
        for (int j = lowY; j <= highY; ++j)
        {
            Real const y = j - x.y(), z = deep ? k - x.z() : 0;
            Real const half = std::sqrt(std::max(0.0, reach * reach - y * y - z * z));
            int const first = number({static_cast<int>(std::ceil(x.x() - half)), j, k});
            int const last = number({static_cast<int>(std::floor(x.x() + half)), j, k});
            for (int cell = first; cell <= last; ++cell)
                if (fluid || content_[cell] == empty) content_[cell] = fluid ? wet : covered;
        }
}

void VoidSearch::openAir()
{
    openFrom(number({1, 1, lattice_.dimensions == 3 ? 1 : 0}));
    if (!controls_.openAt) return;
    int const cell = emptyCellAt(*controls_.openAt);
    if (cell >= 0) openFrom(cell);
}

void VoidSearch::openFrom(int cell)
{
    content_[cell] = open;
    stack_.assign(1, cell);
    while (!stack_.empty())
    {
        int const from = stack_.back();
        stack_.pop_back();
        for (int step : faces_)
        {
            if (content_[from + step] != empty) continue;
            content_[from + step] = open;
            stack_.push_back(from + step);
        }
    }
}

/// The nearest empty cell; -1 where there is none near.
int VoidSearch::emptyCellAt(Vector const& r) const
{
    Cell low{0, 0, 0}, high{0, 0, 0};
    Real const reach = openSearch * lattice_.spacing;
    for (int d = 0; d < lattice_.dimensions; ++d)
    {
        Real const last = count_[d] - 1;
        low[d] = static_cast<int>(std::clamp((r[d] - reach - origin_[d]) / size_, 0.0, last));
        high[d] = static_cast<int>(std::clamp((r[d] + reach - origin_[d]) / size_, 0.0, last));
    }
    int nearest = -1;
    Real least = reach;
    forEachCell(low, high, [&](int cell, Cell const&) {
        if (content_[cell] != empty) return;
        Vector away = centreOf(cell) - r;
        if (lattice_.dimensions == 2) away.z() = 0;
        if (away.norm() > least) return;
        least = away.norm();
        nearest = cell;
    });
    return nearest;
}

void VoidSearch::gather()
{
    groups_.clear();
    cells_.clear();
    int const cellCount = static_cast<int>(content_.size());
    for (int cell = 0; cell < cellCount; ++cell)
    {
        if (content_[cell] != empty) continue;
        std::size_t const first = cells_.size();
        if (gatherFrom(cell))
        {
            groups_.push_back({static_cast<int>(first), static_cast<int>(cells_.size()), 0, 0});
            continue;
        }
        for (std::size_t k = first; k < cells_.size(); ++k) content_[cells_[k]] = open;
        cells_.resize(first);
    }
}

/// Appends the group of an empty cell to cells_. @return whether it borders on fluid.
bool VoidSearch::gatherFrom(int cell)
{
    int const mark = static_cast<int>(groups_.size()) + 1;
    std::size_t next = cells_.size();
    bool bordersOnFluid = false;
    content_[cell] = mark;
    cells_.push_back(cell);
    while (next < cells_.size())
    {
        int const from = cells_[next++];
        for (int step : neighbours_)
        {
            int& content = content_[from + step];
            bordersOnFluid = bordersOnFluid || content == wet;
            if (content != empty) continue;
            content = mark;
            cells_.push_back(from + step);
        }
    }
    return bordersOnFluid;
}

/// Covered cells around each group, as far as the particles reach over their squares; where two groups are near, the first takes the cells between.
void VoidSearch::addRims()
{
    int const layers = 1 + static_cast<int>(std::max(0.0, reach_ - 0.5 * lattice_.spacing) / size_);
    for (std::size_t k = 0; k < groups_.size(); ++k)
    {
        Group& group = groups_[k];
        int const rim = rimOf(static_cast<int>(k));
        stack_.assign(cells_.begin() + group.first, cells_.begin() + group.last);
        std::size_t first = 0;
        for (int layer = 0; layer < layers; ++layer)
        {
            std::size_t const last = stack_.size();
            for (; first < last; ++first)
                for (int step : neighbours_)
                {
                    int const cell = stack_[first] + step;
                    if (content_[cell] != wet && content_[cell] != covered) continue;
                    content_[cell] = rim;
                    stack_.push_back(cell);
                }
        }
        group.rim = static_cast<int>(stack_.size()) - (group.last - group.first);
    }
}

void VoidSearch::fill(ParticleSet const& particles)
{
    for (Vector const& r : particles.r) fillBy(r);
}

void VoidSearch::fillBy(Vector const& r)
{
    Cell low{0, 0, 0}, high{0, 0, 0};
    Vector const x = (r - origin_) / size_; // in cells
    Real const half = 0.5 * lattice_.spacing / size_;
    for (int d = 0; d < lattice_.dimensions; ++d)
    {
        low[d] = static_cast<int>(std::floor(x[d] - half));
        high[d] = static_cast<int>(std::floor(x[d] + half));
    }
    forEachCell(low, high, [&](int cell, Cell const& c) {
        if (!belongs(content_[cell])) return;
        Real part = 1;
        for (int d = 0; d < lattice_.dimensions; ++d) part *= std::min(x[d] + half, c[d] + 1.0) - std::max(x[d] - half, Real(c[d]));
        groups_[groupOf(content_[cell])].filled += part;
    });
}

void VoidSearch::measure()
{
    Real const cellVolume = lattice_.particleVolume() * std::pow(size_ / lattice_.spacing, lattice_.dimensions);
    for (Group const& group : groups_)
    {
        Real const volume = cellVolume * (group.last - group.first + group.rim - group.filled);
        if (volume < controls_.smallest * lattice_.particleVolume()) continue;
        Vector sum = Vector::Zero();
        for (int k = group.first; k < group.last; ++k) sum += centreOf(cells_[k]);
        voids_.push_back({sum / (group.last - group.first), volume});
    }
    std::sort(voids_.begin(), voids_.end(), [](Void const& a, Void const& b) {
        if (a.volume != b.volume) return a.volume > b.volume;
        return std::lexicographical_compare(a.centre.begin(), a.centre.end(), b.centre.begin(), b.centre.end());
    });
}

} // namespace mpsDem
