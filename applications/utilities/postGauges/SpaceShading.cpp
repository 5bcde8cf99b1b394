#include <algorithm>
#include <cmath>

#include "postGauges/SpaceImage.h"

// Light and shade of SpaceImage.

namespace mpsDem::postGauges {

namespace {

constexpr Colour background = {1, 1, 1};
constexpr Colour sky = {0.94F, 0.97F, 1.0F};
constexpr Real hiddenLine = 0.18; ///< What is left of a line behind something.

Vector vectorOf(std::array<float, 3> const& n) { return {n[0], n[1], n[2]}; }

float mix(float a, float b, Real share) { return static_cast<float>(a + share * (static_cast<Real>(b) - a)); }

Colour mix(Colour const& a, Colour const& b, Real share)
{
    return {mix(a[0], b[0], share), mix(a[1], b[1], share), mix(a[2], b[2], share)};
}

Colour times(Colour const& colour, Real factor)
{
    Colour result{};
    for (std::size_t c = 0; c < 3; ++c) result[c] = std::clamp(static_cast<float>(factor * colour[c]), 0.0F, 1.0F);
    return result;
}

/// Lamps in the camera's axes, so that every view is lit alike.
struct Lamps
{
    Vector key, fill;
    explicit Lamps(Camera const& camera)
        : key((-0.55 * camera.right() + 0.75 * camera.upward() + 0.55 * camera.backward()).normalized()),
          fill((0.8 * camera.right() + 0.1 * camera.upward() + 0.6 * camera.backward()).normalized())
    {}

    /// Brightness of a dull surface: half-way Lambert, soft from light to shade.
    [[nodiscard]] Real brightness(Vector const& normal) const
    {
        Real const wrapped = 0.5 + 0.5 * normal.dot(key);
        return 0.58 + 0.42 * wrapped * wrapped + 0.08 * std::max(0.0, normal.dot(fill));
    }
    [[nodiscard]] Real glint(Vector const& normal, Vector const& viewer, Real sharpness) const
    {
        Vector const middle = (key + viewer).normalized();
        return std::pow(std::max(0.0, normal.dot(middle)), sharpness);
    }
};

constexpr int spiralPoints = 14; ///< Of the disc in which obscuring things are looked for.

} // namespace

float SpaceImage::nearest(std::size_t sample) const
{
    return water_.nearness.empty() ? solid_.nearness[sample] : std::max(solid_.nearness[sample], water_.nearness[sample]);
}

Vector SpaceImage::placeOf(int x, int y) const
{
    return camera_.place(window_.xLow + (x + 0.5) / samplesAMetre_, window_.yLow + (y + 0.5) / samplesAMetre_, nearest(at(x, y)));
}

Real SpaceImage::obscuranceAt(int x, int y, Real reach) const
{
    std::size_t const sample = at(x, y);
    bool const wet = !water_.nearness.empty() && water_.nearness[sample] > solid_.nearness[sample];
    Vector const world = vectorOf((wet ? water_ : solid_).normal[sample]);
    Vector const normal(world.dot(camera_.right()), world.dot(camera_.upward()), world.dot(camera_.backward()));
    Vector const here = placeOf(x, y);
    Real const size = reach / camera_.magnification(nearest(sample)) / samplesAMetre_; // [m]
    Real const turn = 0.7 * ((x * 7 + y * 3) % 16);
    Real sum = 0;
    for (int k = 0; k < spiralPoints; ++k)
    {
        Real const r = reach * std::sqrt((k + 0.5) / spiralPoints), angle = 2.39996 * k + turn;
        int const px = x + static_cast<int>(std::lround(r * std::cos(angle))), py = y + static_cast<int>(std::lround(r * std::sin(angle)));
        if (px < 0 || py < 0 || px >= columns_ || py >= rows_ || nearest(at(px, py)) == empty) continue;
        Vector const d = placeOf(px, py) - here;
        sum += std::max(0.0, d.dot(normal) - 0.05 * size) * size / (d.squaredNorm() + 0.05 * size * size);
    }
    return std::max(0.0, 1 - 0.75 * sum / spiralPoints);
}

std::vector<float> SpaceImage::obscurance() const
{
    std::vector<float> raw(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), 1.0F), smooth(raw.size(), 1.0F);
    auto const index = [this](int x, int y) {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    };
    Real const reach = 0.022 * std::max(columns_, rows_);
    for (int y = 0; y < height_; ++y)
        for (int x = 0; x < width_; ++x)
            if (nearest(at(perPixel_ * x, perPixel_ * y)) != empty)
                raw[index(x, y)] = static_cast<float>(obscuranceAt(perPixel_ * x, perPixel_ * y, reach));
    constexpr int blur = 2;
    for (int y = 0; y < height_; ++y)
        for (int x = 0; x < width_; ++x)
        {
            Real sum = 0, weights = 0;
            Real const own = camera_.depth(nearest(at(perPixel_ * x, perPixel_ * y)));
            for (int j = std::max(0, y - blur); j <= std::min(height_ - 1, y + blur); ++j)
                for (int i = std::max(0, x - blur); i <= std::min(width_ - 1, x + blur); ++i)
                {
                    Real const off = std::abs(camera_.depth(nearest(at(perPixel_ * i, perPixel_ * j))) - own) * samplesAMetre_;
                    Real const weight = 1 / (1 + 0.02 * off * off);
                    sum += weight * raw[index(i, j)];
                    weights += weight;
                }
            if (weights > 0) smooth[index(x, y)] = static_cast<float>(sum / weights);
        }
    return smooth;
}

