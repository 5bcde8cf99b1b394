#pragma once

#include <map>
#include <memory>
#include <string>

#include "core/Polyline.h"
#include "io/VtkSeries.h"
#include "particles/ParticleSet.h"
#include "scene/CaseConstants.h"
#include "scene/SolidStage.h"

namespace mpsDem {

/// VTK files of particles and bodies.
///
/// Point arrays of VTK/particles: U, p, id, type (0 fluid, 1 wall, 2 wall row labelled ghost by DBL, 3 ghost rows), n (n_i/n0), surface
/// (0 interior, 1 free surface, 2 near it). Bodies as closed polygons with U and the body's number.
class Output
{
public:
    Output(CaseFolder const& caseFolder, ParticleSet const& particles, std::vector<std::unique_ptr<RigidBody>> const& bodies,
           std::vector<Polyline> const& outlines);

    /// Continues the series at the time of a restart.
    void startAt(Real time);
    /// Writes the next file of each series at the time [s]. @throw CaseError (InputOutput)
    void write(Real time);

private:
    void writeParticles(Real time);
    void writeBody(std::size_t k, Real time);

    ParticleSet const& particles_;
    std::vector<std::unique_ptr<RigidBody>> const& bodies_;
    std::vector<Polyline> const& outlines_;
    std::unique_ptr<VtkSeries> particleSeries_; ///< Absent without particles.
    std::vector<VtkSeries> bodySeries_;
    int timer_;
};

} // namespace mpsDem
