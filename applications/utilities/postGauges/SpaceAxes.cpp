#include "postGauges/SpaceAxes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "postGauges/Text.h"

namespace mpsDem::postGauges {

namespace {

constexpr Colour lineColour = {0.45F, 0.47F, 0.5F};

/// An edge of a box: from a corner along direction d.
struct Edge
{
    int from;
    int direction;
    [[nodiscard]] int to() const { return from | (1 << direction); }
};

std::vector<Edge> edgesOf()
{
    std::vector<Edge> edges;
    for (int d = 0; d < 3; ++d)
        for (int corner = 0; corner < 8; ++corner)
            if ((corner & (1 << d)) == 0) edges.push_back({corner, d});
    return edges;
}

int nearestCorner(Camera const& camera, SpaceBox const& box)
{
    int best = 0;
    for (int i = 1; i < 8; ++i)
        if (camera.project(box.corner(i)).nearness > camera.project(box.corner(best)).nearness) best = i;
    return best;
}

/// Centre of the box in the picture.
std::pair<Real, Real> middleOf(Camera const& camera, SpaceBox const& box)
{
    auto const p = camera.project(0.5 * (box.low + box.high));
    return {p.u, p.v};
}

/// The edge along d that bears the numbers: on the rim of the box's picture; a level one the lowest, an upright one the leftmost.
Edge numbered(Camera const& camera, SpaceBox const& box, int d)
{
    auto const middle = [&](Edge const& edge) { return camera.project(0.5 * (box.corner(edge.from) + box.corner(edge.to()))); };
    auto const ends = [&](Edge const& edge) {
        return std::pair(camera.project(box.corner(edge.from)), camera.project(box.corner(edge.to())));
    };
    Edge best{-1, d};
    Real bestPlace = 1e300;
    for (Edge const& edge : edgesOf())
    {
        if (edge.direction != d) continue;
        auto const [a, b] = ends(edge);
        bool const upright = std::abs(b.v - a.v) > 2 * std::abs(b.u - a.u);
        Real const place = upright ? middle(edge).u : middle(edge).v;
        if (place < bestPlace) best = edge, bestPlace = place;
    }
    return best;
}

} // namespace

void drawBox(SpaceImage& image, Camera const& camera, SpaceBox const& box)
{
    int const nearest = nearestCorner(camera, box);
    for (Edge const& edge : edgesOf())
        if (edge.from != nearest && edge.to() != nearest) image.addLine(box.corner(edge.from), box.corner(edge.to()), lineColour, 1);
}

void writeAxes(std::ostream& script, Camera const& camera, SpaceBox const& box, Real pixelsAMetre, Window const& window)
{
    auto const [middleU, middleV] = middleOf(camera, box);
    auto const place = [&](Real u, Real v) {
        return "first " + number((u - window.xLow) * pixelsAMetre, 7) + "," + number((v - window.yLow) * pixelsAMetre, 7);
    };
    for (int d = 0; d < 3; ++d)
    {
        Edge const edge = numbered(camera, box, d);
        auto const a = camera.project(box.corner(edge.from)), b = camera.project(box.corner(edge.to()));
        Real const length = std::hypot(b.u - a.u, b.v - a.v), pixels = length * pixelsAMetre;
        if (pixels < 45) continue; // seen end on
        // Away from the box, across the edge.
        Real nu = -(b.v - a.v) / length, nv = (b.u - a.u) / length;
        if (nu * (0.5 * (a.u + b.u) - middleU) + nv * (0.5 * (a.v + b.v) - middleV) < 0) nu = -nu, nv = -nv;
        Real const one = 1 / pixelsAMetre;
        bool const beside = std::abs(nu) > std::abs(nv);
        std::string const align = !beside ? " center" : nu < 0 ? " right" : " left";
        script << "set arrow from " << place(a.u, a.v) << " to " << place(b.u, b.v) << " nohead front lw 1.2 lc rgb '#404040'\n";
        for (Real const value : niceTics(box.low[d], box.high[d], std::clamp(static_cast<int>(pixels / (beside ? 50 : 75)), 1, 8)))
        {
            Vector r = box.corner(edge.from);
            r[d] = value;
            auto const p = camera.project(r);
            script << "set arrow from " << place(p.u, p.v) << " to " << place(p.u + 6 * one * nu, p.v + 6 * one * nv)
                   << " nohead front lw 1.2 lc rgb '#404040'\n";
            Real const off = beside ? 10 : 17;
            script << "set label '" << number(value) << "' at " << place(p.u + off * one * nu, p.v + off * one * nv) << align
                   << " front tc rgb '#303030'\n";
        }
        Real const off = beside ? 50 : 38;
        script << "set label '"
               << "xyz"[d] << " [m]' at " << place(0.5 * (a.u + b.u) + off * one * nu, 0.5 * (a.v + b.v) + off * one * nv) << align
               << " front\n";
    }
}

} // namespace mpsDem::postGauges
