#pragma once

#include "core/Polyline.h"
#include "core/TriSurface.h"
#include "core/Types.h"

namespace mpsDem {

/// Mass, centre of mass and inertia of a rigid body in its reference pose.
struct MassProperties
{
    Real mass = 0;                        ///< [kg].
    Vector centreOfMass = Vector::Zero(); ///< In the axes in which the shape was given [m].
    Tensor inertia = Tensor::Identity();  ///< About the centre of mass, axes of the reference pose [kg m2].
    Real volume = 0;                      ///< [m3]; 0 where no shape is known.

    /// Homogeneous right prism over a closed polygon, the plane z = 0 in its middle. Exact.
    ///
    /// With \f$ c_k = x_k y_{k+1} - x_{k+1} y_k \f$ about the centroid: \f$ A = \frac12 \sum c_k \f$,
    /// \f$ \int x^2 = \frac{1}{12} \sum c_k (x_k^2 + x_k x_{k+1} + x_{k+1}^2) \f$, and so on (Green's theorem);
    /// \f$ I_{zz} = \rho t (\int x^2 + \int y^2) \f$, \f$ I_{xx} = \rho t \int y^2 + m t^2 / 12 \f$.
    /// @param outline    Closed chain, any sense of rotation.
    /// @param thickness  Width t in z [m].
    /// @param density    [kg/m3].
    /// @throw CaseError BadInput for an open chain, an empty area, or a thickness or density that is not positive.
    [[nodiscard]] static MassProperties fromPolygon(Polyline const& outline, Real thickness, Real density);

    /// Homogeneous disc of radius R and thickness t, axis along z: I_zz = m R^2 / 2, I_xx = I_yy = m (3 R^2 + t^2) / 12.
    [[nodiscard]] static MassProperties fromCylinder2D(Vector const& centre, Real radius, Real thickness, Real density);

    /// Homogeneous solid within a closed surface of triangles: sums over the tetrahedra between each triangle (a, b, c) and a point amid the
    /// surface, then about the centroid, so that nothing is lost far from the origin. Exact for the triangles.
    ///
    /// With \f$ d = a \cdot (b \times c) \f$ and s = a + b + c: \f$ V = \frac16 \sum d \f$, \f$ \int r = \frac{1}{24} \sum d\,s \f$,
    /// \f$ C = \int r r^T = \frac{1}{120} \sum d (a a^T + b b^T + c c^T + s s^T) \f$, \f$ I = \rho (\mathrm{tr}(C) 1 - C) \f$.
    /// @param surface  Normals outwards; several shells count with their sum.
    /// @param density  [kg/m3].
    /// @throw CaseError BadInput for a rim (with its place), an empty volume, normals that point inwards, or a density that is not positive.
    [[nodiscard]] static MassProperties fromTriSurface(TriSurface const& surface, Real density);

    /// Homogeneous ball: V = 4/3 pi R^3, I = 2/5 m R^2. @throw CaseError BadInput for a radius or density that is not positive.
    [[nodiscard]] static MassProperties fromSphere(Vector const& centre, Real radius, Real density);

    /// Homogeneous circular cylinder between the middles of its ends: V = pi R^2 h, I = m R^2 / 2 along the axis, m (3 R^2 + h^2) / 12 across.
    /// @throw CaseError BadInput for ends that coincide, a radius or a density that is not positive.
    [[nodiscard]] static MassProperties fromCylinder(Vector const& end1, Vector const& end2, Real radius, Real density);

    /// The same body with another mass [kg]: the inertia scales with it.
    [[nodiscard]] MassProperties withMass(Real newMass) const;
};

} // namespace mpsDem
