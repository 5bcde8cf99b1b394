#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "postGauges/Camera.h"

namespace mpsDem::postGauges {

using Colour = std::array<float, 3>; ///< Red, green, blue, 0 to 1.

/// Triangles to be drawn.
struct DrawnMesh
{
    std::span<Vector const> points;  ///< [m]
    std::span<Vector const> normals; ///< One a point; empty: each triangle is flat.
    std::span<std::array<int, 3> const> triangles;
    std::span<Colour const> colours; ///< One a point, or one for all.
};

/// A picture of space, drawn with a depth buffer: what is nearer hides what is behind, in whatever order it comes.
///
/// Solids are opaque. Water is one layer before them, whose thickness along the line of sight is found by adding depths of back faces and
/// taking away those of front faces, so water must be closed surfaces. Everything is shaded in the end: light from above, softer where
/// other things are near (ambient obscurance, McGuire et al. 2011), a glint and a reflection of the sky on water.
class SpaceImage
{
public:
    /// How much of what lies behind water is seen.
    struct WaterLook
    {
        Real opacity = 0.7;  ///< Of a thin layer.
        Real absorption = 2; ///< Of light in it [1/m].
    };

    enum class Faces
    {
        Both,
        TowardsViewer
    };

    /// @param window  Part of the picture plane. @param width, height  [pixels].
    SpaceImage(Camera const& camera, Window const& window, int width, int height);

    void addSolid(DrawnMesh const& mesh, Faces faces);
    void addSphere(Vector const& centre, Real radius, Colour const& colour);
    /// @pre The mesh is closed.
    void addWater(DrawnMesh const& mesh, WaterLook const& look);
    /// A line above everything that is painted, faint where something hides it. @param width  [pixels].
    void addLine(Vector const& from, Vector const& to, Colour const& colour, Real width);

    /// Red, green, blue of each pixel, one byte each, rows from the lowest one upwards.
    [[nodiscard]] std::string bytes() const;

private:
    static constexpr float empty = -3e38F;

    /// The nearest thing at each sample.
    struct Layer
    {
        std::vector<float> nearness;
        std::vector<std::array<float, 3>> normal; ///< Towards the viewer.
        std::vector<Colour> colour;
        void resize(std::size_t samples);
    };

    struct Corner
    {
        Real x, y, nearness; ///< Place in samples.
    };

    /// Side of a triangle. A sample on it belongs to one of the two triangles that share it, so that nothing is counted twice.
    struct Side
    {
        Side(Corner const& a, Corner const& b, Real turn);
        /// Twice the area of the triangle over the side with its tip at (px, py), positive inside.
        [[nodiscard]] Real cross(Real px, Real py) const { return sign * (dx * (py - y) - dy * (px - x)); }
        Real x, y, dx, dy, sign;
    };

    struct Line
    {
        Corner from, to;
        Colour colour;
        Real width; ///< [samples]
    };

    [[nodiscard]] Corner corner(Vector const& r) const;
    [[nodiscard]] std::size_t at(int x, int y) const
    {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(x);
    }
    /// Calls visit(sample, nearness, shares of the corners) for the samples whose middle lies in the triangle.
    template <class Visit>
    void forEachSample(std::array<Corner, 3> const& corners, Visit visit) const;
    template <class Visit>
    void forEachTriangle(DrawnMesh const& mesh, Visit visit) const;
    static void put(Layer& layer, std::size_t sample, float nearness, Vector const& normal, Colour const& colour);

    [[nodiscard]] std::vector<float> obscurance() const;
    [[nodiscard]] Real obscuranceAt(int x, int y, Real reach) const;
    [[nodiscard]] Vector placeOf(int x, int y) const;
    [[nodiscard]] float nearest(std::size_t sample) const;
    [[nodiscard]] Colour solidColour(std::size_t sample) const;
    [[nodiscard]] Colour waterColour(std::size_t sample, Colour const& behind) const;
    [[nodiscard]] std::vector<Colour> shaded() const;
    void drawLine(Line const& line, std::vector<Colour>& picture) const;

    Camera const& camera_;
    Window window_;
    int width_, height_, perPixel_;
    int columns_, rows_; ///< Of samples.
    Real samplesAMetre_;
    Layer solid_, water_;
    std::vector<float> thickness_; ///< Of water [m]; grows with the first water.
    std::vector<Line> lines_;
    WaterLook look_;
};

} // namespace mpsDem::postGauges
