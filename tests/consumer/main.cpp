// A program of somebody else that uses the contact library alone: a disc falls on a floor and leaves it with e times its speed.

#include <array>
#include <cmath>
#include <iostream>

#include <dem/ContactModel.h>

int main()
{
    using namespace mpsDem;
    Real const radius = 0.05;   // [m]
    Real const thickness = 0.1; // [m]
    Real const restitution = 0.5;
    Real const fallSpeed = 1; // [m/s]

    Dictionary const properties = Dictionary::fromText("mu 0.3; e 0.5;");
    Polyline const floor("floor", {Vector(-1, 0, 0), Vector(1, 0, 0)}, false, Polyline::FluidSide::Left);
    MassProperties const mass = MassProperties::fromCylinder2D(Vector::Zero(), radius, thickness, 2500);
    RigidBody disc("disc", mass, Vector(0, 1.001 * radius, 0), Quaternion::Identity());
    disc.restrictTo2D();
    disc.setVelocity(Vector(0, -fallSpeed, 0), Vector::Zero());

    std::array<RigidBody*, 1> const bodies = {&disc};
    ContactModel contacts(properties, 0.1 * radius, thickness, {floor}, bodies, {ContactShape::disc(radius)});

    Real const dt = 1e-4; // [s]
    for (int step = 0; step < 1000; ++step)
    {
        int const count = contacts.subSteps(bodies, dt);
        for (int i = 0; i < count; ++i)
        {
            contacts.addTo(bodies, dt / count);
            disc.advance(step * dt + i * dt / count, dt / count);
        }
    }

    Real const measured = disc.velocity().y() / fallSpeed;
    std::cout << "rebound speed / speed of fall = " << measured << ", asked for " << restitution << '\n';
    return std::abs(measured - restitution) < 0.02 ? 0 : 1;
}
