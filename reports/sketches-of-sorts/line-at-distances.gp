# The lines at given distances from two points: solved, with the distances
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' line-at-distances.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 616,237 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 16.30cm,6.27cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'line-at-distances.'.format
data = 'line-at-distances.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 163 mm x 63 mm
set label 'line-at-distances' at screen 0.50000,0.95216 center font ',8' tc rgb '#202020' noenhanced front

# line 1, column 1, 8 solutions
set label '8 solutions' at screen 0.24847,0.06856 center font ',7' tc rgb '#606060' noenhanced front
set label 'A' at screen 0.06012,0.57876 center font ',7' tc rgb '#202020' noenhanced front
set label 'B' at screen 0.43681,0.57876 center font ',7' tc rgb '#202020' noenhanced front
set label 'l' at screen 0.35918,0.20624 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'a = 1' at screen 0.07102,0.69347 center font ',7' tc rgb '#606060' noenhanced front
set label 'b = 2' at screen 0.36277,0.47154 center font ',7' tc rgb '#606060' noenhanced front
set label 'c = 5' at screen 0.24847,0.60647 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.00307; set rmargin at screen 0.49387
set bmargin at screen 0.09727; set tmargin at screen 0.91230
set xrange [-0.948725202:5.9487252]; set yrange [-2.60352691:1.80352691]
set border 0; unset xtics; unset ytics
plot data index 0 using 1:2 with lines lw 0.5 dt 2 lc rgb '#606060', \
  data index 1 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 2 using 1:2 with lines lw 1.1 lc rgb '#0072B2', \
  data index 3 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow

# line 1, column 2, 8 solutions
set label '8 solutions' at screen 0.75153,0.06856 center font ',7' tc rgb '#606060' noenhanced front
set label 'A' at screen 0.57031,0.30818 center font ',7' tc rgb '#202020' noenhanced front
set label 'B' at screen 0.94699,0.30818 center font ',7' tc rgb '#202020' noenhanced front
set label 'l' at screen 0.95131,0.66254 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'a = 1' at screen 0.60033,0.41294 center font ',7' tc rgb '#606060' noenhanced front
set label 'b = 2' at screen 0.94900,0.50354 center font ',7' tc rgb '#606060' noenhanced front
set label 'c = 5' at screen 0.75865,0.33589 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.50613; set rmargin at screen 0.99693
set bmargin at screen 0.09727; set tmargin at screen 0.91230
set xrange [-1.0487252:5.8487252]; set yrange [-1.14044836:3.26660546]
set border 0; unset xtics; unset ytics
plot data index 4 using 1:2 with lines lw 0.5 dt 2 lc rgb '#606060', \
  data index 5 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 6 using 1:2 with lines lw 1.1 lc rgb '#0072B2', \
  data index 7 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow
unset multiplot
unset output
