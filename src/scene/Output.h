#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>

#include "core/Surface.h"
#include "io/VtkSeries.h"
#include "particles/ParticleSet.h"
#include "scene/CaseConstants.h"
#include "scene/SolidStage.h"

namespace mpsDem {

/// Cells of a surface for VTK: one polygon of all its corners for a closed line, a triangle each in 3-D.
std::vector<std::vector<std::int64_t>> polygonsOf(Surface const& surface);

/// VTK files of particles and bodies, and what a saved state tells about its input.
///
/// Point arrays of VTK/particles: U, p, id, type (0 fluid, 1 wall, 2 wall row labelled ghost by DBL, 3 ghost rows), n (n_i/n0), surface
/// (0 interior, 1 free surface, 2 near it). Bodies as closed polygons (3-D: triangles) with U and the body's number.
class Output
{
public:
    Output(CaseFolder const& caseFolder, ParticleSet const& particles, std::vector<std::unique_ptr<RigidBody>> const& bodies,
           std::vector<Surface> const& outlines);

    /// Continues the series at the time of a restart; later files of an earlier run go with the first write.
    void startAt(Real time) { startTime_ = time; }
    /// Writes the next file of each series at the time [s]. @throw CaseError (InputOutput)
    void write(Real time);

    /// Fingerprint of the dictionaries as they were at the start of the run.
    [[nodiscard]] std::string const& inputHash() const { return inputHash_; }

private:
    void startSeries();
    void writeParticles(Real time);
    void writeBody(std::size_t k, Real time);

    ParticleSet const& particles_;
    std::vector<std::unique_ptr<RigidBody>> const& bodies_;
    std::vector<Surface> const& outlines_;
    std::unique_ptr<VtkSeries> particleSeries_; ///< Absent without particles.
    std::vector<VtkSeries> bodySeries_;
    std::string inputHash_;
    std::optional<Real> startTime_; ///< Until the series have been started [s].
    int timer_;
};

} // namespace mpsDem
