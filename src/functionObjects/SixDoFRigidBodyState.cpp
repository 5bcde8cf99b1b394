#include "functionObjects/SixDoFRigidBodyState.h"

#include <array>
#include <cmath>
#include <numbers>

#include "core/Errors.h"
#include "functionObjects/Observed.h"

namespace mpsDem {

namespace {

std::vector<std::string> columnNames()
{
    std::vector<std::string> columns{"x", "y", "z", "dx", "dy", "dz", "angle", "q0", "q1", "q2", "q3"};
    addVectorColumns(columns, "U");
    addVectorColumns(columns, "omega");
    for (std::string const prefix : {"F", "M"})
        for (std::string const load : {"gravity", "fluid", "contactNormal", "contactTangential", "restraint", "reaction"})
            addVectorColumns(columns, prefix + load);
    return columns;
}

} // namespace

SixDoFRigidBodyState::SixDoFRigidBodyState(std::string const& name, Dictionary const& dict, RunContext const& context)
    : name_(name),
      planar_(context.particles.lattice().dimensions == 2)
{
    for (int k : readBodies(context, dict))
    {
        RigidBody const& body = *context.bodies[k];
        requireFileName(body.name(), dict.where("bodies"));
        std::vector<std::string> const header{
            "Body " + body.name() +
                ": centre of mass and displacement [m], turn since the start [rad], quaternion, velocity [m/s], "
                "angular velocity [rad/s]",
            "forces F [N], moments M about the centre of mass [N m]; contact, restraint and reaction are means over the last step"};
        watched_.push_back({body, body.centre(), body.orientation(), makeTable(context, name, body.name(), columnNames(), header)});
    }
}

Real SixDoFRigidBodyState::angle(Watched const& watched) const
{
    Quaternion const turn = watched.body.orientation() * watched.orientation.conjugate();
    if (!planar_) return 2 * std::atan2(turn.vec().norm(), std::abs(turn.w()));
    Real const whole = 2 * std::atan2(turn.z(), turn.w());
    return whole > std::numbers::pi ? whole - 2 * std::numbers::pi : whole <= -std::numbers::pi ? whole + 2 * std::numbers::pi : whole;
}

void SixDoFRigidBodyState::write(Step const& step)
{
    for (Watched& watched : watched_)
    {
        RigidBody const& body = watched.body;
        std::vector<Real> row;
        addVector(row, body.centre());
        addVector(row, body.centre() - watched.centre);
        Quaternion const& q = body.orientation();
        row.insert(row.end(), {angle(watched), q.w(), q.x(), q.y(), q.z()});
        addVector(row, body.velocity());
        addVector(row, body.angularVelocity());
        std::array<Load, 6> const loads{body.gravityLoad(),           body.fluid,           body.meanContactNormal(),
                                        body.meanContactTangential(), body.meanRestraint(), body.meanReaction()};
        for (Load const& load : loads) addVector(row, load.force);
        for (Load const& load : loads) addVector(row, load.moment);
        watched.table.add(step.time, row);
    }
}

void SixDoFRigidBodyState::report(std::ostream& os) const
{
    char const* separator = "";
    for (Watched const& watched : watched_)
    {
        os << separator << watched.body.name() << ' ';
        watched.table.printLast(os);
        separator = "; ";
    }
}

std::string SixDoFRigidBodyState::block(Watched const& watched) const
{
    return "functionObject/" + name_ + "/" + watched.body.name() + "/start";
}

void SixDoFRigidBodyState::save(State& state) const
{
    for (Watched const& watched : watched_)
    {
        Quaternion const& q = watched.orientation;
        std::array<Real, 7> const start{watched.centre.x(), watched.centre.y(), watched.centre.z(), q.w(), q.x(), q.y(), q.z()};
        state.set(block(watched), std::span<Real const>(start));
    }
}

void SixDoFRigidBodyState::load(State const& state)
{
    for (Watched& watched : watched_)
    {
        if (!state.has(block(watched))) continue; // added at a restart: counts from there
        State::Reals const& start = state.reals(block(watched));
        if (start.size() != 7)
            throw CaseError(ExitCode::InputOutput, "block \"" + block(watched) + "\" of the saved state has another length");
        watched.centre = {start[0], start[1], start[2]};
        watched.orientation = Quaternion(start[3], start[4], start[5], start[6]);
    }
}

} // namespace mpsDem
