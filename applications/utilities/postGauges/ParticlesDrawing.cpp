#include <algorithm>
#include <cmath>
#include <map>

#include "core/Log.h"
#include "postGauges/ParticleColours.h"
#include "postGauges/ParticlesPlot.h"
#include "postGauges/Text.h"

namespace mpsDem::postGauges {

namespace {

/// Radius of a filled point of size 1 [pixels], which differs between gnuplot's terminals (measured, version 5.4).
constexpr char const* pointRadius = "radius = GPVAL_TERM eq 'svg' ? 5.0 : 3.0\n";

/// The discs of one colour, or of one set of values, as rows of data. Discs within the frame are drawn as point symbols, since circles in
/// space are polygons of hundreds of bytes each in SVG; those on the frame as circles, which gnuplot cuts there, beneath the others. gnuplot
/// leaves out circles with their centre outside: such a one becomes one with its centre on the frame that cuts it along the same chord.
class Discs
{
public:
    /// @param radius  [m]
    Discs(Real radius, Real pixelsAMetre, Window const& window) : radius_(radius), pixelsAMetre_(pixelsAMetre), window_(window) {}

    void add(Vector const& place, Real value)
    {
        Real const x = std::clamp(place.x(), window_.xLow, window_.xHigh), y = std::clamp(place.y(), window_.yLow, window_.yHigh);
        Real const beyond = std::hypot(place.x() - x, place.y() - y);
        Real const inside = std::min({x - window_.xLow, window_.xHigh - x, y - window_.yLow, window_.yHigh - y});
        if (inside > radius_)
            addRow(inner_, {x, y, value});
        else if (beyond < radius_)
            addRow(edge_, {x, y, std::sqrt(radius_ * radius_ - beyond * beyond), value});
    }

