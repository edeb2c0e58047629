# SPDX-License-Identifier: Apache-2.0
# How long the cycles of the control loop took, as in figures 20 to 23 of the thesis. `seconds` and `histogram` are the tables,
# `picture` the PNG or SVG to write, `says` what was measured where, `longest` the longest interval, us.
if (picture[strlen(picture)-3:] eq '.svg') set terminal svg size 1300,1100 font 'DejaVu Sans,13' background 'white'; else set terminal pngcairo size 1300,1100 font 'DejaVu Sans,11'
set output picture
set datafile separator ','
set grid
set key above # nothing of the longest is behind it
set multiplot layout 2,2 title says noenhanced
set xlabel 'seconds'
set ylabel 'interval, us'
set yrange [0:longest*1.05]
set title 'Intervals of each second (figure 20)'
plot seconds using 1:2:4 skip 1 with filledcurves lc rgb '#A6CEE3' title 'shortest to longest', \
     seconds using 1:3 skip 1 with lines lc rgb '#0072B2' lw 2 title 'mean'
set yrange [800:1200]
set title 'The same, 800 to 1200 us (figure 21)'
plot seconds using 1:2:4 skip 1 with filledcurves lc rgb '#A6CEE3' title 'shortest to longest', \
     seconds using 1:3 skip 1 with lines lc rgb '#0072B2' lw 2 title 'mean'
unset key
set xlabel 'interval, us'
set ylabel 'cycles'
set yrange [0:*]
set xrange [800:1200]
set title 'How often each interval was (figure 22)'
plot histogram using 1:2 skip 1 with impulses lc rgb '#0072B2' lw 2
set xrange [0:longest*1.05]
set yrange [0.5:*]
set logscale y
set title 'All of them, logarithmic (figure 23)'
plot histogram using 1:2 skip 1 with impulses lc rgb '#D55E00' lw 2
