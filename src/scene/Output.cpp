#include "scene/Output.h"

#include <numeric>

#include "core/Timers.h"
#include "scene/InputFingerprint.h"

namespace mpsDem {

std::vector<std::vector<std::int64_t>> polygonsOf(Surface const& surface)
{
    if (surface.flat())
    {
        std::vector<std::int64_t> corners(surface.points().size());
        std::iota(corners.begin(), corners.end(), 0);
        return {corners};
    }
    std::vector<std::vector<std::int64_t>> polygons;
    for (auto const& t : surface.triangles().triangles()) polygons.push_back({t.corner[0], t.corner[1], t.corner[2]});
    return polygons;
}

Output::Output(CaseFolder const& caseFolder, ParticleSet const& particles, std::vector<std::unique_ptr<RigidBody>> const& bodies,
               std::vector<Surface> const& outlines)
    : particles_(particles),
      bodies_(bodies),
      outlines_(outlines),
      inputHash_(fingerprintOf(caseFolder, runInput())),
      timer_(Timers::add("VTK output", "output"))
{
    if (particles.size() > 0) particleSeries_ = std::make_unique<VtkSeries>(caseFolder.root(), "particles");
    for (auto const& body : bodies) bodySeries_.emplace_back(caseFolder.root(), body->name());
}

void Output::startSeries()
{
    if (!startTime_) return;
    if (particleSeries_) particleSeries_->startAt(*startTime_);
    for (VtkSeries& series : bodySeries_) series.startAt(*startTime_);
    startTime_.reset();
}

void Output::write(Real time)
{
    Timers::Scope const timer(Timers::stage(timer_));
    startSeries();
    if (particleSeries_) writeParticles(time);
    for (std::size_t k = 0; k < bodies_.size(); ++k) writeBody(k, time);
}

void Output::writeParticles(Real time)
{
    std::size_t const count = static_cast<std::size_t>(particles_.owned().last);
    std::vector<std::uint8_t> type(count), surface(count);
    for (std::size_t i = 0; i < count; ++i)
    {
        ParticleType const t = particles_.type[i];
        type[i] = t == ParticleType::Fluid ? 0 : t == ParticleType::Ghost ? 3 : particles_.wet[i] ? 1 : 2;
        surface[i] = static_cast<std::uint8_t>(particles_.surface[i]);
    }
    PointCloud cloud;
    cloud.position = std::span(particles_.r.data(), count);
    cloud.vectors.emplace_back("U", std::span(particles_.u.data(), count));
    cloud.scalars.emplace_back("p", std::span(particles_.p.data(), count));
    cloud.scalars.emplace_back("n", std::span(particles_.n.data(), count));
    cloud.integers.emplace_back("id", std::span<std::int64_t const>(particles_.id.data(), count));
    cloud.integers.emplace_back("type", std::span<std::uint8_t const>(type));
    cloud.integers.emplace_back("surface", std::span<std::uint8_t const>(surface));
    particleSeries_->write(time, cloud);
}

void Output::writeBody(std::size_t k, Real time)
{
    Surface const placed = outlines_[k].moved(bodies_[k]->rotation(), bodies_[k]->centre());
    SurfaceCells cells;
    cells.points = placed.points();
    cells.polygons = polygonsOf(placed);
    std::vector<Vector> const velocity(cells.polygons.size(), bodies_[k]->velocity());
    std::vector<std::int64_t> const number(cells.polygons.size(), static_cast<std::int64_t>(k));
    cells.vectors.emplace_back("U", std::span<Vector const>(velocity));
    cells.integers.emplace_back("body", std::span<std::int64_t const>(number));
    bodySeries_[k].write(time, cells);
}

} // namespace mpsDem
