#include "dem/Latch.h"

#include "core/Log.h"

namespace mpsDem {

Latch::Latch(std::string name, std::size_t body, Vector const& point, Vector const& normal)
    : name_(std::move(name)),
      body_(body),
      point_(point),
      normal_(normal.normalized())
{}

void Latch::check(RigidBody& body, ContactPointSet const& points)
{
    if (closed_) return;
    for (ContactPoint const& point : points.points())
    {
        if ((body.toSpace(point.centre) - point_).dot(normal_) > point.radius) continue;
        closed_ = true;
        energy_ = body.kineticEnergy();
        impulse_ = -body.lock();
        info() << "latch " << name_ << ": body " << body.name() << " locked, impulse (" << impulse_.x() << ' ' << impulse_.y() << ' '
               << impulse_.z() << ") N s, energy " << energy_ << " J\n";
        return;
    }
}

void Latch::save(State& state) const
{
    state.set("contact/latch/" + name_ + "/closed", std::int64_t{closed_});
    state.set("contact/latch/" + name_ + "/impulse", impulse_);
    state.set("contact/latch/" + name_ + "/energy", energy_);
}

void Latch::load(State const& state)
{
    closed_ = state.integer("contact/latch/" + name_ + "/closed") != 0;
    impulse_ = state.vector("contact/latch/" + name_ + "/impulse");
    energy_ = state.real("contact/latch/" + name_ + "/energy");
}

} // namespace mpsDem
