#pragma once

#include <random>

#include "core/TriSurface.h"
#include "support/ContactScene.h"

namespace mpsDem::test {

/// Bodies in 3-D over walls of triangles, z upwards.
struct SolidScene : ContactScene
{
    std::vector<TriSurface> walls;

    /// A box with its centre at `centre`, its skin as given in body axes.
    RigidBody& addMesh(std::string const& name, TriSurface skin, Vector const& size, Real density, Vector const& centre,
                       Quaternion const& turn = Quaternion::Identity())
    {
        MassProperties mass;
        mass.mass = density * size.prod();
        Vector const square = size.cwiseProduct(size);
        mass.inertia = (mass.mass / 12 * (Vector::Constant(square.sum()) - square)).asDiagonal();
        return addSolid(name, mass, ContactShape::mesh(std::move(skin)), centre, turn);
    }

    RigidBody& addCuboid(std::string const& name, Vector const& size, Real density, Vector const& centre,
                         Quaternion const& turn = Quaternion::Identity())
    {
        return addMesh(name, TriSurface::box(name, -0.5 * size, 0.5 * size), size, density, centre, turn);
    }

    RigidBody& addSphere(std::string const& name, Real radius, Real density, Vector const& centre)
    {
        MassProperties mass;
        mass.mass = 4.0 / 3.0 * std::numbers::pi * radius * radius * radius * density;
        mass.inertia = 0.4 * mass.mass * radius * radius * Tensor::Identity();
        return addSolid(name, mass, ContactShape::sphere(radius), centre, Quaternion::Identity());
    }

    void build(std::string const& dictionary)
    {
        contact = std::make_unique<ContactModel>(Dictionary::fromText(dictionary), spacing, walls, pointers, shapes);
    }

    /// Kinetic energy, height and springs; with the heat it is constant [J].
    [[nodiscard]] Real energy() const
    {
        Real sum = kineticEnergy() + contact->elasticEnergy() + contact->dissipatedEnergy();
        for (RigidBody const* body : pointers) sum -= body->mass() * gravity.dot(body->centre());
        return sum;
    }

private:
    RigidBody& addSolid(std::string const& name, MassProperties const& mass, ContactShape shape, Vector const& centre,
                        Quaternion const& turn)
    {
        bodies.push_back(std::make_unique<RigidBody>(name, mass, centre, turn));
        bodies.back()->setGravity(gravity);
        pointers.push_back(bodies.back().get());
        shapes.push_back(std::move(shape));
        return *bodies.back();
    }
};

/// The rectangle [low, high] of the x-y plane cut into 2 + 2 `cuts` triangles: point after point at a random place splits the triangle in
/// which it lies. Slivers and points close to an edge are part of it.
inline TriSurface cutPlane(std::string const& name, Vector const& low, Vector const& high, int cuts, unsigned seed = 1)
{
    std::vector<Vector> points{low, {high.x(), low.y(), 0}, high, {low.x(), high.y(), 0}};
    std::vector<TriSurface::Corners> triangles{{0, 1, 2}, {0, 2, 3}};
    std::mt19937 random(seed);
    auto const unit = [&] { return static_cast<Real>(random()) / 4294967296.0; };
    for (int i = 0; i < cuts; ++i)
    {
        // The largest of a few random ones, so that sizes do not drift apart without end.
        auto const area = [&](std::size_t t) {
            auto const& c = triangles[t];
            return (points[c[1]] - points[c[0]]).cross(points[c[2]] - points[c[0]]).norm();
        };
        std::size_t split = random() % triangles.size();
        for (int k = 0; k < 8; ++k)
            if (std::size_t const other = random() % triangles.size(); area(other) > area(split)) split = other;
        auto const c = triangles[split];
        Real const u = 0.1 + 0.4 * unit(), v = 0.1 + 0.4 * unit();
        points.push_back(points[c[0]] + u * (points[c[1]] - points[c[0]]) + v * (points[c[2]] - points[c[0]]));
        int const n = static_cast<int>(points.size()) - 1;
        triangles[split] = {c[0], c[1], n};
        triangles.push_back({c[1], c[2], n});
        triangles.push_back({c[2], c[0], n});
    }
    return TriSurface(name, points, triangles);
}

/// Floor z = 0 around the origin, free above.
inline TriSurface floorMesh(Real half = 5, std::string const& name = "floor")
{
    return cutPlane(name, {-half, -half, 0}, {half, half, 0}, 0);
}

} // namespace mpsDem::test
