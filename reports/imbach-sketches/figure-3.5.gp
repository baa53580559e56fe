# Sketches of the hexahedron and of the flat problem with the same lengths, as drawn: random, and so not flat yet
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' figure-3.5.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 325,621 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 8.60cm,16.42cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'figure-3.5.'.format
data = 'figure-3.5.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 86 mm x 164 mm
set label '' at screen 0.52907,0.98173 center font ',8' tc rgb '#202020' noenhanced front
set label 'hexahedron' at screen 0.02558,0.79993 center rotate by 90 font ',8' tc rgb '#202020' noenhanced front

# line 1, column 1
set label '' at screen 0.52907,0.62240 center font ',7' tc rgb '#606060' noenhanced front
set label 'P0' at screen 0.09113,0.92105 center font ',7' tc rgb '#202020' noenhanced front
set label 'P1' at screen 0.28054,0.64374 center font ',7' tc rgb '#202020' noenhanced front
set label 'P2' at screen 0.49160,0.95612 center font ',7' tc rgb '#202020' noenhanced front
set label 'P3' at screen 0.27192,0.87610 center font ',7' tc rgb '#202020' noenhanced front
set label 'P4' at screen 0.97401,0.86917 center font ',7' tc rgb '#202020' noenhanced front
set label 'P5' at screen 0.62233,0.87813 center font ',7' tc rgb '#202020' noenhanced front
set label 'P6' at screen 0.23969,0.82288 center font ',7' tc rgb '#202020' noenhanced front
set label 'P7' at screen 0.85755,0.74416 center font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.06395; set rmargin at screen 0.99419
set bmargin at screen 0.63336; set tmargin at screen 0.96651
set xrange [-0.101655127:1.78295577]; set yrange [-1.06630917:0.222451003]
set border 0; unset xtics; unset ytics
plot data index 0 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 1 using 1:2 with lines lw 0.55 lc rgb '#B9C3CC', \
  data index 2 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 3 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 4 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 5 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 6 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 7 using 1:2 with points pt 7 ps 0.42 lc rgb '#B9C3CC', \
  data index 8 using 1:2 with points pt 7 ps 0.42 lc rgb '#5A7083', \
  data index 9 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow
set label 'hexahedron-flat' at screen 0.02558,0.31820 center rotate by 90 font ',8' tc rgb '#202020' noenhanced front

# line 2, column 1
set label '' at screen 0.52907,0.00426 center font ',7' tc rgb '#606060' noenhanced front
set label 'P0' at screen 0.52696,0.57013 center font ',7' tc rgb '#202020' noenhanced front
set label 'P1' at screen 0.08412,0.35117 center font ',7' tc rgb '#202020' noenhanced front
set label 'P2' at screen 0.49578,0.29735 center font ',7' tc rgb '#202020' noenhanced front
set label 'P3' at screen 0.97225,0.60536 center font ',7' tc rgb '#202020' noenhanced front
set label 'P4' at screen 0.55236,0.15564 center font ',7' tc rgb '#202020' noenhanced front
set label 'P5' at screen 0.54313,0.53489 center font ',7' tc rgb '#202020' noenhanced front
set label 'P6' at screen 0.44813,0.31000 center font ',7' tc rgb '#202020' noenhanced front
set label 'P7' at screen 0.53452,0.02561 center font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.06395; set rmargin at screen 0.99419
set bmargin at screen 0.01522; set tmargin at screen 0.62118
set xrange [-0.907228438:0.915491865]; set yrange [-2.03086078:0.236287941]
set border 0; unset xtics; unset ytics
plot data index 10 using 1:2 with lines lw 0.55 lc rgb '#B9C3CC', \
  data index 11 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 12 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 13 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 14 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 15 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 16 using 1:2 with points pt 7 ps 0.42 lc rgb '#B9C3CC', \
  data index 17 using 1:2 with points pt 7 ps 0.42 lc rgb '#7A8C9C', \
  data index 18 using 1:2 with points pt 7 ps 0.42 lc rgb '#5A7083', \
  data index 19 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow
unset multiplot
unset output
