#pragma once

#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/Polyline.h"
#include "core/TriSurface.h"

namespace mpsDem {

/// Surface of a wall or a body as the scene hands it around: a line of the x-y plane in 2-D, triangles in 3-D.
class Surface
{
public:
    Surface() = default;
    Surface(Polyline line) : shape_(std::move(line)) {}             // NOLINT: each of them is a surface
    Surface(TriSurface triangles) : shape_(std::move(triangles)) {} // NOLINT

    /// True for a line of the x-y plane.
    [[nodiscard]] bool flat() const { return std::holds_alternative<Polyline>(shape_); }
    /// @pre flat()
    [[nodiscard]] Polyline const& line() const { return std::get<Polyline>(shape_); }
    /// @pre not flat()
    [[nodiscard]] TriSurface const& triangles() const { return std::get<TriSurface>(shape_); }

    [[nodiscard]] std::string const& name() const
    {
        return std::visit([](auto const& s) -> std::string const& { return s.name(); }, shape_);
    }
    [[nodiscard]] bool closed() const
    {
        return std::visit([](auto const& s) { return s.closed(); }, shape_);
    }
    [[nodiscard]] std::vector<Vector> const& points() const
    {
        return std::visit([](auto const& s) -> std::vector<Vector> const& { return s.points(); }, shape_);
    }
    /// The same surface after r -> centre + R r.
    [[nodiscard]] Surface moved(Tensor const& rotation, Vector const& centre) const
    {
        return std::visit([&](auto const& s) { return Surface(s.moved(rotation, centre)); }, shape_);
    }

private:
    std::variant<Polyline, TriSurface> shape_;
};

/// Surfaces of one kind, for who treats lines and triangles apart.
inline std::vector<Polyline> linesOf(std::vector<Surface> const& surfaces)
{
    std::vector<Polyline> lines;
    for (Surface const& surface : surfaces)
        if (surface.flat()) lines.push_back(surface.line());
    return lines;
}
inline std::vector<TriSurface> trianglesOf(std::vector<Surface> const& surfaces)
{
    std::vector<TriSurface> triangles;
    for (Surface const& surface : surfaces)
        if (!surface.flat()) triangles.push_back(surface.triangles());
    return triangles;
}

} // namespace mpsDem
