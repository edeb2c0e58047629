# SPDX-License-Identifier: Apache-2.0
# Speed, position and control output of `axis`, as in figures 29 to 31 of the thesis. `source` is motion.csv, `picture`
# the PNG or SVG to write, `from` and `to` the seconds to show.
if (picture[strlen(picture)-3:] eq '.svg') set terminal svg size 1200,1300 font 'DejaVu Sans,13' background 'white'; else set terminal pngcairo size 1200,1300 font 'DejaVu Sans,11'
set output picture
set datafile separator ','
set key top right
set grid
set xrange [from:to]
set lmargin 12
set multiplot layout 3,1 title axis.': set-point (blue), measured (orange), control output (green)' noenhanced
set ylabel 'speed, ticks/s'
plot source using 1:(column(axis.'_ticks_per_s')) with lines lc rgb '#E69F00' lw 3 title 'measured', \
     source using 1:(column(axis.'_setpoint_ticks_per_s')) with lines lc rgb '#0072B2' lw 2 title 'set-point'
set ylabel 'position, ticks'
plot source using 1:(column(axis.'_position_ticks')) with lines lc rgb '#E69F00' lw 4 title 'measured', \
     source using 1:(column(axis.'_setpoint_ticks')) with lines lc rgb '#0072B2' lw 2 title 'set-point'
set ylabel 'control output, percent of the largest word'
set xlabel 'seconds'
plot source using 1:(column(axis.'_output_percent')) with lines lc rgb '#009E73' lw 2 title 'output'
