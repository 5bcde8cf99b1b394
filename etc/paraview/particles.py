"""Particles of a case in ParaView: round particles coloured by a field, bodies as surfaces, a picture or a film.

    pvpython particles.py --case dir [--field U] [--time 0.5] [--png picture.png] [--film frames.png]

or inside ParaView (Tools > Python Shell > Run Script) with the working folder in the case; everything then stays on the screen to go on with.
The calls are those of ParaView 5.10 and 5.11 (paraview.simple). pvpython needs a display or an offscreen build of ParaView:
xvfb-run -a -s "-noreset -screen 0 1280x1024x24" pvpython particles.py ...
"""

import argparse
import glob
import os
import re
import sys

from paraview.simple import (
    ColorBy,
    GetActiveViewOrCreate,
    GetAnimationScene,
    GetColorTransferFunction,
    GetScalarBar,
    GetTimeKeeper,
    Hide,
    OpenDataFile,
    Render,
    SaveAnimation,
    SaveScreenshot,
    Show,
    Threshold,
    UpdatePipeline,
)

LABELS = {"p": "p [Pa]", "U": "|U| [m/s]", "n": "n/n0 [-]", "type": "type", "surface": "surface"}
FLUID = 0  # values of the array `type`: 0 fluid, 1 wall, 2 wall row labelled ghost (dry), 3 ghost rows


def read_arguments(words):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("-case", "--case", default=".", help="folder of the case (default: the present one)")
    parser.add_argument("-field", "--field", default="p", help="array that gives the colour: p U n type surface id (default p)")
    parser.add_argument("-range", "--range", nargs=2, type=float, metavar=("LOW", "HIGH"), help="of the colours (default: values at that time)")
    parser.add_argument("-spacing", "--spacing", type=float, help="particle spacing [m] (default: constant/particleProperties)")
    parser.add_argument("-show", "--show", default="fluid", choices=["fluid", "all"], help="fluid (default), or wall and ghost particles too")
    parser.add_argument("-time", "--time", type=float, help="time [s] (default: the last one)")
    parser.add_argument("-size", "--size", nargs=2, type=int, default=[1600, 800], metavar=("WIDTH", "HEIGHT"), help="pixels (default 1600 800)")
    parser.add_argument("-png", "--png", help="write a picture of this time")
    parser.add_argument("-film", "--film", help="write all times: frames.png gives numbered pictures, film.avi a film")
    # pvpython hands -case on as --case. ParaView's shell may carry words of its own: what is not known is left alone.
    return parser.parse_known_args(words)[0]


def spacing_of(case):
    """The entry `spacing` of constant/particleProperties, comments left out."""
    path = os.path.join(case, "constant", "particleProperties")
    with open(path, encoding="utf-8") as file:
        text = re.sub(r"//[^\n]*|/\*.*?\*/", " ", file.read(), flags=re.DOTALL)
    found = re.search(r"\bspacing\s+([-+.\deE]+)\s*;", text)
    if not found:
        raise SystemExit(path + ": no entry `spacing <number>;` - give -spacing")
    return float(found.group(1))


def open_series(case, name):
    path = os.path.join(os.path.abspath(case), "VTK", name + ".vtp.series")
    if not os.path.exists(path):
        raise SystemExit(path + " does not exist: has the solver been run?")
    return OpenDataFile(path)


def body_names(case):
    paths = glob.glob(os.path.join(case, "VTK", "*.vtp.series"))
    names = [os.path.basename(path)[: -len(".vtp.series")] for path in paths]
    return sorted(name for name in names if name != "particles")


def show_particles(source, view, options, spacing, time):
    """Discs of the size of the particles, coloured by the field."""
    shown = source
    if options.show == "fluid":
        shown = Threshold(Input=source, Scalars=["POINTS", "type"], LowerThreshold=FLUID, UpperThreshold=FLUID)
        Hide(source, view)
    # The data must be those of the time wanted before the colours are fitted to them.
    UpdatePipeline(time, shown)
    display = Show(shown, view)
    display.SetRepresentationType("Point Gaussian")
    display.ShaderPreset = "Plain circle"
    display.GaussianRadius = 0.5 * spacing
    ColorBy(display, ("POINTS", options.field, "Magnitude") if options.field == "U" else ("POINTS", options.field))
    colours = GetColorTransferFunction(options.field)
    colours.ApplyPreset("Viridis (matplotlib)", True)
    if options.range:
        colours.RescaleTransferFunction(*options.range)
    else:
        display.RescaleTransferFunctionToDataRange(False, True)
    bar = GetScalarBar(colours, view)
    bar.Title = LABELS.get(options.field, options.field)
    bar.ComponentTitle = ""
    bar.TitleColor = bar.LabelColor = [0.0, 0.0, 0.0]
    display.SetScalarBarVisibility(view, True)


def show_bodies(case, view):
    for name in body_names(case):
        display = Show(open_series(case, name), view)
        display.SetRepresentationType("Surface With Edges")
        display.ColorArrayName = [None, ""]
        display.DiffuseColor = display.AmbientColor = [0.75, 0.75, 0.75]
        display.EdgeColor = [0.0, 0.0, 0.0]


def main(words):
    options = read_arguments(words)
    spacing = options.spacing if options.spacing else spacing_of(options.case)
    source = open_series(options.case, "particles")
    scene = GetAnimationScene()
    scene.UpdateAnimationUsingDataTimeSteps()
    times = list(GetTimeKeeper().TimestepValues or [0.0])
    time = times[-1] if options.time is None else min(times, key=lambda t: abs(t - options.time))
    scene.AnimationTime = time

    view = GetActiveViewOrCreate("RenderView")
    view.ViewSize = options.size
    view.InteractionMode = "2D"
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [1.0, 1.0, 1.0]
    show_particles(source, view, options, spacing, time)
    show_bodies(options.case, view)
    view.ResetCamera(True, 0.95)
    Render(view)
    if options.png:
        SaveScreenshot(options.png, view, ImageResolution=options.size)
        print("time {:g} s: {}".format(time, options.png))
    if options.film:
        SaveAnimation(options.film, view, ImageResolution=options.size)
        print("{} times: {}".format(len(times), options.film))


main(sys.argv[1:])
