#pragma once

#include <optional>
#include <span>
#include <string>

#include "bodies/Load.h"
#include "core/Surface.h"
#include "coupling/PorePressure.h"
#include "particles/CellGrid.h"
#include "particles/ParticleSet.h"

namespace mpsDem {

/// How the hydrodynamic pressure on a surface is found from the particles around it.
struct PressureIntegrationControls
{
    Real wetRadius;           ///< A point is wet if fluid lies within this distance in front of it [m].
    Real radius;              ///< Shepard radius [m].
    bool positiveOnly = true; ///< Clamp at zero.
    /// What a contact face carries: nothing (paper); the pressure of its wet rim; that of the body's other side with the weight of water between.
    enum class ContactFace
    {
        Dry,
        Pore,
        Vented
    };
    ContactFace contactFace = ContactFace::Dry;
    Real faceReach = 0; ///< A dry point with another solid within this distance in front lies on a contact face [m].
};

/// Quadrature points on the surface of a solid; eq 15 and eq 16 over them.
///
/// The points lie on the exact surface, one in the middle of each piece of at most one spacing (3-D: of each triangle, halved until no edge
/// is longer than the diagonal of a square of one spacing), so that sum n dA = 0 for a closed outline
/// and sum x.n dA / d = V to round-off, whatever the boundary particles do.
class WettedSurface
{
public:
    /// @param outline   In body axes from the centre of mass, or in space for a fixed surface.
    /// @param body      Index of the body, -1 for a fixed surface.
    WettedSurface(Surface const& outline, Lattice const& lattice, int body);

    /// Moves the points with their body.
    void place(Tensor const& rotation, Vector const& centre);

    /// Pressure at every point:
    /// \f[ p_S = \frac{\sum_j w_{Sj}\,[\,p_j - \rho\,((\mathbf g-\mathbf a)\cdot\mathbf n)\,(\mathbf n\cdot\mathbf r_{Sj})\,]}{\sum_j w_{Sj}} \f]
    /// over fluid particles in front of the point and wet wall particles of the same solid with a like normal; zero where the point is dry.
    /// @param pressure      Per particle [Pa].
    /// @param gravity       [m/s2]; zero for the response to an acceleration.
    /// @param acceleration  Function (position) -> acceleration of the solid there [m/s2].
    template <class Acceleration>
    void interpolate(ParticleSet const& particles, CellGrid const& grid, Field<Real> const& pressure, Vector const& gravity, Real density,
                     Acceleration acceleration, PressureIntegrationControls const& controls)
    {
        for (std::size_t s = 0; s < position_.size(); ++s)
        {
            Real const slope = density * (gravity - acceleration(position_[s])).dot(normal_[s]);
            evaluatePoint(particles, grid, pressure, slope, controls, s);
        }
        if (controls.contactFace == PressureIntegrationControls::ContactFace::Pore) fillFromRims(particles, grid, controls.faceReach);
        if (controls.contactFace == PressureIntegrationControls::ContactFace::Vented)
            fillFromOtherSide(particles, grid, controls.faceReach, density * gravity);
    }

    /// No pressure where another solid lies on the surface and no fluid between: the water beyond its thin edge is within reach of such
    /// a point, but does not press on it.
    void dryContactFaces(ParticleSet const& particles, CellGrid const& grid);

    /// Eqs 15-16: F = -sum p n dA, M = -sum (r - centre) x (p n dA) [N], [N m].
    [[nodiscard]] Load integrate(Vector const& centre) const;

    [[nodiscard]] Field<Vector> const& position() const { return position_; }
    [[nodiscard]] Field<Vector> const& normal() const { return normal_; }
    [[nodiscard]] Field<Real> const& area() const { return area_; }
    [[nodiscard]] Field<Real> const& pressure() const { return pressure_; }
    [[nodiscard]] Field<std::uint8_t> const& wet() const { return wet_; }

private:
    void addSegments(Polyline const& line);
    void addTriangles(TriSurface const& triangles);
    void evaluatePoint(ParticleSet const& particles, CellGrid const& grid, Field<Real> const& pressure, Real slope,
                       PressureIntegrationControls const& controls, std::size_t s);
    void fillFromRims(ParticleSet const& particles, CellGrid const& grid, Real reach);
    void fillBetweenRims(ParticleSet const& particles, CellGrid const& grid, Real reach);
    /// \f[ p_s = p_q + \rho\,\mathbf g\cdot(\mathbf r_s - \mathbf r_q) \f] with q the point straight behind s on the other side, where it is wet:
    /// water that comes and goes beside the body, out of the plane, has the same pressure below it as above.
    /// @param weight  rho g [N/m3]; zero for the response to an acceleration.
    void fillFromOtherSide(ParticleSet const& particles, CellGrid const& grid, Real reach, Vector const& weight);
    void findOtherSides();
    [[nodiscard]] bool facesSolid(ParticleSet const& particles, CellGrid const& grid, std::size_t s, Real reach) const;

    Lattice lattice_;
    int body_;
    bool closed_;
    Field<Vector> localPosition_, localNormal_, position_, normal_;
    Field<Real> area_, pressure_;
    Field<std::uint8_t> wet_;
    Field<int> otherSide_;              ///< Of each point, -1 for none; empty before it is asked for.
    std::optional<PorePressure> pores_; ///< 3-D; made when it is first needed.
};

} // namespace mpsDem