Colour SpaceImage::solidColour(std::size_t sample) const
{
    if (solid_.nearness[sample] == empty) return background;
    Lamps const lamps(camera_);
    Vector const normal = vectorOf(solid_.normal[sample]);
    Real const glint = 0.12 * lamps.glint(normal, camera_.backward(), 30);
    return mix(times(solid_.colour[sample], lamps.brightness(normal)), Colour{1, 1, 1}, glint);
}

Colour SpaceImage::waterColour(std::size_t sample, Colour const& behind) const
{
    Lamps const lamps(camera_);
    Vector const normal = vectorOf(water_.normal[sample]), viewer = camera_.backward();
    Real const thick = std::max(0.0F, thickness_[sample]);
    Real const opacity = look_.opacity + (1 - look_.opacity) * (1 - std::exp(-look_.absorption * thick));
    Colour const dull = times(water_.colour[sample], lamps.brightness(normal));
    Real const grazing = std::pow(1 - std::clamp(normal.dot(viewer), 0.0, 1.0), 4);
    Colour const body = mix(behind, dull, opacity);
    return mix(mix(body, sky, 0.45 * grazing), Colour{1, 1, 1}, 0.45 * lamps.glint(normal, viewer, 70));
}

std::vector<Colour> SpaceImage::shaded() const
{
    std::vector<Colour> picture(solid_.nearness.size());
    std::vector<float> const open = obscurance();
    for (int y = 0; y < rows_; ++y)
        for (int x = 0; x < columns_; ++x)
        {
            std::size_t const sample = at(x, y);
            Colour colour = solidColour(sample);
            bool const wet = !water_.nearness.empty() && water_.nearness[sample] > solid_.nearness[sample];
            if (wet) colour = waterColour(sample, colour);
            std::size_t const pixel =
                static_cast<std::size_t>(y / perPixel_) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x / perPixel_);
            picture[sample] = nearest(sample) == empty ? colour : times(colour, open[pixel]);
        }
    return picture;
}

void SpaceImage::drawLine(Line const& line, std::vector<Colour>& picture) const
{
    Real const dx = line.to.x - line.from.x, dy = line.to.y - line.from.y, length = std::hypot(dx, dy);
    if (length < 1e-9) return;
    bool const flat = std::abs(dx) >= std::abs(dy);
    Real const main = flat ? dx : dy, begin = flat ? line.from.x : line.from.y, limit = flat ? columns_ : rows_;
    Real const low = std::max(0.0, std::min(begin, begin + main)), high = std::min(limit, std::max(begin, begin + main));
    Real const halfSpan = 0.5 * line.width * length / std::abs(main);
    for (int a = static_cast<int>(std::ceil(low - 0.5)); a + 0.5 < high; ++a)
    {
        Real const share = (a + 0.5 - begin) / main, across = (flat ? line.from.y + share * dy : line.from.x + share * dx);
        Real const nearness = line.from.nearness + share * (line.to.nearness - line.from.nearness);
        for (int b = static_cast<int>(std::ceil(across - halfSpan - 0.5)); b + 0.5 < across + halfSpan; ++b)
        {
            if (a < 0 || b < 0 || b >= (flat ? rows_ : columns_) || a >= limit) continue;
            std::size_t const sample = flat ? at(a, b) : at(b, a);
            Real const slack = 0.004 * std::abs(nearness) + 2 / samplesAMetre_ * (camera_.magnification(1) == 1 ? 1 : 0);
            bool const hidden = nearest(sample) != empty && nearness + slack < nearest(sample);
            picture[sample] = mix(picture[sample], line.colour, hidden ? hiddenLine : 1);
        }
    }
}

std::string SpaceImage::bytes() const
{
    std::vector<Colour> picture = shaded();
    for (Line const& line : lines_) drawLine(line, picture);
    std::string result;
    result.reserve(3 * static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
    Real const part = 1.0 / (perPixel_ * perPixel_);
    for (int y = 0; y < height_; ++y)
        for (int x = 0; x < width_; ++x)
            for (std::size_t c = 0; c < 3; ++c)
            {
                Real sum = 0;
                for (int j = 0; j < perPixel_; ++j)
                    for (int i = 0; i < perPixel_; ++i) sum += picture[at(perPixel_ * x + i, perPixel_ * y + j)][c];
                result += static_cast<char>(static_cast<unsigned char>(std::lround(255 * std::clamp(part * sum, 0.0, 1.0))));
            }
    return result;
}

} // namespace mpsDem::postGauges