    /// Items of a plot command. @param colour  "lc palette" takes the values.
    [[nodiscard]] std::vector<std::string> items(std::string const& colour, Picture& picture) const
    {
        std::vector<std::string> all;
        bool const byValue = colour.ends_with("palette");
        if (!edge_.empty())
            all.push_back(picture.addData(edge_) + " using 1:2:3" + (byValue ? ":4" : "") + " with circles fs solid 1 noborder " + colour +
                          " notitle");
        if (!inner_.empty())
            all.push_back(picture.addData(inner_) + " using 1:2" + (byValue ? ":3" : "") + " with points pt 7 ps " +
                          number(radius_ * pixelsAMetre_) + "/radius " + colour + " notitle");
        return all;
    }

private:
    Real radius_;
    Real pixelsAMetre_;
    Window window_;
    std::string inner_;
    std::string edge_;
};

constexpr Real titleRoom = 34; ///< Above a sheet [pixels at 13 points].

} // namespace

void ParticlesPlot::writeColours(std::ostream& script, SheetLayout const& sheet, Scene const& scene) const
{
    script << pointRadius << "set style fill solid 1 noborder\n";
    script << "set border 15 lw 1 lc rgb '#404040'\nset tics out scale 0.6 nomirror textcolor rgb '#202020'\n";
    scene.bar.writeScale(script, sheet, pictures_.fontSize);
    if (categorical())
        script << "set key at screen " << number(sheet.bar.left, 6) << ",screen " << number(sheet.bar.top, 6)
               << " left top Left reverse samplen 0.6 spacing 1.4 vertical maxrows 6\n";
}

void ParticlesPlot::writePanel(std::ostream& script, SheetLayout const& sheet, std::size_t panel, std::size_t panels, Scene const& scene,
                               Real time) const
{
    auto const columns = static_cast<std::size_t>(sheet.columns);
    bool const left = panel % columns == 0, lowest = panel + columns >= panels;
    std::string const text = (title_.empty() || panels > 1 ? "" : title_ + ", ") + "t = " + fixedNumber(time, scene.decimals) + " s";
    writeMargins(script, sheet.panels[panel]);
    script << "set xrange [" << number(scene.window.xLow, 9) << ':' << number(scene.window.xHigh, 9) << "]\n";
    script << "set yrange [" << number(scene.window.yLow, 9) << ':' << number(scene.window.yHigh, 9) << "]\n";
    script << "set title " << quoted(text) << " offset 0,-0.4\n";
    script << (lowest ? "set xlabel " + quoted(scene.slice.xLabel()) + "\nset format x '%g'\n"
                      : std::string("unset xlabel\nset format x ''\n"));
    script << (left ? "set ylabel " + quoted(scene.slice.yLabel()) + "\nset format y '%g'\n"
                    : std::string("unset ylabel\nset format y ''\n"));
    script << scene.slice.tics(scene.window) << "unset label\n";
    if (panel == 0 && panels > 1 && !title_.empty())
        script << "set label " << quoted(title_) << " at screen "
               << number(0.5 * (sheet.panels.front().left + sheet.panels[columns - 1].right), 6) << ",screen "
               << number(1 - 0.5 * titleRoom * pictures_.fontSize / 13 / sheet.height, 6) << " center font ',"
               << number(1.15 * pictures_.fontSize) << "'\n";
    bool const bar = panel == 0 && !categorical();
    if (bar)
        scene.bar.writeBox(script, sheet, pictures_.fontSize);
    else
        script << "unset colorbox\n";
    if (panel > 0 || !categorical()) script << "unset key\n";
}

std::vector<std::string> ParticlesPlot::colouredItems(ParticleFrame const& frame, Scene const& scene, SheetLayout const& sheet, bool legend,
                                                      Picture& picture) const
{
    auto const values = frame.field(field_, where_);
    Discs const none(0.5 * discSize_ * scene.spacing, sheet.scale, scene.window);
    std::map<int, Discs> discs;
    for (std::size_t const i : scene.slice.particles(frame))
    {
        if (!shows(frame, i) || !coloured(frame.type[i])) continue;
        int const kind = categorical() ? static_cast<int>(values[i]) : 0;
        discs.try_emplace(kind, none).first->second.add(scene.slice.place(frame.data.position[i]), scale_ * values[i]);
    }
    if (!categorical()) return discs.empty() ? std::vector<std::string>() : discs.at(0).items("lc palette", picture);
    std::vector<std::string> items;
    for (ParticleCategory const& category : particleCategories(field_))
    {
        auto const own = discs.find(category.value);
        if (own == discs.end()) continue;
        std::string const colour = "lc rgb '" + category.colour + "'";
        for (std::string const& item : own->second.items(colour, picture)) items.push_back(item);
        if (legend) items.push_back("NaN with points pt 7 ps 1.4 " + colour + " title " + quoted(category.label));
    }
    return items;
}

std::vector<std::string> ParticlesPlot::items(PostCase const& postCase, ParticleFrame const& frame, Scene const& scene,
                                              SheetLayout const& sheet, bool legend, Picture& picture) const
{
    Discs ghosts(0.5 * discSize_ * scene.spacing, sheet.scale, scene.window), walls = ghosts;
    for (std::size_t const i : scene.slice.particles(frame))
    {
        bool const ghost = frame.type[i] == static_cast<int>(ParticleKind::Ghost);
        if (shows(frame, i) && !coloured(frame.type[i])) (ghost ? ghosts : walls).add(scene.slice.place(frame.data.position[i]), 0);
    }
    std::vector<std::string> items = ghosts.items("lc rgb '#cfcfcf'", picture);
    for (std::string const& item : walls.items("lc rgb '#7a7a7a'", picture)) items.push_back(item);
    for (std::string const& item : colouredItems(frame, scene, sheet, legend, picture)) items.push_back(item);
    for (std::string const& body : scene.bodies)
    {
        std::string const rows = outlineRows(scene.slice.outlines(bodyOutlines(postCase, body, frame.time, where_)));
        if (rows.empty()) continue; // not in the slice
        std::string const data = picture.addData(rows);
        bool const filled = bodyStyle_ == "filled";
        if (filled) items.push_back(data + " using 1:2 with filledcurves closed fs solid 1 noborder fc rgb '#b8b8b8' notitle");
        items.push_back(data + " using 1:2 with lines lw 2 lc rgb '#000000' notitle");
    }
    return items;
}

void ParticlesPlot::drawSheet(PostCase const& postCase, Series const& series, std::vector<std::size_t> const& chosen, Scene const& scene,
                              std::string const& fileName) const
{
    auto const sheet = layOut(static_cast<int>(chosen.size()), columns_, scene.window, width_, maxHeight_, pictures_.fontSize,
                              categorical() ? 290 : 110, chosen.size() > 1 && !title_.empty() ? titleRoom : 0);
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
