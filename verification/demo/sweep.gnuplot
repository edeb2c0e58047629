# SPDX-License-Identifier: Apache-2.0
# Speeds of an axis by frequency: `source` is the table of a sweep, `published` the public one, `picture` the PNG or SVG to write,
# `scale` what the speeds of the public one are multiplied by.
if (picture[strlen(picture)-3:] eq '.svg') set terminal svg size 1200,800 font 'DejaVu Sans,14' background 'white'; else set terminal pngcairo size 1200,800 font 'DejaVu Sans,12'
set output picture
set datafile separator ','
set datafile commentschars '#'
set key top right
set grid
set logscale y
set format y '%g'
set yrange [0.01:300]
set xrange [49.9:54.6]
set title sprintf('Frequency sweep (points) and the published one times %.3f (lines)', scale)
set xlabel 'frequency, kHz'
set ylabel 'turns a minute'
plot published using 1:($2*scale) with lines lc rgb '#56B4E9' lw 2 title 'published, upwards', \
     published using 1:($3*scale) with lines lc rgb '#E69F00' lw 2 title 'published, downwards', \
     source using (column('frequency_hz')/1000):(column('upwards_rpm')) with points lc rgb '#0072B2' pt 9 ps 1.4 title 'swept upwards', \
     source using (column('frequency_hz')/1000):(column('downwards_rpm')) with points lc rgb '#D55E00' pt 11 ps 1.4 title 'swept downwards'
