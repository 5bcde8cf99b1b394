#include <algorithm>
#include <cmath>

#include "postGauges/BodySkin.h"
#include "postGauges/ParticleColours.h"
#include "postGauges/SpacePlot.h"
#include "postGauges/Text.h"

// Sheets of SpacePlot.

namespace mpsDem::postGauges {

namespace {

constexpr Colour wallColour = {1.04F, 1.035F, 1.025F};
constexpr Colour bodyColour = {0.50F, 0.51F, 0.54F};
constexpr Real titleRoom = 34; ///< Above a sheet [pixels at 13 points].

/// The picture of a panel in whole pixels.
struct PanelPixels
{
    int left, bottom, width, height;

    PanelPixels(SheetLayout const& sheet, Box const& box)
        : left(static_cast<int>(std::lround(box.left * sheet.width))),
          bottom(static_cast<int>(std::lround(box.bottom * sheet.height))),
          width(static_cast<int>(std::lround((box.right - box.left) * sheet.width))),
          height(static_cast<int>(std::lround((box.top - box.bottom) * sheet.height)))
    {}
};

void writeMargins(std::ostream& script, SheetLayout const& sheet, PanelPixels const& panel)
{
    auto const share = [](int pixels, int all) { return number(static_cast<Real>(pixels) / all, 12); };
    script << "set lmargin at screen " << share(panel.left, sheet.width) << "\nset rmargin at screen "
           << share(panel.left + panel.width, sheet.width) << "\nset bmargin at screen " << share(panel.bottom, sheet.height)
           << "\nset tmargin at screen " << share(panel.bottom + panel.height, sheet.height) << '\n';
    script << "set xrange [0:" << panel.width << "]\nset yrange [0:" << panel.height << "]\n";
}

/// Room for the numbers at the box.
Window withRoom(Window const& window)
{
    Real const u = 0.03 * (window.xHigh - window.xLow), v = 0.02 * (window.yHigh - window.yLow);
    return {window.xLow - u, window.xHigh + u, window.yLow - v, window.yHigh + v};
}

} // namespace

void SpacePlot::drawBodies(PostCase const& postCase, Real time, Scene const& scene, SpaceImage& image) const
{
    std::vector<Colour> const colour{bodyColour};
    for (std::string const& body : scene.bodies)
    {
        SurfaceMesh const skin = smoothSkin(bodyOutlines(postCase, body, time, where()));
        image.addSolid({skin.points, skin.normals, skin.triangles, colour}, SpaceImage::Faces::Both);
    }
}

std::string SpacePlot::explanation() const
{
    if (!coloured()) return {};
    // The colour bar belongs to something with a palette, which lies outside of the picture.
    if (!categorical()) return ", '+' using (-1):(-1):(0) with points lc palette notitle";
    std::string items;
    for (ParticleCategory const& category : particleCategories(field_))
        items += ", NaN with points pt 7 ps 1.4 lc rgb '" + category.colour + "' title " + quoted(category.label);
    return items;
}

void SpacePlot::writePanel(std::ostream& script, SheetLayout const& sheet, std::size_t panel, std::size_t panels, Scene const& scene,
                           Real time) const
{
    std::string const text = (title_.empty() || panels > 1 ? "" : title_ + ", ") + "t = " + fixedNumber(time, scene.decimals) + " s";
    writeMargins(script, sheet, PanelPixels(sheet, sheet.panels[panel]));
    script << "set title " << quoted(text) << " offset 0,-0.4\nunset label\nunset arrow\n";
    if (panel == 0 && panels > 1 && !title_.empty())
        script << "set label " << quoted(title_) << " at screen "
               << number(0.5 * (sheet.panels.front().left + sheet.panels[static_cast<std::size_t>(sheet.columns) - 1].right), 6)
               << ",screen " << number(1 - 0.5 * titleRoom * pictures_.fontSize / 13 / sheet.height, 6) << " center font ',"
               << number(1.15 * pictures_.fontSize) << "'\n";
    if (panel == 0 && coloured() && !categorical())
        scene.bar.writeBox(script, sheet, pictures_.fontSize);
    else
        script << "unset colorbox\n";
}

void SpacePlot::drawSheet(PostCase const& postCase, Series const& series, std::vector<std::size_t> const& chosen, Scene const& scene,
                          std::string const& fileName) const
{
    Camera const camera(camera_, scene.up, scene.box);
    Window const window = withRoom(camera.window());
    Real const sideRoom = !coloured() ? 10 : categorical() ? 290 : 110;
    auto const sheet = layOut(static_cast<int>(chosen.size()), columns_, window, width_, maxHeight_, pictures_.fontSize, sideRoom,
                              chosen.size() > 1 && !title_.empty() ? titleRoom : 0);
    Picture picture(postCase.plots(), fileName, sheet.width, sheet.height, pictures_);
    auto& script = picture.script();
    script << "unset border\nunset tics\n" << (categorical() ? "" : "unset key\n") << "set style fill solid 1 noborder\n";
    if (categorical())
        script << "set key at screen " << number(sheet.bar.left, 6) << ",screen " << number(sheet.bar.top, 6)
               << " left top Left reverse samplen 0.6 spacing 1.4 vertical maxrows 6\n";
    else if (coloured())
        script << "set cbtics textcolor rgb '#202020'\n", scene.bar.writeScale(script, sheet, pictures_.fontSize);
    script << "set multiplot\n";
    std::vector<Colour> const wall{wallColour};
    for (std::size_t k = 0; k < chosen.size(); ++k)
    {
        ParticleFrame const frame = frameOf(series, chosen[k], scene);
        PanelPixels const pixels(sheet, sheet.panels[k]);
        SpaceImage image(camera, window, pixels.width, pixels.height);
        if (!scene.walls.triangles.empty())
            image.addSolid({scene.walls.points, scene.walls.normals, scene.walls.triangles, wall}, SpaceImage::Faces::TowardsViewer);
        drawBodies(postCase, frame.time, scene, image);
        drawFluid(postCase, frame, scene, image);
        if (axes_) drawBox(image, camera, scene.box);
        writePanel(script, sheet, k, chosen.size(), scene, frame.time);
        if (axes_ && k == 0) writeAxes(script, camera, scene.box, pixels.width / (window.xHigh - window.xLow), window);
        script << "plot " << picture.addData(image.bytes()) << " binary array=(" << pixels.width << ',' << pixels.height
               << ") format='%uchar' dx=1 dy=1 origin=(0.5,0.5) using 1:2:3 with rgbimage notitle" << (k == 0 ? explanation() : "") << '\n';
    }
    script << "unset multiplot\n";
    render(postCase, picture);
}

} // namespace mpsDem::postGauges
