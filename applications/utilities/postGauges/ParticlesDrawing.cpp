#include <algorithm>
#include <map>

#include "core/Log.h"
#include "postGauges/ParticleColours.h"
#include "postGauges/ParticlesPlot.h"
#include "postGauges/Text.h"

namespace mpsDem::postGauges {

namespace {

/// Radius of a filled point of size 1 [pixels], which differs between gnuplot's terminals (measured, version 5.4).
constexpr char const* pointRadius = "radius = GPVAL_TERM eq 'svg' ? 5.0 : 3.0\n";

/// Discs of a diameter in metres. Point symbols, since circles in space are polygons of hundreds of bytes each in SVG.
std::string discStyle(Real diameter, Real pixelsAMetre) { return "pt 7 ps " + number(0.5 * diameter * pixelsAMetre) + "/radius"; }

std::string lineOf(Box const& box)
{
    return "set lmargin at screen " + number(box.left, 9) + "\nset rmargin at screen " + number(box.right, 9) + "\nset bmargin at screen " +
           number(box.bottom, 9) + "\nset tmargin at screen " + number(box.top, 9) + '\n';
}

bool inWindow(Vector const& place, Window const& window, Real margin)
{
    return place.x() > window.xLow - margin && place.x() < window.xHigh + margin && place.y() > window.yLow - margin &&
           place.y() < window.yHigh + margin;
}

} // namespace

void ParticlesPlot::writeColours(std::ostream& script, SheetLayout const& sheet, Scene const& scene) const
{
    script << pointRadius << paletteCommand(palette_) << "set cbrange [" << number(scene.range.first, 9) << ':'
           << number(scene.range.second, 9) << "]\n";
    script << "set style fill solid 1 noborder\n";
    script << "set border 15 lw 1 lc rgb '#404040'\nset tics out scale 0.6 nomirror textcolor rgb '#202020'\n";
    script << "set cbtics out scale 0.4\nset format cb '%g'\n";
    if (categorical())
        script << "set key at screen " << number(sheet.bar.left, 6) << ",screen " << number(sheet.bar.top, 6)
               << " left top Left reverse samplen 0.6 spacing 1.4 vertical maxrows 6\n";
}

void ParticlesPlot::writePanel(std::ostream& script, SheetLayout const& sheet, std::size_t panel, std::size_t panels, Scene const& scene,
                               Real time) const
{
    auto const columns = static_cast<std::size_t>(sheet.columns);
    bool const left = panel % columns == 0, lowest = panel + columns >= panels;
    std::string const text = (title_.empty() ? "" : title_ + ", ") + "t = " + fixedNumber(time, scene.decimals) + " s";
    script << lineOf(sheet.panels[panel]);
    script << "set xrange [" << number(scene.window.xLow, 9) << ':' << number(scene.window.xHigh, 9) << "]\n";
    script << "set yrange [" << number(scene.window.yLow, 9) << ':' << number(scene.window.yHigh, 9) << "]\n";
    script << "set title " << quoted(text) << " offset 0,-0.4\n";
    script << (lowest ? "set xlabel 'x [m]'\nset format x '%g'\n" : "unset xlabel\nset format x ''\n");
    script << (left ? "set ylabel 'y [m]'\nset format y '%g'\n" : "unset ylabel\nset format y ''\n");
    bool const bar = panel == 0 && !categorical();
    if (bar)
        script << "set colorbox vertical user origin screen " << number(sheet.bar.left, 6) << ",screen " << number(sheet.bar.bottom, 6)
               << " size screen " << number(sheet.bar.right - sheet.bar.left, 6) << ",screen "
               << number(sheet.bar.top - sheet.bar.bottom, 6) << "\nset cblabel " << quoted(label_) << '\n';
    else
        script << "unset colorbox\n";
    if (panel > 0 || !categorical()) script << "unset key\n";
}

std::vector<std::string> ParticlesPlot::colouredItems(ParticleFrame const& frame, Scene const& scene, std::string const& discs, bool legend,
                                                      Picture& picture) const
{
    auto const values = frame.field(field_, where_);
    std::map<int, std::string> rows;
    for (std::size_t i = 0; i < values.size(); ++i)
    {
        Vector const& place = frame.data.position[i];
        bool const drawn = shows(frame, i) && coloured(frame.type[i]) && inWindow(place, scene.window, scene.spacing);
        if (drawn) addRow(rows[categorical() ? static_cast<int>(values[i]) : 0], {place.x(), place.y(), scale_ * values[i]});
    }
    if (!categorical())
        return rows.empty() ? std::vector<std::string>()
                            : std::vector<std::string>{picture.addData(rows[0]) + " using 1:2:3 " + discs + " lc palette notitle"};
    std::vector<std::string> items;
    for (ParticleCategory const& category : particleCategories(field_))
    {
        auto const own = rows.find(category.value);
        if (own == rows.end()) continue;
        std::string const colour = " lc rgb '" + category.colour + "'";
        items.push_back(picture.addData(own->second) + " using 1:2 " + discs + colour + " notitle");
        if (legend) items.push_back("NaN with points pt 7 ps 1.4" + colour + " title " + quoted(category.label));
    }
    return items;
}

std::vector<std::string> ParticlesPlot::items(PostCase const& postCase, ParticleFrame const& frame, Scene const& scene,
                                              SheetLayout const& sheet, bool legend, Picture& picture) const
{
    std::string const discs = "with points " + discStyle(discSize_ * scene.spacing, sheet.scale);
    std::vector<std::string> items;
    std::string ghosts, walls;
    for (std::size_t i = 0; i < frame.type.size(); ++i)
    {
        Vector const& place = frame.data.position[i];
        bool const drawn = shows(frame, i) && !coloured(frame.type[i]) && inWindow(place, scene.window, scene.spacing);
        bool const ghost = frame.type[i] == static_cast<int>(ParticleKind::Ghost);
        if (drawn) addRow(ghost ? ghosts : walls, {place.x(), place.y()});
    }
    if (!ghosts.empty()) items.push_back(picture.addData(ghosts) + " using 1:2 " + discs + " lc rgb '#cfcfcf' notitle");
    if (!walls.empty()) items.push_back(picture.addData(walls) + " using 1:2 " + discs + " lc rgb '#7a7a7a' notitle");
    auto const coloured = colouredItems(frame, scene, discs, legend, picture);
    items.insert(items.end(), coloured.begin(), coloured.end());
    for (std::string const& body : scene.bodies)
    {
        std::string const data = picture.addData(outlineRows(bodyOutlines(postCase, body, frame.time, where_)));
        bool const filled = bodyStyle_ == "filled";
        if (filled) items.push_back(data + " using 1:2 with filledcurves closed fs solid 1 noborder fc rgb '#b8b8b8' notitle");
        items.push_back(data + " using 1:2 with lines lw 2 lc rgb '#000000' notitle");
    }
    return items;
}

void ParticlesPlot::drawSheet(PostCase const& postCase, Series const& series, std::vector<std::size_t> const& chosen, Scene const& scene,
                              std::string const& fileName) const
{
    auto const sheet =
        layOut(static_cast<int>(chosen.size()), columns_, scene.window, width_, maxHeight_, pictures_.fontSize, categorical() ? 190 : 110);
    Picture picture(postCase.plots(), fileName, sheet.width, sheet.height, pictures_);
    auto& script = picture.script();
    writeColours(script, sheet, scene);
    script << "set multiplot\n";
    for (std::size_t k = 0; k < chosen.size(); ++k)
    {
        ParticleFrame const frame = series.frame(chosen[k]);
        writePanel(script, sheet, k, chosen.size(), scene, frame.time);
        char const* separator = "plot ";
        for (std::string const& item : items(postCase, frame, scene, sheet, k == 0, picture))
        {
            script << separator << item;
            separator = ", \\\n     ";
        }
        if (std::string(separator) == "plot ") script << "plot NaN notitle";
        script << '\n';
    }
    script << "unset multiplot\n";
    render(postCase, picture);
}

} // namespace mpsDem::postGauges
