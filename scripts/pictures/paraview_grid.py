#!/usr/bin/env python3
"""Makes docs/pictures/paraview.png: ParaView opens the grid of gapcheck audit --vtu and shows depths and the way out.

usage: xvfb-run -s -noreset pvbatch paraview_grid.py GAPCHECK    (Debian: python3-paraview, xvfb)
"""

import pathlib
import subprocess
import sys
import tempfile

from paraview.simple import (ColorBy, CreateView, GetColorTransferFunction, GetScalarBar, Glyph, Render,
                             SaveScreenshot, Show, Threshold, XMLUnstructuredGridReader)

ROOT = pathlib.Path(__file__).resolve().parents[2]
PICTURE = ROOT / "docs" / "pictures" / "paraview.png"
DECK = "data/two_plates_tilted.k"
INK = [0.1, 0.12, 0.15]


def view():
    it = CreateView("RenderView")
    it.ViewSize = [1000, 560]
    it.UseColorPaletteForBackground = 0
    it.Background = [1, 1, 1]
    it.OrientationAxesLabelColor = INK
    return it


def show_mesh(grid, picture):
    """The elements, coloured by the depth at their nodes."""
    mesh = Show(grid, picture)
    mesh.Representation = "Surface With Edges"
    mesh.EdgeColor = [0.35, 0.38, 0.42]
    mesh.Opacity = 0.85
    ColorBy(mesh, ("POINTS", "depth"))
    colors = GetColorTransferFunction("depth")
    deepest = grid.PointData["depth"].GetRange()[1]
    colors.ColorSpace = "RGB"
    colors.RGBPoints = [0, 0.82, 0.84, 0.87, deepest / 2, 0.98, 0.75, 0.25, deepest, 0.75, 0.1, 0.1]
    bar = GetScalarBar(colors, picture)
    bar.Title, bar.ComponentTitle = "depth", ""
    bar.TitleColor = bar.LabelColor = INK
    bar.WindowLocation, bar.Position, bar.ScalarBarLength = "Any Location", [0.88, 0.3], 0.4
    mesh.SetScalarBarVisibility(picture, True)


def show_ways(grid, picture):
    """From each penetrating node as far as it must go."""
    nodes = Threshold(Input=grid, Scalars=["POINTS", "depth"], LowerThreshold=1e-9,
                      UpperThreshold=grid.PointData["depth"].GetRange()[1], AllScalars=0)
    ways = Glyph(Input=nodes, GlyphType="Arrow", OrientationArray=["POINTS", "way_out"],
                 ScaleArray=["POINTS", "way_out"], ScaleFactor=4, GlyphMode="All Points")
    arrows = Show(ways, picture)
    arrows.ColorArrayName = ["POINTS", ""]
    arrows.AmbientColor = arrows.DiffuseColor = [0.1, 0.25, 0.55]


def main():
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "grid.vtu"
        subprocess.run([sys.argv[1], "audit", DECK, "--quiet", "--fail-on", "never", "--vtu", path], cwd=ROOT,
                       check=True, stdout=subprocess.DEVNULL)
        grid = XMLUnstructuredGridReader(FileName=[str(path)])
        grid.UpdatePipeline()
        picture = view()
        show_mesh(grid, picture)
        show_ways(grid, picture)
        Render(picture)  # the first one takes a camera of its own
        picture.CameraViewUp = [0, 0, 1]
        low_x, high_x, low_y, high_y, low_z, high_z = grid.GetDataInformation().GetBounds()
        middle = [(low_x + high_x) / 2, (low_y + high_y) / 2, (low_z + high_z) / 2]
        size = max(high_x - low_x, high_y - low_y, high_z - low_z)
        picture.CameraFocalPoint = [middle[0] + 0.06 * size, middle[1], middle[2]]
        picture.CameraPosition = [middle[0] - 0.65 * size, middle[1] - 1.5 * size, middle[2] + 0.6 * size]
        SaveScreenshot(str(PICTURE), picture, CompressionLevel="9")
        print(f"{PICTURE.relative_to(ROOT)}: {PICTURE.stat().st_size // 1000} kB")


if __name__ == "__main__":
    main()
