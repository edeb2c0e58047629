# SPDX-License-Identifier: Apache-2.0
# Commanded and measured position and speed of every axis. `source` is motion.csv, `picture` the PNG to write, `robot`
# its name, `axes` the names of its axes.
set terminal pngcairo size 1600,300*words(axes) font 'DejaVu Sans,10'
set output picture
set datafile separator ','
set key top right
set grid
set multiplot layout words(axes),2 columnsfirst title robot.' workflow: commanded (blue) and measured (orange)' noenhanced
set title noenhanced
do for [axis in axes] {
    set title axis.', position'
    set ylabel 'ticks'
    plot source using 1:(column(axis.'_position_ticks')) with lines lc rgb '#E69F00' lw 3 title 'measured', \
         source using 1:(column(axis.'_setpoint_ticks')) with lines lc rgb '#0072B2' title 'commanded'
}
do for [axis in axes] {
    set title axis.', speed'
    set ylabel 'ticks/s'
    plot source using 1:(column(axis.'_ticks_per_s')) with lines lc rgb '#E69F00' title 'measured', \
         source using 1:(column(axis.'_setpoint_ticks_per_s')) with lines lc rgb '#0072B2' lw 2 title 'commanded'
}
