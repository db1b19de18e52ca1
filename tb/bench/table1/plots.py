"""plots.py - the paper's four plots and one of all algorithms, by gnuplot, as PNG and SVG."""
import subprocess

import tables

TERMINALS = {"png": "pngcairo size 960,640", "svg": "svg size 960,640"}


def series(cells, build, shape, algorithm):
    points = sorted((key[3], float(row["fine_ms"])) for key, row in cells.items()
                    if key[:3] == (build, 16, shape) and key[4] == algorithm)
    return "".join(f"{count} {ms}\n" for count, ms in points)


def plot(gnuplot, path, title, curves, options=()):
    """`curves` are (label, data)."""
    for suffix, terminal in TERMINALS.items():
        script = [f"set terminal {terminal}", f'set output "{path}.{suffix}"',
                  f'set title "{title}"', 'set xlabel "inserted shapes"',
                  'set ylabel "CPU time a tick, ms"', "set key left top noenhanced", "set grid",
                  'set format "%g"',
                  *options]
        for index, (_, data) in enumerate(curves):
            script.append(f"$data{index} << EOD\n{data}EOD")
        script.append("plot " + ", ".join(
            f'$data{index} with linespoints pointtype {index + 4} title "{label}"'
            for index, (label, _) in enumerate(curves)))
        subprocess.run([gnuplot], input="\n".join(script) + "\n", check=True, text=True)


def draw(gnuplot, out, cells, growth):
    def of(shape, algorithm):
        return f"{algorithm}, {shape}", series(cells, "optimised", shape, algorithm)
    plot(gnuplot, out / "fig5_squares", "Original and improved algorithm, squares",
         [of("square", "original"), of("square", "improved")])
    plot(gnuplot, out / "fig6_x", "Original and improved algorithm, X",
         [of("X", "original"), of("X", "improved")])
    plot(gnuplot, out / "fig7_original", "Original algorithm, squares and X",
         [of("square", "original"), of("X", "original")])
    plot(gnuplot, out / "fig8_improved", "Improved algorithm, squares and X",
         [of("square", "improved"), of("X", "improved")])
    plot(gnuplot, out / "growth", "All algorithms, squares; as dense as 200 on the screen beyond",
         [(name, series(growth, "growth", "square", name))
          for name in tables.algorithms(growth, "growth")], ["set logscale xy"])
