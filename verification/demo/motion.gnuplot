# SPDX-License-Identifier: Apache-2.0
# Commanded and measured position and speed of every axis. `source` is motion.csv, `picture` the PNG to write.
set terminal pngcairo size 1600,2000 font 'DejaVu Sans,10'
set output picture
set datafile separator ','
set key top right
set grid
set multiplot layout 7,2 columnsfirst title 'NeuroRobot workflow: commanded (blue) and measured (orange)'
axes = 'head feet lateral insertion rotation pitch yaw'
do for [i=1:7] {
    set title word(axes, i).', position'
    set ylabel 'ticks'
    plot source using 1:(column(6*i-3)) every ::1 with lines lc rgb '#E69F00' lw 3 title 'measured', \
         source using 1:(column(6*i-4)) every ::1 with lines lc rgb '#0072B2' title 'commanded'
}
do for [i=1:7] {
    set title word(axes, i).', speed'
    set ylabel 'ticks/s'
    plot source using 1:(column(6*i-1)) every ::1 with lines lc rgb '#E69F00' title 'measured', \
         source using 1:(column(6*i-2)) every ::1 with lines lc rgb '#0072B2' lw 2 title 'commanded'
}
