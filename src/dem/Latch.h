#pragma once

#include <string>

#include "bodies/RigidBody.h"
#include "core/Dictionary.h"
#include "core/State.h"
#include "dem/ContactPoints.h"

namespace mpsDem {

/// Locks one body for good as soon as one of its contact points reaches a plane, and keeps the impulse and the energy
/// that this took.
///
/// | key    | meaning                       | unit | default        |
/// |--------|-------------------------------|------|----------------|
/// | body   | name of the body              |      | none, required |
/// | point  | any point of the plane        | m    | none, required |
/// | normal | of the plane, to the body     | -    | none, required |
class Latch
{
public:
    Latch(std::string name, std::size_t body, Vector const& point, Vector const& normal);

    [[nodiscard]] std::string const& name() const { return name_; }
    [[nodiscard]] std::size_t body() const { return body_; }
    [[nodiscard]] bool closed() const { return closed_; }
    /// Impulse on the body when it was locked, -m V [N s].
    [[nodiscard]] Vector const& impulse() const { return impulse_; }
    /// Kinetic energy, rotation included, that the body lost when it was locked [J].
    [[nodiscard]] Real energy() const { return energy_; }

    /// Locks the body if it touches. Logs it.
    void check(RigidBody& body, ContactPointSet const& points);

    void save(State& state) const;
    void load(State const& state);

private:
    std::string name_;
    std::size_t body_;
    Vector point_;
    Vector normal_;
    bool closed_ = false;
    Vector impulse_ = Vector::Zero();
    Real energy_ = 0;
};

} // namespace mpsDem
