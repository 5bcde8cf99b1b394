#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "functionObjects/FunctionObject.h"
#include "io/Table.h"
#include "support/TemporaryFolder.h"

namespace mpsDem {

/// A case in a temporary folder whose particles and bodies a test sets by hand; function objects watch it.
struct FunctionObjectScene
{
    explicit FunctionObjectScene(Lattice const& lattice) : particles(lattice) {}

    struct Point
    {
        Vector r;
        ParticleType type = ParticleType::Fluid;
        Vector normal = Vector::Zero();
    };

    /// Fixed walls and fluid at rest; all walls are surface 0 and wet.
    void place(std::vector<Point> const& points)
    {
        Field<Vector> r, zero, normal;
        Field<Real> p;
        Field<ParticleType> type;
        Field<int> body;
        for (Point const& point : points)
        {
            r.push_back(point.r);
            zero.push_back(Vector::Zero());
            normal.push_back(point.normal);
            p.push_back(0);
            type.push_back(point.type);
            body.push_back(-1);
        }
        particles.assign(r, zero, p, type, body, normal);
        for (int i : particles.wall()) particles.wet[i] = 1;
        wallOf.assign(static_cast<std::size_t>(particles.boundary().size()), 0);
    }

    /// Square lattice of fluid, lower left corner (0, 0), with its particles half a spacing from the border.
    [[nodiscard]] std::vector<Point> block(int columns, int rows) const
    {
        Real const l0 = particles.lattice().spacing;
        std::vector<Point> points;
        for (int j = 0; j < rows; ++j)
            for (int i = 0; i < columns; ++i) points.push_back({Vector((i + 0.5) * l0, (j + 0.5) * l0, 0)});
        return points;
    }

    /// Water of a 3-D case below y = surface(x, z), in columns of particles on a square lattice from the corner (0, 0) of the x-z plane; each
    /// column's highest particle stands half a spacing below the surface.
    [[nodiscard]] std::vector<Point> columns(int alongX, int alongZ, int layers, std::function<Real(Real, Real)> const& surface) const
    {
        Real const l0 = particles.lattice().spacing;
        std::vector<Point> points;
        for (int k = 0; k < alongZ; ++k)
            for (int i = 0; i < alongX; ++i)
                for (int j = 0; j < layers; ++j)
                {
                    Real const x = (i + 0.5) * l0, z = (k + 0.5) * l0;
                    points.push_back({Vector(x, surface(x, z) - (j + 0.5) * l0, z)});
                }
        return points;
    }

    [[nodiscard]] RunContext context(Real startTime = 0) const
    {
        return {particles, bodies, wallNames, wallOf, ledger, gravity, density, folder.path(), startTime};
    }

    [[nodiscard]] Table table(std::string const& pathInPostProcessing) const
    {
        return readTable(folder / "postProcessing" / pathInPostProcessing);
    }

    TemporaryFolder folder;
    ParticleSet particles;
    std::vector<std::unique_ptr<RigidBody>> bodies;
    std::vector<std::string> wallNames{"tank"};
    Field<int> wallOf;
    Ledger ledger;
    Vector gravity{0, -10, 0};
    Real density = 1000;
};

/// The object that the text describes, called `watch`.
inline std::unique_ptr<FunctionObject> makeFunctionObject(std::string const& text, RunContext const& context)
{
    Dictionary const dict = Dictionary::fromText(text, "watch");
    auto object = functionObjectRegistry().make(dict.get<std::string>("type"), dict.where("type"), "watch", dict, context);
    dict.requireAllRead();
    return object;
}

} // namespace mpsDem
