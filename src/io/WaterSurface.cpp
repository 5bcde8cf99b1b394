#include "io/WaterSurface.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

#include <vtkCellArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkWindowedSincPolyDataFilter.h>

#include "core/Errors.h"

namespace mpsDem {

namespace {

constexpr Real half = 0.5;
constexpr Real leastFree = 0.25; ///< Share of space free of walls by which is divided; below one half nothing is water anyway.
constexpr Real passBand = 0.08;  ///< Of the windowed sinc: waves of three cells and less are removed.

/// (1-q)^4 (1+4q), q = r/R, without its factor.
Real wendland(Real q) { return q >= 1 ? 0 : std::pow(1 - q, 4) * (1 + 4 * q); }

/// l0^3 times that factor, 21 / (2 pi R^3).
Real factorOf(WaterSurfaceControls const& controls) { return 21 / (2 * std::numbers::pi * std::pow(controls.radius, 3)); }

/// Values on a grid, x fastest.
struct Grid
{
    Vector origin;
    Real step = 0; ///< [m]
    std::array<int, 3> count{};

    [[nodiscard]] std::size_t size() const
    {
        return static_cast<std::size_t>(count[0]) * static_cast<std::size_t>(count[1]) * static_cast<std::size_t>(count[2]);
    }
    [[nodiscard]] std::size_t row(int j, int k) const
    {
        return (static_cast<std::size_t>(k) * static_cast<std::size_t>(count[1]) + static_cast<std::size_t>(j)) *
               static_cast<std::size_t>(count[0]);
    }
};

Grid gridAround(std::span<Vector const> fluid, WaterSurfaceControls const& controls)
{
    Vector low = fluid.front(), high = low;
    for (Vector const& r : fluid)
    {
        low = low.cwiseMin(r);
        high = high.cwiseMax(r);
    }
    Grid grid;
    grid.step = controls.spacing / controls.resolution;
    Vector const room = Vector::Constant(controls.radius * controls.spacing + grid.step);
    grid.origin = low - room;
    Real points = 1;
    for (int d = 0; d < 3; ++d)
    {
        Real const cells = std::ceil((high[d] - low[d] + 2 * room[d]) / grid.step);
        points *= cells + 1;
        grid.count[static_cast<std::size_t>(d)] = static_cast<int>(std::min(cells, 1e9)) + 1;
    }
    if (points > 1e9)
        throw CaseError(ExitCode::Memory, "the water surface would need a grid of " + std::to_string(points) + " points",
                        "a smaller resolution, or fewer particles far away");
    return grid;
}

/// First and last grid point of one direction within the reach of a place; none where first > last.
std::pair<int, int> reached(Grid const& grid, Real place, Real reach, std::size_t d)
{
    Real const from = std::ceil((place - reach - grid.origin[static_cast<int>(d)]) / grid.step);
    Real const to = std::floor((place + reach - grid.origin[static_cast<int>(d)]) / grid.step);
    Real const last = grid.count[d] - 1;
    if (to < 0 || from > last) return {1, 0};
    return {static_cast<int>(std::max(0.0, from)), static_cast<int>(std::min(last, to))};
}

/// Share of filled space at the grid's points: l0^3 sum w.
std::vector<float> fill(Grid const& grid, std::span<Vector const> positions, WaterSurfaceControls const& controls)
{
    constexpr int entries = 1024;
    Real const reach = controls.radius * controls.spacing;
    Real const factor = factorOf(controls);
    std::array<float, entries + 1> table{}; // over (r/R)^2
    for (std::size_t i = 0; i < entries; ++i) table[i] = static_cast<float>(factor * wendland(std::sqrt(static_cast<Real>(i) / entries)));
    std::vector<float> values(grid.size(), 0.0F);
    for (Vector const& r : positions)
    {
        auto const x = reached(grid, r.x(), reach, 0), y = reached(grid, r.y(), reach, 1), z = reached(grid, r.z(), reach, 2);
        for (int k = z.first; k <= z.second; ++k)
            for (int j = y.first; j <= y.second; ++j)
            {
                Vector const d = (grid.origin + grid.step * Vector(0, j, k) - r) / reach;
                float* const line = values.data() + grid.row(j, k);
                for (int i = x.first; i <= x.second; ++i)
                {
                    Real const dx = d.x() + i * grid.step / reach, q2 = dx * dx + d.y() * d.y() + d.z() * d.z();
                    if (q2 < 1) line[i] += table[static_cast<std::size_t>(q2 * entries)];
                }
            }
    }
    return values;
}

/// Turns fluid's and solid's shares into that of the water among free space; cuts it open at the planes.
void combine(Grid const& grid, std::vector<float> const& solid, WaterSurfaceControls const& controls, std::vector<float>& water)
{
    auto const least = static_cast<float>(leastFree);
    for (std::size_t i = 0; i < solid.size(); ++i)
    {
        float const space = 1 - solid[i];
        water[i] = std::min(water[i] / std::max(space, least), space);
    }
    for (CutPlane const& cut : controls.cuts)
        for (int k = 0; k < grid.count[2]; ++k)
            for (int j = 0; j < grid.count[1]; ++j)
                for (int i = 0; i < grid.count[0]; ++i)
                {
                    Vector const r = grid.origin + grid.step * Vector(i, j, k);
                    Real const beyond = (r - cut.point).dot(cut.normal) / controls.spacing;
                    float& value = water[grid.row(j, k) + static_cast<std::size_t>(i)];
                    value = std::min(value, static_cast<float>(half - half * beyond));
                }
}

/// Contour at one half, smoothed.
vtkSmartPointer<vtkPolyData> contour(Grid const& grid, std::vector<float> const& values, int smoothing)
{
    vtkNew<vtkImageData> image;
    image->SetDimensions(grid.count[0], grid.count[1], grid.count[2]);
    image->SetOrigin(grid.origin.x(), grid.origin.y(), grid.origin.z());
    image->SetSpacing(grid.step, grid.step, grid.step);
    image->AllocateScalars(VTK_FLOAT, 1);
    std::copy(values.begin(), values.end(), static_cast<float*>(image->GetScalarPointer()));
    vtkNew<vtkFlyingEdges3D> edges;
    edges->SetInputData(image);
    edges->SetValue(0, half);
    edges->ComputeNormalsOff();
    edges->ComputeGradientsOff();
    edges->ComputeScalarsOff();
    edges->Update();
    vtkSmartPointer<vtkPolyData> surface = edges->GetOutput();
    if (smoothing == 0 || surface->GetNumberOfPoints() == 0) return surface;
    vtkNew<vtkWindowedSincPolyDataFilter> smoother;
    smoother->SetInputData(surface);
    smoother->SetNumberOfIterations(smoothing);
    smoother->SetPassBand(passBand);
    smoother->NormalizeCoordinatesOn();
    smoother->BoundarySmoothingOff();
    smoother->FeatureEdgeSmoothingOff();
    smoother->Update();
    return smoother->GetOutput();
}

SurfaceMesh meshOf(vtkPolyData& surface)
{
    SurfaceMesh mesh;
    mesh.points.resize(static_cast<std::size_t>(surface.GetNumberOfPoints()));
    for (std::size_t i = 0; i < mesh.points.size(); ++i) surface.GetPoint(static_cast<vtkIdType>(i), mesh.points[i].data());
    vtkCellArray* const cells = surface.GetPolys();
    vtkIdType corners = 0;
    vtkIdType const* corner = nullptr;
    for (cells->InitTraversal(); cells->GetNextCell(corners, corner) != 0;)
        if (corners == 3) mesh.triangles.push_back({static_cast<int>(corner[0]), static_cast<int>(corner[1]), static_cast<int>(corner[2])});
    return mesh;
}

/// Turns all triangles where the volume within is negative, then means of the triangles' normals by area.
void orient(SurfaceMesh& mesh)
{
    auto const at = [&](int i) { return mesh.points[static_cast<std::size_t>(i)]; };
    bool const inward = mesh.volume() < 0;
    mesh.normals.assign(mesh.points.size(), Vector::Zero());
    for (auto& triangle : mesh.triangles)
    {
        if (inward) std::swap(triangle[1], triangle[2]);
        Vector const twiceArea = (at(triangle[1]) - at(triangle[0])).cross(at(triangle[2]) - at(triangle[0]));
        for (int const i : triangle) mesh.normals[static_cast<std::size_t>(i)] += twiceArea;
    }
    for (Vector& normal : mesh.normals) normal /= std::max(normal.norm(), tiny);
}

} // namespace

Real SurfaceMesh::volume() const
{
    if (points.empty()) return 0;
    Vector const centre = points.front(); // near the surface: less is lost in the differences
    Real sum = 0;
    auto const at = [&](int i) { return Vector(points[static_cast<std::size_t>(i)] - centre); };
    for (auto const& triangle : triangles) sum += at(triangle[0]).dot(at(triangle[1]).cross(at(triangle[2])));
    return sum / 6;
}

SurfaceMesh waterSurface(std::span<Vector const> fluid, std::span<Vector const> solid, WaterSurfaceControls const& controls)
{
    expect(controls.spacing > 0 && controls.resolution > 0 && controls.radius > 0, "water surface: a length is not positive");
    if (fluid.empty()) return {};
    Grid const grid = gridAround(fluid, controls);
    std::vector<float> water = fill(grid, fluid, controls);
    combine(grid, fill(grid, solid, controls), controls, water);
    SurfaceMesh mesh = meshOf(*contour(grid, water, controls.smoothing));
    orient(mesh);
    return mesh;
}

std::vector<Real> filledShare(std::span<Vector const> fluid, std::span<Vector const> solid, WaterSurfaceControls const& controls)
{
    Real const radius = controls.radius * controls.spacing, factor = factorOf(controls);
    auto const shareOf = [&](std::span<Vector const> positions) {
        std::vector<Real> share(fluid.size(), 0.0);
        if (positions.empty()) return share;
        CellGrid grid;
        grid.build(positions, radius, 3);
        for (std::size_t i = 0; i < fluid.size(); ++i)
            grid.forEachWithin(fluid[i], radius,
                               [&](int, Vector const&, Real r2) { share[i] += factor * wendland(std::sqrt(r2) / radius); });
        return share;
    };
    std::vector<Real> share = shareOf(fluid);
    std::vector<Real> const walls = shareOf(solid);
    for (std::size_t i = 0; i < share.size(); ++i) share[i] = std::min(share[i] / std::max(1 - walls[i], leastFree), 1 - walls[i]);
    return share;
}

KernelMean::KernelMean(std::span<Vector const> positions, Real radius) : radius_(radius)
{
    if (!positions.empty()) grid_.build(positions, radius, 3);
}

namespace {

template <class Value>
std::vector<Value> means(CellGrid const& grid, Real radius, std::span<Vector const> places, std::span<Value const> values,
                         Value const& zero)
{
    std::vector<Value> result(places.size(), zero);
    if (values.empty()) return result;
    for (std::size_t i = 0; i < places.size(); ++i)
    {
        Real weights = 0;
        grid.forEachWithin(places[i], radius, [&](int j, Vector const&, Real r2) {
            Real const w = wendland(std::sqrt(r2) / radius);
            weights += w;
            result[i] += w * values[static_cast<std::size_t>(j)];
        });
        if (weights > 0) result[i] /= weights;
    }
    return result;
}

} // namespace

std::vector<Real> KernelMean::at(std::span<Vector const> places, std::span<Real const> values) const
{
    return means<Real>(grid_, radius_, places, values, 0.0);
}

std::vector<Vector> KernelMean::at(std::span<Vector const> places, std::span<Vector const> values) const
{
    return means<Vector>(grid_, radius_, places, values, Vector::Zero());
}

} // namespace mpsDem
