#pragma once

#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "bodies/RigidBody.h"
#include "dem/ContactModel.h"
#include "support/Measured.h"

namespace mpsDem::test {

/// Bodies, resting surfaces and their contacts, stepped as the coupling does it.
struct ContactScene
{
    std::vector<std::unique_ptr<RigidBody>> bodies;
    std::vector<RigidBody*> pointers;
    std::vector<ContactShape> shapes;
    std::vector<Polyline> surfaces;
    std::unique_ptr<ContactModel> contact;
    Vector gravity = Vector::Zero();
    Real spacing = 0.02;
    Real thickness = 1;
    Real time = 0;

    /// A body with the given outline about its centre of mass.
    RigidBody& addBlock(std::string const& name, std::vector<Vector> points, Real density, Vector const& centre, Real angle = 0)
    {
        Polyline outline = Polyline::outline(name, std::move(points));
        MassProperties const mass = MassProperties::fromPolygon(outline, thickness, density);
        return add(name, mass, ContactShape::polygon(outline.moved(Tensor::Identity(), -mass.centreOfMass)), centre, angle);
    }

    RigidBody& addBox(std::string const& name, Real length, Real height, Real density, Vector const& centre, Real angle = 0)
    {
        Real const x = 0.5 * length;
        Real const y = 0.5 * height;
        return addBlock(name, {{-x, -y, 0}, {x, -y, 0}, {x, y, 0}, {-x, y, 0}}, density, centre, angle);
    }

    /// One sphere: a disc in contact, the inertia of a ball.
    RigidBody& addBall(std::string const& name, Real radius, Real density, Vector const& centre)
    {
        MassProperties mass;
        mass.mass = 4.0 / 3.0 * std::numbers::pi * radius * radius * radius * density;
        mass.inertia = 0.4 * mass.mass * radius * radius * Tensor::Identity();
        return add(name, mass, ContactShape::disc(radius), centre, 0);
    }

    void build(std::string const& dictionary)
    {
        contact = std::make_unique<ContactModel>(Dictionary::fromText(dictionary), spacing, thickness, surfaces, pointers, shapes);
    }

    /// One fluid step; `refine` times as many sub-steps as asked for. @param observe  Called after each sub-step.
    void step(Real dt, Real refine = 1, std::function<void()> const& observe = {})
    {
        int const count = std::max(1, static_cast<int>(std::lround(refine * contact->subSteps(pointers, dt))));
        Real const h = dt / count;
        for (RigidBody* body : pointers) body->beginStep();
        for (int k = 0; k < count; ++k)
        {
            contact->addTo(pointers, h);
            for (RigidBody* body : pointers) body->advance(time, h);
            time += h;
            if (observe) observe();
        }
        for (RigidBody* body : pointers) body->endStep(dt);
    }

    [[nodiscard]] Real kineticEnergy() const
    {
        Real sum = 0;
        for (RigidBody const* body : pointers) sum += body->kineticEnergy();
        return sum;
    }

private:
    RigidBody& add(std::string const& name, MassProperties const& mass, ContactShape shape, Vector const& centre, Real angle)
    {
        Quaternion const turn(Eigen::AngleAxisd(angle, Vector::UnitZ()));
        bodies.push_back(std::make_unique<RigidBody>(name, mass, centre, turn));
        bodies.back()->restrictTo2D();
        bodies.back()->setGravity(gravity);
        pointers.push_back(bodies.back().get());
        shapes.push_back(std::move(shape));
        return *bodies.back();
    }
};

/// Floor y = 0 from x = -10 to 10, free above.
inline Polyline floorLine(std::string const& name = "floor")
{
    return Polyline(name, {{-10, 0, 0}, {10, 0, 0}}, false, Polyline::FluidSide::Left);
}

} // namespace mpsDem::test
